// SPDX-License-Identifier: BSD-3-Clause
// Resistance of joints between rigid bodies.
#include <fmt/core.h>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

using Names = std::array<std::string_view, 3>;

constexpr Names angle_curves = {"LCIDPH", "LCIDT", "LCIDPS"};
constexpr Names angle_damping = {"DLCIDPH", "DLCIDT", "DLCIDPS"};
constexpr Names angle_stiffness = {"ESPH", "EST", "ESPS"};
constexpr Names way_curves = {"LCIDX", "LCIDY", "LCIDZ"};
constexpr Names way_damping = {"DLCIDX", "DLCIDY", "DLCIDZ"};
constexpr Names angle_friction = {"FMPH", "FMT", "FMPS"};
constexpr Names way_friction = {"FFX", "FFY", "FFZ"};
constexpr Names way_stiffness = {"ESX", "ESY", "ESZ"};

bool find_bodies(Build& build, const RawJointStiffness& raw, model::JointStiffness& stiffness) {
  constexpr std::array<std::string_view, 2> field = {"PIDA", "PIDB"};
  for (std::size_t side = 0; side < 2; ++side)
    stiffness.body[side] = build.find(Item::RigidBody, {raw.body[side], field[side], raw.where});
  if (stiffness.body[0] == no_index || stiffness.body[1] == no_index) return false;
  if (stiffness.body[0] != stiffness.body[1]) return true;
  build.report.field_error(raw.where, {"PIDB", std::to_string(raw.body[1]), "another rigid body than PIDA",
                                       "a body does not move against itself", "same"});
  return false;
}

bool find_systems(Build& build, const RawJointStiffness& raw, model::JointStiffness& stiffness) {
  constexpr std::array<std::string_view, 2> field = {"CIDA", "CIDB"};
  for (std::size_t side = 0; side < 2; ++side) {
    const auto axes = find_axes(build, raw.system[side], field[side], raw.where);
    if (!axes) return false;
    stiffness.axes[side] = *axes;
    stiffness.origin[side] = origin_of(build, raw.system[side]);
  }
  return true;
}

/// Curves by their ids; stops and friction are springs, which need a stiffness.
void find_resistance(Build& build, const RawJointStiffness& raw, model::JointStiffness& stiffness) {
  const bool moves = stiffness.is_translational;
  for (std::size_t i = 0; i < 3; ++i) {
    model::JointResistance& resistance = stiffness.resistance[i];
    if (raw.curve[i] != 0)
      resistance.curve =
          build.find(Item::Curve, {raw.curve[i], (moves ? way_curves : angle_curves)[i], raw.curves_where});
    if (raw.damping_curve[i] != 0)
      resistance.damping_curve = build.find(
          Item::Curve, {raw.damping_curve[i], (moves ? way_damping : angle_damping)[i], raw.curves_where});
    if (raw.friction_curve[i] != 0)
      resistance.friction_curve =
          build.find(Item::Curve,
                     {raw.friction_curve[i], (moves ? way_friction : angle_friction)[i], raw.friction_where});
    const bool needs_stiffness = resistance.friction > 0 || raw.friction_curve[i] != 0 ||
                                 resistance.negative_stop || resistance.positive_stop;
    if (needs_stiffness && !(resistance.stiffness > 0))
      build.report.field_warning(
          raw.where,
          {(moves ? way_stiffness : angle_stiffness)[i], "0", "a number above zero",
           "without it the stops and the friction beside it do not act, as in LS-DYNA", "stiffness"});
  }
}

}  // namespace

void build_joint_stiffnesses(Build& build) {
  for (const RawJointStiffness& raw : build.deck.joint_stiffnesses) {
    model::JointStiffness stiffness = raw.stiffness;
    const bool has_bodies = find_bodies(build, raw, stiffness);
    const bool has_systems = find_systems(build, raw, stiffness);
    find_resistance(build, raw, stiffness);
    if (has_bodies && has_systems) build.model.joint_stiffnesses.push_back(stiffness);
  }
}

}  // namespace crumple::deck
