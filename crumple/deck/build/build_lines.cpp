// SPDX-License-Identifier: BSD-3-Clause
// Beams, springs and dampers: elements between two nodes.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"
#include "model/beam_section.hpp"

namespace crumple::deck {

namespace {

const Vector& position_of(const Build& build, Index node) {
  return build.model.nodes.position[static_cast<std::size_t>(node)];
}

/// Whether there is an update of a law for the points of a cross section.
bool suits_integrated(const model::ConstitutiveLaw& law) {
  if (const auto* heated = std::get_if<model::JohnsonCook>(&law)) return heated->simplified;
  if (const auto* table = std::get_if<model::PiecewiseLinearPlasticity>(&law))
    return !model::has_strain_limits(*table);
  return std::holds_alternative<model::Elastic>(law) ||
         std::holds_alternative<model::PlasticKinematic>(law) ||
         std::holds_alternative<model::PowerLawPlasticity>(law) ||
         std::holds_alternative<model::NullMaterial>(law);
}

/// Whether a kind of beam can have a law.
bool suits(model::BeamFormulation formulation, const model::ConstitutiveLaw& law) {
  const auto* plastic = std::get_if<model::PlasticKinematic>(&law);
  const bool elastic = std::holds_alternative<model::Elastic>(law);
  switch (formulation) {
    case model::BeamFormulation::SpotWeld:
      return std::holds_alternative<model::SpotWeldLaw>(law);
    case model::BeamFormulation::Integrated:
      return suits_integrated(law);
    case model::BeamFormulation::Discrete:
      return std::holds_alternative<model::DiscreteBeamLaw>(law);
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
    case model::BeamFormulation::Integrated:
      return {
          "*MAT_ELASTIC, *MAT_PLASTIC_KINEMATIC, *MAT_PIECEWISE_LINEAR_PLASTICITY, "
          "*MAT_PLASTICITY_WITH_DAMAGE, *MAT_POWER_LAW_PLASTICITY, *MAT_SIMPLIFIED_JOHNSON_COOK, *MAT_NULL "
          "or "
          "*MAT_RIGID",
          "beams integrated over their section (ELFORM 1, 4, 5) have these laws"};
    case model::BeamFormulation::Discrete:
      return {
          "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM, *MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM, "
          "*MAT_CABLE_DISCRETE_BEAM, *MAT_ELASTIC_SPRING_DISCRETE_BEAM, "
          "*MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM or *MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM",
          "discrete beams (ELFORM 6) have these laws"};
    case model::BeamFormulation::Truss:
      return {"*MAT_ELASTIC or *MAT_PLASTIC_KINEMATIC with VP = 0", "trusses have these laws"};
    default:
      return {"*MAT_ELASTIC or *MAT_RESULTANT_PLASTICITY", "beams of resultants (ELFORM 2) have these laws"};
  }
}

/// Discrete beams in axes of their own may have both nodes at one place.
bool may_be_a_point(const Build& build, Index part_index) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(part_index)];
  const auto* law = std::get_if<model::DiscreteBeamLaw>(
      &build.model.materials[static_cast<std::size_t>(part.material)].law);
  return law != nullptr && law->kind == model::DiscreteBeamLaw::Kind::Axes;
}

/// Axes that turn with the line of the nodes are not there.
void check_place_of_axes(const RawPart& raw, const model::Part& part, Build& build) {
  const std::size_t index = static_cast<std::size_t>(part.beam_section);
  const double place = build.model.beam_sections[index].discrete.place;
  if (!may_be_a_point(build, build.find_quietly(Item::Part, raw.id))) return;
  if (place == 0 || place == 1 || place == -1) return;
  build.report.field_unsupported(
      build.deck.beam_sections[index].where,
      {"SCOOR", fmt::format("{:g}", place), "-1, 0 or 1",
       "the axes turn with the first node, the mean of both, or the second; not with the line of the nodes",
       "axes"});
}

/// Whether a kind of beam knows all criteria of erosion: those of one point the plastic strain.
bool fails_by(model::BeamFormulation formulation, model::ErosionCriteria criteria) {
  if (formulation != model::BeamFormulation::Truss && formulation != model::BeamFormulation::SpotWeld)
    return !criteria.any();
  criteria.effective_plastic_strain.reset();
  return !criteria.any() && criteria.conditions == 1;
}

/// Laws that a kind of beam can have, said at the part.
void check_beam_law(const RawPart& raw, const model::Part& part, Build& build) {
  const model::Material& material = build.model.materials[static_cast<std::size_t>(part.material)];
  const model::ConstitutiveLaw& law = material.law;
  const model::BeamFormulation formulation =
      build.model.beam_sections[static_cast<std::size_t>(part.beam_section)].formulation;
  if (material.erosion && !fails_by(formulation, *material.erosion))
    build.report.field_unsupported(
        raw.where, {"MID", std::to_string(raw.material), "a material without *MAT_ADD_EROSION",
                    "of beams only trusses (ELFORM 3) and spot welds (9) fail by it, and by plastic strain "
                    "alone: EFFEPS "
                    "below zero, NCS = 1 and nothing else",
                    "erosion"});
  if (material.damage)
    build.report.field_unsupported(
        raw.where, {"MID", std::to_string(raw.material), "a material without *MAT_ADD_DAMAGE_GISSMO",
                    "damage is there for shells and solids", "damage"});
  if (material.least_step > 0)
    build.report.field_unsupported(raw.where,
                                   {"MID", std::to_string(raw.material), "a material without TDEL or DTMIN",
                                    "shells and solids alone are deleted by their time step", "deletion"});
  if (formulation == model::BeamFormulation::Discrete) check_place_of_axes(raw, part, build);
  if (suits(formulation, law)) return;
  const auto [expected, hint] = suiting_laws(formulation);
  build.report.field_unsupported(raw.where,
                                 {"MID", std::to_string(raw.material), expected, hint, "material"});
}

bool bends_differently(const model::BeamSection& section) {
  if (section.formulation == model::BeamFormulation::Discrete) return false;
  if (section.formulation == model::BeamFormulation::Integrated) return !model::is_round(section);
  return section.inertia_s != section.inertia_t;
}

/// The orientation of a beam, where its section needs one.
void check_orientation(const model::BeamElement& beam, const Where& where, Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(beam.part)];
  const auto& section = build.model.beam_sections[static_cast<std::size_t>(part.beam_section)];
  if (section.formulation == model::BeamFormulation::Truss) return;
  if (section.formulation == model::BeamFormulation::Discrete && section.discrete.axes) return;
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
  else if (product == 0 && bends_differently(section))
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
  settle_discrete_beams(build);
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
    if (complete && !has_length(build, beam.node) && !may_be_a_point(build, beam.part)) {
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
