// SPDX-License-Identifier: BSD-3-Clause
// Segments that do not reflect waves: each must be a face of a solid whose material says how fast waves are.
#include <fmt/core.h>

#include <map>
#include <set>

#include "deck/build/build.hpp"
#include "model/solid_faces.hpp"

namespace crumple::deck {

namespace {

using Segment = std::array<Index, 4>;

/// Faces of the solids that deform, by their nodes; of two that share one the first.
using Faces = std::map<Segment, model::SolidFace>;

/// Rigid solids have no waves, and a layer of glue has no thickness for them.
bool has_waves(const model::Model& model, const model::SolidElement& solid) {
  if (solid.part == no_index) return false;  // reported
  const model::Part& part = model.parts[static_cast<std::size_t>(solid.part)];
  if (part.solid_section == no_index) return false;
  const model::SolidSection& section = model.solid_sections[static_cast<std::size_t>(part.solid_section)];
  return !model::is_rigid(model, part) && !model::is_cohesive(section.formulation);
}

Faces faces_with_waves(const model::Model& model) {
  std::vector<Index> some;
  for (std::size_t i = 0; i < model.solids.size(); ++i)
    if (has_waves(model, model.solids[i])) some.push_back(static_cast<Index>(i));
  Faces faces;
  for (const model::SolidFace& face : model::all_faces(model.solids, some))
    faces.emplace(model::key_of(face.node), face);
  return faces;
}

std::string named(const model::Model& model, const Segment& segment) {
  const auto id = [&](std::size_t k) { return model.nodes.id[static_cast<std::size_t>(segment[k])]; };
  return fmt::format("{}, {}, {}, {}", id(0), id(1), id(2), id(3));
}

/// What is wrong with some segments of a card.
struct Odd {
  std::size_t count = 0;
  const Segment* first = nullptr;
  void add(const Segment& segment) {
    if (count++ == 0) first = &segment;
  }
};

/// The waves that segments take, by their nodes: normal and tangential.
using Taken = std::map<Segment, std::pair<bool, bool>>;

/// Adds a segment; false where it takes the same wave already: it would resist twice, and reflect again.
bool add_segment(const model::ViscousSegment& segment, Taken& taken, Build& build) {
  auto& [normal, tangential] = taken[model::key_of(segment.node)];
  if ((normal && segment.normal) || (tangential && segment.tangential)) return false;
  normal = normal || segment.normal;
  tangential = tangential || segment.tangential;
  build.model.viscous_segments.push_back(segment);
  return true;
}

/// Segments of a card that something is wrong with.
struct OddSegments {
  Odd without_solid;
  Odd inner;
  Odd twice;
};

void report_odd(const RawViscousBoundary& raw, const OddSegments& odd, std::size_t count, Build& build) {
  const auto fault = [&](const Odd& found, const char* expected, const char* why, std::string_view kind) {
    return FieldFault{"SSID", std::to_string(raw.set), expected,
                      fmt::format("{} of {} are not, the first has the nodes {}; {}", found.count, count,
                                  named(build.model, *found.first), why),
                      kind};
  };
  if (odd.without_solid.count > 0)
    build.report.field_error(
        raw.where, fault(odd.without_solid, "segments that are faces of solids which deform",
                         "the density and the wave speeds of the boundary are those of the solid; of a "
                         "tetrahedron with ten nodes a face is four segments",
                         "no solid"));
  if (odd.twice.count > 0)
    build.report.field_error(raw.where, fault(odd.twice, "segments that no other card has for the same waves",
                                              "they would resist twice, and reflect; remove one", "twice"));
  if (odd.inner.count > 0)
    build.report.field_warning(
        raw.where, fault(odd.inner, "segments on the surface of the solids",
                         "there are solids on both sides, and the boundary damps what passes", "inner face"));
}

void build_boundary(const RawViscousBoundary& raw, const Faces& faces, Taken& taken, Build& build) {
  const Index index = build.find(Item::SegmentSet, {raw.set, "SSID", raw.where});
  if (index == no_index) return;
  if (!raw.normal && !raw.tangential)
    build.report.warning(raw.where, "no boundary",
                         "AD and AS both turn the boundary off, so that it reflects all waves");
  const std::vector<Segment>& segments = build.model.segment_sets[static_cast<std::size_t>(index)].segments;
  OddSegments odd;
  for (const Segment& segment : segments) {
    const auto found = faces.find(model::key_of(segment));
    if (found == faces.end()) {
      odd.without_solid.add(segment);
      continue;
    }
    if (found->second.neighbour != no_index) odd.inner.add(segment);
    if (!raw.normal && !raw.tangential) continue;
    const model::ViscousSegment own{
        .node = segment, .solid = found->second.solid, .normal = raw.normal, .tangential = raw.tangential};
    if (!add_segment(own, taken, build)) odd.twice.add(segment);
  }
  report_odd(raw, odd, segments.size(), build);
}

/// A rigid body moves its nodes by the sum of all forces, which the boundary does not know.
void warn_of_bodies(Build& build) {
  const std::vector<Index> body = bodies_of_nodes(build);
  std::set<Index> moved;
  for (const model::ViscousSegment& segment : build.model.viscous_segments)
    for (const Index node : segment.node)
      if (body[static_cast<std::size_t>(node)] != no_index) moved.insert(node);
  if (moved.empty()) return;
  build.report.warning(
      build.deck.viscous_boundaries.front().where, "nodes of bodies",
      fmt::format("rigid bodies move {} nodes of non-reflecting boundaries, the first is {}: "
                  "the boundary does not act on these",
                  moved.size(), build.model.nodes.id[static_cast<std::size_t>(*moved.begin())]));
}

}  // namespace

void build_viscous_boundaries(Build& build) {
  if (build.deck.viscous_boundaries.empty()) return;
  const Faces faces = faces_with_waves(build.model);
  Taken taken;
  for (const RawViscousBoundary& raw : build.deck.viscous_boundaries)
    build_boundary(raw, faces, taken, build);
  warn_of_bodies(build);
}

}  // namespace crumple::deck
