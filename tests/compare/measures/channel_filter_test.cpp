// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/channel_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crumple::compare::channel_filter_test {
namespace {

/// Size of a sine after the filter, in the middle, where the ends do not matter.
double gain(int cfc, double frequency, double rate) {
  std::vector<double> values(20000);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::sin(2 * std::numbers::pi * frequency * static_cast<double>(i) / rate);
  const std::vector<double> out = channel_filter(values, cfc, 1 / rate);
  double most = 0;
  for (std::size_t i = 5000; i < 15000; ++i) most = std::max(most, std::abs(out[i]));
  return most;
}

TEST(ChannelFilter, PassesAndStopsWhatTheStandardAsksFor) {
  for (const int cfc : {60, 180, 600}) {
    const double rate = 50 * cfc * 2.0775;
    // Two passes of a filter that is down by 3 dB at the corner are down by 6 dB there.
    EXPECT_NEAR(gain(cfc, 2.0775 * cfc, rate), 0.5, 0.01);
    EXPECT_GT(20 * std::log10(gain(cfc, cfc, rate)), -1);
    EXPECT_LT(20 * std::log10(gain(cfc, cfc, rate)), 0.5);
    EXPECT_NEAR(gain(cfc, 0.1 * cfc, rate), 1, 1e-3);
    EXPECT_NEAR(20 * std::log10(gain(cfc, 8 * cfc, rate) / gain(cfc, 4 * cfc, rate)), -24.5, 2.5);
  }
}

TEST(ChannelFilter, DoesNotShiftInTime) {
  std::vector<double> pulse(1001);
  for (std::size_t i = 0; i < pulse.size(); ++i)
    pulse[i] = std::exp(-std::pow((static_cast<double>(i) - 500) / 20, 2));
  const std::vector<double> out = channel_filter(pulse, 60, 1e-4);
  EXPECT_EQ(std::max_element(out.begin(), out.end()) - out.begin(), 500);
  for (std::size_t i = 0; i < 300; ++i) EXPECT_NEAR(out[500 - i], out[500 + i], 1e-9);
}

TEST(ChannelFilter, KeepsConstantsToTheirEnds) {
  for (const double value : channel_filter(std::vector<double>(300, 7.0), 180, 1e-5))
    EXPECT_NEAR(value, 7, 1e-10);
}

TEST(ChannelFilter, RefusesWhatIsSampledTooCoarsely) {
  EXPECT_TRUE(can_filter(60, 1e-3));
  EXPECT_FALSE(can_filter(600, 1e-3));
  EXPECT_FALSE(can_filter(60, 0));
  Curve curve{"rwforc", "normal", "1", false, {0, 1, 2, 4}, {1, 5, 2, 8}};
  const Curve before = curve;
  EXPECT_FALSE(filter_curve(curve, 600, 1e-3));
  EXPECT_EQ(curve.values, before.values);
}

TEST(ChannelFilter, TheUnitOfTimeMatters) {
  Curve seconds{"rwforc", "normal", "1"};
  for (int i = 0; i <= 2000; ++i) append_point(seconds, i * 1e-5, std::sin(i * 0.3));
  Curve milliseconds = seconds;
  for (double& time : milliseconds.times) time *= 1000;
  ASSERT_TRUE(filter_curve(seconds, 180, 1));
  ASSERT_TRUE(filter_curve(milliseconds, 180, 1e-3));
  for (std::size_t i = 0; i < seconds.values.size(); ++i)
    EXPECT_NEAR(seconds.values[i], milliseconds.values[i], 1e-9);
}

}  // namespace
}  // namespace crumple::compare::channel_filter_test
