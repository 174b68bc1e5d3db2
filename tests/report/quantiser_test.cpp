// SPDX-License-Identifier: BSD-3-Clause
#include "report/quantiser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace crumple::report::quantiser_test {
namespace {

Range range_of(double low, double high) {
  Range range;
  range.add(low);
  range.add(high);
  return range;
}

TEST(Quantiser, ErrorsStayWithinTheBound) {
  std::mt19937_64 random(1);
  for (const int bits : {8, 16})
    for (const auto& [low, high] : {std::pair{0.0, 1.0}, {-3e8, 5e9}, {1e6, 1e6 + 1e-3}, {-2.5e-12, 7e-12}}) {
      const Quantiser quantiser(range_of(low, high), bits);
      // Half a step, and the rounding of numbers that are much larger than it.
      const double rounding = 1e-15 * std::max(std::fabs(low), std::fabs(high));
      EXPECT_LT(quantiser.bound(), 0.5 * (high - low) / ((1 << bits) - 2) + rounding);
      std::uniform_real_distribution<double> values(low, high);
      double worst = 0;
      for (int i = 0; i < 20000; ++i) {
        const double value = values(random);
        worst = std::max(worst, std::fabs(quantiser.value(quantiser.code(value)) - value));
      }
      EXPECT_LE(worst, quantiser.bound());
      EXPECT_GT(worst, 0.8 * quantiser.bound());
    }
}

TEST(Quantiser, EndsAreTheFirstAndTheLastCode) {
  for (const int bits : {8, 16}) {
    const Quantiser quantiser(range_of(-2, 6), bits);
    EXPECT_EQ(quantiser.code(-2), 1);
    EXPECT_EQ(quantiser.code(6), (1 << bits) - 1);
    EXPECT_EQ(quantiser.code(-100), 1);
    EXPECT_EQ(quantiser.code(100), (1 << bits) - 1);
    EXPECT_NEAR(quantiser.value(1), -2, 1e-15);
    EXPECT_NEAR(quantiser.value(static_cast<std::uint16_t>((1 << bits) - 1)), 6, 1e-14);
  }
}

TEST(Quantiser, NoValueIsCodeZero) {
  const Quantiser quantiser(range_of(0, 1), 16);
  EXPECT_EQ(quantiser.code(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(quantiser.code(std::numeric_limits<double>::infinity()), 0);
}

TEST(Quantiser, KeepsARangeOfOneValue) {
  const Quantiser quantiser(range_of(1.5, 1.5), 8);
  EXPECT_EQ(quantiser.value(quantiser.code(1.5)), 1.5);
}

TEST(Range, PassesOverWhatIsNoNumber) {
  Range range;
  range.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(range.empty);
  range.add(3);
  range.add(-std::numeric_limits<double>::infinity());
  EXPECT_EQ(range.low, 3);
  EXPECT_EQ(range.high, 3);
}

}  // namespace
}  // namespace crumple::report::quantiser_test
