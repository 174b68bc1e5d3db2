// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "cellsearch/box.hpp"
#include "cellsearch/candidates.hpp"
#include "cellsearch/scene.hpp"

namespace cellsearch::bench {

/// A number in single precision that is at most `x` (which must be within float's range). Quicker than the
/// exact neighbour, and at most two steps below it.
inline float at_most(double x) {
  return static_cast<float>(x - (x < 0.0 ? -x : x) * 0x1p-23 - 1e-37);
}

/// A number in single precision that is at least `x`.
inline float at_least(double x) {
  return -at_most(-x);
}

/// What the peers share: the territories, the test that makes their answer exact, and the rows.
class ExactPairs {
 public:
  struct Pair {
    Index segment;
    Index node;
  };

  /// Computes the territories of `scene`, and forgets all pairs.
  void reset(const Scene& scene);

  const Scene& scene() const { return scene_; }
  const Box& territory_of(Index segment) const { return territories_[static_cast<std::size_t>(segment)]; }
  const std::vector<Box>& territories() const { return territories_; }

  /// True if the pair belongs to the answer.
  bool is_candidate(Index segment, Index node) const {
    return territory_of(segment).contains(scene_.positions[node]) && !scene_.segments.owns(segment, node);
  }

  /// Forgets the pairs of the last query.
  void clear() { pairs_.clear(); }

  /// Keeps the pair if it is a candidate.
  void add(Index segment, Index node) {
    if (is_candidate(segment, node)) pairs_.push_back({segment, node});
  }

  /// Keeps pairs that another thread has tested.
  void append(const std::vector<Pair>& pairs) { pairs_.insert(pairs_.end(), pairs.begin(), pairs.end()); }

  /// The pairs as sorted rows: a counting sort by segment, then each row.
  const Candidates& rows();

  /// For contestants that find the rows one after another: starts, ends and returns them.
  void start_rows();
  void add_to_row(Index segment, Index node) {
    if (is_candidate(segment, node)) candidates_.node.push_back(node);
  }
  void end_row();
  const Candidates& finished_rows() const { return candidates_; }

 private:
  Scene scene_;
  std::vector<Box> territories_;
  std::vector<Pair> pairs_;
  std::vector<Offset> place_;
  Candidates candidates_;
};

}  // namespace cellsearch::bench
