// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/local_search.hpp"

#include <algorithm>
#include <array>

#include "base/parallel.hpp"
#include "contact/node_segment/looks_ahead.hpp"

namespace crumple::contact {
namespace {

constexpr Index nodes_per_piece = 512;

/// Nodes whose data are asked for at once.
constexpr std::size_t together = 16;

}  // namespace

void LocalSearch::find_in(Index part, const StepView& view, std::span<const RememberedPair> remembered) {
  std::vector<ContactPair>& found = parts_[part];
  found.clear();
  const auto before = [](const RememberedPair& pair, Index place) { return pair.node < place; };
  auto memory = std::lower_bound(remembered.begin(), remembered.end(), part * nodes_per_piece, before);
  const Index end = std::min((part + 1) * nodes_per_piece, surface_->node_count());
  std::array<Visit, together> visits;
  for (Index i = part * nodes_per_piece; i < end;) {
    std::size_t count = 0;
    for (; i < end && count < together; ++i) {
      const Index known = memory == remembered.end() ? end : std::min(memory->node, end);
      if (!view.tracking) i = view.candidates->next_awake(i, known);
      if (i == end) break;
      const auto begin = memory;
      while (memory != remembered.end() && memory->node == i) ++memory;
      visits[count++] = {i, {begin, memory}};
      ask_for_visit(view, i);
    }
    const std::span<const Visit> next = std::span(visits).first(count);
    ask_for_looks(view, next);
    for (const Visit& visit : next) NodeSearch(view, visit.place, visit.remembered).find(found);
  }
}

std::span<ContactPair> LocalSearch::find(const Kinematics& motion, GlobalSearch& candidates,
                                         std::span<const RememberedPair> remembered, bool tracking,
                                         std::span<const DeepPair> deep) {
  StepView view;
  view.now = {surface_, {motion.position.data(), motion.velocity.data(), 0}};
  view.reference = {surface_, {motion.reference.data(), motion.velocity.data(), 0}};
  view.candidates = &candidates;
  view.nearest_point = nearest_point_kernel(motion.isa);
  view.step = motion.step;
  view.tracking = tracking;
  view.deep = deep;

  const Index parts = pieces(surface_->node_count(), nodes_per_piece);
  parts_.resize(parts);
  parallel_for(parts, motion.threads, [&](Index part) { find_in(part, view, remembered); });
  pairs_.clear();
  for (const auto& found : parts_) pairs_.insert(pairs_.end(), found.begin(), found.end());
  return pairs_;
}

}  // namespace crumple::contact
