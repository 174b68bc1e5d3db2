// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_local_search.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "contact/edge_pair_search.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 256;

bool before_edge(const RememberedEdgePair& pair, Index edge) {
  return pair.key.first < edge;
}

}  // namespace

std::span<EdgePair> EdgeLocalSearch::find(const Kinematics& motion, const EdgeSearch& candidates,
                                          std::span<const RememberedEdgePair> remembered,
                                          std::span<const NodeOnEdge> node_depths, bool tracking) {
  pairs_.clear();
  if (!candidates.ready()) return pairs_;
  EdgeView view;
  view.edges = edges_;
  view.surface = surface_;
  view.candidates = &candidates;
  view.motion = &motion;
  view.now = {motion.position.data(), motion.velocity.data(), 0};
  view.step = motion.step;
  view.tracking = tracking;
  view.remembered = remembered;
  view.node_depths = node_depths;

  const Index count = edges_->count();
  parts_.resize(static_cast<std::size_t>(pieces(count, piece)));
  parallel_for(pieces(count, piece), motion.threads, [&](Index part) {
    std::vector<EdgePair>& found = parts_[static_cast<std::size_t>(part)];
    found.clear();
    auto memory = std::lower_bound(remembered.begin(), remembered.end(), part * piece, before_edge);
    for (Index e = part * piece; e < std::min((part + 1) * piece, count); ++e) {
      const auto begin = memory;
      while (memory != remembered.end() && memory->key.first == e) ++memory;
      if (begin == memory && !tracking && candidates.edge_slack(e) > candidates.consumed()) continue;
      EdgePairSearch(view, e, {begin, memory}).find(found);
    }
  });
  for (const auto& found : parts_) pairs_.insert(pairs_.end(), found.begin(), found.end());
  relieve_ends();
  const auto found_pairs = static_cast<Index>(pairs_.size());
  parallel_for(pieces(found_pairs, piece), motion.threads, [&](Index part) {
    for (Index i = part * piece; i < std::min((part + 1) * piece, found_pairs); ++i)
      carry_on(view, pairs_, pairs_[static_cast<std::size_t>(i)]);
  });
  return pairs_;
}

/// An end of an edge has no contact where the edge crosses the other one.
void EdgeLocalSearch::relieve_ends() {
  const std::vector<NodeOnEdge> found = reliefs(*edges_, pairs_);
  if (found.empty()) return;
  for (EdgePair& pair : pairs_) {
    const bool of_first =
        pair.key.meeting == EdgeMeeting::FirstStart || pair.key.meeting == EdgeMeeting::FirstEnd;
    if (pair.key.meeting == EdgeMeeting::Crossing) continue;
    const Index edge = of_first ? pair.key.second : pair.key.first;
    pair.share *= share_left(found, end_of(*edges_, pair.key), edge);
  }
}

std::vector<NodeOnEdge> reliefs(const Edges& edges, std::span<const EdgePair> pairs) {
  std::vector<NodeOnEdge> found;
  for (const EdgePair& pair : pairs) {
    if (pair.key.meeting != EdgeMeeting::Crossing || pair.share <= 0 || pair.penetration() <= 0) continue;
    for (const Index node : edges.ends(pair.key.first))
      found.push_back({node, pair.key.second, 1 - pair.share});
    for (const Index node : edges.ends(pair.key.second))
      found.push_back({node, pair.key.first, 1 - pair.share});
  }
  std::sort(found.begin(), found.end());
  return found;
}

double share_left(std::span<const NodeOnEdge> found, Index node, Index edge) {
  double left = 1;
  const NodeOnEdge wanted{node, edge, 1};
  for (auto at = std::lower_bound(found.begin(), found.end(), wanted);
       at != found.end() && at->node == node && at->edge == edge; ++at)
    left = std::min(left, at->value);
  return left;
}

}  // namespace crumple::contact
