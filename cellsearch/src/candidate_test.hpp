// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "cellsearch/box.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/territory.hpp"

namespace cellsearch {

class NeighbourLists;

/// What makes a node a candidate of a segment: the one filter behind every method, so that all methods find
/// the same pairs to the last bit. A view of the scene and of the neighbour lists; copies are cheap.
class CandidateTest {
 public:
  CandidateTest() = default;

  /// `scene`: checked; `neighbours`: built for it, needed if it excludes neighbours, else not looked at;
  /// `largest_radius`: of the participants, 0 if the scene has no radii [length].
  CandidateTest(const Scene& scene, const NeighbourLists* neighbours, double largest_radius);

  /// True if the node-in-territory test and the exclusion of own nodes are all there is to it.
  bool plain() const { return plain_; }

  /// False for a segment whose row stays empty.
  bool active(Index segment) const { return scene_.active(segment); }

  /// A box around the positions of all nodes that the test can accept for `segment`.
  Box culling_box(Index segment) const {
    const Box box = territory(scene_, segment);
    return scene_.node_radius.empty() ? box : reachable(box);
  }

  /// True if `node` is a candidate of `segment`, whose territory is `box`.
  bool operator()(Index segment, const Box& box, Index node) const {
    return touches(box, node) && !scene_.segments.owns(segment, node) && (plain_ || passes(segment, node));
  }

  /// Of the participants, 0 if the scene has no radii [length].
  double largest_radius() const { return largest_radius_; }

  const Scene& scene() const { return scene_; }

 private:
  bool touches(const Box& box, Index node) const {
    const double* xyz = scene_.positions[node];
    if (scene_.node_radius.empty()) return box.contains(xyz);
    const double radius = scene_.node_radius[static_cast<std::size_t>(node)];
    return xyz[0] + radius >= box.lo[0] && xyz[0] - radius <= box.hi[0] && xyz[1] + radius >= box.lo[1] &&
           xyz[1] - radius <= box.hi[1] && xyz[2] + radius >= box.lo[2] && xyz[2] - radius <= box.hi[2];
  }
  Box reachable(const Box& box) const;
  bool passes(Index segment, Index node) const;

  Scene scene_;
  const NeighbourLists* neighbours_ = nullptr;
  double largest_radius_ = 0.0;
  bool plain_ = true;
};

}  // namespace cellsearch
