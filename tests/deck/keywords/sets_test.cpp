// SPDX-License-Identifier: BSD-3-Clause
// *SET_... in all their forms, *DEFINE_BOX, and the loads on sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "deck/small_deck.hpp"
#include "model/solid_faces.hpp"

namespace crumple::deck::test::sets_test {
namespace {

using Indices = std::vector<Index>;
using Segment = std::array<Index, 4>;

/// A block of 2 x 1 x 1 cubes (solids 21 and 22 on nodes 1 to 12, x from 0 to 2) with a shell (31) on top of
/// each; parts 1 (solids) and 2 (shells).
struct BlockDeck : SmallDeck {
  BlockDeck() {
    nodes = "*NODE\n";
    int id = 0;
    for (const int z : {0, 1})
      for (const int y : {0, 1})
        for (const int x : {0, 1, 2})
          nodes += std::to_string(++id) + "," + std::to_string(x) + "," + std::to_string(y) + "," +
                   std::to_string(z) + "\n";
    shells =
        "*ELEMENT_SOLID\n21,1,1,2,5,4,7,8,11,10\n22,1,2,3,6,5,8,9,12,11\n"
        "*ELEMENT_SHELL\n31,2,7,8,11,10\n32,2,8,9,12,11\n";
    part = "*PART\nblock\n1,7,1\nlid\n2,1,1\n";
    section = "*SECTION_SOLID\n7,1\n*SECTION_SHELL\n1,2\n0.1,0.1\n";
  }
};

model::Model block_with(const std::string& more) {
  BlockDeck deck;
  deck.more = more;
  return read_clean(deck.text());
}

Indices sorted(Indices list) {
  std::sort(list.begin(), list.end());
  return list;
}

TEST(NodeSet, GeneralByNodesPartsAndBoxes) {
  const model::Model model = block_with(
      "*DEFINE_BOX\n         4      -0.1       0.1      -1.0       2.0      -1.0       2.0\n"
      "*SET_NODE_GENERAL_TITLE\nleft\n         1\n       BOX         4\n"
      "*SET_NODE_GENERAL\n         2\nPART               2\nDNODE              7         8\nNODE             "
      "  1\n"
      "*SET_NODE_GENERAL\n3\nALL\nDBOX,4\nDPART,2\n"
      "*SET_NODE_GENERAL\n4\nall\nDNODE,1\nNODE,1\n");
  ASSERT_EQ(model.node_sets.size(), 4U);
  EXPECT_EQ(model.node_sets[0].title, "left");
  EXPECT_EQ(model.node_sets[0].nodes, (Indices{0, 3, 6, 9}));
  EXPECT_EQ(model.node_sets[1].nodes, (Indices{8, 9, 10, 11, 0}));
  EXPECT_EQ(model.node_sets[2].nodes, (Indices{1, 2, 4, 5}));
  EXPECT_EQ(model.node_sets[3].nodes.size(), 12U);
}

/// A box of no thickness has the nodes on it.
TEST(NodeSet, SidesBelongToTheBox) {
  const model::Model model =
      block_with("*DEFINE_BOX\n4,1.0,1.0,0.0,1.0,0.0,0.0\n*SET_NODE_GENERAL\n1\nBOX,4\n");
  EXPECT_EQ(model.node_sets[0].nodes, (Indices{1, 4}));
}

TEST(NodeSet, AddOfSetsBeforeAndBehind) {
  const model::Model model = block_with(
      "*SET_NODE_ADD\n9\n1,3,7\n*SET_NODE_ADD\n8\n1,-3\n"
      "*SET_NODE_LIST\n1\n1,2\n*SET_NODE_LIST\n2\n6\n*SET_NODE_LIST\n3\n2,3\n*SET_NODE_ADD\n7\n2\n");
  EXPECT_EQ(model.node_sets[0].nodes, (Indices{0, 1, 2, 5}));
  EXPECT_EQ(model.node_sets[1].nodes, (Indices{0, 1, 5, 2}));
  EXPECT_EQ(model.node_sets[5].nodes, (Indices{5}));
}

TEST(NodeSet, CollectJoinsBlocksOfOneId) {
  const model::Model model = block_with(
      "*SET_NODE_LIST_COLLECT\n1\n1,2\n*SET_NODE_LIST_COLLECT_TITLE\nmore\n1\n2,3\n"
      "*SET_NODE_LIST_GENERATE_COLLECT\n1\n10,12\n");
  ASSERT_EQ(model.node_sets.size(), 1U);
  EXPECT_EQ(model.node_sets[0].nodes, (Indices{0, 1, 2, 9, 10, 11}));
}

TEST(NodeSet, RangesWithIncrement) {
  const model::Model model = block_with("*SET_NODE_LIST_GENERATE_INCREMENT\n1\n1,10,3\n12,12\n");
  EXPECT_EQ(model.node_sets[0].nodes, (Indices{0, 3, 6, 9, 11}));
}

TEST(NodeSet, Columns) {
  const model::Model model = block_with("*SET_NODE_COLUMN\n1\n3,0.5,0.5\n1\n7\n*SET_PART_COLUMN\n2\n1,0.1\n");
  EXPECT_EQ(sorted(model.node_sets[0].nodes), (Indices{0, 2, 6}));
  EXPECT_EQ(model.part_sets[0].parts, (Indices{0}));
}

TEST(NodeSet, NodesOfShellSets) {
  const model::Model model = block_with("*SET_SHELL_LIST\n5\n32\n*SET_NODE_GENERAL\n1\nSET_SHELL,5\n");
  EXPECT_EQ(sorted(model.node_sets[0].nodes), (Indices{7, 8, 10, 11}));
}

TEST(NodeSet, NodesOfElementsAndOfTheirSets) {
  const model::Model model = block_with(
      "*SET_SOLID_LIST\n5\n22\n*SET_SHELL_LIST\n6\n31\n"
      "*SET_NODE_GENERAL\n1\nSHELL,32,31\nDSHELL,31\n*SET_NODE_GENERAL\n2\nSOLID,21\n"
      "*SET_NODE_GENERAL\n3\nSET_SOLID,5\nDSOLID,21\n*SET_NODE_GENERAL\n4\nALL\nDSET_SOLID,5\nDSET_SHELL,6\n"
      "*SET_NODE_GENERAL\n5\nSET,1\nSET_NODE,4\nDSET,4\n");
  EXPECT_EQ(sorted(model.node_sets[0].nodes), (Indices{8, 11}));
  EXPECT_EQ(sorted(model.node_sets[1].nodes), (Indices{0, 1, 3, 4, 6, 7, 9, 10}));
  EXPECT_EQ(sorted(model.node_sets[2].nodes), (Indices{2, 5, 8, 11}));
  EXPECT_EQ(sorted(model.node_sets[3].nodes), (Indices{0, 3}));
  EXPECT_EQ(sorted(model.node_sets[4].nodes), (Indices{8, 11}));
}

TEST(NodeSet, NodesOfBeamsAndSprings) {
  BlockDeck deck;
  deck.part += "rod\n3,3,1\nspring\n4,4,4\n";
  deck.section += "*SECTION_BEAM\n3,3\n0.5\n*SECTION_DISCRETE\n4\n\n";
  deck.material += "*MAT_SPRING_ELASTIC\n4,1\n";
  deck.more =
      "*ELEMENT_BEAM\n41,3,1,2\n42,3,2,3\n*ELEMENT_DISCRETE\n51,4,4,5\n"
      "*SET_BEAM\n5\n42\n*SET_DISCRETE\n6\n51\n"
      "*SET_NODE_GENERAL\n1\nBEAM,41\n*SET_NODE_GENERAL\n2\nSET_BEAM,5\nDISCRETE,51\nDBEAM,41\n"
      "*SET_NODE_GENERAL\n3\nSET_DISCRETE,6\n*SET_NODE_GENERAL\n4\nBEAM,41\nDSET_BEAM,5\nSOLID,21\n"
      "DDISCRETE,51\nDSET_DISCRETE,6\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(sorted(model.node_sets[0].nodes), (Indices{0, 1}));
  EXPECT_EQ(sorted(model.node_sets[1].nodes), (Indices{2, 3, 4}));
  EXPECT_EQ(sorted(model.node_sets[2].nodes), (Indices{3, 4}));
  EXPECT_EQ(sorted(model.node_sets[3].nodes), (Indices{0, 1, 6, 7, 9, 10}));
}

TEST(SegmentSet, FacesInsideOfSolids) {
  const model::Model model = block_with(
      "*DEFINE_BOX\n4,0.9,1.1,-1.0,2.0,-1.0,2.0\n*SET_SOLID_LIST\n5\n21\n"
      "*SET_SEGMENT_GENERAL\n1\nPART_IO,1\n*SET_SEGMENT_GENERAL\n2\nBOX_SLDIO,4\n"
      "*SET_SEGMENT_GENERAL\n3\nSET_SLDIO,5\n*SET_SEGMENT_GENERAL\n4\nPART_IO,1\nDPART,1\n");
  EXPECT_EQ(model.segment_sets[0].segments.size(), 11U);
  ASSERT_EQ(model.segment_sets[1].segments.size(), 1U);
  Segment between = model.segment_sets[1].segments[0];
  std::sort(between.begin(), between.end());
  EXPECT_EQ(between, (Segment{1, 4, 7, 10}));
  EXPECT_EQ(model.segment_sets[2].segments.size(), 6U);
  ASSERT_EQ(model.segment_sets[3].segments.size(), 1U);
  EXPECT_EQ(model.segment_sets[3].segments[0], model.segment_sets[1].segments[0]);
}

TEST(PartSet, GeneralAddAndCollect) {
  const model::Model model = block_with(
      "*SET_PART_GENERAL\n1\nALL\nDPART,1\n*SET_PART_GENERAL\n2\nPART,1\nSET,1\n*SET_PART_GENERAL\n3\nSET,"
      "2\nDSET,1\n"
      "*SET_PART_ADD\n4\n1,3\n*SET_PART_LIST_COLLECT\n5\n1\n*SET_PART_LIST_COLLECT\n5\n2\n");
  EXPECT_EQ(model.part_sets[0].parts, (Indices{1}));
  EXPECT_EQ(model.part_sets[1].parts, (Indices{0, 1}));
  EXPECT_EQ(model.part_sets[2].parts, (Indices{0}));
  EXPECT_EQ(model.part_sets[3].parts, (Indices{1, 0}));
  EXPECT_EQ(model.part_sets[4].parts, (Indices{0, 1}));
}

TEST(ShellSet, ListGenerateGeneralAndAdd) {
  const model::Model model = block_with(
      "*DEFINE_BOX\n4,0.5,2.5,-1.0,2.0,0.0,2.0\n"
      "*SET_SHELL_LIST\n1\n32,31\n*SET_SHELL\n2\n31\n*SET_SHELL_LIST_GENERATE\n3\n30,40\n"
      "*SET_SHELL_GENERAL\n4\nBOX,4\n*SET_SHELL_GENERAL\n5\nPART,2\nDELEM,31\n*SET_SHELL_"
      "GENERAL\n6\nALL\nDBOX,4\n"
      "*SET_SHELL_ADD\n7\n2,4\n");
  const std::vector<Indices> expected = {{1, 0}, {0}, {0, 1}, {1}, {1}, {0}, {0, 1}};
  ASSERT_EQ(model.shell_sets.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(model.shell_sets[i].shells, expected[i]) << i;
}

TEST(SegmentSet, ListAndGeneralWithSegments) {
  const model::Model model = block_with(
      "*SET_SEGMENT_TITLE\nlid\n         1\n         7         8        11        10       0.5\n"
      "         8         9        12         0\n"
      "*SET_SEGMENT_GENERAL\n2\nSEG,7,8,11,10\nSEG,1,2,5,5\nDSEG,11,10,7,8\n");
  ASSERT_EQ(model.segment_sets.size(), 2U);
  EXPECT_EQ(model.segment_sets[0].title, "lid");
  EXPECT_EQ(model.segment_sets[0].segments, (std::vector<Segment>{{6, 7, 10, 9}, {7, 8, 11, 11}}));
  EXPECT_EQ(model.segment_sets[1].segments, (std::vector<Segment>{{0, 1, 4, 4}}));
}

/// Twice the vector area of a segment, for its direction.
std::array<double, 3> normal_of(const model::Model& model, const Segment& s) {
  const auto& x = model.nodes.position;
  std::array<double, 3> a{}, b{};
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = x[s[2]][i] - x[s[0]][i];
    b[i] = x[s[3]][i] - x[s[1]][i];
  }
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The surface of the block: ten faces, whose vectors of area point outwards, add up to nothing, and give the
/// volume by the divergence theorem.
TEST(SegmentSet, PartsOfSolidsGiveTheirSurface) {
  const model::Model model = block_with("*SET_SEGMENT_GENERAL\n1\nPART,1\n");
  const auto& segments = model.segment_sets[0].segments;
  EXPECT_EQ(segments.size(), 10U);
  std::array<double, 3> sum{};
  double volume = 0;
  for (const Segment& s : segments) {
    const std::array<double, 3> n = normal_of(model, s);
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += n[i];
      double middle = 0;
      for (const Index node : s) middle += model.nodes.position[node][i] / 4;
      volume += n[i] * middle / 6;
    }
  }
  EXPECT_EQ(sum, (std::array<double, 3>{0, 0, 0}));
  EXPECT_DOUBLE_EQ(volume, 2);
}

TEST(SegmentSet, GeneralBySetsBoxesAndShells) {
  const model::Model model = block_with(
      "*DEFINE_BOX\n4,-0.1,0.1,-1.0,2.0,-1.0,2.0\n*DEFINE_BOX\n5,-1.0,1.0,-1.0,2.0,0.9,2.0\n"
      "*SET_SOLID_LIST\n1\n21\n*SET_SOLID_GENERATE\n2\n21,29\n*SET_SOLID_GENERAL\n3\nALL\nDELEM,21\n"
      "*SET_SHELL\n1\n31\n"
      "*SET_SEGMENT_GENERAL\n1\nBOX,4\n*SET_SEGMENT_GENERAL\n2\nBOX_SHELL,5\n*SET_SEGMENT_GENERAL\n3\nBOX_"
      "SOLID,5\n"
      "*SET_SEGMENT_GENERAL\n4\nSET_SOLID,1\n*SET_SEGMENT_GENERAL\n5\nSET_SOLID,2\nDSET,4\n"
      "*SET_SEGMENT_GENERAL\n6\nSET_SHELL,1\nSHELL,32\n*SET_SEGMENT_GENERAL\n7\nALL\nDPART,2\n"
      "*SET_SEGMENT_ADD\n8\n1,2\n*SET_SEGMENT_GENERAL\n9\nSET_SOLID,3\nDBOX,5\n");
  const auto count = [&](std::size_t set) { return model.segment_sets[set].segments.size(); };
  ASSERT_EQ(model.segment_sets.size(), 9U);
  EXPECT_EQ(count(0), 1U);  // the face at x = 0
  EXPECT_EQ(normal_of(model, model.segment_sets[0].segments[0])[0], -2.0);
  EXPECT_EQ(model.segment_sets[1].segments, (std::vector<Segment>{{6, 7, 10, 9}}));
  EXPECT_EQ(count(2), 1U);  // the top of solid 21: the same nodes
  EXPECT_EQ(count(3), 6U);
  EXPECT_EQ(count(4), 5U);  // ten less the five of solid 21 that are outside of both
  EXPECT_EQ(model.segment_sets[5].segments, (std::vector<Segment>{{6, 7, 10, 9}, {7, 8, 11, 10}}));
  EXPECT_EQ(count(6), 8U);  // the shells have the nodes of two faces of the solids
  EXPECT_EQ(count(7), 2U);
  EXPECT_EQ(count(8), 6U);
}

TEST(SolidFaces, OfWedgesPyramidsAndTetrahedra) {
  const auto count = [](const std::array<Index, 8>& node) {
    model::SolidElement solid;
    solid.node = node;
    std::array<std::size_t, 2> found{};
    for (const Segment& face : model::faces_of(solid)) ++found[face[2] == face[3] ? 0 : 1];
    return found;  // triangles, quadrilaterals
  };
  EXPECT_EQ(count({0, 1, 2, 3, 4, 5, 6, 7}), (std::array<std::size_t, 2>{0, 6}));
  EXPECT_EQ(count({0, 1, 2, 3, 4, 4, 5, 5}), (std::array<std::size_t, 2>{2, 3}));
  EXPECT_EQ(count({0, 1, 2, 3, 4, 4, 4, 4}), (std::array<std::size_t, 2>{4, 1}));
  EXPECT_EQ(count({0, 1, 2, 2, 4, 4, 4, 4}), (std::array<std::size_t, 2>{4, 0}));
}

TEST(Loads, OnSetsOfSegmentsAndShells) {
  const model::Model model = block_with(
      "*DEFINE_CURVE\n1\n0.0,0.0\n3.0,2.0\n*SET_SEGMENT\n3\n1,2,5,4\n7,8,11,10\n*SET_SHELL\n4\n31,32\n"
      "*LOAD_SEGMENT_SET\n         3         1       0.5       0.1\n"
      "*LOAD_SHELL_SET_ID\n        12lid\n         4         1       0.7\n");
  ASSERT_EQ(model.pressure_loads.size(), 4U);
  EXPECT_EQ(model.pressure_loads[0].node, (Segment{0, 1, 4, 3}));
  EXPECT_EQ(model.pressure_loads[0].pressure, 0.5);
  EXPECT_EQ(model.pressure_loads[0].arrival, 0.1);
  EXPECT_EQ(model.pressure_loads[0].shell, no_index);
  EXPECT_EQ(model.pressure_loads[1].shell, 0);
  EXPECT_EQ(model.pressure_loads[2].node, (Segment{6, 7, 10, 9}));
  EXPECT_EQ(model.pressure_loads[3].shell, 1);
  EXPECT_EQ(model.pressure_loads[3].pressure, 0.7);
}

TEST(Sets, WithoutMembersGiveAWarning) {
  BlockDeck deck;
  deck.more = "*DEFINE_BOX\n4,5.0,6.0,5.0,6.0,5.0,6.0\n*SET_NODE_GENERAL\n7\nBOX,4\n";
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  EXPECT_NE(listed(result.diagnostics).find("warning: *SET_NODE_GENERAL card 1: set 7 has no members"),
            std::string::npos);
}

}  // namespace
}  // namespace crumple::deck::test::sets_test
