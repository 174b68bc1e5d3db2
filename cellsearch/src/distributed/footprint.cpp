// SPDX-License-Identifier: BSD-3-Clause
#include "footprint.hpp"

#include <cmath>

namespace cellsearch {

namespace {

bool is_finite(const Box& box) {
  bool finite = true;
  for (int axis = 0; axis < 3; ++axis)
    finite = finite && std::isfinite(box.lo[axis]) && std::isfinite(box.hi[axis]);
  return finite;
}

/// Calls use(cell) for the cells of a range until it returns true; tells whether one did.
template <class Use>
bool any_cell(const CellGrid& grid, const CellRange& range, const Use& use) {
  for (Index z = range.first[2]; z <= range.last[2]; ++z) {
    for (Index y = range.first[1]; y <= range.last[1]; ++y) {
      for (Index x = range.first[0]; x <= range.last[0]; ++x) {
        if (use(static_cast<std::size_t>(grid.cell_number(x, y, z)))) return true;
      }
    }
  }
  return false;
}

}  // namespace

void Footprint::reset(const Box& box) {
  // Huge radii may leave the range of numbers: one cell then.
  grid_ = is_finite(box) ? CellGrid(automatic_domain(box, 0.0, most_cells)) : CellGrid();
  marks_.assign(words, 0);
}

void Footprint::mark(const Scene& scene) {
  const auto places = static_cast<Index>(scene.participants());
  for (Index place = 0; place < places; ++place) {
    const CellRange range = grid_.cells_of(reach_of(scene, scene.participant(place)));
    any_cell(grid_, range, [&](std::size_t cell) {
      marks_[cell / 64] |= std::uint64_t{1} << (cell % 64);
      return false;
    });
  }
}

bool Footprint::meets(const Box& territory) const {
  return any_cell(grid_, grid_.cells_of(territory),
                  [&](std::size_t cell) { return (marks_[cell / 64] >> (cell % 64) & 1U) != 0; });
}

}  // namespace cellsearch
