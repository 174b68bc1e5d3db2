// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "base/index.hpp"
#include "domain/element_block.hpp"
#include "domain/node_fields.hpp"

namespace crumple::domain {

/// A run of groups of one block that one thread works off in order. Never depends on the thread count.
struct Chunk {
  Index block = 0;  ///< place in the list that Assembly::build was given: the order of Domain::blocks()
  Index first_group = 0;
  Index last_group = 0;  ///< one past the last
};

/// Groups per chunk of a model with so many groups: 512 elements, and in large models up to 4096, as long as
/// there are enough chunks to balance over many threads. The larger, the fewer are the nodes between chunks.
Index groups_per_chunk(std::ptrdiff_t groups_of_model);

/// How element forces reach the nodes with the same bits for any number of threads. A node that only one
/// chunk touches is added to directly. A node between chunks has one slot per chunk behind the nodes in
/// NodeFields::force; gather_interface sums the slots in the order of the chunks. One more slot per
/// block at the very end takes the forces of its fill.
class Assembly {
 public:
  /// Cuts the blocks into chunks of so many groups (0: by the size of the model), but the rigid ones, and
  /// writes their `target` arrays. `nodes` is the number of nodes.
  void build(const std::vector<ElementBlock*>& blocks, Index nodes, Index groups = 0);

  const std::vector<Chunk>& chunks() const { return chunks_; }
  /// Entries that NodeFields::force needs beyond the nodes.
  Index slots() const { return slots_; }
  /// Adds the slots of every interface node to the node and clears them.
  void gather_interface(AlignedArray<NodeForce>& force, int threads) const;

 private:
  std::vector<Chunk> chunks_;
  std::vector<Index> interface_node_;
  std::vector<Index> first_slot_;  ///< per interface node, and one past the last; slots follow chunk order
  Index nodes_ = 0;
  Index slots_ = 0;
};

}  // namespace crumple::domain
