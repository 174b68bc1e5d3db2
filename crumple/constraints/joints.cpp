// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/joints.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/stopwatch.hpp"

namespace crumple::constraints {

using domain::Domain;
using domain::RigidBody;
using math::Matrix3;
using model::JointKind;

namespace {

/// (omega dt)^2 of a spring whose stiffness has a factor of 1 (RPS), by the bound on its effective mass: some
/// thirty steps in a period at least.
constexpr double usual_budget = 0.04;

/// The same at most, beyond which RPS has no effect. Central differences allow 4; damping with the velocity
/// of half a step ago, and contacts at the same bodies, need their part.
constexpr double largest_budget = 0.8;

/// Damping over mass times the step at most [-]: with it (omega dt)^2 may be 2.
constexpr double largest_damping = 1.0;

/// What is held of a vector.
Vec3 held_part(const Vec3& vector, const Matrix3& axes, const std::array<bool, 3>& held) {
  if (all_of(held)) return vector;
  Vec3 part;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (held[axis]) part += dot(vector, axes.column[axis]) * axes.column[axis];
  return part;
}

/// The global axis that is furthest from a direction.
Vec3 furthest_axis(const Vec3& direction) {
  int furthest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::fabs(direction[axis]) < std::fabs(direction[furthest])) furthest = axis;
  Vec3 unit;
  unit[furthest] = 1;
  return unit;
}

}  // namespace

Joints::Joints(const model::Model& model, Domain& domain) : step_scale_(model.control.step_scale) {
  springs_of_body_.assign(domain.rigid_bodies.size(), 0);
  joints_.reserve(model.joints.size());
  for (const model::Joint& given : model.joints) {
    Joint joint;
    joint.stiffness_scale = given.stiffness_scale;
    joint.damping = given.damping;
    for (std::size_t side = 0; side < 2; ++side) {
      const Index node = domain.nodes.domain_node[given.node[side]];
      joint.body[side] = domain.body_of_node.empty() ? no_index : domain.body_of_node[node];
      if (joint.body[side] == no_index)
        throw Error("Joint " + std::to_string(given.id) + ": node " +
                    std::to_string(model.nodes.id[given.node[side]]) + " belongs to no rigid body.");
    }
    const JointBodies body = bodies_of(domain, joint.body);
    std::array<Vec3, 6> place{};
    for (std::size_t i = 0; i < model::node_count(given.kind); ++i)
      place[i] = domain.nodes.position[domain.nodes.domain_node[given.node[i]]];
    joint.point = arm_in(*body[0], place[0]);
    if (given.kind == JointKind::Cylindrical || given.kind == JointKind::Translational)
      add_sliding_springs(place, given.kind, body, joint);
    else
      add_springs(place, given.kind, body, joint);
    joint.first_spring = penalty_.size();
    penalty_.resize(penalty_.size() + joint.springs.size(), 0);
    for (const Index each : joint.body) springs_of_body_[each] += static_cast<Index>(joint.springs.size());
    domain.joints.push_back({.id = given.id});
    joints_.push_back(std::move(joint));
  }
  previous_.resize(2 * joints_.size());
}

/// Nodes that should be at one place, or on the axis, may be apart a little: B carries the place where its
/// node should be.
void Joints::add_springs(const Places& place, JointKind kind, const JointBodies& body, Joint& joint) {
  const auto hold = [&](std::size_t node) {
    Spring spring;
    spring.first = arm_in(*body[0], place[node]);
    spring.second = arm_in(*body[1], place[node]);
    joint.springs.push_back(spring);
  };
  hold(0);
  if (kind == JointKind::Revolute || kind == JointKind::Locking) hold(2);
  if (kind == JointKind::Locking) hold(4);
  if (kind != JointKind::Universal) return;
  const Vec3 first = normalised(place[2] - place[0]);
  const Vec3 second = normalised(place[3] - place[1]);
  Spring spring;
  spring.is_direction = true;
  spring.first = turned_back(*body[0], first);
  spring.second = turned_back(*body[1], second);
  spring.cosine = dot(first, second);
  joint.springs.push_back(spring);
}

/// The axis is the first of the directions that A carries, the third is across the plane of N5.
void Joints::add_sliding_springs(const Places& place, JointKind kind, const JointBodies& body, Joint& joint) {
  const bool is_guided = kind == JointKind::Translational;
  const Vec3 axis = normalised(place[2] - place[0]);
  Vec3 side = is_guided ? place[4] - place[0] : furthest_axis(axis);
  side = normalised(side - dot(side, axis) * axis);
  const Matrix3 axes{{axis, side, cross(axis, side)}};
  const auto hold = [&](std::size_t node, std::array<bool, 3> held) {
    Spring spring;
    for (std::size_t i = 0; i < 3; ++i) spring.axes.column[i] = turned_back(*body[0], axes.column[i]);
    spring.held = held;
    spring.first = joint.point;
    spring.second = arm_in(*body[1], place[node] - held_part(place[node] - place[0], axes, held));
    joint.springs.push_back(spring);
  };
  hold(1, {false, true, true});
  hold(3, {false, true, true});
  if (is_guided) hold(5, {false, false, true});
}

/// Bound on the inverse of the effective mass of a spring, each body lending its mass divided by the number
/// of springs at it: with k of each at most b / (dt^2 w), no frequency of all together is above sqrt(b) / dt.
/// A point is at its place on both bodies, which on A may slide.
double Joints::inverse_mass(const Domain& domain, const Joint& joint, const Spring& spring) const {
  double sum = 0;
  const Vec3 place = place_of(domain.rigid_bodies[joint.body[1]], spring.second);
  for (const Index index : joint.body) {
    const RigidBody& body = domain.rigid_bodies[index];
    sum += springs_of_body_[index] *
           (spring.is_direction ? turning_response(body) : point_response(body, arm_in(body, place)));
  }
  return sum;
}

void Joints::set_penalties(const Domain& domain, double step) {
  for (const Joint& joint : joints_)
    for (std::size_t i = 0; i < joint.springs.size(); ++i) {
      const double inverse = inverse_mass(domain, joint, joint.springs[i]);
      penalty_[joint.first_spring + i] =
          inverse > 0 ? joint.stiffness_scale * usual_budget / (step * step * inverse) : 0;
    }
}

Joints::Loads Joints::evaluate(const Domain& domain, const Joint& joint, double step) const {
  const JointBodies body = bodies_of(domain, joint.body);
  Loads loads;
  for (std::size_t i = 0; i < joint.springs.size(); ++i) {
    const Spring& spring = joint.springs[i];
    const double inverse = inverse_mass(domain, joint, spring);
    if (!(inverse > 0)) continue;
    const double stiffness =
        std::min(penalty_[joint.first_spring + i], largest_budget / (step * step * inverse));
    const double damping =
        std::min(joint.damping * 2 * std::sqrt(stiffness / inverse), largest_damping / (step * inverse));
    if (spring.is_direction) {
      const Vec3 a = math::matrix_of(body[0]->turn) * spring.first;
      const Vec3 b = math::matrix_of(body[1]->turn) * spring.second;
      const Vec3 about = cross(b, a);
      add_moment(-stiffness * (dot(a, b) - spring.cosine) * about, loads.elastic);
      add_moment(-damping * dot(body[1]->angular_velocity - body[0]->angular_velocity, about) * about,
                 loads.damping);
      continue;
    }
    const Vec3 place = place_of(*body[1], spring.second);
    const Matrix3 axes = turned(*body[0], spring.axes);
    const Vec3 away = held_part(place - place_of(*body[0], spring.first), axes, spring.held);
    const Vec3 rate =
        held_part(velocity_of(*body[1], place) - velocity_of(*body[0], place), axes, spring.held);
    add_force(body, place, -stiffness * away, loads.elastic);
    add_force(body, place, -damping * rate, loads.damping);
    loads.opening = std::max(loads.opening, norm(away));
  }
  return loads;
}

void Joints::add_forces(Domain& domain) {
  if (joints_.empty()) return;
  const StageTimer timer(domain.times.constraints);
  const double step = std::max(domain.clock.step, step_scale_ * domain.clock.element_limit);
  if (domain.clock.cycle == 0) set_penalties(domain, step);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const JointBodies body = bodies_of(domain, joint.body);
    const Loads now = evaluate(domain, joint, step);
    domain::JointReport& report = domain.joints[i];
    report.energy -= work_of(body, previous_[2 * i], now.elastic, domain.clock.step);
    const double dissipated = -work_of(body, previous_[2 * i + 1], now.damping, domain.clock.step);
    report.damping_energy += dissipated;
    domain.energy.damping += dissipated;
    report.force = now.elastic.force + now.damping.force;
    const Vec3 arm = place_of(*body[0], joint.point) - body[0]->centre;
    report.moment = now.elastic.moment[0] + now.damping.moment[0] - cross(arm, report.force);
    report.opening = now.opening;
    add_to_bodies(domain, joint.body, now.elastic);
    add_to_bodies(domain, joint.body, now.damping);
    previous_[2 * i] = now.elastic;
    previous_[2 * i + 1] = now.damping;
  }
}

void Joints::declare(domain::StateList& list) {
  if (joints_.empty()) return;
  list.keep_list("joint_penalties", "force/length", domain::Entity::RigidBody, 1, penalty_);
  list.add("joint_loads", "force", domain::Entity::RigidBody, 9, std::span(previous_));
}

}  // namespace crumple::constraints
