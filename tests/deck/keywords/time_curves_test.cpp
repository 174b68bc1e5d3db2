// SPDX-License-Identifier: BSD-3-Clause
// What loads and motions make of curves over time: offsets, phases, late and displaced beginnings.
#include "deck/small_deck.hpp"

namespace crumple::deck::test::time_curves_test {
namespace {

constexpr const char* steel = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.83E-6,207.0,0.3\n0,0,4\n\n\n";

const model::Curve& loading_curve(const model::Model& model) {
  return model.curves[static_cast<std::size_t>(model.nodal_loads.at(0).curve)];
}

TEST(TimeCurves, AnOffsetDelaysWhatActsOverTime) {
  const model::Model model =
      read_with("*LOAD_NODE_POINT\n1,1,4,1.0\n*DEFINE_CURVE\n4,0,2.0,3.0,0.5\n0.0,1.0\n4.0,2.0\n");
  const model::Curve& curve = loading_curve(model);
  // SFA (a + OFFA) begins at 1; zero up to 0.999 of that.
  EXPECT_EQ(curve.abscissa, (std::vector<double>{0, 0.999, 1.0, 9.0}));
  EXPECT_EQ(curve.ordinate, (std::vector<double>{0, 0, 3.0, 6.0}));
}

TEST(TimeCurves, AnOffsetDelaysMotions) {
  const model::Model model = read_with(
      "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,4\n*DEFINE_CURVE\n4,0,1.0,1.0,0.5\n0.0,1.0\n4.0,2.0\n");
  EXPECT_EQ(model.curves[static_cast<std::size_t>(model.prescribed_motions.at(0).curve)].at(0.49), 0);
}

/// A curve of stress over strain that is shifted, and a load that goes by the same one.
TEST(TimeCurves, AnOffsetLeavesOtherUsesAlone) {
  SmallDeck deck;
  deck.material = steel;
  deck.more = "*DEFINE_CURVE\n4,0,1.0,1.0,0.1\n-0.1,0.3\n0.5,0.4\n";
  EXPECT_EQ(read_clean(deck.text()).curves.size(), 1U);
  deck.more += "*LOAD_NODE_POINT\n1,1,5,1.0\n*DEFINE_CURVE\n5,0,1.0,1.0,0.1\n0.0,0.3\n9.0,0.4\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.curves[0].abscissa, (std::vector<double>{0, 0.6}));
  EXPECT_EQ(model.curves[1].abscissa, (std::vector<double>{0.1, 9.1}));
  EXPECT_EQ(loading_curve(model).abscissa.size(), 4U);
}

TEST(TimeCurves, OfTheRelaxationAloneDoNotActInTheRun) {
  SmallDeck deck;
  deck.more =
      "*LOAD_NODE_POINT\n1,1,4,1.0\n*LOAD_NODE_POINT\n2,1,5,1.0\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n3,1,0,4\n"
      "*DEFINE_CURVE\n4,1\n0.0,1.0\n9.0,1.0\n*DEFINE_CURVE\n5,0\n0.0,1.0\n9.0,1.0\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.nodal_loads.size(), 1U);
  EXPECT_EQ(model.nodal_loads[0].node, 1);
  EXPECT_TRUE(model.prescribed_motions.empty());
  ASSERT_TRUE(model.relaxation.has_value());
  ASSERT_EQ(model.relaxation->nodal_loads.size(), 1U);
  EXPECT_EQ(model.relaxation->nodal_loads[0].node, 0);
  EXPECT_EQ(model.relaxation->prescribed_motions.size(), 1U);
}

TEST(TimeCurves, OfTheRelaxationThatIsTurnedOffAreLeftOutWithAWarning) {
  SmallDeck deck;
  deck.more =
      "*LOAD_NODE_POINT\n1,1,4,1.0\n*DEFINE_CURVE\n4,1\n0.0,1.0\n9.0,1.0\n"
      "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,-999\n";
  expect_one(deck, "curve 4 has SIDR = 1");
  const model::Model model = *read_deck_text(deck.text(), {}).model;
  EXPECT_TRUE(model.nodal_loads.empty());
  EXPECT_FALSE(model.relaxation.has_value());
}

TEST(TimeCurves, OfBothPhasesActInBoth) {
  const model::Model model = read_with("*LOAD_NODE_POINT\n1,1,4,1.0\n*DEFINE_CURVE\n4,2\n0.0,1.0\n9.0,1.0\n");
  EXPECT_EQ(model.nodal_loads.size(), 1U);
  EXPECT_EQ(model.relaxation.value().nodal_loads.size(), 1U);
}

TEST(TimeCurves, OfTheRelaxationStillGiveStresses) {
  SmallDeck deck;
  deck.material = steel;
  deck.more = "*DEFINE_CURVE\n4,1\n0.0,0.3\n0.5,0.4\n";
  EXPECT_TRUE(messages_in(deck).empty());
}

TEST(TimeCurves, ThatBeginLateAreWarnedOfOnce) {
  SmallDeck deck;
  deck.more = "*LOAD_NODE_POINT\n1,1,4,1.0\n2,1,4,1.0\n*DEFINE_CURVE\n4\n0.1,1.0\n9.0,1.0\n";
  expect_one(deck, "curve 4 begins at the time 0.1");
  deck.more = "*LOAD_NODE_POINT\n1,1,4,1.0\n2,1,4,1.0\n*DEFINE_CURVE\n4\n0.1,0.0\n9.0,1.0\n";
  EXPECT_TRUE(messages_in(deck).empty());
}

TEST(TimeCurves, OfDisplacementsThatDoNotBeginAtZero) {
  SmallDeck deck;
  deck.more = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,2,4\n*DEFINE_CURVE\n4\n0.0,0.5\n9.0,0.5\n";
  expect_one(deck, "curve 4 is a displacement, and is 0.5 at its start");
  deck.more = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,4\n*DEFINE_CURVE\n4\n0.0,0.5\n9.0,0.5\n";
  EXPECT_TRUE(messages_in(deck).empty());
}

TEST(IdleLoads, MomentsOnNodesOfSolids) {
  CubeDeck deck;
  const std::string curve = "*DEFINE_CURVE\n4\n0.0,1.0\n9.0,1.0\n";
  deck.more = "*LOAD_NODE_POINT\n5,5,4,1.0\n" + curve;
  expect_one(deck, "the moment acts on node 5, which has no rotation");
  deck.more = "*LOAD_NODE_POINT\n5,1,4,1.0\n" + curve;
  EXPECT_TRUE(messages_in(deck).empty());
  SmallDeck shells;
  shells.more = "*LOAD_NODE_POINT\n5,5,4,1.0\n" + curve;
  EXPECT_TRUE(messages_in(shells).empty());
}

TEST(IdleLoads, ForcesOnNodesWithoutMass) {
  CubeDeck deck;
  deck.nodes += "       9             3.0             0.0             0.0\n";
  deck.more = "*SET_NODE_LIST\n7\n8,9\n*LOAD_NODE_SET\n7,1,4,1.0\n*DEFINE_CURVE\n4\n0.0,1.0\n9.0,1.0\n";
  expect_one(deck, "the force acts on node 9, which has no mass");
  deck.more += "*ELEMENT_MASS\n1,9,1.0\n";
  EXPECT_TRUE(messages_in(deck).empty());
}

TEST(IdleLoads, VelocitiesOfNodesWithoutMass) {
  CubeDeck deck;
  deck.nodes += "       9             3.0             0.0             0.0\n";
  deck.more = "*INITIAL_VELOCITY_NODE\n8,0,0,2\n9,0,0,2\n";
  expect_one(deck, "node 9 has no mass");
  deck.more += "*ELEMENT_MASS\n1,9,1.0\n";
  EXPECT_TRUE(messages_in(deck).empty());
}

}  // namespace
}  // namespace crumple::deck::test::time_curves_test
