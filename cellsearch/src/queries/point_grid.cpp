// SPDX-License-Identifier: BSD-3-Clause
#include "queries/point_grid.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace cellsearch::queries {

void PointGrid::build(std::span<const double> xyz, int /*threads*/) {
  const Index count = static_cast<Index>(xyz.size() / 3);
  const auto point = [&](Index i) { return xyz.data() + 3 * static_cast<std::size_t>(i); };
  bounds_ = Box{};
  for (Index i = 0; i < count; ++i) bounds_.include(point(i));
  grid_ = CellGrid(automatic_domain(bounds_, 0.0, std::max(count, 1)));
  first_.resize(static_cast<std::size_t>(grid_.count()) + 2);
  std::fill(first_.begin(), first_.end(), 0);
  for (Index i = 0; i < count; ++i) ++first_[static_cast<std::size_t>(grid_.cell_of(point(i))) + 2];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  points_.resize(static_cast<std::size_t>(count));
  sorted_.resize(xyz.size());
  for (Index i = 0; i < count; ++i) {
    const Index place = first_[static_cast<std::size_t>(grid_.cell_of(point(i))) + 1]++;
    points_[static_cast<std::size_t>(place)] = i;
    std::copy_n(point(i), 3, sorted_.data() + 3 * static_cast<std::size_t>(place));
  }
}

void PointGrid::collect(const Box& box, Array<Index>& found) const {
  if (points_.empty() || !box.intersects(bounds_)) return;
  const CellRange range = grid_.cells_of(box);
  for (Index iz = range.first[2]; iz <= range.last[2]; ++iz) {
    for (Index iy = range.first[1]; iy <= range.last[1]; ++iy) {
      const Index begin = first_[static_cast<std::size_t>(grid_.cell_number(range.first[0], iy, iz))];
      const Index end = first_[static_cast<std::size_t>(grid_.cell_number(range.last[0], iy, iz)) + 1];
      for (Index place = begin; place < end; ++place) {
        if (box.contains(sorted_.data() + 3 * static_cast<std::size_t>(place))) {
          found.push_back(points_[static_cast<std::size_t>(place)]);
        }
      }
    }
  }
}

Offset PointGrid::bytes() const {
  return static_cast<Offset>((first_.size() + points_.size()) * sizeof(Index) +
                             sorted_.size() * sizeof(double));
}

}  // namespace cellsearch::queries
