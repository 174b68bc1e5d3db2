// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_SOLID with ten nodes.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::quadratic_tetrahedra_test {
namespace {

/// Corners 11 to 14, and 15 to 20 in the middle of the sides.
struct TenNodeDeck : CubeDeck {
  TenNodeDeck() {
    nodes =
        "*NODE\n11,0.,0.,0.\n12,2.,0.,0.\n13,0.,2.,0.\n14,0.,0.,2.\n15,1.,0.,0.\n16,1.,1.,0.\n17,0.,1.,0.\n"
        "18,0.,0.,1.\n19,1.,0.,1.\n20,0.,1.,1.\n";
    section = "*SECTION_SOLID\n1,16\n";
    shells = "*ELEMENT_SOLID\n21,1\n11,12,13,14,15,16,17,18,19,20\n";
  }
  std::string messages() const { return listed(read_deck_text(text()).diagnostics); }
};

TEST(QuadraticTetrahedron, HasItsNodesOnASecondCard) {
  TenNodeDeck deck;
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.solids.size(), 1U);
  const model::SolidNodes& node = model.solids[0].node;
  ASSERT_TRUE(node.has_middles());
  EXPECT_TRUE(model::is_tetrahedron(model.solids[0]));
  for (std::size_t corner = 0; corner < 4; ++corner)
    EXPECT_EQ(node[model::corners_of_tetrahedron[corner]], static_cast<Index>(corner));
  for (std::size_t side = 0; side < 6; ++side) EXPECT_EQ(node.middle(side), static_cast<Index>(4 + side));
  EXPECT_EQ(model.solid_sections[0].formulation, model::SolidFormulation::QuadraticTetrahedron);
  deck.section = "*SECTION_SOLID\n1,17\n";
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  EXPECT_EQ(result.model->solid_sections[0].formulation, model::SolidFormulation::QuadraticTetrahedron);
  EXPECT_NE(listed(result.diagnostics).find("computed as 16, with quadratic shape functions"),
            std::string::npos);
  deck.section = "*SECTION_SOLID\n1,16\n";
  deck.shells =
      "*ELEMENT_SOLID (ten nodes format)\n      21       1\n"
      "      11      12      13      14      15      16      17      18      19      20\n";
  EXPECT_EQ(read_clean(deck.text()).solids[0].node, node);
}

TEST(QuadraticTetrahedron, OrderOfItsNodesIsChecked) {
  TenNodeDeck deck;
  deck.shells = "*ELEMENT_SOLID\n21,1\n11,12,13,14,15,17,16,18,19,20\n";
  EXPECT_NE(
      deck.messages().find(
          "error: *ELEMENT_SOLID card 2: N6 of solid 21 is not in the middle of the side from N2 to N3"),
      std::string::npos)
      << deck.messages();
}

TEST(QuadraticTetrahedron, FourNodesAndTenHavePartsOfTheirOwn) {
  TenNodeDeck deck;
  // Left out altogether they make a tetrahedron with four nodes.
  deck.shells = "*ELEMENT_SOLID\n21,1\n11,12,13,14,0,0,0,0,0,0\n";
  EXPECT_NE(deck.messages().find("error: *ELEMENT_SOLID card 2: solid 21 has four nodes, but section 1 of "
                                 "its part has a formulation "
                                 "for ten, ELFORM 16 or 17"),
            std::string::npos)
      << deck.messages();
  deck.section = "*SECTION_SOLID\n1,13\n";
  EXPECT_FALSE(read_clean(deck.text()).solids[0].node.has_middles());
  deck.shells = "*ELEMENT_SOLID\n21,1\n11,12,13,14,15,16,17,18,19,20\n";
  EXPECT_NE(deck.messages().find(
                "error: *ELEMENT_SOLID card 2: solid 21 has ten nodes, which only ELFORM 16 and 17 compute"),
            std::string::npos)
      << deck.messages();
  deck.shells = "*ELEMENT_SOLID\n21,1\n11,12,13,14,15,16,0,18,19,20\n";
  EXPECT_NE(
      deck.messages().find("error: *ELEMENT_SOLID card 2 field N7: read \"0\", expected the id of a node; "
                           "a tetrahedron with ten nodes has N5 to N10"),
      std::string::npos)
      << deck.messages();
}

TEST(QuadraticTetrahedron, NodesInTheMiddleBelongToItsPart) {
  TenNodeDeck deck;
  deck.more = "*SET_NODE_GENERAL\n7\nPART,1\n*BOUNDARY_SPC_SET\n7,0,1,1,1\n*SET_SEGMENT_GENERAL\n8\nPART,1\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.fixed_nodes.size(), 10U);
  ASSERT_EQ(model.segment_sets.size(), 1U);
  EXPECT_EQ(model.segment_sets[0].segments.size(), 16U);  // four of each side
}

TEST(QuadraticTetrahedron, PressureOnThreeCornersIsWarnedOf) {
  TenNodeDeck deck;
  deck.more = "*DEFINE_CURVE\n3\n0.,1.\n1.,1.\n*LOAD_SEGMENT\n3,1.,0.,11,13,12,12\n";
  EXPECT_NE(
      deck.messages().find("warning: *LOAD_SEGMENT card 1: 1 segments with pressure are the three corners"),
      std::string::npos)
      << deck.messages();
  deck.more = "*DEFINE_CURVE\n3\n0.,1.\n1.,1.\n*LOAD_SEGMENT\n3,1.,0.,11,17,15,15\n";
  EXPECT_EQ(deck.messages().find("three corners"), std::string::npos);
}

TEST(QuadraticTetrahedron, HasFourPointsAndAWarningForFive) {
  TenNodeDeck deck;
  deck.more = "*CONTROL_SOLID\n0,0,5\n";
  EXPECT_NE(deck.messages().find("tetrahedra with ten nodes have four points"), std::string::npos)
      << deck.messages();
  deck.more = "*CONTROL_SOLID\n0,0,4\n";
  EXPECT_EQ(deck.messages().find("points"), std::string::npos);
}

}  // namespace
}  // namespace crumple::deck::test::quadratic_tetrahedra_test
