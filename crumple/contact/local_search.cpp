// SPDX-License-Identifier: BSD-3-Clause
#include "contact/local_search.hpp"

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "contact/node_search.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 512;

}  // namespace

std::span<ContactPair> LocalSearch::find(const Kinematics& motion, const GlobalSearch& candidates,
                                         std::span<const RememberedPair> remembered, bool tracking) {
  StepView view;
  view.now = {surface_, {motion.position.data(), motion.velocity.data(), 0}};
  view.reference = {surface_, {motion.reference.data(), motion.velocity.data(), 0}};
  view.candidates = &candidates;
  view.step = motion.step;
  view.tracking = tracking;

  const Index places = surface_->node_count();
  parts_.resize(pieces(places, piece));
  parts_in_vain_.resize(parts_.size());
  parallel_for(pieces(places, piece), motion.threads, [&](Index part) {
    std::vector<ContactPair>& found = parts_[part];
    found.clear();
    long in_vain = 0;
    const auto before = [](const RememberedPair& pair, Index place) { return pair.node < place; };
    auto memory = std::lower_bound(remembered.begin(), remembered.end(), part * piece, before);
    for (Index i = part * piece; i < std::min((part + 1) * piece, places); ++i) {
      const auto begin = memory;
      while (memory != remembered.end() && memory->node == i) ++memory;
      if (begin == memory && !tracking && candidates.node_slack(i) > candidates.consumed()) continue;
      in_vain += NodeSearch(view, i, {begin, memory}).find(found);
    }
    parts_in_vain_[part] = in_vain;
  });
  in_vain_ = std::accumulate(parts_in_vain_.begin(), parts_in_vain_.end(), 0L);
  pairs_.clear();
  for (const auto& found : parts_) pairs_.insert(pairs_.end(), found.begin(), found.end());
  return pairs_;
}

}  // namespace crumple::contact
