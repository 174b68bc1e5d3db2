// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/aligned_array.hpp"
#include "base/index.hpp"
#include "contact/surface/statistics.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// Which cuts count.
enum class CutDepth {
  Any,
  /// Those deeper than half the thickness of either segment, that of nodes which are through all of a shell:
  /// a penalty lets soft bodies be beyond its mid-surface for a moment.
  Through,
};

/// The pairs of segments (lower first, ascending) whose mid-surfaces cut through each other: an edge of a
/// sub-triangle of one goes through a sub-triangle of the other. Edges that start at a node of the other
/// segment do not count, so that neighbours are found only where they really cut; two faces of solids cut
/// each other from a tenth of the height of their elements on. `position` holds all domain nodes. A check of
/// results, not part of the contact; O(N) for elements of similar size.
std::vector<std::array<Index, 2>> intersecting_segments(const Surface& surface,
                                                        const AlignedArray<Vec3>& position, int threads,
                                                        CutDepth depth = CutDepth::Any);

/// Of the pairs `cut`, in the order of intersecting_segments(), those that cut where nothing did at the
/// start: no pair of `initial` consists of the same two segments or of segments connected to them.
std::vector<std::array<Index, 2>> cut_since(const Surface& surface,
                                            std::span<const std::array<Index, 2>> initial,
                                            std::span<const std::array<Index, 2>> cut);

/// All pairs that cut through each other where the nodes are, and those of them that did not at the start.
struct Intersections {
  std::vector<std::array<Index, 2>> all;
  std::vector<std::array<Index, 2>> since_start;

  Intersections(const Surface& surface, const domain::Domain& domain, CutDepth depth);
};

/// Keeps what is found if there is more of it than in the run so far.
void note_worst(const Intersections& found, const Surface& surface, const domain::Clock& clock,
                domain::WorstIntersections& worst);

/// How deep the contacts are, over the depth at which a node reaches the mid-surface [-].
struct PenetrationSummary {
  Index pairs = 0;
  Index beyond = 0;  ///< pairs whose node is on or beyond the mid-surface
  double largest = 0;
  double percentile_99 = 0;  ///< 99 % of the pairs are at most this deep (nearest rank)
  UserId worst_node = 0;
  UserId worst_segment = 0;  ///< shell
};

PenetrationSummary summarise(std::span<const Penetration> penetrations);

}  // namespace crumple::contact
