// SPDX-License-Identifier: BSD-3-Clause
#include "loads/mass_damping.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "math/to_vec3.hpp"

namespace crumple::loads {

using math::Vec3;

namespace {

constexpr Index piece = 1024;

Vec3 scaled(const Vec3& a, const Vec3& factors) {
  return {a.x * factors.x, a.y * factors.y, a.z * factors.z};
}

}  // namespace

void MassDamping::add_forces(domain::Domain& domain) {
  if (!model_->mass_damping) return;
  const model::MassDamping& damping = *model_->mass_damping;
  factor_ =
      damping.curve == no_index ? damping.constant : model_->curves[damping.curve].at(domain.clock.time);
  on_nodes_.resize(static_cast<std::size_t>(domain.nodes.count()));
  on_bodies_.resize(domain.rigid_bodies.size());
  domain.energy.damping += damp_nodes(domain) + damp_bodies(domain);
}

/// Returns what the forces on nodes that no rigid body moves took since time n-1 [energy].
double MassDamping::damp_nodes(domain::Domain& domain) {
  domain::NodeFields& nodes = domain.nodes;
  const Vec3 along = factor_ * math::to_vec3(model_->mass_damping->translation);
  const Vec3 about = factor_ * math::to_vec3(model_->mass_damping->rotation);
  const double half_step = 0.5 * domain.clock.step;
  taken_.assign(static_cast<std::size_t>(pieces(nodes.count(), piece)), 0.0);
  parallel_for(pieces(nodes.count(), piece), domain.execution.threads, [&](Index p) {
    double taken = 0;
    for (Index i = p * piece; i < std::min((p + 1) * piece, nodes.count()); ++i) {
      if (!nodes.is_free(i)) continue;
      const Push now{-nodes.mass[i] * scaled(nodes.velocity[i], along),
                     -nodes.inertia[i] * scaled(nodes.angular_velocity[i], about)};
      for (int axis = 0; axis < 3; ++axis) {
        nodes.force[i].force[axis] += now.force[axis];
        nodes.force[i].moment[axis] += now.moment[axis];
      }
      Push& last = on_nodes_[static_cast<std::size_t>(i)];
      taken -= half_step * (dot(last.force + now.force, nodes.velocity[i]) +
                            dot(last.moment + now.moment, nodes.angular_velocity[i]));
      last = now;
    }
    taken_[static_cast<std::size_t>(p)] = taken;
  });
  double sum = 0;
  for (const double part : taken_) sum += part;
  return sum;
}

/// The same of rigid bodies.
double MassDamping::damp_bodies(domain::Domain& domain) {
  const Vec3 along = factor_ * math::to_vec3(model_->mass_damping->translation);
  const Vec3 about = factor_ * math::to_vec3(model_->mass_damping->rotation);
  double sum = 0;
  for (std::size_t i = 0; i < domain.rigid_bodies.size(); ++i) {
    domain::RigidBody& body = domain.rigid_bodies[i];
    if (!body.active) continue;
    const Push now{-body.mass * scaled(body.velocity, along), -1.0 * scaled(body.angular_momentum, about)};
    body.force += now.force;
    body.moment += now.moment;
    sum -= 0.5 * domain.clock.step *
           (dot(on_bodies_[i].force + now.force, body.velocity) +
            dot(on_bodies_[i].moment + now.moment, body.angular_velocity));
    on_bodies_[i] = now;
  }
  return sum;
}

double MassDamping::stable_share(double undamped_step) const {
  if (!model_->mass_damping) return 1;
  const model::MassDamping& damping = *model_->mass_damping;
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, damping.translation[axis], damping.rotation[axis]});
  const double a = 0.25 * std::max(0.0, factor_) * largest * undamped_step;
  return std::sqrt(1 + a * a) - a;
}

void MassDamping::declare(domain::StateList& list) {
  if (!model_->mass_damping) return;
  list.keep_list("mass_damping_nodes", "force", domain::Entity::Node, 6, on_nodes_);
  list.keep_list("mass_damping_bodies", "force", domain::Entity::RigidBody, 6, on_bodies_);
}

}  // namespace crumple::loads
