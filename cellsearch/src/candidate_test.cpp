// SPDX-License-Identifier: BSD-3-Clause
#include "candidate_test.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "neighbour_lists.hpp"

namespace cellsearch {

CandidateTest::CandidateTest(const Scene& scene, const NeighbourLists* neighbours, double largest_radius)
    : scene_(scene),
      neighbours_(neighbours),
      largest_radius_(largest_radius),
      plain_(scene.node_radius.empty() && scene.segment_active.empty() && !scene.exclude_neighbours &&
             scene.groups.count == 0) {
  assert(neighbours != nullptr || !scene.exclude_neighbours);
}

Box CandidateTest::reachable(const Box& box) const {
  // The rounded x + r can reach lo where the exact sum falls short by half the distance between neighbouring
  // numbers at lo, and lo - r is rounded too: four times both is on the safe side, also where it overflows.
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  constexpr double smallest = std::numeric_limits<double>::min();
  Box result;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = box.lo[axis];
    const double hi = box.hi[axis];
    result.lo[axis] = (lo - largest_radius_) - (rounding * (std::fabs(lo) + largest_radius_) + smallest);
    result.hi[axis] = (hi + largest_radius_) + (rounding * (std::fabs(hi) + largest_radius_) + smallest);
  }
  return result;
}

bool CandidateTest::passes(Index segment, Index node) const {
  if (!scene_.active(segment)) return false;
  const Groups& groups = scene_.groups;
  if (groups.count > 0 && !groups.allowed(groups.segment_group[static_cast<std::size_t>(segment)],
                                          groups.node_group[static_cast<std::size_t>(node)])) {
    return false;
  }
  return !scene_.exclude_neighbours || !neighbours_->adjoins(scene_.segments, segment, node);
}

}  // namespace cellsearch
