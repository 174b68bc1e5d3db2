// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::output {

namespace {

/// Part of an interval by which time may fall short of a multiple and still count as there: sums of steps
/// that should meet it miss it by round-off.
constexpr double slack = 1e-9;

}  // namespace

Schedule::Schedule(double interval, int points, const model::Control& control) : interval_(interval) {
  if (interval_ <= 0 && control.end_time > 0) interval_ = control.end_time / points;
  if (control.end_cycle > 0) cycle_interval_ = std::max(1L, control.end_cycle / points);
}

bool Schedule::due(const domain::Clock& clock) const {
  if (interval_ <= 0) return clock.cycle >= progress_.next_cycle;
  return clock.time >= (progress_.next_multiple - slack) * interval_;
}

void Schedule::mark_written(const domain::Clock& clock) {
  progress_.last_cycle = clock.cycle;
  progress_.next_cycle = clock.cycle + cycle_interval_;
  if (interval_ > 0) progress_.next_multiple = std::floor(clock.time / interval_ + slack) + 1;
}

void Schedule::declare(const std::string& name, domain::StateList& list) {
  progress_.interval = interval_;
  list.keep(name + "_schedule", "by item", domain::Entity::Run, progress_);
}

void Schedule::resume(const domain::Clock& clock) {
  if (interval_ <= 0 || progress_.interval == interval_) return;
  progress_.next_multiple = std::floor(clock.time / interval_ + slack) + 1;
}

}  // namespace crumple::output
