// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "domain/state_snapshot.hpp"
#include "timeloop/fitting_state.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::test {

/// Double precision, one thread, and the instruction set that CRUMPLE_ISA names or the fastest there is.
inline domain::Execution execution() {
  return {Precision::Double, default_isa(), 1};
}

/// Takes a run up again from a copy of its state, with another number of threads: after some cycles both must
/// be the same, bit by bit. Every run of a test is checked so halfway, as each has other things that
/// remember; CRUMPLE_TEST_RESTART_CYCLE in the environment chooses another cycle and compares the ends.
class RestartCheck {
 public:
  explicit RestartCheck(timeloop::Simulation& simulation) : simulation_(simulation) {
    if (const char* const wanted = std::getenv("CRUMPLE_TEST_RESTART_CYCLE")) cycle_ = std::atol(wanted);
  }

  /// To be called at time zero and after every step.
  void observe() {
    const domain::Clock& clock = simulation_.domain().clock;
    if (copy_.empty() && is_time(clock)) {
      copy_.take(simulation_.state());
      first_cycle_ = clock.cycle;
    } else if (!copy_.empty() && !compared_ && cycle_ < 0 && clock.cycle == first_cycle_ + cycles_compared) {
      compare();
    }
  }
  /// To be called at the end.
  void finish() {
    if (!copy_.empty() && !compared_) compare();
  }

 private:
  static constexpr long cycles_compared = 40;

  bool is_time(const domain::Clock& clock) const {
    const model::Control& control = simulation_.model().control;
    if (cycle_ >= 0) return clock.cycle == cycle_;
    return clock.time >= 0.5 * control.end_time ||
           (control.end_cycle > 0 && clock.cycle >= control.end_cycle / 2);
  }

  void compare() {
    compared_ = true;
    domain::Execution execution = simulation_.domain().execution;
    execution.threads = execution.threads == 2 ? 1 : 2;
    timeloop::Simulation second(simulation_.model(), execution);
    timeloop::require_fitting_state(copy_, second.state(), second.domain());
    copy_.put_back(second.state());
    second.resume();
    const domain::Clock& now = simulation_.domain().clock;
    while (second.domain().clock.cycle < now.cycle) second.step();
    EXPECT_EQ(second.state_hash(), simulation_.state_hash())
        << "taken up from the state of cycle " << first_cycle_ << ", at cycle " << now.cycle;
    EXPECT_EQ(second.domain().energy.total(), simulation_.domain().energy.total());
    EXPECT_EQ(second.domain().energy.external_work, simulation_.domain().energy.external_work);
  }

  timeloop::Simulation& simulation_;
  domain::StateSnapshot copy_;
  long cycle_ = -1;  ///< chosen by the environment
  long first_cycle_ = 0;
  bool compared_ = false;
};

/// Runs to the model's end time; calls `watch` at time zero and after every step.
inline void run(
    timeloop::Simulation& simulation,
    const std::function<void(const domain::Domain&)>& watch = [](const domain::Domain&) {}) {
  RestartCheck restart(simulation);
  simulation.start();
  watch(simulation.domain());
  while (!simulation.finished()) {
    restart.observe();
    simulation.step();
    watch(simulation.domain());
  }
  restart.finish();
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
