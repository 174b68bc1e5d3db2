// SPDX-License-Identifier: BSD-3-Clause
#include "neighbour_lists.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace cellsearch {
namespace {

/// Calls use(segment, node) once for each different corner of each active segment.
template <class Use>
void for_corners(const Scene& scene, const Use& use) {
  const Index count = static_cast<Index>(scene.segments.count());
  for (Index segment = 0; segment < count; ++segment) {
    if (!scene.active(segment)) continue;
    const Index* own = scene.segments[segment];
    for (int corner = 0; corner < 4; ++corner) {
      if (std::find(own, own + corner, own[corner]) == own + corner) use(segment, own[corner]);
    }
  }
}

}  // namespace

void NeighbourLists::build(const Scene& scene, bool wanted) {
  first_.clear();
  segments_.clear();
  if (!wanted) return;
  // Counted two entries on and summed, entry node + 1 is the beginning of the row; filling moves it to the
  // end.
  first_.resize(scene.positions.count() + 2);
  std::fill(first_.begin(), first_.end(), Offset{0});
  for_corners(scene, [&](Index, Index node) { ++first_[static_cast<std::size_t>(node) + 2]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  segments_.resize(static_cast<std::size_t>(first_.back()));
  for_corners(scene, [&](Index segment, Index node) {
    segments_[static_cast<std::size_t>(first_[static_cast<std::size_t>(node) + 1]++)] = segment;
  });
}

bool NeighbourLists::adjoins(const Segments& mesh, Index segment, Index node) const {
  const Index* own = mesh[segment];
  const std::span<const Index> of_node = around(node);
  std::size_t of_corners = 0;
  for (int corner = 0; corner < 4; ++corner) of_corners += around(own[corner]).size();
  // From whichever side has fewer segments: a node with very many must not make every test expensive.
  if (of_node.size() <= of_corners) {
    return std::any_of(of_node.begin(), of_node.end(), [&](Index other) {
      const Index* its = mesh[other];
      return std::any_of(its, its + 4, [&](Index corner) { return mesh.owns(segment, corner); });
    });
  }
  return std::any_of(own, own + 4, [&](Index corner) { return connected(mesh, corner, node); });
}

bool NeighbourLists::connected(const Segments& mesh, Index one, Index other) const {
  std::span<const Index> shorter = around(one);
  Index sought = other;
  if (around(other).size() < shorter.size()) {
    shorter = around(other);
    sought = one;
  }
  return std::any_of(shorter.begin(), shorter.end(),
                     [&](Index segment) { return mesh.owns(segment, sought); });
}

Offset NeighbourLists::bytes() const {
  return static_cast<Offset>(first_.size() * sizeof(Offset) + segments_.size() * sizeof(Index));
}

}  // namespace cellsearch
