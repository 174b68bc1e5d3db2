// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "cellsearch/array.hpp"
#include "cellsearch/box.hpp"
#include "cellsearch/pairs.hpp"
#include "cellsearch/types.hpp"
#include "parallel.hpp"
#include "queries/box_classes.hpp"

namespace cellsearch {

/// All pairs of closed boxes that have a point in common. Every box looks for boxes of its own size and for
/// larger ones, never for smaller ones: so that it looks into few cells and finds little else than partners,
/// whatever the sizes. Memory is re-used from one search to the next.
class BoxPairs {
 public:
  /// Starts a search among `count` boxes, to be set by the caller (by any thread). Empty ones are in no pair.
  std::span<Box> prepare(Index count) {
    boxes_.resize(static_cast<std::size_t>(count));
    return boxes_;
  }

  /// Finds all pairs i < j of intersecting boxes for which accepts(i, j), called by several threads at once,
  /// is true. O(boxes + pairs), accepted or not, times the number of classes of size.
  template <class Accepts>
  void find(const Accepts& accepts, int threads, Pairs& pairs) {
    const Index count = static_cast<Index>(boxes_.size());
    classes_.build(boxes_, threads);
    const int blocks = threads == 1 ? 1 : std::max(1, std::min(4 * threads, count / 64));
    if (found_.size() < static_cast<std::size_t>(blocks)) found_.resize(static_cast<std::size_t>(blocks));
    pairs.first.resize(boxes_.size() + 1);
    for_blocks(threads, blocks, [&](int block) {
      find_block(accepts, BlockRange(count, block, blocks), found_[static_cast<std::size_t>(block)], pairs);
    });
    join(blocks, threads, pairs);
  }

  /// Boxes looked at by the last search.
  Offset visits() const { return visits_; }

  /// Memory in use [bytes].
  Offset bytes() const;

 private:
  struct PairOf {
    Index i;
    Index j;
  };

  /// What the boxes of one block found.
  struct Found {
    Array<Index> near;        // scratch
    Array<Index> own;         // rows of the block's boxes, one after another
    Array<PairOf> of_others;  // pairs whose row belongs to a larger box, anywhere
    Offset visits = 0;
  };

  /// Sets first[i + 1] to the length of what box i found for its own row.
  template <class Accepts>
  void find_block(const Accepts& accepts, BlockRange range, Found& found, Pairs& pairs) const {
    found.own.clear();
    found.of_others.clear();
    found.visits = 0;
    for (Index i = range.begin; i < range.end; ++i) {
      const std::size_t before = found.own.size();
      const Box& box = boxes_[static_cast<std::size_t>(i)];
      const int own_class = box.empty() ? BoxClasses::most : classes_.class_of(i);
      for (int size_class = own_class; size_class < BoxClasses::most;
           size_class = classes_.next(size_class)) {
        classes_.near(box, size_class, found.near);
        found.visits += static_cast<Offset>(found.near.size());
        for (const Index j : found.near) {
          // Within a class both find each other; the smaller number keeps the pair.
          if (size_class == own_class && j <= i) continue;
          if (!box.intersects(boxes_[static_cast<std::size_t>(j)])) continue;
          if (!accepts(std::min(i, j), std::max(i, j))) continue;
          if (i < j) {
            found.own.push_back(j);
          } else {
            found.of_others.push_back({j, i});
          }
        }
      }
      pairs.first[static_cast<std::size_t>(i) + 1] = static_cast<Offset>(found.own.size() - before);
    }
  }

  void join(int blocks, int threads, Pairs& pairs);

  Array<Box> boxes_;
  BoxClasses classes_;
  std::vector<Found> found_;
  Array<Offset> ends_;  // where the next pair of each row goes
  Offset visits_ = 0;
};

}  // namespace cellsearch
