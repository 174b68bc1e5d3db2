// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/cycle_times.hpp"

#include <algorithm>
#include <ctime>

#include "base/stopwatch.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::app {

namespace {

constexpr long most_cycles = 4000;  ///< keeps the strain below a tenth

double processor_seconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

CycleTimes measure_cycles(const model::Model& model, const domain::Execution& execution, double seconds) {
  timeloop::Simulation simulation(model, execution);
  simulation.start();
  const double elements = static_cast<double>(model.shells.size() + model.solids.size());
  // Two milliseconds are short beside what the scheduler gives in one piece, long beside reading the clock.
  const long batch = std::max(1L, static_cast<long>(1e5 / elements));
  for (int cycle = 0; cycle < cycles_to_yield; ++cycle) simulation.step();

  const Stopwatch total;
  const domain::StageTimes& stages = simulation.domain().times;
  CycleTimes best{1e30, 1e30, 1e30, 1e30};
  for (long cycle = 0; cycle < most_cycles && (cycle < 3 || total.seconds() < seconds); cycle += batch) {
    const domain::StageTimes before = stages;
    const double processor = processor_seconds();
    const Stopwatch watch;
    for (long i = 0; i < batch; ++i) simulation.step();
    const double per_cycle = 1e9 / (elements * static_cast<double>(batch));
    best.wall = std::min(best.wall, per_cycle * watch.seconds());
    best.processor = std::min(best.processor, per_cycle * (processor_seconds() - processor));
    best.elements = std::min(best.elements, per_cycle * (stages.elements - before.elements));
    best.integrate = std::min(best.integrate, per_cycle * (stages.integrate - before.integrate));
  }
  return best;
}

}  // namespace crumple::app
