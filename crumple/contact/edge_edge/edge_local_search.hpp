// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/edge_edge/edge_pair.hpp"
#include "contact/edge_edge/edge_search.hpp"
#include "contact/edge_edge/edge_view.hpp"
#include "contact/edge_edge/edges.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// The local search of edges: which candidates are in contact now, where, how deep, and on which side of each
/// other (docs/theory/contact.md).
class EdgeLocalSearch {
 public:
  EdgeLocalSearch(const Edges& edges, const Surface& surface) : edges_(&edges), surface_(&surface) {}

  /// Finds the contacts at time n. `remembered` are those of the step before, in order. With `tracking` every
  /// contact is allowed the penetration that it has now (first step of a contact). `node_depths` are the
  /// penetrations, in the step before, of nodes that touch a segment at an edge, in order. The result is
  /// ordered by key and the same for any number of threads; it holds until the next call. It holds all pairs
  /// nearer than their contact distance, with no share of the force where nodes see to the contact.
  std::span<EdgePair> find(const Kinematics& motion, const EdgeSearch& candidates,
                           std::span<const RememberedEdgePair> remembered,
                           std::span<const NodeOnEdge> node_depths, bool tracking);

  /// Counts the pairs of `remembered` that find(), called before for the same time, has lost.
  void count_lost(const Kinematics& motion, const EdgeSearch& candidates,
                  std::span<const RememberedEdgePair> remembered, long cycle,
                  domain::LostContacts& lost) const;

 private:
  EdgeView view_of(const Kinematics& motion, const EdgeSearch& candidates,
                   std::span<const RememberedEdgePair> remembered) const;
  void mark_inverted(std::span<const RememberedEdgePair> remembered);
  void relieve_ends();

  const Edges* edges_;
  const Surface* surface_;
  std::vector<std::vector<EdgePair>> parts_;
  std::vector<EdgePair> pairs_;
  std::vector<std::uint8_t> inverted_;  ///< as in EdgeView
};

/// For nodes and edges of `pairs` that cross: the share of their contact that is left to the node, in order.
std::vector<NodeOnEdge> reliefs(const Edges& edges, std::span<const EdgePair> pairs);

/// Share that `found` leaves to a node and an edge.
double share_left(std::span<const NodeOnEdge> found, Index node, Index edge);

}  // namespace crumple::contact
