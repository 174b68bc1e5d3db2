// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

namespace crumple::math {

/// Angle of the point (x, y) from the x axis, from -pi to pi, as std::atan2, to a few units in the last
/// place; zero for the origin. The mathematical library's differs between processors; this one uses only
/// sums, products, quotients and roots, and has the same bits everywhere: tan(a/2) = t / (1 + sqrt(1 + t^2))
/// three times, then the series of the arctangent, whose next term is below 1e-18.
inline double arctangent(double y, double x) {
  if (x == 0 && y == 0) return 0;
  const bool is_steep = std::fabs(y) > std::fabs(x);
  double t = is_steep ? x / y : y / x;
  constexpr int halvings = 3;
  for (int i = 0; i < halvings; ++i) t = t / (1 + std::sqrt(1 + t * t));
  constexpr int terms = 9;
  double series = 1.0 / (2 * terms - 1);
  for (int k = terms - 2; k >= 0; --k) series = 1.0 / (2 * k + 1) - t * t * series;
  const double angle = (1 << halvings) * t * series;
  if (is_steep) return std::copysign(0.5 * std::numbers::pi, y) - angle;
  return x > 0 ? angle : angle + std::copysign(std::numbers::pi, y);
}

}  // namespace crumple::math
