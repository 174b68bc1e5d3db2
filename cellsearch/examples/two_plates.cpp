// SPDX-License-Identifier: BSD-3-Clause
// Two parallel plates of one segment each, 0.1 apart: which nodes are near which segment?
#include <array>
#include <cellsearch/search.hpp>
#include <cstdio>

int main() {
  const std::array<double, 24> positions{0, 0, 0.0, 1, 0, 0.0, 1, 1, 0.0, 0, 1, 0.0,   // lower plate
                                         0, 0, 0.1, 1, 0, 0.1, 1, 1, 0.1, 0, 1, 0.1};  // upper plate
  const std::array<cellsearch::Index, 8> connectivity{0, 1, 2, 3, 4, 5, 6, 7};

  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(positions);  // views: nothing is copied
  scene.segments = cellsearch::Segments(connectivity);
  scene.expansion = 0.2;  // c: how far a node may be from the bounding box of a segment

  cellsearch::Search search;  // keep it: it re-uses its memory from search to search
  try {
    const cellsearch::Candidates& found = search.find(scene);
    for (cellsearch::Index segment = 0; segment < found.segments(); ++segment) {
      std::printf("segment %d:", segment);
      for (const cellsearch::Index node : found.of(segment)) std::printf(" %d", node);
      std::printf("\n");
    }
  } catch (const cellsearch::Error& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
