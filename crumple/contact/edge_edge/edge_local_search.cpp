// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/edge_local_search.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "contact/edge_edge/edge_pair_search.hpp"
#include "contact/edge_edge/lost_edges.hpp"

namespace crumple::contact {
namespace {

constexpr Index piece = 256;

bool before_edge(const RememberedEdgePair& pair, Index edge) {
  return pair.key.first < edge;
}

}  // namespace

/// Marks edges that have gone through another one, and those that they meet.
void EdgeLocalSearch::mark_inverted(std::span<const RememberedEdgePair> remembered) {
  inverted_.clear();
  for (const RememberedEdgePair& pair : remembered) {
    if (pair.wrong == 0) continue;
    if (inverted_.empty()) inverted_.assign(static_cast<std::size_t>(edges_->count()), 0);
    for (const Index edge : {pair.key.first, pair.key.second}) {
      inverted_[static_cast<std::size_t>(edge)] = 1;
      for (const Index node : edges_->ends(edge))
        for (const Index next : edges_->at_node(surface_->place[node]))
          inverted_[static_cast<std::size_t>(next)] = 1;
    }
  }
}

EdgeView EdgeLocalSearch::view_of(const Kinematics& motion, const EdgeSearch& candidates,
                                  std::span<const RememberedEdgePair> remembered) const {
  EdgeView view;
  view.edges = edges_;
  view.surface = surface_;
  view.candidates = &candidates;
  view.motion = &motion;
  view.now = {motion.position.data(), motion.velocity.data(), 0};
  view.step = motion.step;
  view.remembered = remembered;
  return view;
}

void EdgeLocalSearch::count_lost(const Kinematics& motion, const EdgeSearch& candidates,
                                 std::span<const RememberedEdgePair> remembered, long cycle,
                                 domain::LostContacts& lost) const {
  count_lost_edges(view_of(motion, candidates, remembered), pairs_, cycle, lost);
}

std::span<EdgePair> EdgeLocalSearch::find(const Kinematics& motion, const EdgeSearch& candidates,
                                          std::span<const RememberedEdgePair> remembered,
                                          std::span<const NodeOnEdge> node_depths, bool tracking) {
  pairs_.clear();
  if (!candidates.ready()) return pairs_;
  EdgeView view = view_of(motion, candidates, remembered);
  view.tracking = tracking;
  view.node_depths = node_depths;
  mark_inverted(remembered);
  view.inverted = inverted_;

  const Index count = edges_->count();
  parts_.resize(static_cast<std::size_t>(pieces(count, piece)));
  parallel_for(pieces(count, piece), motion.threads, [&](Index part) {
    std::vector<EdgePair>& found = parts_[static_cast<std::size_t>(part)];
    found.clear();
    auto memory = std::lower_bound(remembered.begin(), remembered.end(), part * piece, before_edge);
    for (Index e = part * piece; e < std::min((part + 1) * piece, count); ++e) {
      const auto begin = memory;
      while (memory != remembered.end() && memory->key.first == e) ++memory;
      const bool rests = begin == memory && !tracking && !view.may_take_over(e, e);
      if (rests && candidates.edge_slack(e) > candidates.consumed()) continue;
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
