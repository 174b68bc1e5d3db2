// SPDX-License-Identifier: BSD-3-Clause
// A roof of two triangles and a triangle hanging over its ridge: which edges are near which?
#include <array>
#include <cellsearch/edge_pairs.hpp>
#include <cstdio>

int main() {
  const std::array<double, 21> positions{0, 0, 1, 2,   0,  1, 1,   2, 0,  1, -2, 0,  // the roof
                                         1, 1, 3, 1.0, -1, 3, 1.1, 0, 1.1};          // the triangle
  const std::array<cellsearch::Index, 12> connectivity{0, 1, 2, 2, 1, 0, 3, 3, 4, 5, 6, 6};

  const auto edges = cellsearch::unique_edges(cellsearch::Segments(connectivity));  // the ridge only once
  cellsearch::EdgeScene scene;
  scene.positions = cellsearch::Positions(positions);
  scene.edges = cellsearch::Edges(edges);
  scene.expansion = 0.1;

  cellsearch::EdgePairSearch search;
  search.visit(scene, [&](cellsearch::Index i, cellsearch::Index j) {
    const cellsearch::Index* a = scene.edges[i];
    const cellsearch::Index* b = scene.edges[j];
    std::printf("edge %d-%d and edge %d-%d\n", a[0], a[1], b[0], b[1]);
  });
}
