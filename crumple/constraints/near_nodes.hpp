// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "base/index.hpp"

namespace crumple::constraints {

/// Those of some nodes that may meet a surface before long, so that not all of them have to be asked in every
/// step. Who is left out was farther away than all motion since then.
class NearNodes {
 public:
  /// The nodes among `nodes` that the coming step may take to the surface, in their order, and perhaps
  /// others. `approach` bounds by how much any of them comes nearer in that step [length]; infinite if
  /// nothing is known. `gap_of(node)` is the present distance, or a lower bound [length]. To be called in
  /// every step, or forget() before the next call. Holds until then.
  template <class GapOf>
  std::span<const Index> find(std::span<const Index> nodes, double approach, const GapOf& gap_of) {
    constexpr double round_off = 1 + 1e-6;
    constexpr double steps_ahead = 64;
    // Not numbers count as near.
    if (!(way_ + round_off * approach < horizon_)) {
      horizon_ = steps_ahead * approach;
      way_ = 0;
      near_.clear();
      for (const Index node : nodes)
        if (!(gap_of(node) > horizon_)) near_.push_back(node);
    }
    way_ += round_off * approach;
    return near_;
  }

  /// Has the next call look at all nodes.
  void forget() { horizon_ = way_ = 0; }

 private:
  std::vector<Index> near_;
  double horizon_ = 0;  ///< all others were farther away than this when near_ was made [length]
  double way_ = 0;      ///< bound on the approach since then [length]
};

}  // namespace crumple::constraints
