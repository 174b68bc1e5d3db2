// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/linked_list.hpp"

namespace cellsearch {

std::span<Index> LinkedList::prepare(Index cells, Index nodes) {
  head_.assign(static_cast<std::size_t>(cells), -1);
  next_.resize(static_cast<std::size_t>(nodes));
  linked_ = 0;
  return next_;
}

void LinkedList::link() {
  const Index nodes = static_cast<Index>(next_.size());
  for (Index node = 0; node < nodes; ++node) {
    Index& entry = next_[static_cast<std::size_t>(node)];
    if (entry < 0) continue;
    // The entry holds the node's cell until the node is pushed, and its successor from then on.
    Index& head = head_[static_cast<std::size_t>(entry)];
    entry = head;
    head = node;
    ++linked_;
  }
}

}  // namespace cellsearch
