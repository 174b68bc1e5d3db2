// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Nodes on segments: for each candidate of the global search whether it is in contact now, where, how deep,
// and on which side. A contact is a local minimum of the distance from the node to the whole surface around:
// the foot of the node on a segment, or a point on an edge or corner of it to which no other segment there
// comes nearer.
//
//         o node              |
//         |                   |--o        a node in a fold that is sharper than 120 degrees touches both
//         walls
//     ----+----               |  |
//      one foot               +--+----
//
// Of connected segments that push in directions closer than 30 degrees one owns the node, by the dividing
// plane of their common edge (surface/inside_outside.hpp); beyond 60 degrees both push, in between the share
// of the other grows. What lies further away is deferred: a pair that is a gap g from touching is not
// evaluated again before the bound on the relative motion has grown by g (search/travel.hpp).
//
// Each pair remembers the side of the segment on which its node belongs, so that a node which went through a
// shell is pushed back; a new pair has the side where its node is, or came from if it went through in this
// step (surface/crossing.hpp). Behind the face of a solid a node has a contact only if it came through it. A
// pair cannot begin deeper than those from which it takes over, plus the approach in the step; the rest is an
// offset of its contact distance, which shrinks as the pair opens.
//
// Method: the inside-outside search of S.P. Wang & E. Nakamachi, IJNME 40 (1997) 3665-3685, as reconstructed
// in docs/theory/contact.md; rules for sides, faces and offsets are our own.
//
// Order of calls: nodes_in_solids() and faces_over() once, at the start (solid_overlaps.hpp); then in every
// step LocalSearch::find(), which takes the remembered pairs and runs a NodeSearch for each node that is due,
// in pieces of nodes (looks_ahead.hpp prefetches what it reads). RaggedNodes counts the energy of pairs that
// erosion ends.

#include <span>
#include <vector>

#include "base/index.hpp"
#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/search/global_search.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/kinematics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

struct StepView;

/// The local search: which candidates are in contact now, where, and how deep. A node has a contact with
/// every segment that is a nearest place of the surface around it; of connected segments that push in almost
/// the same direction the dividing planes choose one (docs/theory/contact.md).
class LocalSearch {
 public:
  explicit LocalSearch(const Surface& surface) : surface_(&surface) {}

  /// Finds the contacts. `remembered` are the pairs of the step before, in order.
  /// Candidates that are far are put off. With `tracking` every contact is allowed the penetration that it
  /// has now (first step of a contact), those of `deep` with the faces named there. The result is ordered by
  /// (node, segment) and the same for any number of threads; it holds until the next call.
  std::span<ContactPair> find(const Kinematics& motion, GlobalSearch& candidates,
                              std::span<const RememberedPair> remembered, bool tracking,
                              std::span<const DeepPair> deep);

 private:
  /// The contacts of the nodes of one part, into its list.
  void find_in(Index part, const StepView& view, std::span<const RememberedPair> remembered);

  const Surface* surface_;
  std::vector<std::vector<ContactPair>> parts_;
  std::vector<ContactPair> pairs_;
};

}  // namespace crumple::contact
