// SPDX-License-Identifier: BSD-3-Clause
// Two squares one above the other, and a third one beside the lower: which are within 0.25 of each other?
#include <array>
#include <cellsearch/segment_pairs.hpp>
#include <cstdio>

int main() {
  const std::array<double, 30> positions{0, 0, 0,   1, 0, 0,   1, 1, 0,   0, 1, 0,    // lower square
                                         0, 0, 0.2, 1, 0, 0.2, 1, 1, 0.2, 0, 1, 0.2,  // upper square
                                         2, 0, 0,   2, 1, 0};                         // beside the lower one
  const std::array<cellsearch::Index, 12> connectivity{0, 1, 2, 3, 4, 5, 6, 7, 1, 8, 9, 2};

  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(positions);
  scene.segments = cellsearch::Segments(connectivity);
  scene.expansion = 0.125;  // half the distance, because both of a pair are expanded

  cellsearch::SegmentPairSearch search({.exclude_shared_nodes = true, .threads = 2});
  const cellsearch::Pairs& found = search.find(scene);
  for (cellsearch::Index i = 0; i < found.rows(); ++i) {
    for (const cellsearch::Index j : found.of(i)) std::printf("segments %d and %d\n", i, j);
  }
}
