// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cellsearch/array.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/types.hpp"

namespace cellsearch {

/// The different edges of `segments`, each once however many segments share it: two node numbers per edge,
/// the smaller first; edges ascending by the first node, then by the second. A quadrilateral has four edges,
/// a triangle three; an edge from a node to itself is none. `active`: one number per segment, 0 for those
/// that are left out, or empty. O(segments). The array is the caller's.
///
/// Throws Error(BadLayout) if lengths do not fit and Error(BadConnectivity) for a negative node number.
Array<Index> unique_edges(const Segments& segments, std::span<const std::uint8_t> active = {});

/// View of edges in the caller's memory: two node numbers per edge. Nothing is copied or owned.
class Edges {
 public:
  Edges() = default;

  /// `nodes`: two node numbers per edge.
  Edges(std::span<const Index> nodes) : nodes_(nodes) {}

  /// Number of edges.
  std::size_t count() const { return nodes_.size() / 2; }

  /// The two node numbers of `edge`, not checked.
  const Index* operator[](Index edge) const { return nodes_.data() + 2 * static_cast<std::size_t>(edge); }

  /// True if the two edges have a node in common.
  bool share_node(Index one, Index other) const {
    const Index* a = (*this)[one];
    const Index* b = (*this)[other];
    return ((a[0] == b[0]) | (a[0] == b[1]) | (a[1] == b[0]) | (a[1] == b[1])) != 0;
  }

  /// The caller's span.
  std::span<const Index> nodes() const { return nodes_; }

 private:
  std::span<const Index> nodes_;
};

}  // namespace cellsearch
