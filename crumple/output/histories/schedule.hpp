// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "domain/domain.hpp"
#include "model/control.hpp"

namespace crumple::output {

/// When something is due: at time zero and then at the first step at or after each multiple of the interval.
/// Counting multiples keeps rows near them however long the run is; adding up intervals would drift.
class Schedule {
 public:
  /// `interval` as the deck asks for [time]; zero spreads `points` of them over the run. A run without end
  /// time counts cycles instead.
  Schedule(double interval, int points, const model::Control& control);

  /// True if something is due that `mark_written` has not been told of.
  bool due(const domain::Clock& clock) const;
  /// Something was written: the next multiple after the present time is due next.
  void mark_written(const domain::Clock& clock);
  /// True if the state at hand is the one that was written last.
  bool has_written(const domain::Clock& clock) const { return progress_.last_cycle == clock.cycle; }

  double interval() const { return interval_; }

  /// Declares how far it has come, for a restart.
  void declare(const std::string& name, domain::StateList& list);
  /// To be called after a restart has filled what was declared: the interval may have changed since.
  void resume(const domain::Clock& clock);

 private:
  struct Progress {
    double interval = 0;  ///< by which the multiples count [time]
    double next_multiple = 0;
    long next_cycle = 0;
    long last_cycle = -1;
  };
  double interval_ = 0;        ///< [time]; 0 counts cycles
  long cycle_interval_ = 100;  ///< for runs that only a number of cycles ends
  Progress progress_;
};

}  // namespace crumple::output
