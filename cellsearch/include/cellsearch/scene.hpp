// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cellsearch/types.hpp"

namespace cellsearch {

/// View of nodal positions in the caller's memory: node i has x, y, z at values[i * stride + 0, 1, 2]
/// [length]. A stride above 3 serves callers whose records carry more than positions (for instance 8 for
/// a 64-byte record); begin the span at the first x. Nothing is copied or owned.
class Positions {
 public:
  Positions() = default;

  /// `values`: all records one after another; `stride`: doubles from one node to the next, >= 3. What
  /// follows z may be missing in the last record. Fewer than 3 numbers left over make no node.
  Positions(std::span<const double> values, std::size_t stride = 3) : values_(values), stride_(stride) {}

  /// Number of nodes.
  std::size_t count() const {
    return values_.size() < 3 || stride_ < 3 ? 0 : (values_.size() - 3) / stride_ + 1;
  }

  /// The three coordinates of `node`, not checked.
  const double* operator[](Index node) const {
    return values_.data() + static_cast<std::size_t>(node) * stride_;
  }

  /// The caller's span.
  std::span<const double> values() const { return values_; }

  /// Doubles from one node to the next.
  std::size_t stride() const { return stride_; }

 private:
  std::span<const double> values_;
  std::size_t stride_ = 3;
};

/// View of segment connectivity in the caller's memory: 4 node numbers per segment (0-based, in order around
/// it); a triangle repeats its last node. Nothing is copied or owned.
class Segments {
 public:
  Segments() = default;

  /// `nodes`: 4 node numbers per segment.
  Segments(std::span<const Index> nodes) : nodes_(nodes) {}

  /// Number of segments.
  std::size_t count() const { return nodes_.size() / 4; }

  /// The four node numbers of `segment`, not checked.
  const Index* operator[](Index segment) const {
    return nodes_.data() + 4 * static_cast<std::size_t>(segment);
  }

  /// True if `node` is one of the nodes of `segment`. Without a branch: it is part of the inner loop.
  bool owns(Index segment, Index node) const {
    const Index* own = (*this)[segment];
    return ((own[0] == node) | (own[1] == node) | (own[2] == node) | (own[3] == node)) != 0;
  }

  /// The caller's span.
  std::span<const Index> nodes() const { return nodes_; }

 private:
  std::span<const Index> nodes_;
};

/// Who may touch whom, by groups of nodes and of segments (parts, bodies, the two sides of a contact). A node
/// of group b is a candidate of a segment of group a only if allow[a * count + b] is not 0; the matrix need
/// not be symmetric. Views of the caller's memory. As constructed there are no groups, and everyone may touch
/// everyone.
struct Groups {
  Index count = 0;                         ///< number of groups G, numbered from 0; 0: no groups
  std::span<const Index> node_group{};     ///< one per node; not looked at for nodes that take no part
  std::span<const Index> segment_group{};  ///< one per segment
  std::span<const std::uint8_t> allow{};   ///< G x G, row: group of the segment, column: group of the node

  /// True if nodes of group `nodes_of` may be candidates of segments of group `segments_of`; not checked.
  bool allowed(Index segments_of, Index nodes_of) const {
    const std::size_t row = static_cast<std::size_t>(segments_of) * static_cast<std::size_t>(count);
    return allow[row + static_cast<std::size_t>(nodes_of)] != 0;
  }
};

/// Everything that one search looks at, as views of the caller's memory, which must stay alive and unchanged
/// from `Search::build` until the last query that follows it.
struct Scene {
  Positions positions;
  Segments segments;

  /// c, by which every territory is expanded on all sides [length], >= 0 (eq. 7-9 of the paper).
  double expansion = 0.0;

  /// One further expansion per segment [length], >= 0, added to `expansion` (thickness, say), or empty.
  std::span<const double> segment_expansion{};

  /// The nodes that take part, strictly ascending; all nodes if not set. Nodes of segments that are not
  /// listed still shape their segment but are never candidates. The rest may even be non-finite.
  std::optional<std::span<const Index>> nodes{};

  /// One radius per node [length], >= 0, or empty. A node with a radius is a candidate if the cube of that
  /// half edge around it touches the closed territory: x + r >= lo and x - r <= hi on every axis. The time of
  /// a search grows with the largest radius, as it does with c; not looked at for nodes that take no part.
  std::span<const double> node_radius{};

  /// One number per segment, 0 for those that are switched off (eroded), or empty. The row of such a segment
  /// is empty and it makes no neighbours; its nodes stay candidates of others unless left out of `nodes`. It
  /// must still be well formed: its nodes exist and are finite.
  std::span<const std::uint8_t> segment_active{};

  /// Excludes not only the own nodes of a segment but also their neighbours: all nodes that share an active
  /// segment with one of them (the first ring of the mesh). Costs O(N) time and memory per build.
  bool exclude_neighbours = false;

  /// Who may touch whom.
  Groups groups{};

  /// True if `segment` is not switched off; not checked.
  bool active(Index segment) const {
    return segment_active.empty() || segment_active[static_cast<std::size_t>(segment)] != 0;
  }

  /// The whole expansion of `segment` [length].
  double expansion_of(Index segment) const {
    return segment_expansion.empty() ? expansion
                                     : expansion + segment_expansion[static_cast<std::size_t>(segment)];
  }

  /// Number of nodes that take part.
  std::size_t participants() const { return nodes ? nodes->size() : positions.count(); }

  /// The number of the participant at `place` (0 <= place < participants()); ascends with `place`.
  Index participant(Index place) const { return nodes ? (*nodes)[static_cast<std::size_t>(place)] : place; }
};

}  // namespace cellsearch
