// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "domain/state_snapshot.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::test {

/// Double precision, one thread, and the instruction set that CRUMPLE_ISA names or the fastest there is.
inline domain::Execution execution() {
  return {Precision::Double, default_isa(), 1};
}

/// A second simulation that begins with a copied state must come to the end of the first, bit by bit.
inline void expect_same_end(timeloop::Simulation& first, const domain::StateSnapshot& copy, int threads) {
  domain::Execution execution = first.domain().execution;
  execution.threads = threads;
  timeloop::Simulation second(first.model(), execution);
  copy.put_back(second.state());
  second.resume();
  EXPECT_LT(second.domain().clock.cycle, first.domain().clock.cycle);
  while (second.domain().clock.cycle < first.domain().clock.cycle) second.step();
  EXPECT_EQ(second.state_hash(), first.state_hash()) << "from a copied state, with " << threads << " threads";
  EXPECT_EQ(second.domain().energy.total(), first.domain().energy.total());
}

/// Runs to the model's end time; calls `watch` at time zero and after every step. Where the environment has
/// CRUMPLE_TEST_RESTART_CYCLE, a copy of the state of that cycle is taken up again and must end the same.
inline void run(
    timeloop::Simulation& simulation,
    const std::function<void(const domain::Domain&)>& watch = [](const domain::Domain&) {}) {
  const char* const wanted = std::getenv("CRUMPLE_TEST_RESTART_CYCLE");
  const long copied_cycle = wanted == nullptr ? -1 : std::atol(wanted);
  domain::StateSnapshot copy;
  simulation.start();
  watch(simulation.domain());
  while (!simulation.finished()) {
    if (simulation.domain().clock.cycle == copied_cycle) copy.take(simulation.state());
    simulation.step();
    watch(simulation.domain());
  }
  if (!copy.empty()) expect_same_end(simulation, copy, 2);
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
