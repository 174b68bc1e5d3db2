// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "contact/edge_edge/edge_pair.hpp"
#include "contact/edge_edge/edge_search.hpp"
#include "contact/edge_edge/edges.hpp"
#include "contact/surface/segment_shape.hpp"

namespace crumple::contact {

/// What the local search of edges of one step works with.
struct EdgeView {
  const Edges* edges = nullptr;
  const Surface* surface = nullptr;
  const EdgeSearch* candidates = nullptr;
  const Kinematics* motion = nullptr;
  Configuration now;
  double step = 0;                                 ///< from n-1 to n [time]
  bool tracking = false;                           ///< allow the penetrations that there are
  std::span<const RememberedEdgePair> remembered;  ///< all, in order
  std::span<const NodeOnEdge> node_depths;         ///< see EdgeLocalSearch::find(), in order

  /// 1 for edges that have gone through another one and for those that they meet, which may take over from
  /// them however deep they are by then; empty where there are none.
  std::span<const std::uint8_t> inverted;

  bool may_take_over(Index one, Index other) const {
    return !inverted.empty() && inverted[static_cast<std::size_t>(one)] != 0 &&
           inverted[static_cast<std::size_t>(other)] != 0;
  }
  EdgeShape shape(Index edge) const { return edge_shape(edges->ends(edge), now); }
};

/// Calls visit(other) for an edge and those that meet it.
template <class Visit>
void visit_around(const EdgeView& view, Index edge, const Visit& visit) {
  visit(edge);
  for (const Index node : view.edges->ends(edge))
    for (const Index next : view.edges->at_node(view.surface->place[node]))
      if (next != edge) visit(next);
}

/// Calls visit(pair, sign) for those of `pairs`, in order, that have the two edges of `key` or their
/// neighbours; sign is -1 where first and second have changed places.
template <class Pair, class Visit>
void visit_connected(const EdgeView& view, std::span<const Pair> pairs, const EdgePairKey& key,
                     const Visit& visit) {
  const auto look = [&](Index one, Index other) {
    const EdgePairKey wanted{std::min(one, other), std::max(one, other), EdgeMeeting::Crossing};
    const auto before = [](const Pair& pair, const EdgePairKey& k) { return pair.key < k; };
    for (auto at = std::lower_bound(pairs.begin(), pairs.end(), wanted, before);
         at != pairs.end() && at->key.first == wanted.first && at->key.second == wanted.second; ++at)
      visit(*at, one < other ? 1.0 : -1.0);
  };
  if (pairs.empty()) return;
  visit_around(view, key.first, [&](Index one) {
    visit_around(view, key.second, [&](Index other) {
      if (one != other) look(one, other);
    });
  });
}

}  // namespace crumple::contact
