// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_body_stoppers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "constraints/rigid_motion.hpp"
#include "math/to_vec3.hpp"

namespace crumple::constraints {

using math::Vec3;

namespace {

/// True where a place is past a bound by more than round-off; side is 1 of the largest, -1 of the smallest.
bool is_beyond(double place, double bound, int side) {
  constexpr double round_off = 1e-9;
  return side * (place - bound) > round_off * (std::fabs(place) + std::fabs(bound));
}

}  // namespace

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
    if (body.fixed_translation[static_cast<std::size_t>(stopper.axis)]) continue;
    if (given.birth_time <= 0) {
      check_start(stopper, given.largest, 1);
      check_start(stopper, given.smallest, -1);
    }
    stoppers_.push_back(stopper);
  }
}

double RigidBodyStoppers::bound_at(const Stopper& stopper, const Bound& bound, double time) const {
  return (bound.is_displacement ? stopper.start : 0.0) + model_->curves[bound.curve].at(time);
}

/// A bound that acts from the start must have the body on its right side.
void RigidBodyStoppers::check_start(const Stopper& stopper, const Bound& bound, int side) const {
  if (bound.curve == no_index) return;
  const double at = bound_at(stopper, bound, 0);
  if (!is_beyond(stopper.start, at, side)) return;
  throw Error("The stopper of rigid body " + std::to_string(model_->rigid_bodies[stopper.given.body].id) +
              ": at time zero its centre is at " + std::to_string(stopper.start) +
              " along the direction, beyond the " + (side > 0 ? "largest (LCMAX), " : "smallest (LCMIN), ") +
              std::to_string(at) +
              ". Move the body or the bound, or let the stopper act later by TB. A curve's number below zero "
              "is a bound of the displacement.");
}

void RigidBodyStoppers::impose(domain::Domain& domain, double next_step) const {
  const double time = domain.clock.time;
  for (const Stopper& stopper : stoppers_) {
    const model::RigidBodyStopper& given = stopper.given;
    if (time < given.birth_time || time >= given.death_time) continue;
    domain::RigidBody& body = domain.rigid_bodies[given.body];
    const Vec3 direction = stopper.sign * body.held_axes.column[static_cast<std::size_t>(stopper.axis)];
    const double place = dot(body.centre, direction);
    const double velocity = dot(body.velocity, direction);
    // Velocity with which the centre is on the bound at n+1; of one that is beyond already that of the bound,
    // as to bring it back within a step would throw it.
    const auto towards = [&](const Bound& bound, int side) {
      if (bound.curve == no_index) return side * std::numeric_limits<double>::max();
      const double now = bound_at(stopper, bound, time);
      const double next = bound_at(stopper, bound, time + next_step);
      return (next - (is_beyond(place, now, side) ? now : place)) / next_step;
    };
    double most = towards(given.largest, 1);
    double least = towards(given.smallest, -1);
    if (given.speed_curve != no_index) {
      const double speed = std::fabs(model_->curves[given.speed_curve].at(time + 0.5 * next_step));
      most = std::min(most, speed);
      least = std::max(least, -speed);
    }
    const double bounded = std::max(least, std::min(most, velocity));
    if (bounded != velocity) hold_translation(body, stopper.axis, stopper.sign * bounded);
  }
}

}  // namespace crumple::constraints
