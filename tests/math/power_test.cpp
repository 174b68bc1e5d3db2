// SPDX-License-Identifier: BSD-3-Clause
#include "math/power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace crumple::math::power_test {
namespace {

/// Distance in units in the last place of `expected`, but at least of `floor`.
template <class Real>
double ulps(Real found, long double expected, long double floor = 0) {
  const auto magnitude = static_cast<Real>(std::max(std::fabs(expected), floor));
  const Real ulp = std::nextafter(magnitude, std::numeric_limits<Real>::infinity()) - magnitude;
  return static_cast<double>(std::fabs(static_cast<long double>(found) - expected) /
                             static_cast<long double>(ulp));
}

template <class Real>
void check_log2(double from, double to) {
  double worst = 0;
  for (double e = from; e < to; e += 0.0137) {
    const auto x = static_cast<Real>(std::exp2(e));
    worst = std::max(worst, ulps(binary_log(x), std::log2(static_cast<long double>(x)), 1.0L));
  }
  EXPECT_LE(worst, 3.0);
}

TEST(Power, Log2WithinThreeUlps) {
  check_log2<float>(-120, 120);
  check_log2<double>(-1000, 1000);
  EXPECT_EQ(binary_log(8.0), 3.0);
  EXPECT_EQ(binary_log(1.0F), 0.0F);
}

template <class Real>
void check_exp2(double limit) {
  double worst = 0;
  for (double e = -limit; e < limit; e += 0.0137) {
    const auto x = static_cast<Real>(e);
    worst = std::max(worst, ulps(power_of_two(x), std::exp2(static_cast<long double>(x))));
  }
  EXPECT_LE(worst, 2.0);
}

TEST(Power, Exp2WithinTwoUlps) {
  check_exp2<float>(120);
  check_exp2<double>(1000);
  EXPECT_EQ(power_of_two(10.0), 1024.0);
  EXPECT_EQ(power_of_two(-1.0F), 0.5F);
}

TEST(Power, RateFactorsOfCowperAndSymonds) {
  for (double x = 1e-8; x < 1e8; x *= 1.7)
    for (const double p : {1.0, 3.0, 5.0, 8.0}) {
      EXPECT_NEAR(power(x, 1 / p), std::pow(x, 1 / p), 1e-14 * std::pow(x, 1 / p));
      const auto exact = static_cast<float>(std::pow(x, 1 / p));
      EXPECT_NEAR(power(static_cast<float>(x), static_cast<float>(1 / p)), exact, 3e-6F * exact);
    }
  EXPECT_EQ(power(0.0, 0.2), 0.0);
  EXPECT_EQ(power(0.0F, 0.2F), 0.0F);
}

TEST(Power, PacksGiveTheBitsOfTheScalar) {
  using Pack = simd::native_simd<double>;
  for (double x = 1e-8; x < 1e8; x *= 3.1) {
    const Pack found = power(Pack(x), Pack(0.2));
    for (std::size_t lane = 0; lane < Pack::size(); ++lane) EXPECT_EQ(found[lane], power(x, 0.2));
  }
}

}  // namespace
}  // namespace crumple::math::power_test
