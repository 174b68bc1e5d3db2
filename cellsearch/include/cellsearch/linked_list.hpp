// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsearch/types.hpp"

namespace cellsearch {

/// The paper's linked lists of the nodes in each cell: `head[Ncell]`, `next[N]` (fig. 2-4). The nodes are
/// pushed in ascending order, so each list runs from the highest node to the lowest, and a negative number
/// ends it. Ncell + N integers in all, eq. (12). Memory is re-used from one filling to the next.
class LinkedList {
 public:
  /// Starts a new filling. Returns `nodes` entries to be set by the caller (by any thread): entry i is the
  /// cell of node i, 0 <= cell < cells, or negative if node i shall be in no list. Then call link().
  std::span<Index> prepare(Index cells, Index nodes);

  /// Turns the cells given to prepare() into lists, in place: no third array is needed. O(Ncell + N), serial,
  /// because the order within a list is part of the definition.
  void link();

  /// The last node pushed into `cell`, negative if the cell is empty.
  Index head(Index cell) const { return head_[static_cast<std::size_t>(cell)]; }

  /// The node pushed before `node` into the same cell, negative if it was the first.
  Index next(Index node) const { return next_[static_cast<std::size_t>(node)]; }

  /// Eq. (12): M = Ncell + N.
  Offset integers() const { return static_cast<Offset>(head_.size()) + static_cast<Offset>(next_.size()); }

  /// Number of nodes that are in a list.
  Index linked() const { return linked_; }

 private:
  std::vector<Index> head_;
  std::vector<Index> next_;
  Index linked_ = 0;
};

}  // namespace cellsearch
