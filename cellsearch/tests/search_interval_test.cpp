// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/search_interval.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace cellsearch::search_interval_test {
namespace {

// Eq. (10) with numbers that are exact in binary: c = 2.5, vmax = 0.5, dtmax = 0.25.
TEST(SearchInterval, FollowsEquation10) {
  EXPECT_EQ(search_interval(2.5, 0.0, 0.5, 0.25, 100), 20);
  EXPECT_EQ(search_interval(2.5, 1.25, 0.5, 0.25, 100), 10);
  EXPECT_EQ(search_interval(2.5, 1.26, 0.5, 0.25, 100), 9);  // rounded down
}

TEST(SearchInterval, IsCapped) {
  EXPECT_EQ(search_interval(2.5, 0.0, 0.5, 0.25, 12), 12);
  EXPECT_EQ(search_interval(2.5, 0.0, 0.0, 0.25, 50), 50);
  EXPECT_EQ(search_interval(2.5, 0.0, 5e-324, 1e-300, 50), 50);
  EXPECT_EQ(search_interval(1e300, 0.0, 1e-300, 1.0, 50), 50);
}

TEST(SearchInterval, IsAtLeastOne) {
  EXPECT_EQ(search_interval(0.1, 0.0, 100.0, 1.0, 50), 1);
  EXPECT_EQ(search_interval(1.0, 1.0, 0.0, 1.0, 50), 1);
  EXPECT_EQ(search_interval(1.0, 2.0, 0.5, 1.0, 50), 1);
  EXPECT_EQ(search_interval(2.5, 0.0, 0.5, 0.25, 0), 1);
  EXPECT_EQ(search_interval(2.5, 0.0, std::numeric_limits<double>::infinity(), 0.25, 50), 1);
}

TEST(SearchInterval, IsCarefulWithNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(search_interval(nan, 0.0, 0.5, 0.25, 50), 1);
  EXPECT_EQ(search_interval(2.5, nan, 0.5, 0.25, 50), 1);
  EXPECT_EQ(search_interval(2.5, 0.0, nan, 0.25, 50), 1);
  EXPECT_EQ(search_interval(2.5, 0.0, 0.5, nan, 50), 1);
  EXPECT_EQ(search_interval(2.5, 0.0, -0.5, 0.25, 50), 1);
  EXPECT_EQ(search_interval(2.5, 0.0, std::numeric_limits<double>::infinity(), 0.0, 50), 1);
}

}  // namespace
}  // namespace cellsearch::search_interval_test
