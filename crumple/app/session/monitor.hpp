// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <utility>

#include "app/console/console.hpp"
#include "app/session/run_speed.hpp"
#include "app/session/status_line.hpp"
#include "base/stopwatch.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::app {

/// Tells how far a run is: a line every twentieth of the run and every ten seconds; on a terminal also a bar,
/// written over five times a second; and when the step of the elements has fallen to a hundredth, and to a
/// hundredth of that, which of them it is. Quiet, it prints nothing.
class Monitor {
 public:
  /// `earlier_seconds`: wall time that the cycles before a restart took [s].
  Monitor(const timeloop::Simulation& simulation, const Console& console, bool quiet,
          double earlier_seconds = 0);

  /// `listener` hears how far the run is with the next observe and then five times a second, quiet or not.
  void tell(std::function<void(const Progress&)> listener) { listener_ = std::move(listener); }

  /// The cycles begin now, and not when this was made.
  void begin() { since_start_.restart(); }
  /// To be called once at time zero and after every step.
  void observe();
  /// Prints a line at once.
  void print_line();
  /// Prints a line unless that of the present cycle is there.
  void print_last_line();
  /// Removes the bar, so that other text can be printed. The next observe brings it back.
  void clear_bar();

  Progress progress() const;

  /// Wall time of the cycles, those before a restart included [s].
  double seconds() const { return earlier_seconds_ + since_start_.seconds(); }

 private:
  void print_due(double now);
  void print_fall_of_step();

  const timeloop::Simulation& simulation_;
  const Console& console_;
  bool quiet_;
  std::function<void(const Progress&)> listener_;
  bool bar_shown_ = false;
  bool header_shown_ = false;
  double earlier_seconds_ = 0;
  Stopwatch since_start_;
  double next_line_time_ = 0;     ///< [time]
  double next_line_seconds_ = 0;  ///< wall time [s]
  double next_bar_seconds_ = 0;   ///< wall time [s]
  double next_word_seconds_ = 0;  ///< to the listener, wall time [s]
  long line_cycle_ = -1;          ///< of the last line
  double first_limit_ = 0;        ///< of the elements when the run began, or was taken up [time]
  double noted_limit_ = 0;        ///< the one of the last note; at first that of the start [time]
  RunSpeed speed_;
};

}  // namespace crumple::app
