// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/rigid_body.hpp"

namespace crumple::constraints {

/// The dynamics of one rigid body (docs/theory/rigid_bodies.md). Arms and moments are about its centre, in
/// global axes.

/// Tensor of inertia at a place of the body [mass * length^2].
math::Matrix3 inertia_tensor(const domain::RigidBody& body, const math::Quaternion& turn);

/// The angular velocity that goes with the angular momentum at a place: about held axes what is prescribed,
/// about the others so that the components of the momentum about them are right [1/time].
math::Vec3 spin_of(const domain::RigidBody& body, const math::Quaternion& turn, const math::Vec3& momentum);

/// Velocity at time n of the body's point with that arm from the centre [length/time].
math::Vec3 velocity_at(const domain::RigidBody& body, const math::Vec3& arm);

/// Change of the velocity of a point by an impulse of unit size along `direction` on it [1/mass].
math::Vec3 response_at(const domain::RigidBody& body, const math::Vec3& arm, const math::Vec3& direction);

/// Changes the momenta by an impulse on a point; held axes take up their part of it.
void give_impulse(domain::RigidBody& body, const math::Vec3& arm, const math::Vec3& impulse);

/// Prescribes the velocity of the centre along one of held_axes, or the angular velocity about it, at n +
/// 1/2.
void hold_translation(domain::RigidBody& body, int axis, double velocity);
void hold_rotation(domain::RigidBody& body, int axis, double spin);

/// Turns the body over a step: sets next_turn and angular_velocity. Of a free body both kinetic energy and
/// angular momentum are kept to round-off: the implicit midpoint rule for the momentum in the body's axes,
/// and Cayley's transform for the turn (J.C. Simo, K.K. Wong, Int. J. Numer. Meth. Engng 31, 1991, 19-52;
/// M.A. Austin, P.S. Krishnaprasad, L.-S. Wang, J. Comput. Phys. 107, 1993, 105-117).
void turn_over_step(domain::RigidBody& body, double step);

}  // namespace crumple::constraints
