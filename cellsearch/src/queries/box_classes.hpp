// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/box.hpp"
#include "cellsearch/types.hpp"
#include "queries/point_grid.hpp"

namespace cellsearch {

/// Boxes by size: a class for each power of two of the largest extent, and in each class a grid over the
/// centres. Boxes of one class can be found through their centres without looking far, because none of them
/// reaches further than the largest of its class. Memory is re-used.
class BoxClasses {
 public:
  /// Everything below 2^-63 of the largest box is in the lowest class.
  static constexpr int most = 64;

  /// Sorts the boxes; empty ones are left out. O(boxes).
  void build(std::span<const Box> boxes, int threads);

  /// The class of a box that is not empty.
  int class_of(Index box) const { return class_of_[static_cast<std::size_t>(box)]; }

  /// The next larger class that is not empty, or `most`.
  int next(int size_class) const { return next_[static_cast<std::size_t>(size_class)]; }

  /// Empties `found`, then lists all boxes of the class that may have a point in common with `box`, and some
  /// more; in any order.
  void near(const Box& box, int size_class, Array<Index>& found) const;

  /// Memory in use [bytes].
  Offset bytes() const;

 private:
  struct Class {
    Index begin = 0;
    Index end = 0;
    Box centres;
    Point reach{0.0, 0.0, 0.0};  // largest half extents
    queries::PointGrid grid;
  };

  void sort(std::span<const Box> boxes, int threads);
  void place_centres(std::span<const Box> boxes, Class& its);

  Array<std::uint8_t> class_of_;
  Array<Index> order_;     // boxes by class
  Array<double> centres_;  // in the same order
  std::array<Class, most> classes_;
  std::array<int, most> next_{};
};

}  // namespace cellsearch
