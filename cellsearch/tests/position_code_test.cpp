// SPDX-License-Identifier: BSD-3-Clause
#include "reference/position_code.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "finder_scene.hpp"

namespace cellsearch::position_code_test {
namespace {

// Eight nodes in 4 x 3 x 2 boxes of 1 over [0, 4] x [0, 3] x [0, 2]. Codes by hand, ix + 4 (iy + 3 iz):
//   node 0 (0, 0, 0)        box 0 0 0   code 0
//   node 1 (4, 3, 2)        box 3 2 1   code 3 + 4 (2 + 3) = 23, the last box: the upper ends belong to it
//   node 2 (1.5, 0.5, 0.5)  box 1 0 0   code 1
//   node 3 (2.5, 0.5, 0.5)  box 2 0 0   code 2
//   node 4 (1.2, 1.5, 0.5)  box 1 1 0   code 1 + 4 = 5
//   node 5 (1.5, 0.9, 1.5)  box 1 0 1   code 1 + 4 * 3 = 13
//   node 6 (0.5, 2.5, 0.5)  box 0 2 0   code 0 + 4 * 2 = 8
//   node 7 (2.2, 0.2, 0.9)  box 2 0 0   code 2, as node 3
struct EightNodes : FinderScene {
  EightNodes() {
    positions = {0.0, 0.0, 0.0, 4.0, 3.0, 2.0, 1.5, 0.5, 0.5, 2.5, 0.5, 0.5,
                 1.2, 1.5, 0.5, 1.5, 0.9, 1.5, 0.5, 2.5, 0.5, 2.2, 0.2, 0.9};
    connectivity = {2, 2, 2, 2};
    expansion = 0.75;
  }
};

TEST(PositionCode, MergesTheBoxNumbersAndSortsThem) {
  const EightNodes scene;
  PositionCode coded;
  coded.build(scene.input(1.0));
  EXPECT_EQ(coded.cells(), 4 * 3 * 2);
  EXPECT_EQ(coded.code_of(1, 0, 1), 13u);
  std::vector<std::uint64_t> codes;
  std::vector<Index> nodes;
  for (const PositionCode::Entry& entry : coded.entries()) {
    codes.push_back(entry.code);
    nodes.push_back(entry.node);
  }
  EXPECT_EQ(codes, (std::vector<std::uint64_t>{0, 1, 2, 2, 5, 8, 13, 23}));
  EXPECT_EQ(nodes, (std::vector<Index>{0, 2, 3, 7, 4, 6, 5, 1}));
}

// The segment is the point of node 2 with the territory [0.75, 2.25] x [-0.25, 1.25] x [-0.25, 1.25]: boxes
// 0..2, 0..1, 0..1, in four rows of three. Codes 0..2 hold nodes 0 2 3 7, codes 4..6 node 4, codes 12..14
// node 5, codes 16..18 none. Of these, node 7 alone is inside and not the segment's own.
TEST(PositionCode, SearchesTheRowsOfBoxesOfATerritory) {
  const EightNodes scene;
  PositionCode coded;
  coded.build(scene.input(1.0));
  const FinderRows rows(coded, scene);
  EXPECT_EQ(rows.nodes, std::vector<Index>{7});
  EXPECT_EQ(rows.cell_visits, 12);
  EXPECT_EQ(rows.raw_visits, 6);
}

// 8 nodes, and a territory over 30 x 20 rows of boxes: looking at all nodes is cheaper.
TEST(PositionCode, LooksAtAllNodesWhereThereAreFewerThanRows) {
  EightNodes scene;
  scene.expansion = 10.0;
  PositionCode coded;
  coded.build(scene.input(0.1));
  const FinderRows rows(coded, scene);
  EXPECT_EQ(rows.nodes, (std::vector<Index>{0, 1, 3, 4, 5, 6, 7}));
  EXPECT_EQ(rows.cell_visits, 1);
  EXPECT_EQ(rows.raw_visits, 8);
}

// No array has the size of the space: boxes of 1 in a space of 1e15 of them, told apart by 64-bit codes.
TEST(PositionCode, NeedsNoMemoryForEmptySpace) {
  FinderScene scene;
  scene.positions = {0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 1e5, 1e5, 1e5};
  PositionCode coded;
  coded.build(scene.input(1.0));
  EXPECT_EQ(coded.cells(), Offset{1000000000000000});
  EXPECT_EQ(coded.bytes(), 3 * 16);
  EXPECT_EQ(coded.entries()[1].code, 1u);
  EXPECT_EQ(coded.entries()[2].code, 999999999999999u);
}

}  // namespace
}  // namespace cellsearch::position_code_test
