// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "cellsearch/box.hpp"
#include "cellsearch/edges.hpp"
#include "cellsearch/error.hpp"
#include "cellsearch/pairs.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch {

class BoxPairs;

/// What a search for pairs of edges looks at, as views of the caller's memory.
struct EdgeScene {
  Positions positions;
  Edges edges;  ///< for instance from unique_edges(); errors that name a segment name an edge here

  /// By which the bounding box of every edge is expanded on all sides [length], >= 0.
  double expansion = 0.0;

  /// One further expansion per edge [length], >= 0, added to `expansion`, or empty.
  std::span<const double> edge_expansion{};

  /// The edges that take part (feature edges, say), strictly ascending; all edges if not set. The rest are in
  /// no pair, and nothing but their place in the numbering counts.
  std::optional<std::span<const Index>> subset{};

  /// Who may touch whom: the number of groups, the group of each edge, and a matrix (row by column) of which
  /// one entry that is not 0 allows the pair, whichever of the two groups is the row. No groups: everyone.
  Index group_count = 0;
  std::span<const Index> edge_group{};
  std::span<const std::uint8_t> allow{};

  /// The whole expansion of `edge` [length].
  double expansion_of(Index edge) const {
    return edge_expansion.empty() ? expansion : expansion + edge_expansion[static_cast<std::size_t>(edge)];
  }

  /// The closed box of an edge: the bounding box of its two nodes, expanded on all sides [length].
  Box box_of(Index edge) const {
    const Index* nodes = edges[edge];
    Box box;
    box.include(positions[nodes[0]]);
    box.include(positions[nodes[1]]);
    return box.expanded(expansion_of(edge));
  }

  /// Number of edges that take part.
  std::size_t participants() const { return subset ? subset->size() : edges.count(); }

  /// The number of the participant at `place`; ascends with `place`.
  Index participant(Index place) const { return subset ? (*subset)[static_cast<std::size_t>(place)] : place; }
};

/// How to search for pairs of edges.
struct EdgePairSettings {
  /// Leaves out pairs that have a node in common, which always touch.
  bool exclude_shared_nodes = true;

  /// Number of threads, >= 1. The results are bitwise the same for any number.
  int threads = 1;
};

/// Which edges are near which: all pairs i < j of participating edges whose closed boxes (bounding box of the
/// two nodes, expanded by the edge's own expansion) have a point in common.
///
/// Time and memory are O(edges + pairs) for lengths mixed in any way, times the number of different powers of
/// two among the lengths. Keep the object: it re-uses its memory. One thread at a time may use it.
class EdgePairSearch {
 public:
  /// Throws Error(BadSetting).
  explicit EdgePairSearch(const EdgePairSettings& settings = {});
  ~EdgePairSearch();
  EdgePairSearch(EdgePairSearch&&) noexcept;
  EdgePairSearch& operator=(EdgePairSearch&&) noexcept;
  EdgePairSearch(const EdgePairSearch&) = delete;
  EdgePairSearch& operator=(const EdgePairSearch&) = delete;

  /// All pairs, one row per edge, participating or not. The scene is looked at during this call only. The
  /// result belongs to this object and is overwritten by the next call. Throws Error (BadLayout, EmptyInput,
  /// NonFiniteCoordinate by node, BadConnectivity, BadExpansion and BadSegmentGroup by edge, BadNodeList by
  /// place in `subset`); the result is then empty.
  const Pairs& find(const EdgeScene& scene);

  /// Calls visitor(i, j) for all pairs of `scene` in ascending order; what it throws reaches the caller.
  template <class Visitor>
  void visit(const EdgeScene& scene, Visitor&& visitor) {
    find(scene).visit(std::forward<Visitor>(visitor));
  }

  /// Moves the last result out of the object.
  Pairs take() { return std::move(pairs_); }

  /// Box tests made by the last search; the same for any number of threads.
  Offset visits() const;

  /// Working memory besides the result [bytes].
  Offset bytes() const;

 private:
  EdgePairSettings settings_;
  Pairs pairs_;
  std::unique_ptr<BoxPairs> boxes_;
};

}  // namespace cellsearch
