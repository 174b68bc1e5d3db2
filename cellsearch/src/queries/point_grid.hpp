// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsearch/array.hpp"
#include "cellsearch/box.hpp"
#include "cellsearch/cell_grid.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch::queries {

/// Points in equal cells, about one point per cell on the average; crowded cells have grids of their own, and
/// so on, so that points far apart or in clusters cost no more. Memory is re-used from one build to the next.
class PointGrid {
 public:
  /// Sorts the points (3 finite numbers each [length]) into cells. O(points) for each level of grids.
  void build(std::span<const double> xyz, int threads);

  /// Appends the numbers of all points inside the closed box, in any order. Any number of threads at once.
  void collect(const Box& box, Array<Index>& found) const;

  /// Memory in use [bytes].
  Offset bytes() const;

 private:
  struct Level {
    CellGrid cells;
    std::size_t first_cell = 0;  // in starts_ and child_
  };

  void sort(Index begin, Index end);
  void collect(const Level& level, const Box& box, Array<Index>& found) const;
  void collect_run(Index begin, Index end, const Box& box, Array<Index>& found) const;

  std::vector<Level> levels_;
  Array<Index> starts_;   // by cell; one more for each level
  Array<Index> child_;    // by entry of starts_: the level inside, or -1
  Array<Index> points_;   // by cells
  Array<double> sorted_;  // coordinates, by cells
  Array<Index> spare_points_;
  Array<double> spare_sorted_;
};

}  // namespace cellsearch::queries
