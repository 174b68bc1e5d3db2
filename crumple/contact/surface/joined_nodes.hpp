// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

struct Surface;

/// Which nodes of a surface tied contacts join to which: a tied node to the corners of its segment, and these
/// to it. They are no more apart than their tie lets them be, and touch no more than the nodes of one element
/// do.
struct JoinedNodes {
  std::vector<Index>
      first;                ///< by place in Surface::nodes, one more than there are; empty: nothing is joined
  std::vector<Index> node;  ///< domain nodes, ascending at each place
  Index ended = 0;          ///< ties of nodes that had ended at the last look
  std::vector<std::uint8_t> freed;  ///< 1: joined to less than a step ago, by place; empty: none

  bool empty() const { return first.empty(); }
  /// True if a tie of the node of that place has ended in this step: its contacts begin.
  bool has_freed(Index place) const { return !freed.empty() && freed[place] != 0; }
  /// Domain nodes that the node of that place is joined to; not if empty().
  std::span<const Index> of(Index place) const {
    return std::span(node).subspan(first[place], first[place + 1] - first[place]);
  }
};

/// Finds what ties join now. The surface of a contact that goes with a tie that breaks, and is there for what
/// happens after, does not count that tie: `contact` is its id.
void join_nodes(const domain::Domain& domain, UserId contact, Surface& surface);

/// The same where ties of nodes have ended since the last look: they may touch each other from then on. True
/// if there were such.
bool follow_ended_ties(const domain::Domain& domain, UserId contact, Surface& surface);

}  // namespace crumple::contact
