// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/motion.hpp"

#include <algorithm>
#include <vector>

#include "base/isa_variants.hpp"
#include "base/parallel.hpp"

namespace crumple::timeloop {
namespace {

using domain::NodeFields;
using math::Vec3;

constexpr Index piece = 1024;

/// Calls work(p, range) for fixed pieces of [0, count).
template <class Work>
void for_each_piece(Index count, int threads, const Work& work) {
  parallel_for(pieces(count, piece), threads, [&](Index p) {
    work(p, NodeRange{p * piece, std::min((p + 1) * piece, count)});
  });
}

/// Sums sum_of(range) over fixed pieces of [0, count), the pieces in order.
template <class SumOf>
double ordered_sum(Index count, int threads, const SumOf& sum_of) {
  std::vector<double> sums(pieces(count, piece));
  for_each_piece(count, threads, [&](Index p, NodeRange range) { sums[p] = sum_of(range); });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

}  // namespace

NodeKernels node_kernels(Isa isa) {
  return visit_isa(isa, []<Isa Variant>() { return node_kernels<Variant>(); });
}

VelocityRange move_nodes(domain::Domain& domain, double step) {
  const NodeKernels kernels = node_kernels(domain.execution.isa);
  const Index count = domain.nodes.count();
  std::vector<VelocityRange> ranges(pieces(count, piece));
  for_each_piece(count, domain.execution.threads,
                 [&](Index p, NodeRange range) { ranges[p] = kernels.drift(domain.nodes, range, step); });
  VelocityRange all;
  for (const VelocityRange& range : ranges) all.include(range);
  return all;
}

KickSums accelerate_nodes(domain::Domain& domain, const Kick& kick) {
  const NodeKernels kernels = node_kernels(domain.execution.isa);
  const Index count = domain.nodes.count();
  std::vector<KickSums> sums(pieces(count, piece));
  for_each_piece(count, domain.execution.threads,
                 [&](Index p, NodeRange range) { sums[p] = kernels.kick(domain.nodes, range, kick); });
  KickSums total;
  for (const KickSums& sum : sums) {
    total.translational += sum.translational;
    total.rotational += sum.rotational;
    total.fastest = std::max(total.fastest, sum.fastest);
  }
  return total;
}

double kinetic_energy(const domain::Domain& domain, const AlignedArray<Vec3>& previous_velocity,
                      const AlignedArray<Vec3>& velocity) {
  const NodeFields& nodes = domain.nodes;
  return 0.5 * ordered_sum(nodes.count(), domain.execution.threads, [&](NodeRange range) {
           double sum = 0;
           for (Index i = range.first; i < range.last; ++i)
             if (nodes.is_free(i)) sum += nodes.mass[i] * dot(previous_velocity[i], velocity[i]);
           return sum;
         });
}

double rotational_energy(const domain::Domain& domain) {
  const NodeFields& nodes = domain.nodes;
  return 0.5 * ordered_sum(nodes.count(), domain.execution.threads, [&](NodeRange range) {
           double sum = 0;
           for (Index i = range.first; i < range.last; ++i)
             if (nodes.is_free(i))
               sum += nodes.inertia[i] * dot(nodes.angular_velocity[i], nodes.angular_velocity[i]);
           return sum;
         });
}

}  // namespace crumple::timeloop
