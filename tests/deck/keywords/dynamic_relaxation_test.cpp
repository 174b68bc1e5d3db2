// SPDX-License-Identifier: BSD-3-Clause
// *CONTROL_DYNAMIC_RELAXATION, and what acts in its phase.
#include "deck/small_deck.hpp"

namespace crumple::deck::test::dynamic_relaxation_test {
namespace {

constexpr const char* steady = "*DEFINE_CURVE\n4,2\n0.0,1.0\n9.0,1.0\n";
constexpr const char* pull = "*LOAD_NODE_POINT\n2,1,4,1.0\n";

/// The card that public decks have.
TEST(DynamicRelaxationCard, HasTheDefaultsOfLsDyna) {
  const model::Model model =
      read_with(std::string(pull) + steady +
                "*CONTROL_DYNAMIC_RELAXATION\n"
                "       250      .001      .995         0        .9         0       .04         1\n");
  const model::RelaxationSettings& settings = model.relaxation.value().settings;
  EXPECT_EQ(settings.check_cycles, 250);
  EXPECT_EQ(settings.tolerance, 0.001);
  EXPECT_EQ(settings.factor, 0.995);
  EXPECT_EQ(settings.end_time, 0);
  EXPECT_EQ(settings.step_scale, 0.9);
  EXPECT_FALSE(settings.automatic);
  const model::Model blank =
      read_with(std::string(pull) + steady + "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,1\n");
  EXPECT_EQ(blank.relaxation.value().settings.check_cycles, 250);
  EXPECT_EQ(blank.relaxation.value().settings.tolerance, 0.001);
  EXPECT_EQ(blank.relaxation.value().settings.factor, 0.995);
  EXPECT_EQ(blank.relaxation.value().settings.step_scale, 0);
}

TEST(DynamicRelaxationCard, ReadsAllItsFields) {
  const model::Model model = read_with(std::string(pull) + steady +
                                       "*CONTROL_DYNAMIC_RELAXATION\n100,1E-5,0.98,2.0,0.5,1,0.02,-1\n");
  const model::RelaxationSettings& settings = model.relaxation.value().settings;
  EXPECT_EQ(settings.check_cycles, 100);
  EXPECT_EQ(settings.tolerance, 1e-5);
  EXPECT_EQ(settings.factor, 0.98);
  EXPECT_EQ(settings.end_time, 2.0);
  EXPECT_TRUE(settings.automatic);
  EXPECT_EQ(settings.automatic_tolerance, 0.02);
  EXPECT_EQ(model::relaxation_model(model).control.step_scale, 0.5);
  EXPECT_EQ(model.control.step_scale, 0.9);
}

TEST(DynamicRelaxationCard, OtherKindsAreRefused) {
  for (const char* flag : {"2", "3", "-3", "5", "6"}) {
    SmallDeck deck;
    deck.more = std::string("*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,") + flag + "\n";
    expect_one(deck, std::string("error: *CONTROL_DYNAMIC_RELAXATION card 1 field IDRFLG: read \"") + flag);
  }
}

TEST(DynamicRelaxationCard, WithoutAnythingToDoIsWarnedOf) {
  SmallDeck deck;
  deck.more = "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,1\n";
  expect_one(deck, "nothing acts in the dynamic relaxation");
}

TEST(DynamicRelaxationCard, ARunOfNoLengthNeedsIt) {
  SmallDeck deck;
  deck.termination = "*CONTROL_TERMINATION\n0.0\n";
  expect_one(deck, "field ENDTIM: read \"0.0\", expected a number above zero");
  deck.termination = "*CONTROL_TERMINATION\n-1\n";
  expect_one(deck, "field ENDTIM: read \"-1\", expected a number that is not negative");
  deck.termination = "*CONTROL_TERMINATION\n0.0\n";
  deck.more = std::string(pull) + steady;
  EXPECT_EQ(read_clean(deck.text()).control.end_time, 0);
}

/// LCIDDR goes before LCID, whatever their SIDR.
TEST(DynamicRelaxationCard, BodyLoadsMayHaveACurveOfTheirOwn) {
  const std::string curves = std::string(steady) + "*DEFINE_CURVE\n5,0\n0.0,0.0\n9.0,1.0\n";
  for (const char* load : {"*LOAD_BODY_Z\n4,2.0,5\n", "*LOAD_BODY_Z\n5,2.0,4\n"}) {
    const model::Model model = read_with(load + curves);
    ASSERT_EQ(model.body_loads.size(), 1U);
    const model::DynamicRelaxation* const relaxation = model.relaxation ? &*model.relaxation : nullptr;
    ASSERT_NE(relaxation, nullptr) << load;
    ASSERT_EQ(relaxation->body_loads.size(), 1U);
    EXPECT_NE(relaxation->body_loads[0].curve, model.body_loads[0].curve);
    EXPECT_EQ(relaxation->body_loads[0].scale, 2.0);
  }
  const model::Model one = read_with("*LOAD_BODY_Z\n5,2.0\n*LOAD_BODY_RX\n4,1.0,4\n" + curves);
  EXPECT_TRUE(one.relaxation.value().body_loads.empty()) << "5 is of the run alone";
  EXPECT_EQ(one.relaxation.value().inertia_fields.size(), 1U);
}

TEST(DynamicRelaxationCard, VelocitiesThatWouldBeginWithItAreWarnedOf) {
  SmallDeck deck;
  const std::string velocity = "*INITIAL_VELOCITY_GENERATION\n1,2,0,0,0,1.0\n0,0,0,0,0,1.0,";
  deck.more = std::string(pull) + steady + velocity + "0\n";
  expect_one(deck, "field PHASE: read \"0\"");
  deck.more = std::string(pull) + steady + velocity + "1\n";
  EXPECT_TRUE(messages_in(deck).empty());
}

TEST(DynamicRelaxationCard, WallsThatMoveAreRefused) {
  SmallDeck deck;
  deck.more = std::string(pull) + steady + "*RIGIDWALL_PLANAR_MOVING\n0\n0,0,-1,0,0,1,0\n1.0,0.1\n";
  expect_one(deck, "a rigid wall that moves is not supported with a dynamic relaxation");
}

}  // namespace
}  // namespace crumple::deck::test::dynamic_relaxation_test
