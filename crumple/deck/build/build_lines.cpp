// SPDX-License-Identifier: BSD-3-Clause
// Beams, springs and dampers: elements between two nodes.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

const Vector& position_of(const Build& build, Index node) {
  return build.model.nodes.position[static_cast<std::size_t>(node)];
}

/// Whether a kind of beam can have a law.
bool suits(model::BeamFormulation formulation, const model::ConstitutiveLaw& law) {
  const auto* plastic = std::get_if<model::PlasticKinematic>(&law);
  const bool elastic = std::holds_alternative<model::Elastic>(law);
  switch (formulation) {
    case model::BeamFormulation::SpotWeld:
      return std::holds_alternative<model::SpotWeldLaw>(law);
    case model::BeamFormulation::Truss:
      return elastic || (plastic != nullptr && !plastic->viscoplastic);
    default:
      return elastic || std::holds_alternative<model::ResultantPlasticity>(law);
  }
}

/// The laws that a kind of beam can have, and why, in words.
std::array<std::string, 2> suiting_laws(model::BeamFormulation formulation) {
  switch (formulation) {
    case model::BeamFormulation::SpotWeld:
      return {"*MAT_SPOTWELD", "spot weld beams (ELFORM 9) have this law"};
    case model::BeamFormulation::Truss:
      return {"*MAT_ELASTIC or *MAT_PLASTIC_KINEMATIC with VP = 0", "trusses have these laws"};
    default:
      return {"*MAT_ELASTIC or *MAT_RESULTANT_PLASTICITY", "beams of resultants (ELFORM 2) have these laws"};
  }
}

/// Laws that a kind of beam can have, said at the part.
void check_beam_law(const RawPart& raw, const model::Part& part, Build& build) {
  const model::ConstitutiveLaw& law = build.model.materials[static_cast<std::size_t>(part.material)].law;
  const model::BeamFormulation formulation =
      build.model.beam_sections[static_cast<std::size_t>(part.beam_section)].formulation;
  if (suits(formulation, law)) return;
  const auto [expected, hint] = suiting_laws(formulation);
  build.report.field_unsupported(raw.where,
                                 {"MID", std::to_string(raw.material), expected, hint, "material"});
}

/// The orientation of a beam, where its section needs one.
void check_orientation(const model::BeamElement& beam, const Where& where, Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(beam.part)];
  const auto& section = build.model.beam_sections[static_cast<std::size_t>(part.beam_section)];
  if (section.formulation == model::BeamFormulation::Truss) return;
  const Vector axis = difference(position_of(build, beam.node[1]), position_of(build, beam.node[0]));
  Vector towards = beam.orientation;
  if (beam.orientation_node != no_index)
    towards = difference(position_of(build, beam.orientation_node), position_of(build, beam.node[0]));
  const double product = length_of(axis) * length_of(towards);
  constexpr double parallel = 1e-6;
  if (product > 0 && length_of(cross(axis, towards)) <= parallel * product)
    build.report.error(
        where, "orientation",
        fmt::format("what gives the orientation of beam {} lies on its axis; move N3 off the line", beam.id));
  else if (product == 0 && section.inertia_s != section.inertia_t)
    build.report.error(where, "orientation",
                       fmt::format("beam {} has no orientation, and its section bends differently about its "
                                   "two axes; give a node N3 in the direction of s",
                                   beam.id));
}

const RawPart* raw_part(const Build& build, UserId id) {
  const auto& parts = build.deck.parts;
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const RawPart& p) { return p.id == id; });
  return found == parts.end() ? nullptr : &*found;
}

/// Two ends at one place.
bool has_length(const Build& build, const std::array<Index, 2>& node) {
  return length_of(difference(position_of(build, node[1]), position_of(build, node[0]))) > 0;
}

/// The nodes of both ends. False, with a message, if one is missing.
bool find_ends(const std::array<UserId, 2>& ids, const Where& where, std::array<Index, 2>& node,
               Build& build) {
  node[0] = build.find(Item::Node, {ids[0], "N1", where});
  node[1] = ids[1] == 0 ? node[0] : build.find(Item::Node, {ids[1], "N2", where});
  return node[0] != no_index && node[1] != no_index;
}

}  // namespace

void build_beams(Build& build) {
  std::vector<char> checked(build.model.parts.size(), 0);
  build.model.beams.reserve(build.deck.beams.size());
  for (const RawBeam& raw : build.deck.beams) {
    if (build.is_dropped(raw.part)) continue;
    model::BeamElement beam;
    beam.id = raw.id;
    beam.orientation = raw.orientation;
    beam.part = find_part_of(build, ElementKind::Beam, {raw.part, "PID", raw.where});
    bool complete = find_ends(raw.node, raw.where, beam.node, build) && beam.part != no_index;
    if (raw.orientation_node != 0) {
      beam.orientation_node = build.find(Item::Node, {raw.orientation_node, "N3", raw.where});
      complete = complete && beam.orientation_node != no_index;
    }
    build.enter(Item::Beam, {raw.id, "EID", raw.where}, build.model.beams.size());
    if (complete && !has_length(build, beam.node)) {
      build.report.error(raw.where, "length",
                         fmt::format("beam {} has no length; check N1 and N2 and their coordinates", raw.id));
      complete = false;
    }
    if (complete) {
      const auto part = static_cast<std::size_t>(beam.part);
      check_orientation(beam, raw.where, build);
      if (!checked[part])
        if (const RawPart* its = raw_part(build, raw.part))
          check_beam_law(*its, build.model.parts[part], build);
      checked[part] = 1;
      ++build.lines_of_part[part];
    }
    build.model.beams.push_back(beam);
  }
}

void build_discretes(Build& build) {
  for (std::size_t i = 0; i < build.deck.orientations.size(); ++i)
    build.enter(Item::Orientation, {build.deck.orientations[i].id, "VID", build.deck.orientations[i].where},
                i);
  build.model.discretes.reserve(build.deck.discretes.size());
  for (const RawDiscrete& raw : build.deck.discretes) {
    if (build.is_dropped(raw.part)) continue;
    model::DiscreteElement discrete;
    discrete.id = raw.id;
    discrete.scale = raw.scale;
    discrete.offset = raw.offset;
    discrete.grounded = raw.node[1] == 0;
    discrete.part = find_part_of(build, ElementKind::Discrete, {raw.part, "PID", raw.where});
    bool complete = find_ends(raw.node, raw.where, discrete.node, build) && discrete.part != no_index;
    if (raw.orientation != 0) {
      const Index index = build.find(Item::Orientation, {raw.orientation, "VID", raw.where});
      if (index != no_index) discrete.axis = build.deck.orientations[static_cast<std::size_t>(index)].vector;
      complete = complete && index != no_index;
    } else if (complete && !has_length(build, discrete.node)) {
      build.report.field_error(
          raw.where,
          {"VID", "0", "the id of an orientation",
           discrete.grounded ? "without N2 there is no line from N1 to N2; give the direction with "
                               "*DEFINE_SD_ORIENTATION"
                             : "N1 and N2 lie at the same place; give the direction with "
                               "*DEFINE_SD_ORIENTATION",
           "direction"});
      complete = false;
    }
    build.enter(Item::Discrete, {raw.id, "EID", raw.where}, build.model.discretes.size());
    if (complete) ++build.lines_of_part[static_cast<std::size_t>(discrete.part)];
    build.model.discretes.push_back(discrete);
  }
}

}  // namespace crumple::deck
