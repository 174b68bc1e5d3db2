// SPDX-License-Identifier: BSD-3-Clause
#include "math/cube_root.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crumple::math::cube_root_test {
namespace {

/// Largest error over half the range of exponents, in units in the last place.
template <class Real>
double worst_error(double from, double to) {
  double worst = 0;
  for (double e = from; e < to; e += 0.00173) {
    const auto x = static_cast<Real>(std::exp2(e));
    const long double exact = std::cbrt(static_cast<long double>(x));
    const auto near = static_cast<Real>(exact);
    const Real ulp = std::nextafter(near, std::numeric_limits<Real>::infinity()) - near;
    worst = std::max(worst, static_cast<double>(std::fabs(static_cast<long double>(cube_root(x)) - exact) /
                                                static_cast<long double>(ulp)));
  }
  return worst;
}

TEST(CubeRoot, WithinFourUlps) {
  EXPECT_LE(worst_error<float>(-100, 100), 4.0);
  EXPECT_LE(worst_error<double>(-900, 900), 4.0);
}

TEST(CubeRoot, OfPacksIsThatOfEachNumber) {
  using Pack = simd::native_simd<float>;
  for (float x = 1e-20F; x < 1e20F; x *= 1.37F)
    EXPECT_NEAR(cube_root(Pack(x))[0], std::cbrt(x), 4e-7F * std::cbrt(x));
}

TEST(CubeRoot, OfWhatIsNotPositiveIsZero) {
  EXPECT_EQ(cube_root(0.0), 0.0);
  EXPECT_EQ(cube_root(-8.0), 0.0);
  EXPECT_EQ(cube_root(-8.0F), 0.0F);
}

}  // namespace
}  // namespace crumple::math::cube_root_test
