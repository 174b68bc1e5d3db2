// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "cellsearch/error.hpp"

namespace cellsearch {
namespace {

constexpr double most_cells = static_cast<double>(std::numeric_limits<Index>::max());

void check_axis(const CellDomain& domain, int axis) {
  const std::string name(1, static_cast<char>('x' + axis));
  const double lo = domain.box.lo[axis];
  const double hi = domain.box.hi[axis];
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorKind::BadDomain, axis,
                "The cell domain from " + name + " = " + std::to_string(lo) + " to " + std::to_string(hi) +
                    " with " + std::to_string(domain.cells[axis]) + " cells " + what + ".");
  };
  if (!std::isfinite(lo) || !std::isfinite(hi)) fail("is not finite");
  if (lo > hi) fail("is inverted");
  if (domain.cells[axis] < 1) fail("needs at least one cell");
  if (domain.cells[axis] == 1) return;
  if (lo == hi) fail("has no extent, which allows one cell only");
  const double scale = domain.cells[axis] / (hi - lo);
  if (!std::isfinite(scale) || scale <= 0.0) fail("is too thin or too long to be divided");
}

/// floor(extent / edge), at least one; one where the extent is out of the range of numbers.
double cells_along(double extent, double edge) {
  const double cells = std::floor(extent / edge);
  const bool dividable = std::isfinite(extent) && std::isfinite(cells / extent) && cells / extent > 0.0;
  return dividable && cells > 1.0 ? cells : 1.0;
}

}  // namespace

CellGrid::CellGrid() : CellGrid(CellDomain{Box{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {1, 1, 1}}) {}

CellGrid::CellGrid(const CellDomain& domain) : domain_(domain) {
  double product = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    check_axis(domain, axis);
    const Index cells = domain.cells[axis];
    product *= cells;
    if (cells > 1) cells_per_length_[axis] = cells / (domain.box.hi[axis] - domain.box.lo[axis]);
  }
  if (product > most_cells) {
    throw Error(ErrorKind::BadDomain, -1, "The cell domain has more than 2147483647 cells.");
  }
}

CellDomain automatic_domain(const Box& nodes, double cell_edge, Offset max_cells) {
  CellDomain domain{Box{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {1, 1, 1}};
  if (nodes.empty()) return domain;
  domain.box = nodes;
  Point extent;
  for (int axis = 0; axis < 3; ++axis) extent[axis] = nodes.hi[axis] - nodes.lo[axis];
  const double longest = std::max({extent[0], extent[1], extent[2]});
  const double limit = std::clamp(static_cast<double>(max_cells), 1.0, most_cells);
  if (!(longest > 0.0) || !std::isfinite(longest)) return domain;

  double edge = cell_edge;
  if (!(edge > 0.0) || !std::isfinite(edge)) edge = longest / limit;
  // No axis may exceed the limit alone; this also keeps the product below within the range of numbers.
  edge = std::max(edge, longest / limit);
  // Larger cells until they are few enough. For flat scenes the cube root is a cautious step, so this may
  // take some rounds, but every one gains at least 5%.
  for (;;) {
    double product = 1.0;
    for (int axis = 0; axis < 3; ++axis) product *= cells_along(extent[axis], edge);
    if (product <= limit) break;
    edge *= std::max(1.05, std::cbrt(product / limit));
  }
  for (int axis = 0; axis < 3; ++axis) {
    domain.cells[axis] = static_cast<Index>(cells_along(extent[axis], edge));
  }
  return domain;
}

}  // namespace cellsearch
