// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/resample.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace crumple::compare::resample_test {
namespace {

Curve line(double start, double end, std::size_t points) {
  Curve curve{"glstat", "kinetic", ""};
  for (std::size_t i = 0; i < points; ++i) {
    const double time = start + (end - start) * static_cast<double>(i) / static_cast<double>(points - 1);
    append_point(curve, time, 10 + 3 * time);
  }
  return curve;
}

TEST(Curve, NameSaysWhatItIs) {
  EXPECT_EQ(name_of({"glstat", "kinetic", ""}), "glstat.kinetic");
  EXPECT_EQ(name_of({"rcforc", "fx", "3 first"}), "rcforc.fx[3 first]");
}

TEST(Curve, ARestartReplacesWhatItWritesAnew) {
  Curve curve{"glstat", "kinetic", ""};
  for (const double time : {0.0, 1.0, 2.0, 3.0}) append_point(curve, time, time);
  append_point(curve, 2.0, 20);
  append_point(curve, 2.5, 25);
  append_point(curve, 2.6, std::nan(""));
  append_point(curve, std::numeric_limits<double>::infinity(), 1);
  EXPECT_EQ(curve.times, (std::vector<double>{0, 1, 2, 2.5}));
  EXPECT_EQ(curve.values, (std::vector<double>{0, 1, 20, 25}));
}

TEST(Curve, ValuesBetweenPointsLieOnStraightLines) {
  const Curve curve{"glstat", "kinetic", "", false, {0, 1, 3}, {5, 7, -1}};
  EXPECT_EQ(value_at(curve, -1), 5);
  EXPECT_EQ(value_at(curve, 0.25), 5.5);
  EXPECT_EQ(value_at(curve, 1), 7);
  EXPECT_EQ(value_at(curve, 2), 3);
  EXPECT_EQ(value_at(curve, 9), -1);
}

TEST(CommonTimes, AreThoseBothCurvesHave) {
  const auto times = common_times(line(0, 2, 401), line(0.5, 3, 11), std::nullopt);
  ASSERT_TRUE(times);
  EXPECT_EQ(times->start, 0.5);
  EXPECT_EQ(times->end, 2);
  EXPECT_EQ(times->samples, 301U);  // as many as the finer curve has there
  EXPECT_EQ(times->at(0), 0.5);
  EXPECT_EQ(times->at(300), 2);
  EXPECT_NEAR(times->interval(), 0.005, 1e-15);
  const std::vector<double> values = resample(line(0.5, 3, 11), *times);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], 10 + 3 * times->at(i), 1e-13);
}

TEST(CommonTimes, TheirNumberHasBounds) {
  EXPECT_EQ(common_times(line(0, 1, 5), line(0, 1, 7), std::nullopt)->samples, fewest_samples);
  EXPECT_EQ(common_times(line(0, 1, 50001), line(0, 1, 7), std::nullopt)->samples, most_chosen_samples);
  const auto asked = common_times(line(0, 1, 5), line(0, 1.05, 7), 0.1);
  EXPECT_EQ(asked->samples, 11U);
  EXPECT_NEAR(asked->interval(), 0.1, 1e-15);
  EXPECT_THROW(common_times(line(0, 1, 5), line(0, 1, 5), 1e-9), Error);
  EXPECT_THROW(common_times(line(0, 1, 5), line(0, 1, 5), 0.5), Error);
}

TEST(CommonTimes, ThereMayBeNone) {
  EXPECT_FALSE(common_times(line(0, 1, 5), line(1, 2, 5), std::nullopt));
  EXPECT_FALSE(common_times(line(0, 1, 5), Curve{"glstat", "kinetic", ""}, std::nullopt));
}

}  // namespace
}  // namespace crumple::compare::resample_test
