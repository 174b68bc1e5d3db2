// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/stopwatch.hpp"
#include "domain/state_snapshot.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::app {

/// A copy of a recent state of a run, from which the last state before an error is computed again: what is
/// worth looking at is where it began. The copy takes as much memory as the state, and less than a hundredth
/// of the time.
class GoodState {
 public:
  /// To be called at the start and after every step.
  void observe(timeloop::Simulation& simulation);

  /// After a step that threw at `cycle`: brings the simulation to the cycle before it. False if that fails,
  /// which leaves the simulation somewhere between.
  bool return_before(long cycle, timeloop::Simulation& simulation) const;

 private:
  domain::StateSnapshot copy_;
  domain::StateSnapshot reports_;
  Stopwatch since_copy_;
  double copy_seconds_ = 0;  ///< that the last copy took [s]
};

}  // namespace crumple::app
