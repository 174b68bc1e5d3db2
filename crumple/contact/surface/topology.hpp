// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index.hpp"

namespace crumple::contact {

/// How the surface goes on at an edge of a segment.
enum class EdgeKind : std::uint8_t {
  Free,      ///< one segment: the surface ends here, rounded like a half cylinder
  Shared,    ///< two segments, oriented alike: the surface goes on
  Junction,  ///< three or more segments, or two that no orientation can reconcile (a Moebius strip)
};

/// Which segments touch which nodes and edges. Made at the start and when segments have gone; never depends
/// on the thread count.
struct Topology {
  std::vector<std::array<Index, 4>> edges_of;  ///< edge k of a segment joins its nodes k and k+1; no_index
                                               ///< for the edge that a triangle lacks
  std::vector<EdgeKind> kind;                  ///< per edge
  std::vector<Index> first_at_edge;            ///< rows of segment_at_edge, and one past the last
  std::vector<Index> segment_at_edge;          ///< ascending in each row
  std::vector<Index> first_at_node;            ///< rows of segment_at_node, by place of the node
  std::vector<Index> segment_at_node;          ///< ascending in each row
  std::vector<std::uint8_t> smooth_node;       ///< 1 where one closed fan of shared edges surrounds the node

  Index edges() const { return static_cast<Index>(kind.size()); }
  std::span<const Index> at_edge(Index edge) const {
    return std::span(segment_at_edge)
        .subspan(first_at_edge[edge], first_at_edge[edge + 1] - first_at_edge[edge]);
  }
  std::span<const Index> at_node(Index place) const {
    return std::span(segment_at_node)
        .subspan(first_at_node[place], first_at_node[place + 1] - first_at_node[place]);
  }
};

/// True if edge k of the four nodes at `segment` exists; a triangle repeats its last node.
inline bool has_edge(const Index* segment, int k) {
  return segment[k] != segment[(k + 1) % 4];
}

/// Reverses the order of the four nodes of a segment; a triangle still repeats its last.
void reverse_segment(Index* nodes);

/// Reverses segments (in place) so that neighbours run through their common edge in opposite directions
/// wherever that is possible, starting from those that must stay (1 in `keep`), and else from the lowest
/// segment of each connected piece. Only those that are `active` count as neighbours. `connectivity` holds
/// four nodes per segment. O(N log N).
void orient_alike(std::vector<Index>& connectivity, const std::vector<std::uint8_t>& active,
                  const std::vector<std::uint8_t>& keep);

/// Collects edges and neighbours of the segments that are `active`. `place` gives the place of a node;
/// `nodes` is the number of places.
Topology build_topology(const std::vector<Index>& connectivity, const std::vector<std::uint8_t>& active,
                        const std::vector<Index>& place, Index nodes);

}  // namespace crumple::contact
