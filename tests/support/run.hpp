// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "timeloop/simulation.hpp"

namespace crumple::test {

/// Double precision, one thread, and the instruction set that CRUMPLE_ISA names or the fastest there is.
inline domain::Execution execution() {
  return {Precision::Double, default_isa(), 1};
}

/// Runs to the model's end time; calls `watch` at time zero and after every step.
inline void run(
    timeloop::Simulation& simulation,
    const std::function<void(const domain::Domain&)>& watch = [](const domain::Domain&) {}) {
  simulation.start();
  watch(simulation.domain());
  while (!simulation.finished()) {
    simulation.step();
    watch(simulation.domain());
  }
}

/// Displacement of a model node [length].
inline math::Vec3 displacement(const domain::Domain& domain, Index model_node) {
  const Index node = domain.nodes.domain_node[model_node];
  return domain.nodes.position[node] - domain.nodes.reference[node];
}

/// Momentum of all nodes [mass * length/time].
inline math::Vec3 momentum(const domain::Domain& domain) {
  math::Vec3 sum;
  for (Index i = 0; i < domain.nodes.count(); ++i) sum += domain.nodes.mass[i] * domain.nodes.velocity[i];
  return sum;
}

}  // namespace crumple::test
