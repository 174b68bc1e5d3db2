// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/index.hpp"
#include "domain/element_block.hpp"
#include "domain/node_fields.hpp"

namespace crumple::domain {

/// Neighbouring groups of one block, computed one after the other.
struct Chunk {
  Index block = 0;  ///< place in the list that Assembly::build was given: the order of Domain::blocks()
  Index first_group = 0;
  Index last_group = 0;  ///< one past the last
};

/// Chunks that one thread computes, one after the other.
struct ThreadShare {
  Index first_chunk = 0;
  Index last_chunk = 0;  ///< one past the last
};

/// How the elements are dealt out. No result depends on it.
struct Cut {
  int threads = 1;  ///< each gets a share of about the same cost
  /// Groups of a chunk, each of which is a share of its own then; 0: as few chunks and shares as threads and
  /// blocks allow.
  Index groups_per_chunk = 0;
};

/// How element forces reach the nodes: as if one thread added them up, element after element in the order of
/// Domain::blocks(), whatever the shares. A node whose elements are all in one share is added to directly. A
/// node between shares has a slot for each corner of an element that touches it, behind the nodes in
/// NodeFields::force; gather_interface sums these slots in the order of the elements. One more slot per block
/// at the very end takes the forces of its fill.
class Assembly {
 public:
  /// Cuts the blocks, but the rigid ones, and writes their `target` arrays. `nodes` is the number of nodes.
  void build(const std::vector<ElementBlock*>& blocks, Index nodes, const Cut& cut);

  const std::vector<Chunk>& chunks() const { return chunks_; }
  const std::vector<ThreadShare>& shares() const { return shares_; }
  /// Entries that NodeFields::force needs beyond the nodes.
  Index slots() const { return slots_; }
  /// Adds the slots of every interface node to the node and clears them.
  void gather_interface(AlignedArray<NodeForce>& force, int threads) const;

 private:
  void add_chunk(const Chunk& chunk, bool begins_share);
  void cut_by_groups(const std::vector<ElementBlock*>& blocks, Index groups);
  void cut_by_cost(const std::vector<ElementBlock*>& blocks, int threads);
  void place_slots(const std::vector<ElementBlock*>& blocks);

  std::vector<Chunk> chunks_;
  std::vector<ThreadShare> shares_;
  std::vector<Index> interface_node_;
  std::vector<Index> first_slot_;  ///< per interface node, and one past the last; slots follow element order
  Index nodes_ = 0;
  Index slots_ = 0;
};

}  // namespace crumple::domain
