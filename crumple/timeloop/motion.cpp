// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/motion.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"

namespace crumple::timeloop {
namespace {

using domain::NodeFields;
using math::Vec3;

constexpr Index piece = 1024;

/// Sums sum_of(first, last) over fixed pieces of [0, count), the pieces in order.
template <class SumOf>
double ordered_sum(Index count, int threads, const SumOf& sum_of) {
  std::vector<double> sums(pieces(count, piece));
  parallel_for(static_cast<Index>(sums.size()), threads,
               [&](Index p) { sums[p] = sum_of(p * piece, std::min((p + 1) * piece, count)); });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

Vec3 held(const Vec3& velocity, unsigned fixed_axes) {
  return {(fixed_axes & 1U) != 0 ? 0.0 : velocity.x, (fixed_axes & 2U) != 0 ? 0.0 : velocity.y,
          (fixed_axes & 4U) != 0 ? 0.0 : velocity.z};
}

/// Kicks one node; returns twice its rotational energy.
double accelerate_node(NodeFields& nodes, Index i, Vec3& previous_velocity, double interval) {
  domain::NodeForce& force = nodes.force[i];
  const double mass = nodes.mass[i];
  const double inertia = nodes.inertia[i];
  const double per_mass = mass > 0 ? 1.0 / mass : 0.0;
  const double per_inertia = inertia > 0 ? 1.0 / inertia : 0.0;
  const unsigned fixed = nodes.fixed[i];
  const Vec3 acceleration = held(per_mass * Vec3{force.force[0], force.force[1], force.force[2]}, fixed & 7U);
  const Vec3 spin = per_inertia * Vec3{force.moment[0], force.moment[1], force.moment[2]};
  const Vec3 previous_spin = nodes.angular_velocity[i];
  previous_velocity = nodes.velocity[i];
  nodes.acceleration[i] = acceleration;
  nodes.velocity[i] += interval * acceleration;
  nodes.angular_velocity[i] = held(previous_spin + interval * spin, fixed >> 3U);
  force = domain::NodeForce{};
  return inertia * dot(previous_spin, nodes.angular_velocity[i]);
}

}  // namespace

void move_nodes(domain::Domain& domain, double step) {
  NodeFields& nodes = domain.nodes;
  const Index count = nodes.count();
  parallel_for(pieces(count, piece), domain.execution.threads, [&](Index p) {
    for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) {
      nodes.position[i] += step * nodes.velocity[i];
      nodes.publish(i);
    }
  });
}

double accelerate_nodes(domain::Domain& domain, AlignedArray<Vec3>& previous_velocity, double interval) {
  NodeFields& nodes = domain.nodes;
  return 0.5 * ordered_sum(nodes.count(), domain.execution.threads, [&](Index first, Index last) {
           double sum = 0;
           for (Index i = first; i < last; ++i)
             sum += accelerate_node(nodes, i, previous_velocity[i], interval);
           return sum;
         });
}

double kinetic_energy(const domain::Domain& domain, const AlignedArray<Vec3>& previous_velocity,
                      const AlignedArray<Vec3>& velocity) {
  const NodeFields& nodes = domain.nodes;
  return 0.5 * ordered_sum(nodes.count(), domain.execution.threads, [&](Index first, Index last) {
           double sum = 0;
           for (Index i = first; i < last; ++i) sum += nodes.mass[i] * dot(previous_velocity[i], velocity[i]);
           return sum;
         });
}

double rotational_energy(const domain::Domain& domain) {
  const NodeFields& nodes = domain.nodes;
  return 0.5 * ordered_sum(nodes.count(), domain.execution.threads, [&](Index first, Index last) {
           double sum = 0;
           for (Index i = first; i < last; ++i)
             sum += nodes.inertia[i] * dot(nodes.angular_velocity[i], nodes.angular_velocity[i]);
           return sum;
         });
}

}  // namespace crumple::timeloop
