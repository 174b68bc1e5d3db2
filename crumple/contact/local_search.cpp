// SPDX-License-Identifier: BSD-3-Clause
#include "contact/local_search.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "contact/node_search.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 512;

}  // namespace

std::span<ContactPair> LocalSearch::find(const Kinematics& motion, GlobalSearch& candidates,
                                         std::span<const RememberedPair> remembered, bool tracking) {
  StepView view;
  view.now = {surface_, {motion.position.data(), motion.velocity.data(), 0}};
  view.reference = {surface_, {motion.reference.data(), motion.velocity.data(), 0}};
  view.candidates = &candidates;
  view.nearest_point = nearest_point_kernel(motion.isa);
  view.step = motion.step;
  view.tracking = tracking;

  const Index places = surface_->node_count();
  parts_.resize(pieces(places, piece));
  parallel_for(pieces(places, piece), motion.threads, [&](Index part) {
    std::vector<ContactPair>& found = parts_[part];
    found.clear();
    const auto before = [](const RememberedPair& pair, Index place) { return pair.node < place; };
    auto memory = std::lower_bound(remembered.begin(), remembered.end(), part * piece, before);
    const Index end = std::min((part + 1) * piece, places);
    for (Index i = part * piece; i < end; ++i) {
      const Index known = memory == remembered.end() ? end : std::min(memory->node, end);
      if (!tracking) i = candidates.next_awake(i, known);
      if (i == end) break;
      const auto begin = memory;
      while (memory != remembered.end() && memory->node == i) ++memory;
      NodeSearch(view, i, {begin, memory}).find(found);
    }
  });
  pairs_.clear();
  for (const auto& found : parts_) pairs_.insert(pairs_.end(), found.begin(), found.end());
  return pairs_;
}

}  // namespace crumple::contact
