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

/// Adds the wall time between construction and destruction to `total`, and to `share` if there is one [s].
class StageTimer {
 public:
  explicit StageTimer(double& total, double* share = nullptr) : total_(total), share_(share) {}
  ~StageTimer() {
    const double seconds = watch_.seconds();
    total_ += seconds;
    if (share_ != nullptr) *share_ += seconds;
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double& total_;
  double* share_;
  Stopwatch watch_;
};

}  // namespace crumple
