// SPDX-License-Identifier: BSD-3-Clause
#include "loads/relative_damping.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace crumple::loads {

using math::Vec3;

namespace {

/// Nodes and body move against each other: the rate of that is D (1 + m / M), of turns D (1 + j / J), with
/// mass and inertia of the damped nodes about the centre of the body. Off the centre both act at once, and
/// the largest rate is not above the sum of the two.
double coupling_of(const NodeShares& selection, const domain::Domain& domain, const domain::RigidBody& body) {
  double mass = 0;
  double inertia = 0;
  for (std::size_t k = 0; k < selection.nodes.size(); ++k) {
    const Index node = selection.nodes[k];
    if (!domain.nodes.is_free(node)) continue;
    const Vec3 arm = domain.nodes.position[node] - body.centre;
    mass += selection.share[k] * domain.nodes.mass[node];
    inertia += selection.share[k] * domain.nodes.mass[node] * dot(arm, arm);
  }
  const Vec3& own = body.principal_inertia;
  const double least = std::min({own.x, own.y, own.z});
  return 1 + (body.mass > 0 ? mass / body.mass : 0) + (least > 0 ? inertia / least : 0);
}

}  // namespace

RelativeDampings::RelativeDampings(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  for (const model::RelativeDamping& given : model.relative_dampings) {
    Damping damping;
    damping.given = &given;
    damping.selection = shares_of_parts(domain, given.parts);
    damping.coupling =
        coupling_of(damping.selection, domain, domain.rigid_bodies[static_cast<std::size_t>(given.body)]);
    damping.on_nodes.resize(damping.selection.nodes.size());
    dampings_.push_back(std::move(damping));
  }
}

void RelativeDampings::add_forces(domain::Domain& domain) {
  for (Damping& damping : dampings_) {
    const model::RelativeDamping& given = *damping.given;
    const double share =
        given.curve == no_index ? given.share : model_->curves[given.curve].at(domain.clock.time);
    damping.rate = 4 * std::numbers::pi * share * given.frequency;
    domain.energy.damping += damp(damping, domain);
  }
}

/// Returns what the forces took since time n-1 [energy].
double RelativeDampings::damp(Damping& damping, domain::Domain& domain) {
  domain::NodeFields& nodes = domain.nodes;
  domain::RigidBody& body = domain.rigid_bodies[static_cast<std::size_t>(damping.given->body)];
  const double half_step = 0.5 * domain.clock.step;
  double taken = 0;
  Push reaction;
  for (std::size_t k = 0; k < damping.on_nodes.size(); ++k) {
    const Index node = damping.selection.nodes[k];
    Vec3 now;
    if (nodes.is_free(node)) {
      const Vec3 arm = nodes.position[node] - body.centre;
      const Vec3 relative = nodes.velocity[node] - (body.velocity + cross(body.angular_velocity, arm));
      now = -(damping.rate * damping.selection.share[k] * nodes.mass[node]) * relative;
      for (int axis = 0; axis < 3; ++axis) nodes.force[node].force[axis] += now[axis];
      reaction.force -= now;
      reaction.moment -= cross(arm, now);
    }
    taken -= half_step * dot(damping.on_nodes[k] + now, nodes.velocity[node]);
    damping.on_nodes[k] = now;
  }
  body.force += reaction.force;
  body.moment += reaction.moment;
  taken -= half_step * (dot(damping.on_body.force + reaction.force, body.velocity) +
                        dot(damping.on_body.moment + reaction.moment, body.angular_velocity));
  damping.on_body = reaction;
  return taken;
}

double RelativeDampings::stable_share(double undamped_step) const {
  double rate = 0;
  for (const Damping& damping : dampings_) rate += std::max(0.0, damping.rate) * damping.coupling;
  const double a = 0.25 * rate * undamped_step;
  return std::sqrt(1 + a * a) - a;
}

void RelativeDampings::declare(domain::StateList& list) {
  for (std::size_t i = 0; i < dampings_.size(); ++i) {
    const std::string which = "relative_damping_" + std::to_string(i);
    list.keep_list(which + "_nodes", "force", domain::Entity::Node, 3, dampings_[i].on_nodes);
    list.keep(which + "_body", "force", domain::Entity::RigidBody, dampings_[i].on_body);
  }
}

}  // namespace crumple::loads
