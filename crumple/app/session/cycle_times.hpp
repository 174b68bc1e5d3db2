// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::app {

/// Times per element-cycle, the smallest of many short batches [ns].
struct CycleTimes {
  double wall = 0;
  double processor = 0;  ///< processor time of all threads
  double elements = 0;   ///< wall time of the element stage
  double integrate = 0;  ///< wall time of the nodes' motion
};

/// Cycles before the measurement: what a benchmark's model is to yield does so by then.
inline constexpr int cycles_to_yield = 90;

/// Runs whole time steps of a benchmark's model for about `seconds`. Throws Error if it cannot be run.
CycleTimes measure_cycles(const model::Model& model, const domain::Execution& execution, double seconds);

}  // namespace crumple::app
