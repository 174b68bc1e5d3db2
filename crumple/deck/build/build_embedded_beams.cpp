// SPDX-License-Identifier: BSD-3-Clause
// Beams inside solids.
#include <fmt/core.h>

#include <algorithm>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Elements of a kind in some parts, by their places in the model, ascending.
template <class Element>
std::vector<Index> elements_of(const std::vector<Element>& elements, const std::vector<char>& wanted) {
  std::vector<Index> found;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements[i].part != no_index && wanted[static_cast<std::size_t>(elements[i].part)] != 0)
      found.push_back(static_cast<Index>(i));
  return found;
}

/// The parts of one side, by part of the model; empty, with a message, if they are missing or of other kinds
/// of elements.
std::vector<char> parts_of_side(Build& build, const RawEmbeddedBeams& raw, const RawEmbeddedBeams::Side& side,
                                ElementKind kind) {
  const std::vector<Index> parts = find_parts(build, side.is_set, {side.id, side.field, raw.where});
  std::vector<char> wanted(parts.empty() ? 0 : build.model.parts.size(), 0);
  const bool beams = kind == ElementKind::Beam;
  for (const Index index : parts) {
    const model::Part& part = build.model.parts[static_cast<std::size_t>(index)];
    if (kind_of(part) != kind) {
      build.report.field_unsupported(
          raw.where,
          {side.field, std::to_string(side.id), beams ? "parts of beams or trusses" : "parts of solids",
           fmt::format("part {} has other elements, which {}", part.id,
                       beams ? "are not put into solids" : "hold no beams"),
           "kind of part"});
      continue;
    }
    wanted[static_cast<std::size_t>(index)] = 1;
  }
  return wanted;
}

/// Leaves out tetrahedra with ten nodes: their shape functions are negative in places, and so the masses that
/// their corners would carry.
void drop_quadratic(Build& build, const RawEmbeddedBeams& raw, std::vector<Index>& solids) {
  const auto quadratic = [&](Index solid) {
    return build.model.solids[static_cast<std::size_t>(solid)].node.has_middles();
  };
  if (std::none_of(solids.begin(), solids.end(), quadratic)) return;
  build.report.field_unsupported(raw.where, {raw.solids.field, std::to_string(raw.solids.id),
                                             "solids without nodes in the middle of their sides",
                                             "tetrahedra with ten nodes hold no beams", "ten nodes"});
  solids.erase(std::remove_if(solids.begin(), solids.end(), quadratic), solids.end());
}

}  // namespace

void build_embedded_beams(Build& build) {
  for (std::size_t i = 0; i < build.deck.embedded_beams.size(); ++i) {
    const RawEmbeddedBeams& raw = build.deck.embedded_beams[i];
    const std::vector<char> beams = parts_of_side(build, raw, raw.beams, ElementKind::Beam);
    const std::vector<char> solids = parts_of_side(build, raw, raw.solids, ElementKind::Solid);
    if (beams.empty() || solids.empty()) continue;
    model::EmbeddedBeams made;
    made.id = raw.id != 0 ? raw.id : static_cast<UserId>(i) + 1;
    made.beams = elements_of(build.model.beams, beams);
    made.solids = elements_of(build.model.solids, solids);
    made.end_time = raw.end_time;
    made.between_nodes = raw.between_nodes;
    drop_quadratic(build, raw, made.solids);
    if (made.beams.empty() || made.solids.empty())
      build.report.warning(raw.where, "empty", "there are no beams or no solids to couple");
    else
      build.model.embedded_beams.push_back(std::move(made));
  }
}

}  // namespace crumple::deck
