// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_speed.hpp"

#include <algorithm>
#include <limits>

namespace crumple::app {

namespace {

constexpr double shortest_window = 2;      ///< [s]
constexpr double share_of_run = 0.25;      ///< that the window is of the run so far
constexpr double spacing = 0.01;           ///< of samples over the window
constexpr double shortest_spacing = 0.02;  ///< [s]
constexpr long first_cycles = 2;           ///< which are not like the others

double window_after(double seconds) {
  return std::max(shortest_window, share_of_run * seconds);
}

}  // namespace

void RunSpeed::observe(double seconds, double time, long cycle) {
  const Sample now{seconds, time, cycle};
  if (!is_started_) first_ = now;
  is_started_ = true;
  const long done = cycle - first_.cycle;
  // The first cycle alone tells nothing, and both of the first are forgotten after the third.
  if (done <= 1) {
    samples_.assign(1, now);
    return;
  }
  if (done > first_cycles && samples_.front().cycle < first_.cycle + first_cycles)
    samples_.erase(samples_.begin(), samples_.end() - 1);
  // The last sample moves on until it is worth a new one.
  const double window = window_after(seconds - first_.seconds);
  const std::size_t size = samples_.size();
  if (size > 1 &&
      samples_[size - 1].seconds - samples_[size - 2].seconds < std::max(shortest_spacing, spacing * window))
    samples_.back() = now;
  else
    samples_.push_back(now);
  while (samples_.size() > 2 && samples_[1].seconds < seconds - window) samples_.pop_front();
}

double RunSpeed::seconds_to(double end_time, long end_cycle) const {
  constexpr double unknown = -1;
  if (samples_.size() < 2) return unknown;
  const Sample& now = samples_.back();
  const Sample& then = samples_.front();
  if (now.cycle <= then.cycle) return unknown;
  const double elapsed = now.seconds - then.seconds;
  double to_go = std::numeric_limits<double>::infinity();
  if (now.time > then.time) to_go = std::max(0.0, end_time - now.time) * elapsed / (now.time - then.time);
  if (end_cycle > 0)
    to_go = std::min(to_go, static_cast<double>(std::max(0L, end_cycle - now.cycle)) * elapsed /
                                static_cast<double>(now.cycle - then.cycle));
  return to_go;
}

}  // namespace crumple::app
