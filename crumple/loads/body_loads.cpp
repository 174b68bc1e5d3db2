// SPDX-License-Identifier: BSD-3-Clause
#include "loads/body_loads.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "math/to_vec3.hpp"

namespace crumple::loads {

using math::Vec3;

namespace {

constexpr Index piece = 1024;

/// Adds -m a to every node that no rigid body moves; returns the momentum of these nodes. `momenta` is room
/// for that of each piece.
Vec3 push_nodes(domain::NodeFields& nodes, const Vec3& acceleration, int threads,
                std::vector<Vec3>& momenta) {
  momenta.assign(static_cast<std::size_t>(pieces(nodes.count(), piece)), Vec3{});
  parallel_for(pieces(nodes.count(), piece), threads, [&](Index p) {
    for (Index i = p * piece; i < std::min((p + 1) * piece, nodes.count()); ++i) {
      if (!nodes.is_free(i)) continue;
      for (int axis = 0; axis < 3; ++axis) nodes.force[i].force[axis] -= nodes.mass[i] * acceleration[axis];
      momenta[p] += nodes.mass[i] * nodes.velocity[i];
    }
  });
  Vec3 total;
  for (const Vec3& momentum : momenta) total += momentum;
  return total;
}

}  // namespace

void BodyLoads::add_forces(domain::Domain& domain) {
  if (model_->body_loads.empty()) return;
  Vec3 acceleration;
  for (const model::BodyLoad& load : model_->body_loads)
    acceleration[load.axis] += load.scale * model_->curves[load.curve].at(domain.clock.time);
  Vec3 momentum = push_nodes(domain.nodes, acceleration, domain.execution.threads, momenta_);
  for (domain::RigidBody& body : domain.rigid_bodies) {
    if (!body.active) continue;
    body.force -= body.mass * acceleration;
    momentum += body.mass * body.velocity;
  }
  domain.energy.external_work -= 0.5 * domain.clock.step * dot(previous_ + acceleration, momentum);
  previous_ = acceleration;
}

void RigidBodyLoads::add_forces(domain::Domain& domain) {
  for (std::size_t i = 0; i < previous_.size(); ++i) {
    const model::RigidBodyLoad& load = model_->rigid_body_loads[i];
    if (load.plane.given()) continue;  // FollowerLoads
    domain::RigidBody& body = domain.rigid_bodies[load.body];
    const double factor = model_->curves[load.curve].at(domain.clock.time);
    const Vec3 force = math::to_vec3(load.force);
    const Vec3 moment = math::to_vec3(load.moment);
    body.force += factor * force;
    body.moment += factor * moment;
    const double rate = dot(force, body.velocity) + dot(moment, body.angular_velocity);
    domain.energy.external_work += 0.5 * domain.clock.step * (previous_[i] + factor) * rate;
    previous_[i] = factor;
  }
}

void BodyLoads::declare(domain::StateList& list) {
  list.keep("body_load", "length/time^2", domain::Entity::Run, previous_);
}

void RigidBodyLoads::declare(domain::StateList& list) {
  list.keep_list("rigid_body_loads", "-", domain::Entity::RigidBody, 1, previous_);
}

}  // namespace crumple::loads
