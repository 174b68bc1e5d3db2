// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// The active segments around every node, as compressed rows. Memory is re-used from one build to the next.
class NeighbourLists {
 public:
  /// Builds the lists of a checked scene if it asks for the exclusion of neighbours; else makes them empty.
  /// O(nodes + segments).
  void build(const Scene& scene) { build(scene, scene.exclude_neighbours); }

  /// The same, by the caller's own wish.
  void build(const Scene& scene, bool wanted);

  /// The active segments of which `node` is a corner, ascending.
  std::span<const Index> around(Index node) const {
    const std::size_t begin = static_cast<std::size_t>(first_[static_cast<std::size_t>(node)]);
    const std::size_t end = static_cast<std::size_t>(first_[static_cast<std::size_t>(node) + 1]);
    return {segments_.data() + begin, end - begin};
  }

  /// True if an active segment has both `node` and a corner of `segment` among its corners.
  bool adjoins(const Segments& mesh, Index segment, Index node) const;

  /// True if an active segment has both nodes among its corners.
  bool connected(const Segments& mesh, Index one, Index other) const;

  /// Memory in use [bytes].
  Offset bytes() const;

 private:
  Array<Offset> first_;    // nodes + 1
  Array<Index> segments_;  // the rows
};

}  // namespace cellsearch
