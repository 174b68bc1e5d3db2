// SPDX-License-Identifier: BSD-3-Clause
#include "output/histories/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace crumple::output::schedule_test {
namespace {

/// Times at which something is written in a run with steps of `step(cycle)`.
template <class Step>
std::vector<double> written_times(Schedule schedule, double end, const Step& step) {
  std::vector<double> times;
  domain::Clock clock;
  for (;;) {
    if (schedule.due(clock)) {
      times.push_back(clock.time);
      schedule.mark_written(clock);
    }
    if (clock.time >= end) return times;
    clock.time += step(clock.cycle);
    ++clock.cycle;
  }
}

model::Control ends_at(double time) {
  model::Control control;
  control.end_time = time;
  return control;
}

TEST(Schedule, WritesAtZeroAndAtTheFirstStepAfterEachMultiple) {
  const double interval = 0.01;
  const auto times = written_times(Schedule(interval, 5, ends_at(1)), 1.0, [](long cycle) {
    return 1e-3 * (1 + 0.9 * std::sin(static_cast<double>(cycle)));
  });
  ASSERT_EQ(times.size(), 101U);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_GE(times[k], static_cast<double>(k) * interval * (1 - 1e-9));
    EXPECT_LT(times[k], static_cast<double>(k) * interval + 1.9e-3);
  }
}

TEST(Schedule, SpreadsTheDefaultNumberOverTheRun) {
  const Schedule schedule(0, 100, ends_at(0.012));
  EXPECT_DOUBLE_EQ(schedule.interval(), 1.2e-4);
  EXPECT_EQ(written_times(schedule, 0.012, [](long) { return 1e-6; }).size(), 101U);
}

TEST(Schedule, RoundOffOfSummedStepsNeitherLosesNorDoublesAMultiple) {
  // 0.1 is not a binary number: ten of them sum to less than 1.
  const auto times = written_times(Schedule(1, 5, ends_at(100)), 100.0 - 1e-6, [](long) { return 0.1; });
  ASSERT_EQ(times.size(), 101U);
  for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], static_cast<double>(k), 1e-9);
}

TEST(Schedule, AStepLongerThanTheIntervalWritesOnce) {
  const auto times = written_times(Schedule(0.1, 5, ends_at(2)), 2.0, [](long) { return 0.25; });
  EXPECT_EQ(times.size(), 9U) << "every step, and no step twice";
}

TEST(Schedule, ARunThatOnlyCyclesEndCountsCycles) {
  model::Control control;
  control.end_cycle = 1000;
  EXPECT_EQ(written_times(Schedule(0, 100, control), 1.0, [](long) { return 1e-3; }).size(), 101U);
}

}  // namespace
}  // namespace crumple::output::schedule_test
