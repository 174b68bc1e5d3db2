// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/box.hpp"
#include "cellsearch/cell_grid.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch::queries {

/// Points in equal cells, about one point per cell. Memory is re-used from one build to the next.
class PointGrid {
 public:
  /// Sorts the points (3 finite numbers each [length]) into cells. O(points).
  void build(std::span<const double> xyz, int threads);

  /// Appends the numbers of all points inside the closed box, in any order. Any number of threads at once.
  void collect(const Box& box, Array<Index>& found) const;

  /// Memory in use [bytes].
  Offset bytes() const;

 private:
  CellGrid grid_;
  Box bounds_;
  Array<Index> first_;    // cells + 1
  Array<Index> points_;   // by cells
  Array<double> sorted_;  // coordinates, by cells
};

}  // namespace cellsearch::queries
