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
// that crosses there (relieve_nodes()). Edges that are almost parallel have no clear crossing and leave the
// contact to their ends; between two angles the shares change linearly. Inside of a surface only edges count
// that stand out. These rules are our own; docs/theory/contact.md has them with their reasons.
//
// Files: edges.hpp what takes part, edge_geometry.hpp nearest points and passages, edge_search.hpp candidates
// (by cellsearch, as complete as those of nodes), edge_local_search.hpp all pairs of a step,
// edge_pair_search.hpp those of one edge with edges of higher numbers, edge_pair.hpp what a pair is and what
// of it is remembered.
//
// The order of calls is that of every detector (search/detector.hpp). Forces, friction, stability and energy
// are those of all touches, here of four nodes with the weights 1-s, s, -(1-t), -t.

#include <span>
#include <vector>

#include "contact/edge_edge/edge_local_search.hpp"
#include "contact/edge_edge/edge_pair.hpp"
#include "contact/edge_edge/edge_search.hpp"
#include "contact/edge_edge/edges.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/search/detector.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The contact of edges with edges, and of beams, beside that of nodes with segments. Nodes leave to it what
/// crossing edges hold: it must come behind them in the list of detectors.
class EdgeContact final : public Detector {
 public:
  /// `nodes` are the contacts of nodes of each step; they must outlive this.
  EdgeContact(const model::Model& model, const domain::Domain& domain, const model::Contact& contact,
              const Surface& surface, const std::span<ContactPair>& nodes);

  /// False where no edge takes part: then this is not needed.
  bool exists() const { return edges_.count() > 0; }
  const Edges& edges() const { return edges_; }
  /// The contacts that find() found, until the next one.
  std::span<const EdgePair> pairs() const { return pairs_; }

  std::string method() const override { return "cells"; }
  double update(const domain::Domain& domain, const Kinematics& motion, bool surface_changed,
                bool start) override;
  double find(const domain::Domain& domain, const Kinematics& motion, bool start,
              domain::ContactReport& report) override;
  void find_nothing() override { pairs_ = {}; }
  Index count() const override { return static_cast<Index>(pairs_.size()); }
  void fill(const Kinematics& motion, std::span<Touch> touches) const override;
  void remember(const Kinematics& motion, std::span<const Touch> touches, TouchNotes& notes) override;
  void append_initial_overlaps(std::vector<domain::InitialOverlap>& overlaps) const override;
  void verify(const Kinematics& motion) override { search_.verify(motion); }
  void report(domain::ContactReport& report, ContactStatistics& statistics) const override;
  void declare_search(domain::StateList& list) override { search_.declare(list); }
  void declare_pairs(domain::StateList& list) override;
  void resume(const domain::Domain& domain, const Kinematics& motion) override;

 private:
  void relieve_nodes() const;
  double height_of(const EdgePair& pair) const;
  Touch touch_of(const EdgePair& pair) const;
  UserId node_id(const EdgePair& pair) const;
  void remember_nodes();

  const Surface* surface_;
  const std::span<ContactPair>* nodes_;
  Edges edges_;
  EdgeSearch search_;
  EdgeLocalSearch local_;
  Index eroded_beams_ = 0;
  std::span<EdgePair> pairs_;
  std::vector<RememberedEdgePair> remembered_;
  std::vector<NodeOnEdge> node_depths_;
};

}  // namespace crumple::contact
