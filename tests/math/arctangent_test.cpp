// SPDX-License-Identifier: BSD-3-Clause
#include "math/arctangent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace crumple::math::arctangent_test {
namespace {

TEST(Arctangent, IsThatOfTheMathematicalLibrary) {
  constexpr int points = 100000;
  for (int i = 0; i < points; ++i) {
    const double angle = 3.141592 * (2.0 * i / points - 1);
    const double length = 1e-3 + 0.1 * (i % 17);
    const double y = length * std::sin(angle);
    const double x = length * std::cos(angle);
    const double exact = std::atan2(y, x);
    // Each of the three halvings rounds a few times.
    ASSERT_NEAR(arctangent(y, x), exact,
                12 * std::numeric_limits<double>::epsilon() * std::fabs(exact) + 1e-300)
        << angle;
  }
}

TEST(Arctangent, OfAxesAndOfTheOrigin) {
  EXPECT_EQ(arctangent(0, 0), 0);
  EXPECT_EQ(arctangent(0, 2), 0);
  EXPECT_EQ(arctangent(3, 0), std::atan2(3, 0));
  EXPECT_EQ(arctangent(-3, 0), std::atan2(-3, 0));
  EXPECT_EQ(arctangent(0, -1), std::atan2(0.0, -1.0));
  EXPECT_EQ(arctangent(1e-300, 1), 1e-300);
}

}  // namespace
}  // namespace crumple::math::arctangent_test
