// SPDX-License-Identifier: BSD-3-Clause
// *DATABASE_CROSS_SECTION and *DATABASE_EXTENT_BINARY.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::cross_sections_test {
namespace {

using Indices = std::vector<Index>;

/// The only section of the small deck: shells 11 over x from 0 to 1 and 12 from 1 to 2, y from 0 to 1.
model::CrossSection section_of(const std::string& cards) {
  const model::Model model = read_with(cards);
  EXPECT_EQ(model.output.cross_sections.size(), 1U);
  return model.output.cross_sections.at(0);
}

TEST(CrossSections, PlanesTakeTheElementsThatTheyCutAndTheNodesBehind) {
  const auto section =
      section_of("*DATABASE_CROSS_SECTION_PLANE_ID\n7,middle of the second\n0,1.5,0.,0.,2.,0.,0.\n0.\n");
  EXPECT_EQ(section.id, 7);
  EXPECT_EQ(section.title, "middle of the second");
  EXPECT_EQ(section.shells, (Indices{1}));
  EXPECT_EQ(section.nodes, (Indices{1, 2}));
}

TEST(CrossSections, TheNormalPointsFromTheNodesToTheElements) {
  const auto section = section_of("*DATABASE_CROSS_SECTION_PLANE\n0,1.5,0.,0.,0.,0.,0.\n0.\n");
  EXPECT_EQ(section.id, 1);
  EXPECT_EQ(section.shells, (Indices{1}));
  EXPECT_EQ(section.nodes, (Indices{4, 5}));
}

TEST(CrossSections, NodesInThePlaneAreBehindIt) {
  const auto ahead = section_of("*DATABASE_CROSS_SECTION_PLANE\n0,1.,0.,0.,2.,0.,0.\n0.\n");
  EXPECT_EQ(ahead.shells, (Indices{1}));
  EXPECT_EQ(ahead.nodes, (Indices{1, 2}));
  const auto behind = section_of("*DATABASE_CROSS_SECTION_PLANE\n0,1.,0.,0.,0.,0.,0.\n0.\n");
  EXPECT_EQ(behind.shells, (Indices{0}));
  EXPECT_EQ(behind.nodes, (Indices{1, 2}));
}

TEST(CrossSections, ExtentsLeaveOutWhatLiesBeside) {
  // The plane y = 0.5 cuts both shells; its first edge goes along x from 0, the second along -z.
  const std::string plane = "*DATABASE_CROSS_SECTION_PLANE\n0,0.,0.5,0.,0.,1.,0.\n";
  EXPECT_EQ(section_of(plane + "0.\n").shells, (Indices{0, 1}));
  EXPECT_EQ(section_of(plane + "1.,0.5,0.,1.0,0.\n").shells, (Indices{0}));
  EXPECT_EQ(section_of(plane + "1.,0.5,0.,2.0,0.1\n").shells, (Indices{0, 1}));
  EXPECT_EQ(section_of(plane + "1.,0.5,0.,0.0,0.1\n").shells, (Indices{0, 1}));
}

TEST(CrossSections, ACircleHasItsCentreAtTheTail) {
  EXPECT_EQ(section_of("*DATABASE_CROSS_SECTION_PLANE\n0,0.5,0.5,0.,0.5,1.,0.,0.2\n0.\n").shells,
            (Indices{0}));
}

TEST(CrossSections, OfSetsHoldTheirMembers) {
  const auto section = section_of(
      "*DATABASE_CROSS_SECTION_SET\n3,0,0,4\n*SET_NODE_LIST\n3\n2,3\n*SET_SHELL_LIST\n4\n12\n"
      "*DATABASE_SECFORC\n0.1\n");
  EXPECT_EQ(section.id, 1);
  EXPECT_EQ(section.shells, (Indices{1}));
  EXPECT_EQ(section.nodes, (Indices{1, 2}));
}

TEST(CrossSections, OnlyThePartsOfASetAreCut) {
  const auto messages =
      messages_with("*DATABASE_CROSS_SECTION_PLANE\n5,1.5,0.,0.,2.,0.,0.\n0.\n*SET_PART_LIST\n5\n1\n");
  EXPECT_TRUE(messages.empty());
  const auto missed = messages_with("*DATABASE_CROSS_SECTION_PLANE\n0,9.,0.,0.,10.,0.,0.\n0.\n");
  ASSERT_EQ(missed.size(), 1U);
  EXPECT_NE(missed[0].find("cross-section 1 cuts no element; its force is zero"), std::string::npos);
}

TEST(CrossSections, AxesOfTheirOwnAreLeftOutWithAWarning) {
  const auto messages =
      messages_with("*DATABASE_CROSS_SECTION_PLANE\n0,1.5,0.,0.,2.,0.,0.\n0.,0.,0.,0.,0.,4\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("forces are along global axes"), std::string::npos) << messages[0];
}

TEST(StateExtent, IsReadAsTheCardSays) {
  const model::StateExtent extent =
      read_with("*DATABASE_EXTENT_BINARY\n3,2,5,0,2,1,2,0\n0,0,0,1\n").output.extent;
  EXPECT_EQ(extent.solid_history, 3);
  EXPECT_EQ(extent.shell_history, 2);
  EXPECT_EQ(extent.shell_points, 5);
  EXPECT_FALSE(extent.stresses);
  EXPECT_TRUE(extent.plastic_strain);
  EXPECT_FALSE(extent.resultants);
  EXPECT_TRUE(extent.energy);
}

TEST(StateExtent, WhatCannotBeFollowedHasAWarning) {
  const auto messages = messages_with("*DATABASE_EXTENT_BINARY\n0,0,-4,1\n1\n");
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_NE(messages[0].find("STRFLG"), std::string::npos) << messages[0];
  EXPECT_NE(messages[1].find("MAXINT: read \"-4\", expected 3 or more"), std::string::npos) << messages[1];
  EXPECT_NE(messages[2].find("CMPFLG"), std::string::npos) << messages[2];
}

}  // namespace
}  // namespace crumple::deck::test::cross_sections_test
