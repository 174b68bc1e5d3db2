// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"

namespace crumple::constraints {

/// A node of a rigid body that a wall stops.
struct BodyTouch {
  Index node = no_index;
  math::Vec3 arm;      ///< from the centre of the body [length]
  math::Vec3 normal;   ///< out of the wall, unit
  double slowest = 0;  ///< least relative velocity along the normal that does not carry it in [length/time]
  math::Vec3 impulse;  ///< that it has received [force * time]
};

/// What all touches have in common.
struct StoppingWall {
  math::Vec3 velocity;  ///< of the wall [length/time]
  double friction = 0;  ///< Coulomb coefficient; 1 or more sticks
};

/// Gives the body impulses on the touching nodes until none goes into the wall: pushing ones only, as little
/// as is needed. Of all motions that the wall allows this finds, without friction, the one that is nearest to
/// the body's by kinetic energy: a perfectly plastic impact (J.J. Moreau, Unilateral contact and dry friction
/// in finite freedom dynamics, CISM Courses and Lectures 302, 1988). By one node after the other, again and
/// again (projected Gauss-Seidel).
void stop_body(domain::RigidBody& body, const StoppingWall& wall, std::vector<BodyTouch>& touches);

}  // namespace crumple::constraints
