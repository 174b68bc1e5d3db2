// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/held_step.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crumple::timeloop::held_step_test {
namespace {

TEST(HeldStep, FallsAtOnceToWhatIsAllowed) {
  HeldStep held;
  double step = held.next(0, 0, 1);
  EXPECT_EQ(step, 1);
  for (long cycle = 1; cycle < 100; ++cycle) {
    const double allowed = std::pow(0.99, static_cast<double>(cycle));
    step = held.next(cycle, step, allowed);
    EXPECT_EQ(step, allowed);
  }
}

TEST(HeldStep, StaysWhereTheAllowedOneSwings) {
  HeldStep held;
  double step = held.next(0, 0, 1);
  for (long cycle = 1; cycle < 1000; ++cycle) {
    const double before = step;
    step = held.next(cycle, step, 1 + 0.1 * std::sin(1.7 * static_cast<double>(cycle)));
    EXPECT_LE(step, before) << cycle;
  }
  EXPECT_NEAR(step, 0.9, 1e-4);
}

TEST(HeldStep, RisesWhenMoreHasBeenAllowedForLong) {
  HeldStep held;
  double step = held.next(0, 0, 1);
  long risen = 0;
  for (long cycle = 1; cycle < 100 && risen == 0; ++cycle) {
    step = held.next(cycle, step, 2);
    if (step > 1) risen = cycle;
  }
  EXPECT_GE(risen, 20);
  EXPECT_LE(risen, 40);
  EXPECT_DOUBLE_EQ(step, 0.99 * 2);
  // Two percent more is not clearly more.
  for (long cycle = risen + 1; cycle < risen + 100; ++cycle)
    EXPECT_EQ(held.next(cycle, step, 1.019 * step), step);
}

}  // namespace
}  // namespace crumple::timeloop::held_step_test
