// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "cellsearch/error.hpp"
#include "cellsearch/pairs.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch {

class BoxPairs;

/// How to search for pairs of segments.
struct SegmentPairSettings {
  /// Leaves out pairs that have a node in common, which always touch.
  bool exclude_shared_nodes = true;

  /// Number of threads, >= 1. The results are bitwise the same for any number.
  int threads = 1;
};

/// Which segments are near which: all pairs i < j whose closed territories (bounding box of the nodes,
/// expanded by the segment's own expansion on all sides) have a point in common. To find all segments within
/// the distance d of each other give each of them the expansion d / 2.
///
/// Of the scene count the positions, the segments, their expansions, `segment_active` (a segment that is
/// switched off is in no pair) and `groups` without the groups of nodes, which may be left empty: a pair is
/// allowed if the matrix allows the one for the other or the other for the one. What concerns nodes (`nodes`,
/// `node_radius`, `exclude_neighbours`) is not looked at.
///
/// Time and memory are O(segments + pairs) for sizes mixed in any way, times the number of different powers
/// of two among the sizes (7 for a mesh refined 100x). Keep the object: it re-uses its memory. One thread at
/// a time may use it.
class SegmentPairSearch {
 public:
  /// Throws Error(BadSetting).
  explicit SegmentPairSearch(const SegmentPairSettings& settings = {});
  ~SegmentPairSearch();
  SegmentPairSearch(SegmentPairSearch&&) noexcept;
  SegmentPairSearch& operator=(SegmentPairSearch&&) noexcept;
  SegmentPairSearch(const SegmentPairSearch&) = delete;
  SegmentPairSearch& operator=(const SegmentPairSearch&) = delete;

  /// All pairs, one row per segment. The scene is looked at during this call only. The result belongs to this
  /// object and is overwritten by the next call. Throws Error (see ErrorKind); the result is then empty.
  const Pairs& find(const Scene& scene);

  /// Calls visitor(i, j) for all pairs of `scene` in ascending order; what it throws reaches the caller.
  template <class Visitor>
  void visit(const Scene& scene, Visitor&& visitor) {
    find(scene).visit(std::forward<Visitor>(visitor));
  }

  /// Moves the last result out of the object.
  Pairs take() { return std::move(pairs_); }

  /// Box tests made by the last search; the same for any number of threads.
  Offset visits() const;

  /// Working memory besides the result [bytes].
  Offset bytes() const;

 private:
  SegmentPairSettings settings_;
  Pairs pairs_;
  std::unique_ptr<BoxPairs> boxes_;
};

}  // namespace cellsearch
