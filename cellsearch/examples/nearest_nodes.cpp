// SPDX-License-Identifier: BSD-3-Clause
// Five nodes on a line: the two nearest of each, not farther than 3.
#include <array>
#include <cellsearch/nearest_nodes.hpp>
#include <cstdio>

int main() {
  const std::array<double, 15> positions{0, 0, 0, 1, 0, 0, 3, 0, 0, 6, 0, 0, 10, 0, 0};

  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(positions);  // segments are not needed

  cellsearch::NearestSearch search({.neighbours = 2, .largest_distance = 3.0});
  const cellsearch::NearestNodes& found = search.find(scene);
  for (cellsearch::Index p = 0; p < found.rows(); ++p) {
    std::printf("node %d:", p);
    for (std::size_t rank = 0; rank < found.of(p).size(); ++rank) {
      std::printf(" %d (%g)", found.of(p)[rank], found.distances_of(p)[rank]);
    }
    std::printf("\n");
  }
}
