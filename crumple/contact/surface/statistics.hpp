// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"

namespace crumple::contact {

/// What the global search did so far.
struct SearchStatistics {
  long searches = 0;
  long candidates = 0;         ///< pairs of all searches together
  long node_visits = 0;        ///< nodes that the method looked at in all searches, candidates or not
  long cell_visits = 0;        ///< cells that it looked into; 0 for methods without cells
  double find_seconds = 0;     ///< wall time of building and asking, without following the motion [s]
  double expansion = 0;        ///< c: largest expansion of a territory [length]
  double margin = 0;           ///< what nodes may move relative to each other before the next search [length]
  int predicted_interval = 0;  ///< steps until the next search by eq. (10) of the paper, at the last search
};

/// What a contact did so far.
struct ContactStatistics {
  SearchStatistics search;
  Index initial_penetrations = 0;  ///< pairs that overlapped at the start; their contact distance is reduced
  double worst_initial = 0;        ///< largest overlap at the start [length]
  UserId worst_initial_node = 0;
  UserId worst_initial_segment = 0;  ///< shell or solid
  Index limited_pairs = 0;           ///< pairs whose stiffness stability limits, now
  Index most_limited_pairs = 0;      ///< largest number of the run
  Index nodes_astray = 0;            ///< pairs with the node beyond the mid-surface, now
  Index edges_astray = 0;            ///< pairs of edges that have gone through each other, now
};

/// A pair with a force.
struct Penetration {
  double depth = 0;  ///< penetration [length]
  double reach = 0;  ///< at this depth the node is on the mid-surface, or behind the solid of a face [length]
  UserId node = 0;
  UserId segment = 0;  ///< shell or solid
  /// Penetration that leaves no doubt: through the whole thickness of a shell, to the middle of a solid
  /// behind a face [length].
  double most = 0;
};

}  // namespace crumple::contact
