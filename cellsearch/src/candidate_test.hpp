// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cellsearch/box.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/territory.hpp"

namespace cellsearch {

/// What makes a node a candidate of a segment: the one filter behind every method, so that all methods find
/// the same pairs to the last bit. A view of the scene; copies are cheap.
class CandidateTest {
 public:
  CandidateTest() = default;
  explicit CandidateTest(const Scene& scene) : scene_(scene) {}

  /// True if the node-in-territory test and the exclusion of own nodes are all there is to it.
  bool plain() const { return true; }

  /// False for a segment whose row stays empty.
  bool active(Index /*segment*/) const { return true; }

  /// A box around the positions of all nodes that the test can accept for `segment`.
  Box culling_box(Index segment) const { return territory(scene_, segment); }

  /// True if `node` is a candidate of `segment`, whose territory is `box`.
  bool operator()(Index segment, const Box& box, Index node) const {
    return box.contains(scene_.positions[node]) && !scene_.segments.owns(segment, node);
  }

  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
};

}  // namespace cellsearch
