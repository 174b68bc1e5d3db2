// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsearch/box.hpp"
#include "cellsearch/cell_grid.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch {

/// What a node fills in tests of candidates: x - r to x + r, rounded as there.
inline Box reach_of(const Scene& scene, Index node) {
  const double radius = scene.node_radius.empty() ? 0.0 : scene.node_radius[static_cast<std::size_t>(node)];
  const double* xyz = scene.positions[node];
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    box.lo[axis] = xyz[axis] - radius;
    box.hi[axis] = xyz[axis] + radius;
  }
  return box;
}

/// Which cells of the box around a rank's participants have one: the second, finer filter of what other ranks
/// send. Cell numbers never decrease with the coordinate, so a territory that reaches a participant covers a
/// marked cell.
class Footprint {
 public:
  static constexpr Offset most_cells = 4096;
  static constexpr std::size_t words = static_cast<std::size_t>(most_cells) / 64;

  /// Cells over `box`, none marked. Every rank that knows the box makes the same cells.
  void reset(const Box& box);

  /// Marks the cells of all participants of `scene`.
  void mark(const Scene& scene);

  /// True if `territory`, which touches the box, covers a marked cell.
  bool meets(const Box& territory) const;

  /// The marks as they travel, `words` numbers.
  std::span<std::uint64_t> marks() { return marks_; }

 private:
  CellGrid grid_;
  std::vector<std::uint64_t> marks_;
};

}  // namespace cellsearch
