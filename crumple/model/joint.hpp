// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "base/index.hpp"

namespace crumple::model {

/// What a joint leaves free of the motion of two bodies against each other.
enum class JointKind {
  Spherical,      ///< the rotation about a point
  Revolute,       ///< the rotation about an axis
  Cylindrical,    ///< the rotation about an axis and the displacement along it
  Translational,  ///< the displacement along an axis
  Universal,      ///< the rotations about two axes at right angles, one of each body
  Locking,        ///< nothing
};

/// Two rigid bodies that are joined by penalty (*CONSTRAINED_JOINT). The first, third and fifth node belong
/// to one body, the others to the second one. The axis is the line from the first to the third node.
struct Joint {
  UserId id = 0;
  JointKind kind = JointKind::Spherical;
  std::array<Index, 6> node{no_index, no_index, no_index, no_index, no_index, no_index};
  double stiffness_scale = 1;  ///< RPS: factor on the penalty stiffness [-]
  double damping = 1;          ///< share of the critical damping of the penalty [-]
};

/// Number of nodes that a kind of joint needs.
constexpr std::size_t node_count(JointKind kind) {
  return kind == JointKind::Spherical                                     ? 2
         : kind == JointKind::Translational || kind == JointKind::Locking ? 6
                                                                          : 4;
}

/// What resists one relative motion in a joint: an angle, or a displacement along an axis.
struct JointResistance {
  Index curve = no_index;               ///< moment over angle [rad], or force over displacement
  Index damping_curve = no_index;       ///< the same over their rates
  double stiffness = 0;                 ///< of friction and stops [moment/rad, force/length]
  double friction = 0;                  ///< limit of the moment or force of friction
  Index friction_curve = no_index;      ///< instead, over the angle or displacement
  std::optional<double> negative_stop;  ///< below zero [rad, length]
  std::optional<double> positive_stop;  ///< above zero [rad, length]
};

/// Resistance of two rigid bodies against motion relative to each other (*CONSTRAINED_JOINT_STIFFNESS): about
/// or along the axes of a coordinate system that each body carries.
struct JointStiffness {
  UserId id = 0;
  bool is_translational = false;
  std::array<Index, 2> body{no_index, no_index};               ///< in Model::rigid_bodies
  std::array<std::array<std::array<double, 3>, 3>, 2> axes{};  ///< of each body at time zero
  std::array<std::array<double, 3>, 2> origin{};               ///< the same [length]
  std::array<JointResistance, 3> resistance{};                 ///< phi, theta, psi, or x, y, z
};

}  // namespace crumple::model
