// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/inspection_times.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::app {

namespace {

constexpr int inspections_per_run = 50;

/// All inspections of so few segments together take hundredths of a second.
constexpr Index few_segments = 1000;
/// Beyond, cycles between two inspections over the number of segments, and at most.
constexpr double cycles_per_segment = 1.0 / 3.0;
constexpr double most_cycles_between = 1500;

long cycles_between(Index segments) {
  if (segments <= few_segments) return 1;
  return std::lround(std::min(most_cycles_between, cycles_per_segment * segments));
}

}  // namespace

InspectionTimes::InspectionTimes(const model::Control& control, Index segments)
    : interval_(control.end_time / inspections_per_run),
      interval_cycles_(control.end_cycle > 0 ? std::max(1L, control.end_cycle / inspections_per_run) : 0),
      least_cycles_(cycles_between(segments)) {}

bool InspectionTimes::due(const domain::Clock& clock) {
  if (clock.cycle - last_cycle_ < least_cycles_) return false;
  const bool by_cycles = interval_cycles_ > 0 && clock.cycle % interval_cycles_ == 0;
  const bool by_time = std::floor(clock.time / interval_) > std::floor((clock.time - clock.step) / interval_);
  if (by_cycles || by_time) last_cycle_ = clock.cycle;
  return by_cycles || by_time;
}

}  // namespace crumple::app
