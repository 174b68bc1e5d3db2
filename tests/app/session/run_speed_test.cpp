// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/run_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace crumple::app::run_speed_test {
namespace {

/// A run as the wall clock sees it: the seconds that a cycle takes and its step, by cycle and time.
struct Course {
  double end_time = 1;
  std::function<double(long)> seconds;
  std::function<double(double)> step;
};

/// Largest error of the time to go over what is really left, between two seconds after the start and the last
/// second of the run.
double worst_error(const Course& course) {
  struct Moment {
    double seconds;
    double to_go;
  };
  std::vector<Moment> moments;
  RunSpeed speed;
  double now = 0;
  double time = 0;
  speed.observe(now, time, 0);
  for (long cycle = 1; time < course.end_time; ++cycle) {
    now += course.seconds(cycle);
    time = std::min(course.end_time, time + course.step(time));
    speed.observe(now, time, cycle);
    const double to_go = speed.seconds_to(course.end_time, 0);
    EXPECT_EQ(to_go < 0, cycle < 2) << "known from the second cycle on";
    if (to_go >= 0) moments.push_back({now, to_go});
  }
  double worst = 0;
  for (const Moment& moment : moments)
    if (moment.seconds > 2 && moment.seconds < now - 1)
      worst = std::max(worst, std::fabs(moment.to_go - (now - moment.seconds)) / (now - moment.seconds));
  return worst;
}

TEST(RunSpeedTest, IsNotLedAstrayByTheFirstCycles) {
  // Forty times slower, as where memory is touched for the first time.
  EXPECT_LT(worst_error({1, [](long cycle) { return cycle < 3 ? 0.2 : 0.005; }, [](double) { return 2e-4; }}),
            0.01);
  // One that takes longer than the window.
  EXPECT_LT(
      worst_error({1, [](long cycle) { return cycle == 1 ? 3.0 : 0.005; }, [](double) { return 2e-4; }}),
      0.01);
}

TEST(RunSpeedTest, CountsFramesAndSearchesThatComeNowAndThen) {
  const auto with_frames = [](long cycle) { return 0.004 + (cycle % 100 == 0 ? 0.3 : 0.0); };
  EXPECT_LT(worst_error({1, with_frames, [](double) { return 1e-4; }}), 0.3);
}

TEST(RunSpeedTest, FollowsStepsThatFall) {
  const auto falling = [](double time) { return 2e-4 * (1 - 0.5 * time); };
  EXPECT_LT(worst_error({1, [](long) { return 0.004; }, falling}), 0.3);
  // Added mass and contact that holds the step: a third of it from one cycle to the next. No estimate before
  // can know that; ten seconds later it must be right.
  const auto drops = [](double time) { return time < 0.05 ? 3e-4 : 1e-4; };
  RunSpeed speed;
  double now = 0;
  double time = 0;
  for (long cycle = 0; now < 10.7; ++cycle) {
    speed.observe(now, time, cycle);
    now += 0.004;
    time += drops(time);
  }
  const double left = (1 - time) / 1e-4 * 0.004;
  EXPECT_NEAR(speed.seconds_to(1, 0), left, 0.3 * left);
}

TEST(RunSpeedTest, SaysWhenNothingIsKnown) {
  RunSpeed speed;
  EXPECT_LT(speed.seconds_to(1, 0), 0);
  speed.observe(0, 0.5, 100);
  EXPECT_LT(speed.seconds_to(1, 0), 0);
  speed.observe(3, 0.6, 101);
  EXPECT_LT(speed.seconds_to(1, 0), 0);
  speed.observe(3.1, 0.7, 102);
  EXPECT_NEAR(speed.seconds_to(1, 0), 0.3, 1e-12);
}

TEST(RunSpeedTest, EndsByCyclesCount) {
  RunSpeed speed;
  for (int cycle = 0; cycle <= 100; ++cycle) speed.observe(0.1 * cycle, 1e-9 * cycle, cycle);
  EXPECT_NEAR(speed.seconds_to(1e20, 300), 20, 1e-9);
  EXPECT_NEAR(speed.seconds_to(150e-9, 300), 5, 1e-9);
  EXPECT_EQ(speed.seconds_to(50e-9, 300), 0);
}

}  // namespace
}  // namespace crumple::app::run_speed_test
