// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_RIGID_BODY_STOPPERS and *BOUNDARY_SPC_SYMMETRY_PLANE.
#include <gtest/gtest.h>

#include <cmath>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::stoppers_test {
namespace {

constexpr const char* curves =
    "*DEFINE_CURVE\n5\n0,1\n9,1\n*DEFINE_CURVE\n6\n0,-1\n9,-1\n*DEFINE_CURVE\n7\n0,3\n9,3\n";

SmallDeck rigid_plate(const std::string& more) {
  SmallDeck deck;
  deck.material = "*MAT_RIGID\n         1   7.83E-6     207.0       0.3\n\n\n";
  deck.more = curves + more;
  return deck;
}

TEST(Stoppers, EveryValue) {
  const model::Model model =
      read_clean(rigid_plate("*CONSTRAINED_RIGID_BODY_STOPPERS\n"
                             "         1        -5         6         0         0         7         2\n"
                             "       0.5       1.5\n"
                             "1,5,0,0,0,0,4,8\n\n*DEFINE_VECTOR\n8,0,0,0,0,0,-2\n")
                     .text());
  ASSERT_EQ(model.rigid_body_stoppers.size(), 2U);
  const model::RigidBodyStopper& first = model.rigid_body_stoppers[0];
  EXPECT_EQ(first.body, 0);
  EXPECT_EQ(first.direction, (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(first.largest.curve, 0);
  EXPECT_TRUE(first.largest.is_displacement);
  EXPECT_EQ(first.smallest.curve, 1);
  EXPECT_FALSE(first.smallest.is_displacement);
  EXPECT_EQ(first.speed_curve, 2);
  EXPECT_EQ(first.birth_time, 0.5);
  EXPECT_EQ(first.death_time, 1.5);
  const model::RigidBodyStopper& second = model.rigid_body_stoppers[1];
  EXPECT_EQ(second.direction, (std::array<double, 3>{0, 0, -1}));
  EXPECT_EQ(second.smallest.curve, no_index);
  EXPECT_EQ(second.speed_curve, no_index);
  EXPECT_EQ(second.death_time, 1e21);
}

TEST(Stoppers, StiffnessOfImplicitRunsIsTheFourthField) {
  const std::string card = "*CONSTRAINED_RIGID_BODY_STOPPERS\n1,5,0,0,0,0,1\n";
  EXPECT_EQ(read_clean(rigid_plate(card + "0.5,1.5,,1e3\n").text()).rigid_body_stoppers.size(), 1U);
}

TEST(Stoppers, Faults) {
  const auto faulty = [](const std::string& card, const std::string& text) {
    expect_one(rigid_plate("*CONSTRAINED_RIGID_BODY_STOPPERS\n" + card + "\n"), text);
  };
  faulty("2,5,0,0,0,0,1", "field PID: read \"2\"");
  faulty("1,9,0,0,0,0,1", "LCMAX: read \"9\", expected the id of a curve");
  faulty("1,-9,0,0,0,0,1", "LCMAX: read \"9\"");
  faulty("1,5,0,3,0,0,1", "other rigid bodies do not stop with this one");
  faulty("1,5,0,0,0,0,5", "rotations (5 to 8) are not stopped");
  faulty("1,5,0,0,0,0,0", "a number from 1 to 4");
  faulty("1,5,0,0,0,0,4,9", "field VID: read \"9\"");
  faulty("1,0,0,0,0,0,1", "stops nothing");
  faulty("1,5,0,0,0,0,4,8\n\n*DEFINE_VECTOR\n8,0,0,0,1,1,0", "a direction along the axes that hold the body");
}

TEST(SymmetryPlane, HoldsNodesNearIt) {
  // The nodes at x = 0; the plane is 0.1 away.
  const model::Model model = read_with(
      "*BOUNDARY_SPC_SYMMETRY_PLANE\n         3         1       0.1       5.0       0.0      -2.0\n0.15\n");
  ASSERT_EQ(model.fixed_nodes.size(), 2U);
  EXPECT_EQ(model.fixed_nodes[0].node, 0);
  EXPECT_EQ(model.fixed_nodes[1].node, 3);
  for (const model::FixedNode& fixed : model.fixed_nodes) {
    EXPECT_EQ(fixed.translation, (std::array<bool, 3>{true, false, false}));
    EXPECT_EQ(fixed.rotation, (std::array<bool, 3>{false, true, true}));
  }
  // Of shells 0.2 without TOL.
  EXPECT_EQ(read_with("*BOUNDARY_SPC_SYMMETRY_PLANE\n3,1,0.19,,,1\n").fixed_nodes.size(), 2U);
}

TEST(SymmetryPlane, ObliqueOfAPartSet) {
  const model::Model model =
      read_with("*SET_PART_LIST\n4\n1\n*BOUNDARY_SPC_SYMMETRY_PLANE_SET\n3,4,0,0,0,1,-1,0\n1e-6\n");
  ASSERT_EQ(model.local_supports.size(), 2U);  // nodes 1 and 3 on the diagonal
  EXPECT_EQ(model.local_supports[0].node, 0);
  EXPECT_EQ(model.local_supports[1].node, 2);
  const model::LocalSupport& support = model.local_supports[0];
  EXPECT_NEAR(support.axes[0][0], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(support.axes[0][1], -std::sqrt(0.5), 1e-15);
  EXPECT_EQ(support.translation, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(support.rotation, (std::array<bool, 3>{false, true, true}));
}

TEST(SymmetryPlane, Faults) {
  SmallDeck deck;
  deck.more = "*BOUNDARY_SPC_SYMMETRY_PLANE\n3,1\n";
  expect_one(deck, "expected a vector that is not zero");
  deck.more = "*BOUNDARY_SPC_SYMMETRY_PLANE\n3,7,,,,1\n";
  expect_one(deck, "field PID");
  deck.more = "*BOUNDARY_SPC_SYMMETRY_PLANE\n3,1,9,,,1\n";
  expect_one(deck, "no node lies on the plane");
  CubeDeck cube;
  cube.more = "*BOUNDARY_SPC_SYMMETRY_PLANE\n3,1,,,,1\n";
  expect_one(cube, "field TOL: read \"0\", expected a distance above zero");
}

}  // namespace
}  // namespace crumple::deck::test::stoppers_test
