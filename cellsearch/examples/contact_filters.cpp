// SPDX-License-Identifier: BSD-3-Clause
// A strip of three squares folded onto itself, and a ball: which nodes may touch which segment?
#include <array>
#include <cellsearch/search.hpp>
#include <cstdint>
#include <cstdio>

int main() {
  const std::array<double, 27> positions{0,   0,   0,   1, 0, 0,   1, 1, 0,   0, 1, 0,    // lower square
                                         1,   0,   0.4, 1, 1, 0.4, 0, 0, 0.4, 0, 1, 0.4,  // upper square
                                         0.5, 0.5, 1.0};  // centre of the ball
  const std::array<cellsearch::Index, 12> connectivity{0, 1, 2, 3, 1, 4, 5, 2, 4, 6, 7, 5};
  const std::array<double, 9> radius{0, 0, 0, 0, 0, 0, 0, 0, 0.3};
  const std::array<std::uint8_t, 3> active{1, 0, 1};  // the square in the fold has failed
  const std::array<cellsearch::Index, 9> node_part{0, 0, 0, 0, 0, 0, 0, 0, 1};
  const std::array<cellsearch::Index, 3> segment_part{0, 0, 0};
  const std::array<std::uint8_t, 4> allow{1, 1,   // segments of the strip: nodes of the strip and of the ball
                                          0, 0};  // the ball has no segments

  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(positions);
  scene.segments = cellsearch::Segments(connectivity);
  scene.expansion = 0.5;
  scene.node_radius = radius;
  scene.segment_active = active;
  scene.exclude_neighbours = true;
  scene.groups = {2, node_part, segment_part, allow};

  cellsearch::Search search;
  search.build(scene);
  search.visit([](cellsearch::Index segment, cellsearch::Index node) {
    std::printf("segment %d: node %d\n", segment, node);
  });
}
