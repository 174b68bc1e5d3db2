// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/inspection_times.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "domain/state_snapshot.hpp"

namespace crumple::app::inspection_times_test {
namespace {

/// Cycles with an inspection, for `cycles` steps of equal length up to the end time 1.
std::vector<long> cycles_of(InspectionTimes& times, long first, long cycles, double step) {
  std::vector<long> found;
  for (long cycle = first; cycle <= cycles; ++cycle) {
    domain::Clock clock;
    clock.cycle = cycle;
    clock.step = step;
    clock.time = step * static_cast<double>(cycle);
    if (times.due(clock)) found.push_back(cycle);
  }
  return found;
}

model::Control until(double time, long cycles = 0) {
  model::Control control;
  control.end_time = time;
  control.end_cycle = cycles;
  return control;
}

TEST(InspectionTimes, AreFiftyOverTheEndTime) {
  InspectionTimes times(until(1.0), 100);
  const std::vector<long> found = cycles_of(times, 0, 1024, 1.0 / 1024);
  ASSERT_EQ(found.size(), 50U);
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(static_cast<double>(found[i]), 1024.0 / 50 * static_cast<double>(i + 1), 1.0);
}

TEST(InspectionTimes, ComeInEveryCycleOfARunWithFewerAndNeverWithoutEndTime) {
  InspectionTimes few(until(1.0), 100);
  EXPECT_EQ(cycles_of(few, 0, 16, 1.0 / 16).size(), 16U);
  InspectionTimes none(until(0.0), 100);
  EXPECT_TRUE(cycles_of(none, 0, 16, 1.0 / 16).empty());
}

TEST(InspectionTimes, FollowTheLastCycleWhereThatComesFirst) {
  InspectionTimes times(until(1e6, 200), 100);
  EXPECT_EQ(cycles_of(times, 0, 200, 1.0 / 1024).size(), 50U);
}

/// An inspection of a thousand segments costs a fraction of a millisecond; of more it takes a half percent at
/// most.
TEST(InspectionTimes, AreRareInLargeModels) {
  InspectionTimes times(until(1.0), 3000);
  EXPECT_EQ(cycles_of(times, 0, 8192, 1.0 / 8192).size(), 7U);  // no closer than 1000 cycles
  InspectionTimes large(until(1.0), 1000000);
  EXPECT_EQ(cycles_of(large, 0, 8192, 1.0 / 8192).size(), 5U);  // than 1500
}

TEST(InspectionTimes, GoOnAfterARestartAsIfThereWasNone) {
  InspectionTimes whole(until(1.0), 3000);
  std::vector<long> expected = cycles_of(whole, 0, 8192, 1.0 / 8192);
  InspectionTimes before(until(1.0), 3000);
  std::vector<long> found = cycles_of(before, 0, 2500, 1.0 / 8192);
  InspectionTimes after(until(1.0), 3000);
  domain::StateList from;
  before.declare(from);
  domain::StateList to;
  after.declare(to);
  domain::StateSnapshot copy;
  copy.take(from);
  copy.put_back(to);
  const std::vector<long> rest = cycles_of(after, 2501, 8192, 1.0 / 8192);
  found.insert(found.end(), rest.begin(), rest.end());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace crumple::app::inspection_times_test
