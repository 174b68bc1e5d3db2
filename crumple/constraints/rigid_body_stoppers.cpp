// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_body_stoppers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraints/rigid_motion.hpp"
#include "math/to_vec3.hpp"

namespace crumple::constraints {

using math::Vec3;

RigidBodyStoppers::RigidBodyStoppers(const model::Model& model, const domain::Domain& domain)
    : model_(&model) {
  for (const model::RigidBodyStopper& given : model.rigid_body_stoppers) {
    const domain::RigidBody& body = domain.rigid_bodies[given.body];
    const Vec3 direction = math::to_vec3(given.direction);
    Stopper stopper{.given = given};
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double along = dot(direction, body.held_axes.column[static_cast<std::size_t>(axis)]);
      if (std::fabs(along) <= largest) continue;
      largest = std::fabs(along);
      stopper.axis = axis;
      stopper.sign = along < 0 ? -1 : 1;
    }
    stopper.start = dot(body.centre, direction);
    stoppers_.push_back(stopper);
  }
}

void RigidBodyStoppers::impose(domain::Domain& domain, double next_step) const {
  const double time = domain.clock.time;
  for (const auto& [given, axis, sign, start] : stoppers_) {
    if (time < given.birth_time || time >= given.death_time) continue;
    domain::RigidBody& body = domain.rigid_bodies[given.body];
    const Vec3 direction = sign * body.held_axes.column[static_cast<std::size_t>(axis)];
    const double place = dot(body.centre, direction);
    const double velocity = dot(body.velocity, direction);
    // Velocity with which the centre is on the bound at n+1.
    const auto towards = [&, first = start](const model::RigidBodyStopper::Bound& bound, double none) {
      if (bound.curve == no_index) return none;
      const double at = model_->curves[bound.curve].at(time + next_step);
      return ((bound.is_displacement ? first : 0.0) + at - place) / next_step;
    };
    constexpr double never = std::numeric_limits<double>::max();
    double most = towards(given.largest, never);
    double least = towards(given.smallest, -never);
    if (given.speed_curve != no_index) {
      const double speed = std::fabs(model_->curves[given.speed_curve].at(time + 0.5 * next_step));
      most = std::min(most, speed);
      least = std::max(least, -speed);
    }
    const double bounded = std::max(least, std::min(most, velocity));
    if (bounded != velocity) hold_translation(body, axis, sign * bounded);
  }
}

}  // namespace crumple::constraints
