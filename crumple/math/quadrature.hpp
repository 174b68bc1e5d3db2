// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace crumple::math {

/// Points in [-1, 1], ascending, and weights that sum to 1 (not to 2: they are shares of a thickness).
struct Quadrature {
  std::vector<double> point;
  std::vector<double> weight;
};

/// Gauss-Legendre rule of n >= 1 points, exact for polynomials up to degree 2n - 1 (Abramowitz & Stegun
/// 1964, eq. 25.4.29). Computed without the mathematical library: the same bits on every machine.
Quadrature gauss_rule(int n);

/// Gauss-Lobatto rule of n >= 2 points, ends included, exact up to degree 2n - 3 (Abramowitz & Stegun 1964,
/// eq. 25.4.32).
Quadrature lobatto_rule(int n);

/// Trapezoidal rule of n >= 2 points, equally spaced, ends included.
Quadrature trapezoid_rule(int n);

}  // namespace crumple::math
