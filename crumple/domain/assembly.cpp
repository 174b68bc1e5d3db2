// SPDX-License-Identifier: BSD-3-Clause
#include "domain/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/prefetch.hpp"

namespace crumple::domain {
namespace {

/// Calls visit(entry, node, real) for the corners of a chunk in the order in which its kernel adds their
/// forces to the nodes.
template <class Visit>
void for_each_entry(const std::vector<ElementBlock*>& blocks, const Chunk& chunk, const Visit& visit) {
  const ElementBlock& block = *blocks[chunk.block];
  const auto visit_one = [&](Index group, Index k, Index lane) {
    const std::size_t entry = (static_cast<std::size_t>(group) * block.corners + k) * lanes + lane;
    visit(entry, block.node[entry], group * lanes + lane < block.elements);
  };
  for (Index group = chunk.first_group; group < chunk.last_group; ++group) {
    if (block.corner_by_corner) {
      for (Index k = 0; k < block.corners; ++k)
        for (Index lane = 0; lane < lanes; ++lane) visit_one(group, k, lane);
    } else {
      for (Index lane = 0; lane < lanes; ++lane)
        for (Index k = 0; k < block.corners; ++k) visit_one(group, k, lane);
    }
  }
}

/// What a group costs, roughly, in the time of an integration point: shares are only to be about even.
double cost_of_group(const ElementBlock& block) {
  return static_cast<double>(block.corners + block.points);
}

double cost_of_all(const std::vector<ElementBlock*>& blocks) {
  double sum = 0;
  for (const ElementBlock* block : blocks)
    if (!block->rigid) sum += block->groups() * cost_of_group(*block);
  return sum;
}

/// Which share touches a node: `none`, one, or `several`.
constexpr Index none = no_index;
constexpr Index several = no_index - 1;

}  // namespace

void Assembly::add_chunk(const Chunk& chunk, bool begins_share) {
  const auto number = static_cast<Index>(chunks_.size());
  chunks_.push_back(chunk);
  if (begins_share) shares_.push_back({number, number});
  shares_.back().last_chunk = number + 1;
}

void Assembly::cut_by_groups(const std::vector<ElementBlock*>& blocks, Index groups) {
  for (Index b = 0; b < static_cast<Index>(blocks.size()); ++b)
    for (Index g = 0; g < blocks[b]->groups() && !blocks[b]->rigid; g += groups)
      add_chunk({b, g, std::min(g + groups, blocks[b]->groups())}, true);
}

void Assembly::cut_by_cost(const std::vector<ElementBlock*>& blocks, int threads) {
  const double share_cost = cost_of_all(blocks) / threads;
  double before = 0;         // cost of the groups dealt out
  Index present = no_index;  // number of the share that they end in
  for (Index b = 0; b < static_cast<Index>(blocks.size()); ++b) {
    if (blocks[b]->rigid) continue;
    const double group_cost = cost_of_group(*blocks[b]);
    const Index all = blocks[b]->groups();
    for (Index first = 0; first < all;) {
      const auto share = std::min(static_cast<Index>((before + 0.5 * group_cost) / share_cost), threads - 1);
      Index count = all - first;
      if (share < threads - 1) {
        const double room = (share + 1) * share_cost - before;
        count = std::clamp(static_cast<Index>(std::lround(room / group_cost)), 1, count);
      }
      add_chunk({b, first, first + count}, share != present);
      present = share;
      before += count * group_cost;
      first += count;
    }
  }
}

void Assembly::place_slots(const std::vector<ElementBlock*>& blocks) {
  const auto for_each = [&](const auto& visit) {
    for (Index s = 0; s < static_cast<Index>(shares_.size()); ++s)
      for (Index c = shares_[s].first_chunk; c < shares_[s].last_chunk; ++c)
        for_each_entry(blocks, chunks_[c], [&](std::size_t entry, Index node, bool real) {
          visit(s, *blocks[chunks_[c].block], chunks_[c].block, entry, node, real);
        });
  };
  std::vector<Index> share_of(nodes_, none);
  std::vector<Index> corners(nodes_, 0);
  for_each([&](Index s, ElementBlock&, Index, std::size_t, Index node, bool real) {
    if (!real) return;
    ++corners[node];
    if (share_of[node] != s) share_of[node] = share_of[node] == none ? s : several;
  });

  interface_node_.clear();
  first_slot_.assign(1, nodes_);
  std::vector<Index> next_slot(nodes_, no_index);
  for (Index node = 0; node < nodes_; ++node) {
    if (share_of[node] != several) continue;
    interface_node_.push_back(node);
    next_slot[node] = first_slot_.back();
    first_slot_.push_back(first_slot_.back() + corners[node]);
  }
  const Index fill_slot = first_slot_.back();
  slots_ = fill_slot + static_cast<Index>(blocks.size()) - nodes_;

  for (ElementBlock* block : blocks) block->target.resize(block->node.size());
  for_each([&](Index, ElementBlock& block, Index number, std::size_t entry, Index node, bool real) {
    if (!real)
      block.target[entry] = fill_slot + number;
    else
      block.target[entry] = share_of[node] == several ? next_slot[node]++ : node;
  });
}

void Assembly::build(const std::vector<ElementBlock*>& blocks, Index nodes, const Cut& cut) {
  nodes_ = nodes;
  chunks_.clear();
  shares_.clear();
  if (cut.groups_per_chunk > 0)
    cut_by_groups(blocks, cut.groups_per_chunk);
  else
    cut_by_cost(blocks, cut.threads);
  place_slots(blocks);
}

void Assembly::gather_interface(AlignedArray<NodeForce>& force, int threads) const {
  constexpr Index piece = 1024;
  constexpr Index ahead = 8;
  const auto count = static_cast<Index>(interface_node_.size());
  parallel_for(pieces(count, piece), threads, [&](Index p) {
    for (Index i = p * piece; i < std::min((p + 1) * piece, count); ++i) {
      // The slots of a node lie side by side, but not the nodes.
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
