// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "domain/domain.hpp"

namespace crumple::constraints {

using math::Vec3;

/// Forces and moments of a joint on its bodies A and B; the force on B is the opposite of that on A.
struct JointLoad {
  Vec3 force;                  ///< on A [force]
  std::array<Vec3, 2> moment;  ///< on each, about its centre of mass [force * length]
};

/// True if all three axes are held.
inline bool all_of(const std::array<bool, 3>& axes) {
  return axes[0] && axes[1] && axes[2];
}

using JointBodies = std::array<const domain::RigidBody*, 2>;

/// The bodies with these places in the domain.
JointBodies bodies_of(const domain::Domain& domain, const std::array<Index, 2>& places);

/// Puts a force on B at a place, and its opposite on A.
void add_force(const JointBodies& body, const Vec3& place, const Vec3& force, JointLoad& load);

/// Puts a moment on B, and its opposite on A.
void add_moment(const Vec3& moment, JointLoad& load);

/// Adds a load to the forces and moments of its bodies.
void add_to_bodies(domain::Domain& domain, const std::array<Index, 2>& places, const JointLoad& load);

/// Work of a joint on both bodies over the last step, by the trapezoidal rule, of the loads at its ends. A
/// moment of n-1 acts on the spin after its kick, that of n on the spin before: with these the kinetic energy
/// of free bodies balances to round-off.
double work_of(const JointBodies& body, const JointLoad& last, const JointLoad& now, double step);

/// Arm of a place from the body's centre, in its axes, and back.
Vec3 arm_in(const domain::RigidBody& body, const Vec3& place);
Vec3 place_of(const domain::RigidBody& body, const Vec3& arm);

/// A direction in the body's axes.
Vec3 turned_back(const domain::RigidBody& body, const Vec3& direction);

/// Axes that the body carries, as they are in space now.
math::Matrix3 turned(const domain::RigidBody& body, const math::Matrix3& axes);

/// Velocity of a place that moves with the body, in the last step.
Vec3 velocity_of(const domain::RigidBody& body, const Vec3& place);

/// Bound on the change of velocity of a point by a unit impulse there, in any direction. `arm` is in the
/// body's axes [1/mass].
double point_response(const domain::RigidBody& body, const Vec3& arm);

/// The same of the angular velocity by a unit moment [1/(mass * length^2)].
double turning_response(const domain::RigidBody& body);

}  // namespace crumple::constraints
