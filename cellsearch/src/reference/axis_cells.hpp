// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "finder.hpp"

namespace cellsearch {

/// Equal cells along one axis, over a closed interval of coordinates. CellGrid's eq. (5) for methods that do
/// not number the cells of a whole box, and whose intervals and numbers of cells may differ from place to
/// place.
struct AxisCells {
  /// A method may multiply the cells of three axes: 2^60 still is a number.
  static constexpr Index most_cells = 1 << 20;

  double lo = 0.0;
  double hi = 0.0;
  double per_length = 0.0;  // 0 for one cell: everything falls into cell 0
  Index count = 1;

  /// Cells over lo..hi that are `width` wide [length] or a little wider, at least 1 and at most `most`: then
  /// much wider. Not a number, 0 or infinity as a width are no error: they give `most` or one.
  static AxisCells of_width(double lo, double hi, double width, Index most) {
    AxisCells cells{lo, hi};
    const double wanted = std::min(std::floor((hi - lo) / width), static_cast<double>(most));
    const double per_length = wanted / (hi - lo);
    // Fails for what is not a number, too.
    if (wanted > 1.0 && std::isfinite(per_length) && per_length > 0.0) {
      cells.count = static_cast<Index>(wanted);
      cells.per_length = per_length;
    }
    return cells;
  }

  /// The cell of a coordinate, clamped to the first and the last one. Never decreases with the coordinate,
  /// also in floating point.
  Index of(double coordinate) const {
    const double place = (coordinate - lo) * per_length;
    if (!(place > 0.0)) return 0;
    return place >= static_cast<double>(count - 1) ? count - 1 : static_cast<Index>(place);
  }

  /// True if the closed interval from..to reaches the cells.
  bool meets(double from, double to) const { return from <= hi && to >= lo; }
};

/// True if `node` counts: it lies in the domain, if the user has given one.
inline bool in_limit(const FinderInput& input, Index node) {
  return !input.limit || input.limit->contains(input.scene.positions[node]);
}

/// The bounding box of the nodes that count [length]; empty if there is none.
inline Box bounds_of_nodes(const FinderInput& input) {
  Box bounds;
  const Index places = static_cast<Index>(input.scene.participants());
  for (Index place = 0; place < places; ++place) {
    const Index node = input.scene.participant(place);
    if (in_limit(input, node)) bounds.include(input.scene.positions[node]);
  }
  return bounds;
}

/// The width of cells along each axis [length] for a method whose memory does not depend on their number:
/// that of the user's domain, else the edge asked for by the settings, not the larger one to which the grid
/// may have grown to save memory. If all segments are points there is no edge, and the grid's is taken.
inline Point cell_widths(const FinderInput& input) {
  Point widths{input.cell_edge, input.cell_edge, input.cell_edge};
  if (!input.limit && input.cell_edge > 0.0) return widths;
  const CellDomain& domain = input.grid.domain();
  for (int axis = 0; axis < 3; ++axis) {
    widths[axis] = (domain.box.hi[axis] - domain.box.lo[axis]) / domain.cells[axis];
  }
  return widths;
}

}  // namespace cellsearch
