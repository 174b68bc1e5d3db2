// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"

namespace crumple::model {

/// A piecewise linear function given by points of ascending abscissa (at least two), constant beyond the
/// ends unless the user of the curve says otherwise.
struct Curve {
  UserId id = 0;
  std::vector<double> abscissa;
  std::vector<double> ordinate;

  /// Ordinate at `x`, interpolated; the nearest end's beyond the ends.
  double at(double x) const;
};

}  // namespace crumple::model
