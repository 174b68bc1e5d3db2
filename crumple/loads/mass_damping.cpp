// SPDX-License-Identifier: BSD-3-Clause
#include "loads/mass_damping.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/parallel.hpp"
#include "math/to_vec3.hpp"

namespace crumple::loads {

using math::Vec3;

namespace {

constexpr Index piece = 1024;

Vec3 scaled(const Vec3& a, const Vec3& factors) {
  return {a.x * factors.x, a.y * factors.y, a.z * factors.z};
}

/// The largest factor on a damping along and about the axes.
double largest_factor(const model::MassDamping& damping) {
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    largest = std::max({largest, damping.translation[axis], damping.rotation[axis]});
  return largest;
}

}  // namespace

MassDamping::MassDamping(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  const auto bodies = static_cast<Index>(domain.rigid_bodies.size());
  if (model.mass_damping) {
    Damping all;
    all.given = &*model.mass_damping;
    for (Index body = 0; body < bodies; ++body) all.bodies.push_back(body);
    dampings_.push_back(std::move(all));
  }
  for (const model::MassDamping& given : model.part_dampings) {
    Damping damping;
    damping.given = &given;
    damping.of_all = false;
    damping.selection = shares_of_parts(domain, given.parts);
    for (std::size_t body = 0; body < model.rigid_bodies.size(); ++body)
      if (has_part(model.rigid_bodies[body], given.parts)) damping.bodies.push_back(static_cast<Index>(body));
    dampings_.push_back(std::move(damping));
  }
  for (Damping& damping : dampings_) {
    damping.on_nodes.resize(damping.of_all ? static_cast<std::size_t>(domain.nodes.count())
                                           : damping.selection.nodes.size());
    damping.on_bodies.resize(damping.bodies.size());
  }
}

void MassDamping::relax(const domain::Domain& domain, double share) {
  static const model::MassDamping of_all_motion;
  if (dampings_.empty() || !dampings_.back().lost_in_step) {
    Damping relaxing;
    relaxing.given = &of_all_motion;
    for (std::size_t body = 0; body < domain.rigid_bodies.size(); ++body)
      relaxing.bodies.push_back(static_cast<Index>(body));
    relaxing.on_nodes.resize(static_cast<std::size_t>(domain.nodes.count()));
    relaxing.on_bodies.resize(relaxing.bodies.size());
    dampings_.push_back(std::move(relaxing));
  }
  dampings_.back().lost_in_step = share;
}

/// D(t) at time n [1/time].
double MassDamping::factor_of(const Damping& damping, const domain::Clock& clock) const {
  if (damping.lost_in_step) return clock.step > 0 ? *damping.lost_in_step / clock.step : 0;
  const model::MassDamping& given = *damping.given;
  return given.curve == no_index ? given.constant : given.scale * model_->curves[given.curve].at(clock.time);
}

void MassDamping::add_forces(domain::Domain& domain) {
  for (Damping& damping : dampings_) {
    damping.factor = factor_of(damping, domain.clock);
    domain.energy.damping += damp_nodes(damping, domain) + damp_bodies(damping, domain);
  }
}

/// Returns what the forces on nodes that no rigid body moves took since time n-1 [energy].
double MassDamping::damp_nodes(Damping& damping, domain::Domain& domain) {
  domain::NodeFields& nodes = domain.nodes;
  const Vec3 along = damping.factor * math::to_vec3(damping.given->translation);
  const Vec3 about = damping.factor * math::to_vec3(damping.given->rotation);
  const double half_step = 0.5 * domain.clock.step;
  const auto count = static_cast<Index>(damping.on_nodes.size());
  taken_.assign(static_cast<std::size_t>(pieces(count, piece)), 0.0);
  parallel_for(pieces(count, piece), domain.execution.threads, [&](Index p) {
    double taken = 0;
    for (Index k = p * piece; k < std::min((p + 1) * piece, count); ++k) {
      const auto place = static_cast<std::size_t>(k);
      const Index i = damping.of_all ? k : damping.selection.nodes[place];
      if (!nodes.is_free(i)) continue;
      const double share = damping.of_all ? 1.0 : damping.selection.share[place];
      const Push now{-(share * nodes.mass[i]) * scaled(nodes.velocity[i], along),
                     -(share * nodes.inertia[i]) * scaled(nodes.angular_velocity[i], about)};
      for (int axis = 0; axis < 3; ++axis) {
        nodes.force[i].force[axis] += now.force[axis];
        nodes.force[i].moment[axis] += now.moment[axis];
      }
      Push& last = damping.on_nodes[place];
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
double MassDamping::damp_bodies(Damping& damping, domain::Domain& domain) {
  const Vec3 along = damping.factor * math::to_vec3(damping.given->translation);
  const Vec3 about = damping.factor * math::to_vec3(damping.given->rotation);
  double sum = 0;
  for (std::size_t i = 0; i < damping.bodies.size(); ++i) {
    domain::RigidBody& body = domain.rigid_bodies[damping.bodies[i]];
    if (!body.active) continue;
    const Push now{-body.mass * scaled(body.velocity, along), -1.0 * scaled(body.angular_momentum, about)};
    body.force += now.force;
    body.moment += now.moment;
    Push& last = damping.on_bodies[i];
    sum -=
        0.5 * domain.clock.step *
        (dot(last.force + now.force, body.velocity) + dot(last.moment + now.moment, body.angular_velocity));
    last = now;
  }
  return sum;
}

/// The mean of the dampings at a node, which its mass weighs, is no larger than the largest of a part.
double MassDamping::stable_share(double undamped_step) {
  if (dampings_.empty()) return 1;
  double of_all = 0;
  double of_parts = 0;
  rate_of_part_.assign(model_->part_dampings.empty() ? 0 : model_->parts.size(), 0.0);
  for (const Damping& damping : dampings_) {
    const double rate = std::max(0.0, damping.factor) * largest_factor(*damping.given);
    if (damping.of_all) {
      of_all += rate;
      continue;
    }
    for (const Index part : damping.given->parts)
      of_parts = std::max(of_parts, rate_of_part_[static_cast<std::size_t>(part)] += rate);
  }
  const double a = 0.25 * (of_all + of_parts) * undamped_step;
  return std::sqrt(1 + a * a) - a;
}

void MassDamping::declare(domain::StateList& list) {
  for (std::size_t i = 0; i < dampings_.size(); ++i) {
    // Several have the number of each in their names, apart from that of all.
    const std::string which = dampings_[i].lost_in_step ? "relaxation"
                              : dampings_[i].of_all     ? "mass_damping"
                                                        : "part_damping_" + std::to_string(i);
    list.keep_list(which + "_nodes", "force", domain::Entity::Node, 6, dampings_[i].on_nodes);
    list.keep_list(which + "_bodies", "force", domain::Entity::RigidBody, 6, dampings_[i].on_bodies);
  }
}

}  // namespace crumple::loads
