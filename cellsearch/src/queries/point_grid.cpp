// SPDX-License-Identifier: BSD-3-Clause
#include "queries/point_grid.hpp"

#include <algorithm>
#include <numeric>

namespace cellsearch::queries {
namespace {

constexpr Index crowd = 32;

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

void PointGrid::build(std::span<const double> xyz, int /*threads*/) {
  const Index count = static_cast<Index>(xyz.size() / 3);
  levels_.clear();
  starts_.clear();
  child_.clear();
  points_.resize(at(count));
  std::iota(points_.begin(), points_.end(), 0);
  sorted_.assign(xyz.begin(), xyz.end());
  spare_points_.resize(at(count));
  spare_sorted_.resize(xyz.size());
  if (count == 0) return;
  sort(0, count);
  for (std::size_t number = 0; number < levels_.size(); ++number) {
    const std::size_t first = levels_[number].first_cell;
    const std::size_t last = first + at(levels_[number].cells.count());
    for (std::size_t cell = first; cell < last; ++cell) {
      const Index begin = starts_[cell];
      const Index end = starts_[cell + 1];
      if (end - begin <= crowd) continue;
      const std::size_t levels = levels_.size();
      sort(begin, end);
      if (levels_.size() > levels) child_[cell] = static_cast<Index>(levels);
    }
  }
}

/// Sorts a run of points into a level of their own, unless they cannot be told apart.
void PointGrid::sort(Index begin, Index end) {
  const auto point = [&](Index place) { return sorted_.data() + 3 * at(place); };
  Box bounds;
  for (Index place = begin; place < end; ++place) bounds.include(point(place));
  Level level{CellGrid(automatic_domain(bounds, 0.0, end - begin)), starts_.size()};
  if (level.cells.count() == 1 && !levels_.empty()) return;
  // Counted one entry on and summed, an entry is the beginning of the cell after it; then it moves to its
  // own.
  starts_.resize(level.first_cell + at(level.cells.count()) + 1);
  child_.resize(starts_.size());
  const auto starts = starts_.begin() + static_cast<std::ptrdiff_t>(level.first_cell);
  std::fill(starts, starts_.end(), 0);
  std::fill(child_.begin() + static_cast<std::ptrdiff_t>(level.first_cell), child_.end(), -1);
  for (Index place = begin; place < end; ++place) ++starts[level.cells.cell_of(point(place))];
  std::partial_sum(starts, starts_.end(), starts);
  for (auto entry = starts; entry != starts_.end(); ++entry) *entry += begin;
  for (Index place = end - 1; place >= begin; --place) {
    const Index to = --starts[level.cells.cell_of(point(place))];
    spare_points_[at(to)] = points_[at(place)];
    std::copy_n(point(place), 3, spare_sorted_.data() + 3 * at(to));
  }
  std::copy(spare_points_.begin() + begin, spare_points_.begin() + end, points_.begin() + begin);
  std::copy(spare_sorted_.begin() + 3 * Offset{begin}, spare_sorted_.begin() + 3 * Offset{end},
            sorted_.begin() + 3 * Offset{begin});
  levels_.push_back(level);
}

void PointGrid::collect(const Box& box, Array<Index>& found) const {
  if (!levels_.empty() && box.intersects(levels_[0].cells.domain().box)) collect(levels_[0], box, found);
}

void PointGrid::collect(const Level& level, const Box& box, Array<Index>& found) const {
  const CellRange range = level.cells.cells_of(box);
  for (Index iz = range.first[2]; iz <= range.last[2]; ++iz) {
    for (Index iy = range.first[1]; iy <= range.last[1]; ++iy) {
      // Cells along x lie one after another, and so do their points.
      const std::size_t first = level.first_cell + at(level.cells.cell_number(range.first[0], iy, iz));
      const std::size_t last = level.first_cell + at(level.cells.cell_number(range.last[0], iy, iz));
      if (levels_.size() == 1 || starts_[last + 1] - starts_[first] <= crowd) {
        collect_run(starts_[first], starts_[last + 1], box, found);
        continue;
      }
      for (std::size_t cell = first; cell <= last; ++cell) {
        if (child_[cell] < 0) {
          collect_run(starts_[cell], starts_[cell + 1], box, found);
        } else if (const Level& child = levels_[at(child_[cell])]; box.intersects(child.cells.domain().box)) {
          collect(child, box, found);
        }
      }
    }
  }
}

void PointGrid::collect_run(Index begin, Index end, const Box& box, Array<Index>& found) const {
  // Written in any case and kept if inside: whether a point is inside cannot be predicted.
  const std::size_t before = found.size();
  found.resize(before + at(end - begin));
  Index* to = found.data() + before;
  const double* xyz = sorted_.data() + 3 * at(begin);
  for (Index place = begin; place < end; ++place, xyz += 3) {
    *to = points_[at(place)];
    const auto within = [&](int axis) {
      return static_cast<int>(xyz[axis] >= box.lo[axis]) & static_cast<int>(xyz[axis] <= box.hi[axis]);
    };
    to += within(0) & within(1) & within(2);
  }
  found.resize(static_cast<std::size_t>(to - found.data()));
}

Offset PointGrid::bytes() const {
  return static_cast<Offset>(levels_.size() * sizeof(Level) +
                             (starts_.size() + child_.size() + points_.size() + spare_points_.size()) *
                                 sizeof(Index) +
                             (sorted_.size() + spare_sorted_.size()) * sizeof(double));
}

}  // namespace cellsearch::queries
