// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/edge_edge/edge_pair.hpp"
#include "contact/edge_edge/edge_search.hpp"
#include "contact/edge_edge/edge_view.hpp"
#include "contact/edge_edge/edges.hpp"
#include "contact/surface/segment_shape.hpp"

namespace crumple::contact {

/// The local search of one edge and those with higher numbers.
class EdgePairSearch {
 public:
  /// `own` are the remembered pairs of which the edge is the first.
  EdgePairSearch(const EdgeView& view, Index edge, std::span<const RememberedEdgePair> own)
      : view_(view), edges_(*view.edges), edge_(edge), own_(own) {}

  /// Appends the contacts of the edge to `found`, in order.
  void find(std::vector<EdgePair>& found);

 private:
  bool may_meet(Index other, double full) const;
  void examine(Index other, double full, std::vector<EdgePair>& found);
  void examine_crossing(const NearestOnEdges& nearest, Index other, double full,
                        std::vector<EdgePair>& found) const;
  void examine_end(EdgeMeeting meeting, Index other, double full, std::vector<EdgePair>& found) const;
  const RememberedEdgePair* memory_of(const EdgePairKey& key) const;
  /// Where a pair belongs, and how it is known.
  struct Side {
    Vec3 normal;  ///< in which the first edge is pushed; zero: where it is
    bool passed_now = false;
  };
  bool takes_over(const EdgePairKey& key) const;
  Side known_side(const EdgePairKey& key, bool may_pass) const;
  double share_of(const NearestOnEdges& nearest, const EdgePair& pair, double sine) const;
  double fall_away(Index edge, const Vec3& point, const Vec3& push) const;
  bool owns_ends(const NearestOnEdges& nearest, Index other) const;
  void set_offset(EdgePair& pair, double full, const RememberedEdgePair* memory, bool was_wrong) const;
  double new_offset(const EdgePair& pair, double full, bool was_wrong) const;
  double node_depth(Index node, Index edge) const;
  double deepest_node(const EdgePairKey& key) const;
  bool nearest_of_others(Index node, Index edge, double fraction, const Vec3& away) const;

  const EdgeView& view_;
  const Edges& edges_;
  Index edge_;
  std::span<const RememberedEdgePair> own_;
};

/// The domain node of a contact of an end.
Index end_of(const Edges& edges, const EdgePairKey& key);

/// Finds the friction force, the largest slope and the contact points of the step before, of this pair or of
/// one of their neighbours that the contact has left. `present` are the contacts now, in order.
void carry_on(const EdgeView& view, std::span<const EdgePair> present, EdgePair& pair);

/// Axes that turn with a pair of edges: along the first one, or the second or any where that is the normal,
/// across it, and along the normal.
Frame frame_of(const EdgeShape& first, const EdgeShape& second, const Vec3& normal);

}  // namespace crumple::contact
