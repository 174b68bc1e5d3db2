// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Edges against edges, and beams: what nodes on segments cannot see. Two sheets whose edges cross between
// their nodes would pass through each other. Free edges of shells take part, with INTERIOR all of them,
// beams, and the sharp edges of solids; AUTOMATIC_GENERAL asks for it, and SOFT = 2
// with a DEPTH that ends in 5.
//
//                second edge
//                    |
//                    |       The nearest points follow in closed form (C. Ericson, Real-Time Collision
//     first  --------+----   Detection, 2005, 5.1.9). Between the ends their line is the common perpendicular
//      edge          |       u x v, whose sign is the side; the gap is the distance along it, negative once
//                    |       the edges have passed through each other
//
// A crossing belongs to the edges, an end of an edge to the node there: a node leaves its contact to an edge
// that crosses there (relieve()). Edges that are almost parallel have no clear crossing and leave the contact
// to their ends; between two angles the shares change linearly. Inside of a surface only edges count that
// stand out. These rules are our own; docs/theory/contact.md has them with their reasons.
//
// Files: edges.hpp what takes part, edge_geometry.hpp nearest points and passages, edge_search.hpp candidates
// (by cellsearch, as complete as those of nodes), edge_local_search.hpp all pairs of a step,
// edge_pair_search.hpp those of one edge with edges of higher numbers, edge_pair.hpp what a pair is and what
// of it is remembered.
//
// Order of calls in a step: update() (erosion, search), find(), relieve() on the pairs of nodes,
// append_touches(); once the forces are known remember(). Forces, friction, stability and energy are those of
// all touches, here of four nodes with the weights 1-s, s, -(1-t), -t.

#include <span>
#include <vector>

#include "contact/edge_edge/edge_local_search.hpp"
#include "contact/edge_edge/edge_pair.hpp"
#include "contact/edge_edge/edge_search.hpp"
#include "contact/edge_edge/edges.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/surface/statistics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The contact of edges with edges, and of beams, that an interface has beside that of nodes with segments.
/// Without edges that take part it does nothing.
class EdgeContact {
 public:
  EdgeContact(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
              const Surface& surface);
  EdgeContact(const EdgeContact&) = delete;
  EdgeContact& operator=(const EdgeContact&) = delete;

  bool exists() const { return edges_.count() > 0; }
  /// Follows erosion, and searches again where needed; see EdgeSearch. Returns what the springs of pairs held
  /// whose edges have eroded [energy].
  double update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed);
  void verify(const Kinematics& motion) const { search_.verify(motion); }
  /// Finds the contacts at time n; see EdgeLocalSearch.
  void find(const Kinematics& motion, bool tracking);
  /// There are none at this time.
  void find_nothing() { present_ = {}; }
  /// Takes from nodes the share of those contacts that crossing edges have.
  void relieve(std::span<ContactPair> nodes) const;
  /// Appends the contacts that were found, in order.
  void append_touches(std::vector<Touch>& touches) const;
  /// Keeps what the next step needs. `touches` are those appended, after the forces, `nodes` the contacts of
  /// nodes; adds what has a force to `penetrations`.
  void remember(const Kinematics& motion, std::span<const Touch> touches, std::span<const ContactPair> nodes,
                std::vector<Penetration>& penetrations);

  std::span<const EdgePair> present() const { return present_; }
  const Edges& edges() const { return edges_; }
  const EdgeSearch& search() const { return search_; }
  /// Id of a node of the first edge where a contact is.
  UserId node_id(const EdgePair& pair) const;

  /// Declares what is remembered from step to step.
  void declare(domain::StateList& list);
  /// To be called once after a restart has filled what was declared.
  void resume(const domain::Domain& domain, const Kinematics& motion);

 private:
  const Surface* surface_;
  Edges edges_;
  EdgeSearch search_;
  EdgeLocalSearch local_;
  Index eroded_beams_ = 0;
  std::span<EdgePair> present_;
  std::vector<RememberedEdgePair> remembered_;
  std::vector<NodeOnEdge> node_depths_;
};

}  // namespace crumple::contact
