// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/prescribed_motion.hpp"

#include <string>

#include "base/error.hpp"
#include "constraints/rigid_motion.hpp"

namespace crumple::constraints {

using domain::Domain;
using model::PrescribedMotion;

PrescribedMotions::PrescribedMotions(const model::Model& model, const Domain& domain) : model_(&model) {
  motions_.reserve(model.prescribed_motions.size());
  const std::vector<char> local = nodes_with_local_constraints(model);
  for (const PrescribedMotion& given : model.prescribed_motions) {
    if (given.node != no_index && local[static_cast<std::size_t>(given.node)] != 0) continue;
    Motion motion{given, given.node == no_index ? no_index : domain.nodes.domain_node[given.node], 0};
    if (motion.node != no_index && !domain.nodes.is_free(motion.node))
      throw Error("The motion of node " + std::to_string(model.nodes.id[given.node]) +
                  " is prescribed, but a rigid body moves it.");
    motions_.push_back(motion);
  }
  deferred_.assign(motions_.size(), 0.0);
}

void PrescribedMotions::remember(const Domain& domain) {
  for (Motion& motion : motions_) {
    if (motion.node == no_index) continue;
    const auto& velocity = motion.given.rotation ? domain.nodes.angular_velocity : domain.nodes.velocity;
    motion.before = velocity[motion.node][motion.given.axis];
  }
}

double prescribed_velocity(const PrescribedMotion& motion, const model::Curve& curve,
                           const MotionTimes& times, double before) {
  const double since = times.time - motion.birth;
  switch (motion.kind) {
    case PrescribedMotion::Kind::Velocity:
      return motion.scale * curve.at(since + 0.5 * times.next_step);
    case PrescribedMotion::Kind::Acceleration:
      return before + times.interval * motion.scale * curve.at(since);
    case PrescribedMotion::Kind::Displacement:
      return motion.scale * (curve.at(since + times.next_step) - curve.at(since)) / times.next_step;
  }
  return 0;
}

double PrescribedMotions::impose_on_node(Domain& domain, std::size_t place, double target) {
  const Motion& motion = motions_[place];
  domain::NodeFields& nodes = domain.nodes;
  const bool rotation = motion.given.rotation;
  double& present = (rotation ? nodes.angular_velocity : nodes.velocity)[motion.node][motion.given.axis];
  const double impulse =
      (rotation ? nodes.moving_inertia(motion.node) : nodes.moving_mass(motion.node)) * (target - present);
  present = target;
  const double work = 0.5 * impulse * motion.before;
  domain.energy.external_work += work;
  deferred_[place] = 0.5 * impulse * target;
  return work;
}

KineticChange PrescribedMotions::impose(Domain& domain, double interval, double next_step) {
  const double time = domain.clock.time;
  const MotionTimes times{time, interval, next_step};
  KineticChange change;
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    Motion& motion = motions_[i];
    const PrescribedMotion& given = motion.given;
    domain.energy.external_work += deferred_[i];
    deferred_[i] = 0;
    if (time < given.birth || time >= given.death) continue;
    const model::Curve& curve = model_->curves[given.curve];
    if (motion.node != no_index) {
      (given.rotation ? change.rotational : change.translational) +=
          impose_on_node(domain, i, prescribed_velocity(given, curve, times, motion.before));
      continue;
    }
    domain::RigidBody& body = domain.rigid_bodies[given.body];
    motion.before = dot(body.held_axes.column[static_cast<std::size_t>(given.axis)],
                        given.rotation ? body.previous_spin : body.previous_velocity);
    const double target = prescribed_velocity(given, curve, times, motion.before);
    if (given.rotation)
      hold_rotation(body, given.axis, target);
    else
      hold_translation(body, given.axis, target);
  }
  return change;
}

void PrescribedMotions::declare(domain::StateList& list) {
  list.add("prescribed_deferred_work", "energy", domain::Entity::Run, 1, std::span(deferred_));
}

}  // namespace crumple::constraints
