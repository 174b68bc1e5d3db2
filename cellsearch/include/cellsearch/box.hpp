// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "cellsearch/types.hpp"

namespace cellsearch {

/// Closed axis-parallel box lo <= x <= hi [length]. As constructed it is empty and holds no point.
struct Box {
  Point lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Point hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
           -std::numeric_limits<double>::infinity()};

  /// True if no point is inside.
  bool empty() const { return !(lo[0] <= hi[0] && lo[1] <= hi[1] && lo[2] <= hi[2]); }

  /// True if the point `xyz` (3 numbers) is inside or on the surface. A non-finite coordinate is outside.
  bool contains(const double* xyz) const {
    return xyz[0] >= lo[0] && xyz[0] <= hi[0] && xyz[1] >= lo[1] && xyz[1] <= hi[1] && xyz[2] >= lo[2] &&
           xyz[2] <= hi[2];
  }

  /// True if the boxes share at least one point; touching counts.
  bool intersects(const Box& other) const {
    return lo[0] <= other.hi[0] && other.lo[0] <= hi[0] && lo[1] <= other.hi[1] && other.lo[1] <= hi[1] &&
           lo[2] <= other.hi[2] && other.lo[2] <= hi[2];
  }

  /// Grows so that it contains the point `xyz` (3 numbers).
  void include(const double* xyz) {
    for (int axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], xyz[axis]);
      hi[axis] = std::max(hi[axis], xyz[axis]);
    }
  }

  /// Grows so that it contains `other`.
  void include(const Box& other) {
    for (int axis = 0; axis < 3; ++axis) {
      lo[axis] = std::min(lo[axis], other.lo[axis]);
      hi[axis] = std::max(hi[axis], other.hi[axis]);
    }
  }

  /// The box moved outwards by `distance` [length] on all six sides.
  Box expanded(double distance) const {
    Box result = *this;
    for (int axis = 0; axis < 3; ++axis) {
      result.lo[axis] -= distance;
      result.hi[axis] += distance;
    }
    return result;
  }
};

}  // namespace cellsearch
