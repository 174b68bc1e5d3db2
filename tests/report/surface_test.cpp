// SPDX-License-Identifier: BSD-3-Clause
#include "report/surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"

namespace crumple::report::surface_test {
namespace {

constexpr Index never = 10;  // frames of the run

void add(CellList& cells, std::int64_t type, const std::vector<std::int64_t>& nodes, Index death = never) {
  cells.connectivity.insert(cells.connectivity.end(), nodes.begin(), nodes.end());
  cells.offsets.push_back(static_cast<std::int64_t>(cells.connectivity.size()));
  cells.types.push_back(type);
  cells.death.push_back(death);
}

/// Unit cubes in a row along x; node 4 i + j is corner j of the i-th square.
CellList cubes(const std::vector<Index>& deaths) {
  CellList cells;
  for (std::size_t i = 0; i < deaths.size(); ++i) {
    const auto first = static_cast<std::int64_t>(4 * i);
    add(cells, 12, {first, first + 1, first + 2, first + 3, first + 4, first + 5, first + 6, first + 7},
        deaths[i]);
  }
  return cells;
}

TEST(Surface, ShellsAndLinesAreDrawnAsTheyAre) {
  CellList cells;
  add(cells, 9, {5, 6, 8, 7});
  add(cells, 5, {6, 9, 8});
  add(cells, 3, {5, 9});
  add(cells, 1, {2});
  const Surface surface = make_surface(cells, 10);
  ASSERT_EQ(surface.faces.size(), 2U);
  EXPECT_EQ(surface.nodes, (std::vector<Index>{5, 6, 7, 8, 9}));
  EXPECT_EQ(surface.cells, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(surface.faces[0].node, (std::array<Index, 4>{0, 1, 3, 2}));
  EXPECT_EQ(surface.faces[1].node, (std::array<Index, 4>{1, 4, 3, 3}));
  ASSERT_EQ(surface.lines.size(), 1U);
  EXPECT_EQ(surface.lines[0].node[0], 0);
  EXPECT_EQ(surface.lines[0].node[1], 4);
}

TEST(Surface, FacesBetweenSolidsAreHidden) {
  const Surface surface = make_surface(cubes({never, never, never}), 16);
  EXPECT_EQ(surface.faces.size(), 14U);
  EXPECT_TRUE(std::all_of(surface.faces.begin(), surface.faces.end(),
                          [](const Face& face) { return face.behind == no_index; }));
}

/// Each face is four triangles, which the neighbour's hide.
TEST(Surface, TetrahedraWithTenNodesShowSixteenTriangles) {
  CellList cells;
  add(cells, 24, {0, 1, 2, 3, 5, 6, 7, 8, 9, 10});
  const Surface alone = make_surface(cells, 11);
  EXPECT_EQ(alone.faces.size(), 16U);
  std::set<std::pair<Index, Index>> edges;
  for (const Face& face : alone.faces) {
    EXPECT_EQ(face.node[2], face.node[3]);
    for (std::size_t k = 0; k < 3; ++k) edges.insert({face.node[k], face.node[(k + 1) % 3]});
  }
  // Closed: each edge once in each direction.
  EXPECT_EQ(edges.size(), 48U);
  for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
  // On the other side of the face 0 2 1 with 7, 6, 5 between.
  add(cells, 24, {0, 2, 1, 4, 7, 6, 5, 11, 12, 13});
  EXPECT_EQ(make_surface(cells, 14).faces.size(), 24U);
}

TEST(Surface, ErosionBringsInnerFacesToLight) {
  const Surface surface = make_surface(cubes({never, 4, never}), 16);
  EXPECT_EQ(surface.faces.size(), 16U);
  std::multiset<std::pair<Index, Index>> inner;
  for (const Face& face : surface.faces)
    if (face.behind != no_index) inner.insert({face.cell, face.behind});
  EXPECT_EQ(inner, (std::multiset<std::pair<Index, Index>>{{0, 1}, {2, 1}}));
}

TEST(Surface, FacesOfSolidsThatFailTogetherStayHidden) {
  EXPECT_EQ(make_surface(cubes({4, 4}), 12).faces.size(), 10U);
}

TEST(Surface, EverySolidIsClosed) {
  const std::vector<std::pair<std::int64_t, std::vector<std::int64_t>>> solids = {
      {10, {0, 1, 2, 3}}, {14, {0, 1, 2, 3, 4}}, {13, {0, 1, 2, 3, 4, 5}}, {12, {0, 1, 2, 3, 4, 5, 6, 7}}};
  for (const auto& [type, nodes] : solids) {
    CellList cells;
    add(cells, type, nodes);
    const Surface surface = make_surface(cells, 8);
    // On a closed surface whose faces all turn the same way round, every edge is run along once in each
    // direction.
    std::set<std::pair<Index, Index>> edges;
    for (const Face& face : surface.faces) {
      for (std::size_t i = 0; i < 4; ++i) {
        const auto edge = std::pair(face.node[i], face.node[(i + 1) % 4]);
        if (edge.first == edge.second) continue;
        EXPECT_TRUE(edges.insert(edge).second) << "type " << type;
      }
    }
    for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1U) << "type " << type;
    EXPECT_EQ(surface.nodes.size(), nodes.size());
  }
}

TEST(Surface, SolidsOfDifferentKindsHideTheirCommonFace) {
  CellList cells = cubes({never});
  add(cells, 14, {4, 5, 6, 7, 8});
  EXPECT_EQ(make_surface(cells, 9).faces.size(), 9U);
  CellList triangles;
  add(triangles, 10, {0, 1, 2, 3});
  add(triangles, 10, {0, 2, 1, 4});
  EXPECT_EQ(make_surface(triangles, 5).faces.size(), 6U);
}

TEST(Surface, RefusesCellsThatAreWrong) {
  CellList cells;
  add(cells, 42, {0, 1});
  EXPECT_THROW(make_surface(cells, 2), Error);
  CellList beyond;
  add(beyond, 9, {0, 1, 2, 9});
  EXPECT_THROW(make_surface(beyond, 9), Error);
  CellList few;
  add(few, 9, {0, 1, 2});
  EXPECT_THROW(make_surface(few, 9), Error);
}

}  // namespace
}  // namespace crumple::report::surface_test
