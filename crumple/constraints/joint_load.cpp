// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/joint_load.hpp"

#include <algorithm>

#include "constraints/rigid_motion.hpp"

namespace crumple::constraints {

using domain::RigidBody;
using math::Matrix3;

namespace {

/// Inverse of the moments of inertia about the body's axes; zero where nothing can turn it.
Vec3 inverse_inertia(const RigidBody& body) {
  Vec3 inverse;
  if (all_of(body.fixed_rotation)) return inverse;
  for (int axis = 0; axis < 3; ++axis)
    if (body.principal_inertia[axis] > 0) inverse[axis] = 1 / body.principal_inertia[axis];
  return inverse;
}

}  // namespace

JointBodies bodies_of(const domain::Domain& domain, const std::array<Index, 2>& places) {
  return {&domain.rigid_bodies[places[0]], &domain.rigid_bodies[places[1]]};
}

void add_force(const JointBodies& body, const Vec3& place, const Vec3& force, JointLoad& load) {
  load.force -= force;
  load.moment[0] -= cross(place - body[0]->centre, force);
  load.moment[1] += cross(place - body[1]->centre, force);
}

void add_moment(const Vec3& moment, JointLoad& load) {
  load.moment[0] -= moment;
  load.moment[1] += moment;
}

void add_to_bodies(domain::Domain& domain, const std::array<Index, 2>& places, const JointLoad& load) {
  domain.rigid_bodies[places[0]].force += load.force;
  domain.rigid_bodies[places[1]].force -= load.force;
  for (std::size_t side = 0; side < 2; ++side) domain.rigid_bodies[places[side]].moment += load.moment[side];
}

double work_of(const JointBodies& body, const JointLoad& last, const JointLoad& now, double step) {
  double rate = dot(last.force + now.force, body[0]->velocity - body[1]->velocity);
  for (std::size_t side = 0; side < 2; ++side)
    rate += dot(last.moment[side], body[side]->spin) +
            dot(now.moment[side], spin_of(*body[side], body[side]->turn, body[side]->angular_momentum));
  return 0.5 * step * rate;
}

Vec3 arm_in(const RigidBody& body, const Vec3& place) {
  return math::transposed_product(math::matrix_of(body.turn), place - body.centre);
}

Vec3 place_of(const RigidBody& body, const Vec3& arm) {
  return body.centre + math::matrix_of(body.turn) * arm;
}

Vec3 turned_back(const RigidBody& body, const Vec3& direction) {
  return math::transposed_product(math::matrix_of(body.turn), direction);
}

Matrix3 turned(const RigidBody& body, const Matrix3& axes) {
  const Matrix3 turn = math::matrix_of(body.turn);
  return {{turn * axes.column[0], turn * axes.column[1], turn * axes.column[2]}};
}

Vec3 velocity_of(const RigidBody& body, const Vec3& place) {
  return body.velocity + cross(body.angular_velocity, place - body.centre);
}

/// The trace of (arm x)^T I^-1 (arm x) is at least its largest eigenvalue.
double point_response(const RigidBody& body, const Vec3& arm) {
  const Vec3 inverse = inverse_inertia(body);
  double response = all_of(body.fixed_translation) ? 0.0 : 1 / body.mass;
  for (int axis = 0; axis < 3; ++axis) response += inverse[axis] * (dot(arm, arm) - arm[axis] * arm[axis]);
  return response;
}

double turning_response(const RigidBody& body) {
  const Vec3 inverse = inverse_inertia(body);
  return std::max({inverse.x, inverse.y, inverse.z});
}

}  // namespace crumple::constraints
