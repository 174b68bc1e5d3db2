// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/even_looks.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::app {

namespace {

constexpr int looks_per_run = 50;

/// Looks at so few segments take hundredths of a second together.
constexpr Index few_segments = 1000;
/// Beyond, cycles between two looks over the number of segments, and at most.
constexpr double cycles_per_segment = 1.0 / 3.0;
constexpr double most_cycles_between = 1500;

long cycles_between_looks(Index segments) {
  if (segments <= few_segments) return 1;
  return std::lround(std::min(most_cycles_between, cycles_per_segment * segments));
}

}  // namespace

EvenLooks::EvenLooks(const model::Control& control, Index segments)
    : interval_(control.end_time / looks_per_run),
      interval_cycles_(control.end_cycle > 0 ? std::max(1L, control.end_cycle / looks_per_run) : 0),
      least_cycles_(cycles_between_looks(segments)) {}

bool EvenLooks::due(const domain::Clock& clock) {
  if (clock.cycle - last_cycle_ < least_cycles_) return false;
  const bool by_cycles = interval_cycles_ > 0 && clock.cycle % interval_cycles_ == 0;
  const bool by_time = std::floor(clock.time / interval_) > std::floor((clock.time - clock.step) / interval_);
  if (by_cycles || by_time) last_cycle_ = clock.cycle;
  return by_cycles || by_time;
}

}  // namespace crumple::app
