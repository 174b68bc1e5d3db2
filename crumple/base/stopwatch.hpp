// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace crumple {

/// Wall time since construction or the last restart.
class Stopwatch {
 public:
  /// Elapsed time [s].
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  void restart() { start_ = Clock::now(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// Adds the wall time between construction and destruction to `total` [s].
class StageTimer {
 public:
  explicit StageTimer(double& total) : total_(total) {}
  ~StageTimer() { total_ += watch_.seconds(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double& total_;
  Stopwatch watch_;
};

}  // namespace crumple
