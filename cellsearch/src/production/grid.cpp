// SPDX-License-Identifier: BSD-3-Clause
#include "production/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cellsearch::production {
namespace {

// Nodes that have moved a little since the grid was made must not reach the limit.
constexpr double most_cells_along = (lattice_limit / 2) >> (fine_bits + cross_bits);

/// Half the extent, which is finite even where the extent is not.
double half_extent(const Box& box, int axis) {
  return 0.5 * box.hi[axis] - 0.5 * box.lo[axis];
}

double edge_of(const CellEdges& edges, int axis) {
  return axis == edges.run_axis ? edges.run : edges.cross;
}

double cells_along(const Box& nodes, const CellEdges& edges, int axis) {
  const double half = half_extent(nodes, axis);
  const double cells = half > 0.0 ? std::floor(half / (0.5 * edge_of(edges, axis))) + 1.0 : 1.0;
  return cells < most_cells_along ? cells : most_cells_along;
}

}  // namespace

double cells_for(const Box& nodes, const CellEdges& edges) {
  double product = 1.0;
  for (int axis = 0; axis < 3; ++axis) product *= cells_along(nodes, edges, axis) + 1.0;
  return product;
}

Grid make_grid(const Box& nodes, const CellEdges& edges) {
  Grid grid;
  const int run = edges.run_axis;
  grid.axis = {run, (run + 1) % 3, (run + 2) % 3};
  Offset step = 1;
  for (const int axis : grid.axis) {
    const double cells = cells_along(nodes, edges, axis);
    const int bits = fine_bits + (axis == run ? run_bits : cross_bits);
    const double half = half_extent(nodes, axis);
    // An extent that double precision cannot divide is one cell: everything falls into it.
    double scale = std::ldexp(cells, bits - 1) / half;
    if (half > 0.0) scale = std::min(scale, std::ldexp(1.0 / (0.5 * edge_of(edges, axis)), bits - 1));
    if (!(half > 0.0) || !std::isfinite(scale) || !std::isfinite(nodes.lo[axis] * scale) || scale == 0.0)
      scale = 0.0;
    grid.scale[axis] = scale;
    grid.offset[axis] = -(nodes.lo[axis] * scale);
    grid.cells[axis] = scale > 0.0 ? static_cast<Index>(cells) : 1;
    grid.top[axis] = (grid.cells[axis] << bits) - 1;
    grid.shift[axis] = bits;
    grid.step[axis] = static_cast<std::int32_t>(step);
    const double largest = std::max(std::fabs(nodes.lo[axis]), std::fabs(nodes.hi[axis]));
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * largest * scale;
    grid.margin[axis] = 3 + static_cast<std::int32_t>(std::min(rounding, 0.25 * lattice_limit));
    step *= grid.cells[axis] + 1;
  }
  grid.cell_count = step;
  return grid;
}

}  // namespace cellsearch::production
