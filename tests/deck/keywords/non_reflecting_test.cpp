// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::non_reflecting_test {
namespace {

model::Model cube_with(const std::string& more) {
  CubeDeck deck;
  deck.more = "*SET_SEGMENT\n3\n5,6,7,8\n1,4,3,2\n*SET_SEGMENT\n4\n1,2,6,5\n" + more;
  return read_clean(deck.text());
}

TEST(NonReflecting, TakesBothWavesByDefault) {
  const model::Model model = cube_with("*BOUNDARY_NON_REFLECTING\n3\n");
  ASSERT_EQ(model.viscous_segments.size(), 2U);
  EXPECT_EQ(model.viscous_segments[0].node, (std::array<Index, 4>{4, 5, 6, 7}));
  EXPECT_EQ(model.viscous_segments[1].node, (std::array<Index, 4>{0, 3, 2, 1}));
  for (const model::ViscousSegment& segment : model.viscous_segments) {
    EXPECT_EQ(segment.solid, 0);
    EXPECT_TRUE(segment.normal);
    EXPECT_TRUE(segment.tangential);
  }
}

TEST(NonReflecting, ValuesThatAreNotZeroTurnWavesOff) {
  const model::Model model = cube_with("*BOUNDARY_NON_REFLECTING\n3,0.0,1.0\n4,1.0,0.0\n");
  ASSERT_EQ(model.viscous_segments.size(), 3U);
  EXPECT_TRUE(model.viscous_segments[0].normal);
  EXPECT_FALSE(model.viscous_segments[0].tangential);
  EXPECT_FALSE(model.viscous_segments[2].normal);
  EXPECT_TRUE(model.viscous_segments[2].tangential);
}

TEST(NonReflecting, OneSetMayTakeEachWaveByACardOfItsOwn) {
  const model::Model model = cube_with("*BOUNDARY_NON_REFLECTING\n4,1.0\n4,0.0,1.0\n");
  EXPECT_EQ(model.viscous_segments.size(), 2U);
}

TEST(NonReflecting, SaysWhereARigidBodyMovesItsNodes) {
  CubeDeck deck;
  deck.more =
      "*SET_SEGMENT\n3\n5,6,7,8\n*SET_NODE_LIST\n5\n7,8\n*CONSTRAINED_NODAL_RIGID_BODY\n9,0,5\n"
      "*BOUNDARY_NON_REFLECTING\n3\n";
  const ReadResult result = read_deck_text(deck.text(), {}, {});
  ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
  EXPECT_NE(listed(result.diagnostics)
                .find("warning: *BOUNDARY_NON_REFLECTING card 1: rigid bodies move 2 nodes of non-reflecting "
                      "boundaries, the first is 7: the boundary does not act on these"),
            std::string::npos)
      << listed(result.diagnostics);
}

TEST(NonReflecting, FacesOfRigidSolidsAreNone) {
  CubeDeck deck;
  deck.material = "*MAT_RIGID\n1,7.83E-6,207.0,0.3\n\n\n";
  deck.more = "*SET_SEGMENT\n3\n5,6,7,8\n*BOUNDARY_NON_REFLECTING\n3\n";
  const ReadResult result = read_deck_text(deck.text(), {}, {});
  EXPECT_FALSE(result.model.has_value());
  EXPECT_NE(listed(result.diagnostics).find("expected segments that are faces of solids which deform"),
            std::string::npos)
      << listed(result.diagnostics);
}

}  // namespace
}  // namespace crumple::deck::test::non_reflecting_test
