// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "cellsearch/box.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// The region that is divided into cells and the number of cells along x, y, z: (xmin, xmax, Nx) and so on in
/// the paper. It may cover only part of a model; then only nodes inside it (surface included) count.
struct CellDomain {
  Box box;
  std::array<Index, 3> cells{1, 1, 1};
};

/// Cells from first to last (both included) along each axis.
struct CellRange {
  std::array<Index, 3> first{0, 0, 0};
  std::array<Index, 3> last{0, 0, 0};
};

/// Equal axis-parallel cells, fixed in space: eq. (5) and (6) of the paper.
class CellGrid {
 public:
  /// One cell at the origin.
  CellGrid();

  /// Throws Error(BadDomain) if the box is empty or not finite, if a number of cells is below 1, if their
  /// product exceeds 2^31 - 1, or if an axis with more than one cell is too thin or too long for eq. (5) to
  /// be finite. An axis of no extent is allowed with one cell (plane problems).
  explicit CellGrid(const CellDomain& domain);

  /// Eq. (5): floor(Nx (x - xmin) / (xmax - xmin)) for axis 0, likewise 1 and 2, clamped to 0..Nx-1 so that
  /// x = xmax falls into the last cell. Never decreases with x, also in floating point: this is why the range
  /// of cells of a box contains the cell of every point inside the box.
  Index axis_cell(int axis, double coordinate) const {
    const double place = (coordinate - domain_.box.lo[axis]) * cells_per_length_[axis];
    const Index last = domain_.cells[axis] - 1;
    // Compare before converting: a number outside the range of Index must not be converted.
    if (!(place > 0.0)) return 0;
    return place >= static_cast<double>(last) ? last : static_cast<Index>(place);
  }

  /// Eq. (6): Ic = Iz Nx Ny + Iy Nx + Ix.
  Index cell_number(Index ix, Index iy, Index iz) const {
    return (iz * domain_.cells[1] + iy) * domain_.cells[0] + ix;
  }

  /// The cell of the point `xyz` (3 numbers), clamped into the domain.
  Index cell_of(const double* xyz) const {
    return cell_number(axis_cell(0, xyz[0]), axis_cell(1, xyz[1]), axis_cell(2, xyz[2]));
  }

  /// The cells that a box intersects, clamped into the domain.
  CellRange cells_of(const Box& box) const {
    CellRange range;
    for (int axis = 0; axis < 3; ++axis) {
      range.first[axis] = axis_cell(axis, box.lo[axis]);
      range.last[axis] = axis_cell(axis, box.hi[axis]);
    }
    return range;
  }

  /// Ncell, the number of all cells.
  Index count() const { return domain_.cells[0] * domain_.cells[1] * domain_.cells[2]; }

  /// The region and the numbers of cells.
  const CellDomain& domain() const { return domain_; }

 private:
  CellDomain domain_;
  Point cells_per_length_{0.0, 0.0, 0.0};  // 0 on an axis of one cell: everything falls into cell 0
};

/// A domain that contains `nodes` (their bounding box [length]; may be flat or empty), with cells of about
/// `cell_edge` [length], and never more than `max_cells` cells: where a sparse scene would need more, all
/// cells are made larger. An edge that is not positive and finite is replaced by what gives about
/// `max_cells`.
CellDomain automatic_domain(const Box& nodes, double cell_edge, Offset max_cells);

}  // namespace cellsearch
