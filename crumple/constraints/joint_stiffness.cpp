// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/joint_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/stopwatch.hpp"
#include "math/arctangent.hpp"
#include "math/to_vec3.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::RigidBody;
using math::Matrix3;

namespace {

/// With theta near a right angle phi and psi are about the same axis: moments grow no further from here.
constexpr double least_cosine = 0.05;

/// The turn nearest to the last one.
double unwrapped(double angle, double last) {
  constexpr double full = 2 * std::numbers::pi;
  return angle + full * std::round((last - angle) / full);
}

/// A spring from `slip` on that gives way at the limit, taking `slip` with it.
double friction_force(const model::Model& model, const model::JointResistance& resistance, double position,
                      double& slip) {
  const double limit = resistance.friction_curve == no_index
                           ? resistance.friction
                           : std::fabs(model.curves[resistance.friction_curve].at(position));
  if (!(resistance.stiffness > 0) || (resistance.friction_curve == no_index && !(limit > 0))) return 0;
  const double trial = resistance.stiffness * (position - slip);
  const double force = std::clamp(trial, -limit, limit);
  slip += (trial - force) / resistance.stiffness;
  return force;
}

/// Steepest slope of a curve, 0 without one.
double largest_slope(const model::Model& model, Index curve) {
  if (curve == no_index) return 0;
  const model::Curve& points = model.curves[curve];
  double largest = 0;
  for (std::size_t i = 1; i < points.abscissa.size(); ++i)
    largest = std::max(largest, std::fabs((points.ordinate[i] - points.ordinate[i - 1]) /
                                          (points.abscissa[i] - points.abscissa[i - 1])));
  return largest;
}

}  // namespace

JointStiffnesses::JointStiffnesses(const model::Model& model, Domain& domain)
    : model_(&model), joints_of_body_(domain.rigid_bodies.size(), 0) {
  for (const model::JointStiffness& given : model.joint_stiffnesses) {
    Frames frames;
    frames.body = given.body;
    for (std::size_t side = 0; side < 2; ++side) {
      const RigidBody& body = domain.rigid_bodies[given.body[side]];
      for (std::size_t axis = 0; axis < 3; ++axis)
        frames.axes[side].column[axis] = turned_back(body, math::to_vec3(given.axes[side][axis]));
      frames.origin[side] = arm_in(body, math::to_vec3(given.origin[side]));
    }
    for (const Index body : frames.body) ++joints_of_body_[body];
    frames_.push_back(frames);
    domain.joint_stiffnesses.push_back({.id = given.id});
    memory_.emplace_back();
    const std::array<double, 3> start = coordinates(domain, frames_.size() - 1).position;
    memory_.back().position = memory_.back().slip = start;
  }
}

/// Stable are (omega dt)^2 + 2 c w dt < 4, with the stiffness and the damping of all coordinates of a joint
/// as if they were the largest; half of that is used. Each body lends its inertia to all of its joints in
/// equal parts.
void JointStiffnesses::set_longest_step(const Domain& domain) {
  longest_step_ = std::numeric_limits<double>::infinity();
  for (std::size_t at = 0; at < frames_.size(); ++at) {
    const model::JointStiffness& given = model_->joint_stiffnesses[at];
    const Vec3 place = place_of(domain.rigid_bodies[frames_[at].body[1]], frames_[at].origin[1]);
    double response = 0;
    for (const Index index : frames_[at].body) {
      const RigidBody& body = domain.rigid_bodies[index];
      response += joints_of_body_[index] * (given.is_translational ? point_response(body, arm_in(body, place))
                                                                   : turning_response(body));
    }
    double stiffness = 0;
    double damping = 0;
    for (const model::JointResistance& each : given.resistance) {
      stiffness = std::max(stiffness, 2 * each.stiffness + largest_slope(*model_, each.curve));
      damping = std::max(damping, largest_slope(*model_, each.damping_curve));
    }
    const double rate = damping * response;
    const double square = stiffness * response;
    if (rate + square > 0)
      longest_step_ = std::min(longest_step_, 2 / (rate + std::sqrt(rate * rate + 2 * square)));
  }
}

JointStiffnesses::Coordinates JointStiffnesses::coordinates(const Domain& domain, std::size_t at) const {
  const Frames& frames = frames_[at];
  const JointBodies body = bodies_of(domain, frames.body);
  const Matrix3 a = turned(*body[0], frames.axes[0]);
  const Matrix3 b = turned(*body[1], frames.axes[1]);
  Coordinates now;
  now.place = place_of(*body[1], frames.origin[1]);
  if (model_->joint_stiffnesses[at].is_translational) {
    const Vec3 away = now.place - place_of(*body[0], frames.origin[0]);
    const Vec3 rate = velocity_of(*body[1], now.place) - velocity_of(*body[0], now.place);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      now.position[axis] = dot(a.column[axis], away);
      now.rate[axis] = dot(a.column[axis], rate);
      now.direction[axis] = a.column[axis];
    }
    return now;
  }
  const Vec3& z = b.column[2];
  const double sine = dot(a.column[0], z);
  const Vec3 product = cross(z, a.column[0]);
  const double cosine = norm(product);
  now.position = {
      unwrapped(math::arctangent(-dot(a.column[1], z), dot(a.column[2], z)), memory_[at].position[0]),
      math::arctangent(sine, cosine),
      unwrapped(math::arctangent(-dot(a.column[0], b.column[1]), dot(a.column[0], b.column[0])),
                memory_[at].position[2])};
  // The y axis that has turned with phi, at right angles to x of A and z of B.
  const Vec3 y = cosine > 0 ? (1 / cosine) * product : a.column[1];
  const double inverse = 1 / std::max(cosine, least_cosine);
  now.direction = {inverse * cross(y, z), y, inverse * cross(a.column[0], y)};
  const Vec3 spin = body[1]->angular_velocity - body[0]->angular_velocity;
  for (std::size_t axis = 0; axis < 3; ++axis) now.rate[axis] = dot(now.direction[axis], spin);
  return now;
}

/// Resistance of the curve and of the stops.
double JointStiffnesses::elastic_force(const model::JointResistance& resistance, double position) const {
  double force = resistance.curve == no_index ? 0 : model_->curves[resistance.curve].at(position);
  if (resistance.positive_stop && position > *resistance.positive_stop)
    force += resistance.stiffness * (position - *resistance.positive_stop);
  if (resistance.negative_stop && position < *resistance.negative_stop)
    force += resistance.stiffness * (position - *resistance.negative_stop);
  return force;
}

void JointStiffnesses::add(Domain& domain, std::size_t at) {
  const model::JointStiffness& given = model_->joint_stiffnesses[at];
  const JointBodies body = bodies_of(domain, frames_[at].body);
  domain::JointStiffnessReport& report = domain.joint_stiffnesses[at];
  Memory& memory = memory_[at];
  const Coordinates now = coordinates(domain, at);
  JointLoad elastic;
  JointLoad damping;
  double slipped = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const model::JointResistance& resistance = given.resistance[axis];
    const double before = memory.slip[axis];
    const double friction = friction_force(*model_, resistance, now.position[axis], memory.slip[axis]);
    slipped += friction * (memory.slip[axis] - before);
    report.elastic[axis] = elastic_force(resistance, now.position[axis]) + friction;
    report.damping[axis] = resistance.damping_curve == no_index
                               ? 0
                               : model_->curves[resistance.damping_curve].at(now.rate[axis]);
    const Vec3 push = -report.elastic[axis] * now.direction[axis];
    const Vec3 drag = -report.damping[axis] * now.direction[axis];
    if (given.is_translational) {
      add_force(body, now.place, push, elastic);
      add_force(body, now.place, drag, damping);
    } else {
      add_moment(push, elastic);
      add_moment(drag, damping);
    }
  }
  const double dissipated = -work_of(body, memory.damping, damping, domain.clock.step);
  report.position = memory.position = now.position;
  report.rate = now.rate;
  report.friction_energy += slipped;
  report.energy -= work_of(body, memory.elastic, elastic, domain.clock.step) + slipped;
  report.damping_energy += dissipated;
  domain.energy.damping += dissipated;
  memory.elastic = elastic;
  memory.damping = damping;
  add_to_bodies(domain, frames_[at].body, elastic);
  add_to_bodies(domain, frames_[at].body, damping);
}

void JointStiffnesses::add_forces(Domain& domain) {
  if (frames_.empty()) return;
  const StageTimer timer(domain.times.constraints);
  for (std::size_t at = 0; at < frames_.size(); ++at) add(domain, at);
  set_longest_step(domain);
}

void JointStiffnesses::declare(domain::StateList& list) {
  if (frames_.empty()) return;
  list.add("joint_stiffness_memory", "by item", domain::Entity::RigidBody, 24, std::span(memory_));
}

}  // namespace crumple::constraints
