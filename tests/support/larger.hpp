// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace crumple::test {

/// The larger of two numbers, and no number if one of them is none: std::max(a, NaN) is a, and a largest
/// error made with it says nothing of what went wrong.
inline double larger_of(double a, double b) {
  return a > b || std::isnan(a) ? a : b;
}

}  // namespace crumple::test
