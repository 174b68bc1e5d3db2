// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/enforcement/contact_pair.hpp"
#include "contact/node_segment/node_search.hpp"

namespace crumple::contact {

/// A node that the local search looks at, and the pairs that it had.
struct Visit {
  Index place = no_index;  ///< in Surface::nodes
  std::span<const RememberedPair> remembered;
};

/// Asks for what ask_for_looks() will read of a node.
void ask_for_visit(const StepView& view, Index place);

/// Asks for what the local search of these nodes will read. In a large model all of it comes from memory, the
/// number of a segment before its nodes, and these before their positions: each is asked for of all nodes
/// before the next is, so that the waiting is shared. `visits`: as many as the first cache can hold.
void ask_for_looks(const StepView& view, std::span<const Visit> visits);

}  // namespace crumple::contact
