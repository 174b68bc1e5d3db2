// SPDX-License-Identifier: BSD-3-Clause
#include "reference/nbs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cellsearch/error.hpp"
#include "cellsearch/search.hpp"
#include "finder_scene.hpp"

namespace cellsearch::nbs_test {
namespace {

std::vector<Index> bodies_of(const BodyLists& lists, Index list) {
  std::vector<Index> bodies;
  for (Index body = lists.head(list); body >= 0; body = lists.next(body)) bodies.push_back(body);
  return bodies;
}

// Bodies 0..4 in layers 1, 0, 1, 2, 1, pushed in ascending order: a list runs from the last to the first.
TEST(BodyLists, RunFromTheBodyPushedLastToTheFirst) {
  BodyLists lists;
  lists.prepare(4, 5);
  const std::vector<Index> layers{1, 0, 1, 2, 1};
  for (Index body = 0; body < 5; ++body) lists.push(layers[static_cast<std::size_t>(body)], body);
  EXPECT_EQ(bodies_of(lists, 0), std::vector<Index>{1});
  EXPECT_EQ(bodies_of(lists, 1), (std::vector<Index>{4, 2, 0}));
  EXPECT_EQ(bodies_of(lists, 2), std::vector<Index>{3});
  EXPECT_TRUE(bodies_of(lists, 3).empty());
  EXPECT_EQ(lists.integers(), 4 + 5);
}

TEST(BodyLists, ForgetOneListAndTakeItsBodiesAgain) {
  BodyLists lists;
  lists.prepare(2, 3);
  for (Index body = 0; body < 3; ++body) lists.push(body % 2, body);
  lists.clear(0);
  EXPECT_TRUE(bodies_of(lists, 0).empty());
  EXPECT_EQ(bodies_of(lists, 1), std::vector<Index>{1});
  lists.push(0, 2);
  EXPECT_EQ(bodies_of(lists, 0), std::vector<Index>{2});
  lists.prepare(1, 1);
  EXPECT_TRUE(bodies_of(lists, 0).empty());
  EXPECT_EQ(lists.integers(), 2);
}

// Nodes at 0.5, 1.5, ..., 9.5 along x, all with y = z = 0.5; territories of 1.98 around nodes 0, 3 and 9.
// The extent of 9 gives 9 cells of 1: nodes 0..8 in cells 0..8, and node 9, on the upper end, in cell 8 too.
// Node 0 meets those of cells 0 1, node 3 those of 2 3 4, node 9 those of 7 8: 2 + 3 + 3 nodes.
TEST(Nbs, MeetsTheNodesOfItsCellAndTheNeighbours) {
  FinderScene scene;
  for (int node = 0; node < 10; ++node) {
    scene.positions.insert(scene.positions.end(), {node + 0.5, 0.5, 0.5});
  }
  scene.connectivity = {0, 0, 0, 0, 3, 3, 3, 3, 9, 9, 9, 9};
  scene.expansion = 0.99;
  Nbs nbs;
  nbs.build(scene.input(123.0));  // the wanted edge does not matter
  EXPECT_EQ(nbs.axis(0).count, 9);
  EXPECT_EQ(nbs.axis(1).count, 1);
  EXPECT_EQ(nbs.axis(2).count, 1);
  EXPECT_EQ(nbs.cells(), 9);
  const FinderRows rows(nbs, scene);
  EXPECT_TRUE(rows.nodes.empty());
  EXPECT_EQ(rows.raw_visits, 2 + 3 + 3);
  EXPECT_EQ(rows.cell_visits, 2 + 3 + 2);
}

// A lattice of 7 x 7 x 7 nodes a unit apart, and territories of almost 3 around the one in the middle and the
// one in the first corner: 4 cells of 1.5 along each axis, with the nodes 0 1 | 2 | 3 4 | 5 6. The middle is
// in the third of them and meets the last three: 5 nodes along each axis. The corner meets 0 1 2. Inside the
// territories are the next nodes on all sides: 3^3 - 1 and 2^3 - 1.
TEST(Nbs, MeetsTwentySevenCellsInSpace) {
  FinderScene scene;
  for (int z = 0; z < 7; ++z) {
    for (int y = 0; y < 7; ++y) {
      for (int x = 0; x < 7; ++x) {
        scene.positions.insert(scene.positions.end(), {1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  const Index middle = 3 + 7 * (3 + 7 * 3);
  scene.connectivity = {middle, middle, middle, middle, 0, 0, 0, 0};
  scene.expansion = 1.4998;
  Nbs nbs;
  nbs.build(scene.input(1.0));
  EXPECT_EQ(nbs.cells(), 4 * 4 * 4);
  const FinderRows rows(nbs, scene);
  EXPECT_EQ(rows.raw_visits, 5 * 5 * 5 + 3 * 3 * 3);
  EXPECT_EQ(rows.ends, (std::vector<Offset>{26, 26 + 7}));
}

// A strip of `small` territories of 1 and a last one of `size`.
FinderScene strip(int small, double size) {
  FinderScene scene;
  for (int k = 0; k < small; ++k) {
    const Index base = static_cast<Index>(scene.positions.size() / 3);
    scene.positions.insert(scene.positions.end(), {2.0 * k, 0.0, 0.0, 2.0 * k + 1.0, 1.0, 0.0});
    scene.connectivity.insert(scene.connectivity.end(), {base, base, base + 1, base + 1});
  }
  const Index base = static_cast<Index>(scene.positions.size() / 3);
  scene.positions.insert(scene.positions.end(), {0.0, 0.0, 0.5, size, 0.5, 0.5});
  scene.connectivity.insert(scene.connectivity.end(), {base, base, base + 1, base + 1});
  return scene;
}

// With 8 of size 1 and one of size s the mean is (8 + s) / 9, and s is 3 times that for s = 4.
TEST(Nbs, RefusesBodiesOfDifferentSizes) {
  Nbs nbs;
  EXPECT_NO_THROW(nbs.build(strip(8, 3.99).input(1.0)));
  const FinderScene mixed = strip(8, 4.01);
  try {
    nbs.build(mixed.input(1.0));
    FAIL() << "a territory of 3.005 times the mean must be refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::UnsuitedMethod);
    EXPECT_EQ(error.index(), 8);
    EXPECT_NE(std::string(error.what()).find("segment 8"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(nbs.build(strip(8, 3.99).input(1.0))) << "a refusal must leave nothing behind";
  EXPECT_EQ(FinderRows(nbs, strip(8, 3.99)).ends.size(), 9u);
}

// Only what takes part is compared: the large segment is beside the domain.
TEST(Nbs, LooksAtTheSizesInsideTheDomainOnly) {
  FinderScene scene = strip(8, 1000.0);
  for (double* z = &scene.positions[8 * 6 + 2]; z < scene.positions.data() + scene.positions.size(); z += 3) {
    *z = 7.0;
  }
  FinderInput input = scene.input(1.0);
  Nbs nbs;
  EXPECT_THROW(nbs.build(input), Error);
  input.limit = Box{{0.0, 0.0, 0.0}, {20.0, 1.0, 1.0}};
  EXPECT_NO_THROW(nbs.build(input));
  EXPECT_EQ(nbs.nodes_in_domain(), 16);
}

TEST(Nbs, LeavesTheSearchUsableAfterARefusal) {
  const FinderScene mixed = strip(8, 100.0);
  const FinderScene similar = strip(8, 2.0);
  Search search({.method = Method::Nbs});
  EXPECT_THROW(search.build(mixed.input(1.0).scene), Error);
  EXPECT_EQ(search.query().segments(), 0);
  EXPECT_EQ(search.find(similar.input(1.0).scene).segments(), 9);
}

// The heads of lists are no more than bodies along an axis, however far these are apart: with 2 nodes and
// 2 segments, 4 lists of each kind at most.
TEST(Nbs, NeedsNoMemoryForEmptySpace) {
  FinderScene scene;
  scene.positions = {0.0, 0.0, 0.0, 1e9, 1e9, 1e9};
  scene.connectivity = {0, 0, 0, 0, 1, 1, 1, 1};
  scene.expansion = 0.5;
  Nbs nbs;
  nbs.build(scene.input(1.0));
  EXPECT_EQ(nbs.cells(), 4 * 4 * 4);
  EXPECT_LE(nbs.bytes(), 300);
}

}  // namespace
}  // namespace cellsearch::nbs_test
