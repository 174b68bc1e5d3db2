// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
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
