// SPDX-License-Identifier: BSD-3-Clause
#include "domain/assembly.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "base/prefetch.hpp"

namespace crumple::domain {
namespace {

/// Chunks that touch a node: the first one, and how many.
struct Touch {
  Index last_chunk = no_index;
  Index chunks = 0;
};

template <class Visit>
void for_each_entry(const std::vector<ElementBlock*>& blocks, const Chunk& chunk, const Visit& visit) {
  const ElementBlock& block = *blocks[chunk.block];
  for (Index group = chunk.first_group; group < chunk.last_group; ++group)
    for (Index k = 0; k < block.corners; ++k)
      for (Index lane = 0; lane < lanes; ++lane) {
        const std::size_t entry = (static_cast<std::size_t>(group) * block.corners + k) * lanes + lane;
        visit(entry, block.node[entry], group * lanes + lane < block.elements);
      }
}

std::ptrdiff_t all_groups(const std::vector<ElementBlock*>& blocks) {
  std::ptrdiff_t sum = 0;
  for (const ElementBlock* block : blocks)
    if (!block->rigid) sum += block->groups();
  return sum;
}

}  // namespace

Index groups_per_chunk(std::ptrdiff_t groups_of_model) {
  constexpr Index least = 32;
  constexpr Index most = 256;
  constexpr Index enough_chunks = 64;
  Index groups = least;
  while (groups < most && groups_of_model / (2 * groups) >= enough_chunks) groups *= 2;
  return groups;
}

void Assembly::build(const std::vector<ElementBlock*>& blocks, Index nodes, Index groups) {
  nodes_ = nodes;
  if (groups == 0) groups = groups_per_chunk(all_groups(blocks));
  chunks_.clear();
  for (Index b = 0; b < static_cast<Index>(blocks.size()); ++b) {
    if (blocks[b]->rigid) continue;
    for (Index g = 0; g < blocks[b]->groups(); g += groups)
      chunks_.push_back({b, g, std::min(g + groups, blocks[b]->groups())});
  }

  std::vector<Touch> touch(nodes);
  for (Index c = 0; c < static_cast<Index>(chunks_.size()); ++c)
    for_each_entry(blocks, chunks_[c], [&](std::size_t, Index node, bool real) {
      if (!real || touch[node].last_chunk == c) return;
      touch[node].last_chunk = c;
      ++touch[node].chunks;
    });

  interface_node_.clear();
  first_slot_.assign(1, nodes);
  std::vector<Index> next_slot(nodes, no_index);
  for (Index node = 0; node < nodes; ++node) {
    if (touch[node].chunks < 2) continue;
    interface_node_.push_back(node);
    next_slot[node] = first_slot_.back() - 1;
    first_slot_.push_back(first_slot_.back() + touch[node].chunks);
  }
  const Index fill_slot = first_slot_.back();
  slots_ = fill_slot + static_cast<Index>(blocks.size()) - nodes;

  std::vector<Index> seen_in(nodes, no_index);
  for (ElementBlock* block : blocks) block->target.resize(block->node.size());
  for (Index c = 0; c < static_cast<Index>(chunks_.size()); ++c)
    for_each_entry(blocks, chunks_[c], [&](std::size_t entry, Index node, bool real) {
      Index& target = blocks[chunks_[c].block]->target[entry];
      if (!real) {
        target = fill_slot + chunks_[c].block;
      } else if (next_slot[node] == no_index) {
        target = node;
      } else {
        if (seen_in[node] != c) ++next_slot[node];
        seen_in[node] = c;
        target = next_slot[node];
      }
    });
}

void Assembly::gather_interface(AlignedArray<NodeForce>& force, int threads) const {
  constexpr Index piece = 1024;
  constexpr Index ahead = 8;
  const auto count = static_cast<Index>(interface_node_.size());
  parallel_for(pieces(count, piece), threads, [&](Index p) {
    for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) {
      // The chunks' sums lie side by side, but not the nodes.
      if (i + ahead < count) prefetch<true>(&force[interface_node_[i + ahead]], 1);
      NodeForce& node = force[interface_node_[i]];
      for (Index s = first_slot_[i]; s < first_slot_[i + 1]; ++s) {
        for (int axis = 0; axis < 3; ++axis) {
          node.force[axis] += force[s].force[axis];
          node.moment[axis] += force[s].moment[axis];
        }
        force[s] = NodeForce{};
      }
    }
  });
}

}  // namespace crumple::domain
