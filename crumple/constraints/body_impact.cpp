// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/body_impact.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/rigid_motion.hpp"

namespace crumple::constraints {

using domain::RigidBody;
using math::Vec3;

namespace {

/// One node stopped along the normal. Returns by how much its velocity has changed.
double stop_along_normal(RigidBody& body, const StoppingWall& wall, BodyTouch& touch) {
  const Vec3& normal = touch.normal;
  const double response = dot(normal, response_at(body, touch.arm, normal));
  if (!(response > 0)) return 0;
  const double wanted =
      (touch.slowest - dot(normal, velocity_at(body, touch.arm) - wall.velocity)) / response;
  const double before = dot(normal, touch.impulse);
  const double change = std::max(0.0, before + wanted) - before;
  if (change == 0) return 0;
  give_impulse(body, touch.arm, change * normal);
  touch.impulse += change * normal;
  return std::fabs(change) * response;
}

/// Friction against its slip, within Coulomb's bound. Returns by how much its velocity has changed.
double rub(RigidBody& body, const StoppingWall& wall, BodyTouch& touch) {
  const Vec3& normal = touch.normal;
  const Vec3 velocity = velocity_at(body, touch.arm) - wall.velocity;
  const Vec3 slip = velocity - dot(velocity, normal) * normal;
  const double speed = norm(slip);
  if (speed == 0) return 0;
  const Vec3 direction = (1 / speed) * slip;
  const double response = dot(direction, response_at(body, touch.arm, direction));
  if (!(response > 0)) return 0;
  const double pressing = dot(touch.impulse, normal);
  const Vec3 before = touch.impulse - pressing * normal;
  Vec3 after = before - (speed / response) * direction;
  const double size = norm(after);
  const double bound = wall.friction >= 1 ? (pressing > 0 ? size : 0.0) : wall.friction * pressing;
  if (size > bound) after = (bound / size) * after;
  give_impulse(body, touch.arm, after - before);
  touch.impulse += after - before;
  return norm(after - before) * response;
}

}  // namespace

void stop_body(RigidBody& body, const StoppingWall& wall, std::vector<BodyTouch>& touches) {
  constexpr int most_rounds = 1000;
  constexpr double small_change = 1e-10;  // of a velocity, over the largest change
  double largest = 0;
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (BodyTouch& touch : touches) {
      change = std::max(change, stop_along_normal(body, wall, touch));
      if (wall.friction > 0) change = std::max(change, rub(body, wall, touch));
    }
    largest = std::max(largest, change);
    if (change <= small_change * largest) break;
  }
}

}  // namespace crumple::constraints
