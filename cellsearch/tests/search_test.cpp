// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cellsearch/verify.hpp"
#include "scenes.hpp"

namespace cellsearch::search_test {
namespace {

TEST(Method, HasANameForEach) {
  EXPECT_EQ(method_named("linked-cell"), Method::LinkedCell);
  EXPECT_EQ(method_named("brute-force"), Method::BruteForce);
  for (const Method method : methods()) EXPECT_EQ(method_named(name_of(method)), method);
  EXPECT_FALSE(method_named("linked_cell"));
  EXPECT_FALSE(method_named(""));
}

// Two unit squares, one 0.25 above the other: each node is above a corner of the other square.
struct TwoPlates {
  std::vector<double> positions{0, 0, 0,    1, 0, 0,    1, 1, 0,    0, 1, 0,
                                0, 0, 0.25, 1, 0, 0.25, 1, 1, 0.25, 0, 1, 0.25};
  std::vector<Index> connectivity{0, 1, 2, 3, 4, 5, 6, 7};
  Scene scene;

  TwoPlates() {
    scene.positions = Positions(positions);
    scene.segments = Segments(connectivity);
    scene.expansion = 0.25;
  }
};

TEST(Search, FindsTheOtherPlateAndNeverItsOwnNodes) {
  const TwoPlates plates;
  Search search;
  const Candidates& found = search.find(plates.scene);
  EXPECT_EQ(found.first, (Array<Offset>{0, 4, 8}));
  EXPECT_EQ(found.node, (Array<Index>{4, 5, 6, 7, 0, 1, 2, 3}));
}

TEST(Search, TellsHowFarNodesMayMove) {
  TwoPlates plates;
  Search search;
  EXPECT_EQ(search.allowed_motion(0.0), 0.0);
  search.build(plates.scene);
  EXPECT_EQ(search.allowed_motion(0.125), 0.125);
  EXPECT_EQ(search.allowed_motion(0.5), 0.0);
  // Up to the limit the pair has been among the candidates; beyond it a pair may come from outside.
  const double left = search.allowed_motion(0.125);
  for (const double gap : {0.25, 0.2500001}) {
    TwoPlates apart;
    for (std::size_t node = 4; node < 8; ++node) apart.positions[3 * node + 2] = gap;
    const bool found = search.find(apart.scene).pairs() > 0;
    EXPECT_EQ(found, gap - left <= 0.125);
  }
}

TEST(Search, FindsNothingBeyondTheExpansion) {
  TwoPlates plates;
  plates.scene.expansion = 0.2499;
  Search search;
  EXPECT_EQ(search.find(plates.scene).first, (Array<Offset>{0, 0, 0}));
}

TEST(Search, LeavesNodesOutsideAGivenDomainAlone) {
  const TwoPlates plates;
  for (const Method method : methods()) {
    Search search({.method = method, .domain = CellDomain{Box{{0.5, 0.0, 0.0}, {1.0, 1.0, 1.0}}, {3, 3, 3}}});
    const Candidates& found = search.find(plates.scene);
    EXPECT_EQ(found.first, (Array<Offset>{0, 2, 4}));
    EXPECT_EQ(found.node, (Array<Index>{5, 6, 1, 2}));
    EXPECT_EQ(search.statistics().nodes_in_domain, 4);
  }
}

TEST(Search, FindsListedNodesOnly) {
  TwoPlates plates;
  const std::vector<Index> listed{1, 2, 7};
  plates.scene.nodes = listed;
  Search search;
  EXPECT_EQ(search.find(plates.scene).node, (Array<Index>{7, 1, 2}));
  EXPECT_EQ(search.statistics().participants, 3);
  plates.scene.nodes = std::span<const Index>{};
  EXPECT_EQ(search.find(plates.scene).pairs(), 0);
  EXPECT_EQ(search.query().segments(), 2);
}

TEST(Search, IgnoresNonFiniteNodesThatNeitherListNorSegmentNames) {
  TwoPlates plates;
  plates.positions.insert(plates.positions.end(), {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0});
  plates.scene.positions = Positions(plates.positions);
  const std::vector<Index> listed{0, 1, 2, 3, 4, 5, 6, 7};
  plates.scene.nodes = listed;
  Search search;
  EXPECT_EQ(search.find(plates.scene).pairs(), 8);
}

// Eq. (12) and the raw visits of the printed method, counted by hand: one cell holds all 8 nodes, and each of
// the 2 segments looks at all of them.
TEST(Search, CountsCellsMemoryAndVisits) {
  const TwoPlates plates;
  Search search(
      {.method = Method::LinkedCell, .domain = CellDomain{Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, {1, 1, 1}}});
  search.find(plates.scene);
  EXPECT_EQ(search.statistics().cells, 1);
  EXPECT_EQ(search.statistics().bytes, 4 * (1 + 8));
  EXPECT_EQ(search.statistics().raw_visits, 16);
  EXPECT_EQ(search.statistics().candidates, 8);
  EXPECT_EQ(search.statistics().segments, 2);
  EXPECT_EQ(search.statistics().participants, 8);
}

// With cells of a quarter along z the plates are in different cells, both reached by both territories;
// a third plate far above is visited by none.
TEST(Search, VisitsOnlyCellsOfTheTerritory) {
  TwoPlates plates;
  for (const double x : {0.0, 0.5, 1.0}) plates.positions.insert(plates.positions.end(), {x, 0.5, 0.9});
  plates.scene.positions = Positions(plates.positions);
  Search search(
      {.method = Method::LinkedCell, .domain = CellDomain{Box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, {2, 2, 4}}});
  search.find(plates.scene);
  EXPECT_EQ(search.statistics().cells, 16);
  EXPECT_EQ(search.statistics().bytes, 4 * (16 + 11));
  EXPECT_EQ(search.statistics().raw_visits, 16);
}

TEST(Search, VisitsInTheOrderOfTheRows) {
  const scenes::Mesh mesh = scenes::folded_sheets(3000, 5);  // several batches
  Search search;
  const Candidates found = search.find(mesh.scene());
  ASSERT_GT(found.pairs(), 1000);
  Candidates visited;
  visited.first.resize(found.first.size(), 0);
  const Statistics before = search.statistics();
  search.visit([&](Index segment, Index node) {
    visited.node.push_back(node);
    visited.first[static_cast<std::size_t>(segment) + 1] = visited.pairs();
  });
  for (std::size_t s = 1; s < visited.first.size(); ++s) {
    visited.first[s] = std::max(visited.first[s], visited.first[s - 1]);
  }
  EXPECT_EQ(visited, found);
  EXPECT_EQ(search.statistics().raw_visits, 2 * before.raw_visits);
  EXPECT_EQ(search.statistics().candidates, 2 * before.candidates);
}

TEST(Search, LetsAVisitorThrow) {
  const TwoPlates plates;
  Search search;
  search.build(plates.scene);
  int calls = 0;
  const auto visitor = [&](Index, Index) {
    if (++calls == 3) throw std::runtime_error("enough");
  };
  EXPECT_THROW(search.visit(visitor), std::runtime_error);
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(search.query().pairs(), 8);
}

TEST(Search, CanBeMovedAfterABuild) {
  const TwoPlates plates;
  Search search({.method = Method::LinkedCell});
  search.build(plates.scene);
  Search moved(std::move(search));
  EXPECT_EQ(moved.query().pairs(), 8);
  Search assigned({.method = Method::BruteForce});
  assigned = std::move(moved);
  EXPECT_EQ(assigned.query().pairs(), 8);
  EXPECT_EQ(assigned.settings().method, Method::LinkedCell);
  const Candidates kept = assigned.take();
  EXPECT_EQ(kept.pairs(), 8);
}

TEST(Search, FollowsNodesThatMove) {
  TwoPlates plates;
  Search search;
  EXPECT_EQ(search.find(plates.scene).pairs(), 8);
  for (std::size_t node = 4; node < 8; ++node) plates.positions[3 * node + 2] = 9.0;
  EXPECT_EQ(search.find(plates.scene).pairs(), 0);
  for (std::size_t node = 4; node < 8; ++node) plates.positions[3 * node + 2] = -0.125;
  EXPECT_EQ(search.find(plates.scene).pairs(), 8);
}

TEST(Search, HasNothingToSayBeforeTheFirstBuild) {
  for (const Method method : methods()) {
    Search search({.method = method, .threads = 3});
    EXPECT_EQ(search.query().segments(), 0);
    EXPECT_EQ(search.query().pairs(), 0);
    search.visit([](Index, Index) { FAIL(); });
  }
}

// Cells are as large as the mean edge, and a triangle has three edges: with sides of 3, 4 and 5 the mean is
// 4, and 8 x 4 x 1 cells of 4 cover the 32 x 16 x 4 of the nodes.
TEST(Search, MakesCellsOfTheMeanEdge) {
  const std::vector<double> positions{0, 0, 0, 3, 0, 0, 0, 4, 0, 32, 16, 4};
  const std::vector<Index> connectivity{0, 1, 2, 2};
  Scene scene;
  scene.positions = Positions(positions);
  scene.segments = Segments(connectivity);
  Search search({.method = Method::LinkedCell, .cells_per_node = 100.0});
  search.build(scene);
  EXPECT_EQ(search.grid().domain().cells, (std::array<Index, 3>{8, 4, 1}));
  EXPECT_EQ(search.statistics().cells, 32);
}

// O(N), eq. (11), counted and not timed: raw visits per segment do not grow with the mesh.
TEST(Search, VisitsAsManyNodesPerSegmentInALargeMeshAsInASmallOne) {
  std::vector<double> visits;
  for (const int nodes : {20000, 80000, 320000}) {
    const scenes::Mesh mesh = scenes::folded_sheets(nodes, 1);
    Search search({.method = Method::LinkedCell});
    search.find(mesh.scene());
    const Statistics& statistics = search.statistics();
    visits.push_back(static_cast<double>(statistics.raw_visits) / static_cast<double>(statistics.segments));
    EXPECT_LE(statistics.cells, 4 * statistics.participants);
  }
  EXPECT_NEAR(visits[2] / visits[0], 1.0, 0.05);
  EXPECT_NEAR(visits[1] / visits[0], 1.0, 0.05);
}

// Memory does not grow with the empty volume.
TEST(Search, CapsTheCellsOfASparseScene) {
  const scenes::Mesh mesh = scenes::sparse_patches(200, 1e8, 3);
  Search search;
  const Candidates& found = search.find(mesh.scene());
  EXPECT_LE(search.statistics().cells, static_cast<Offset>(4 * mesh.node_count()));
  EXPECT_FALSE(verify(found, mesh.scene(), search.settings()));
}

}  // namespace
}  // namespace cellsearch::search_test
