// SPDX-License-Identifier: BSD-3-Clause
// *INITIAL_STRESS_SHELL, *INITIAL_STRESS_SOLID, both formats, and *INTERFACE_SPRINGBACK_LSDYNA.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::initial_stress_test {
namespace {

std::string column(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}
std::string line(const std::vector<std::string>& fields, std::size_t width) {
  std::string all;
  for (const std::string& field : fields) all += column(field, width);
  return all + "\n";
}

TEST(InitialStress, OfShellsInTheStandardFormat) {
  const model::Model model =
      read_with("*INITIAL_STRESS_SHELL\n" + line({"12", "1", "2"}, 10) +
                line({"0.5", "1.0", "2.0", "3.0", "4.0", "5.0", "6.0", "0.0"}, 10) +
                line({"-0.5", "-1.0", "-2.0", "-3.0", "-4.0", "-5.0", "-6.0", "0.0"}, 10) +
                line({"11", "1", "2"}, 10) + line({"-1", "7.0"}, 10) + line({"1", "8.0"}, 10));
  ASSERT_EQ(model.shell_stresses.size(), 2U);
  const model::InitialStress& first = model.shell_stresses[0];
  EXPECT_EQ(first.element, 1);
  EXPECT_EQ(first.planes, 1);
  ASSERT_EQ(first.points.size(), 2U);
  EXPECT_EQ(first.points[0].place, -0.5);
  EXPECT_EQ(first.points[1].stress, (std::array<double, 6>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(model.shell_stresses[1].points[1].stress[0], 8);
}

/// Layer by layer or plane by plane, the points come out plane by plane; another number of layers is a
/// warning.
TEST(InitialStress, OfShellsInTheLargeFormat) {
  SmallDeck deck;
  deck.material = "*MAT_POWER_LAW_PLASTICITY\n1,7.83E-6,207,0.3,0.5,0.22\n\n";
  const auto point = [](const std::string& place, const std::string& xx) {
    return line({place, xx, "0", "0", "0"}, 16) + line({"0.0", "9.0", "0.01"}, 16);
  };
  const std::string head = "*INITIAL_STRESS_SHELL\n" + line({"11", "4", "3", "0", "0", "1"}, 10);
  std::string by_layer = head;
  std::string by_plane = head;
  const std::string places[3] = {"-0.7745967", "0.0", "0.7745967"};
  for (const auto& place : places)
    for (int k = 0; k < 4; ++k) by_layer += point(place, std::to_string(k) + ".5");
  for (int k = 0; k < 4; ++k)
    for (const auto& place : places) by_plane += point(place, std::to_string(k) + ".5");
  for (const std::string& text : {by_layer, by_plane}) {
    deck.more = text;
    const ReadResult result = read_deck_text(deck.text(), {});
    ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
    EXPECT_NE(listed(result.diagnostics).find("field NTHICK: read \"3\", expected 2"), std::string::npos)
        << listed(result.diagnostics);
    const model::InitialStress& stress = result.model->shell_stresses.at(0);
    EXPECT_EQ(stress.planes, 4);
    ASSERT_EQ(stress.points.size(), 12U);
    for (std::size_t k = 0; k < 12; ++k) {
      const std::size_t plane = k / 3;
      EXPECT_EQ(stress.points[k].stress[0], 0.5 + static_cast<double>(plane));
      EXPECT_EQ(stress.points[k].stress[5], 9);
      EXPECT_EQ(stress.points[k].plastic_strain, 0.01);
    }
  }
}

TEST(InitialStress, OfSolidsInBothFormats) {
  CubeDeck deck;
  deck.more = "*INITIAL_STRESS_SOLID\n" + line({"21", "1"}, 10) +
              line({"1.0", "2.0", "3.0", "4.0", "5.0", "6.0", "0.0"}, 10);
  const model::Model small = read_clean(deck.text());
  deck.more = "*INITIAL_STRESS_SOLID\n" + line({"21", "1", "0", "1"}, 10) +
              line({"1.0", "2.0", "3.0", "4.0", "5.0"}, 16) + line({"6.0", "0.0"}, 16);
  const model::Model large = read_clean(deck.text());
  for (const model::Model* model : {&small, &large}) {
    ASSERT_EQ(model->solid_stresses.size(), 1U);
    EXPECT_EQ(model->solid_stresses[0].element, 0);
    EXPECT_EQ(model->solid_stresses[0].points.at(0).stress, (std::array<double, 6>{1, 2, 3, 4, 5, 6}));
  }
}

/// The one message of a deck.
std::string only_message(const SmallDeck& deck) {
  const std::vector<std::string> found = messages_in(deck);
  EXPECT_EQ(found.size(), 1U) << listed(read_deck_text(deck.text()).diagnostics);
  return found.empty() ? "" : found[0];
}

std::string with_shell(const std::vector<std::string>& head,
                       const std::vector<std::string>& first = {"-1", "1.0"},
                       const std::vector<std::string>& second = {"1", "1.0"}) {
  return "*INITIAL_STRESS_SHELL\n" + line(head, 10) + line(first, 10) + line(second, 10);
}

TEST(InitialStress, OfSets) {
  const model::Model model =
      read_with("*SET_SHELL_LIST\n7\n11,12\n*INITIAL_STRESS_SHELL_SET\n" + line({"7", "1", "2"}, 10) +
                line({"-1", "1.0"}, 10) + line({"1", "2.0"}, 10));
  ASSERT_EQ(model.shell_stresses.size(), 2U);
  EXPECT_EQ(model.shell_stresses[1].element, 1);
  EXPECT_EQ(model.shell_stresses[1].points.at(1).stress[0], 2);
  CubeDeck deck;
  deck.more = "*SET_SOLID\n7\n21\n*INITIAL_STRESS_SOLID_SET\n" + line({"7", "1"}, 10) + line({"5.0"}, 10);
  EXPECT_EQ(read_clean(deck.text()).solid_stresses.at(0).points.at(0).stress[0], 5);
}

/// Back stresses of *MAT_PLASTIC_KINEMATIC, and the volume that IVEFLG = 1 puts behind them.
TEST(InitialStress, TakesHistoryVariablesThatAreKnown) {
  SmallDeck shells;
  shells.material = "*MAT_PLASTIC_KINEMATIC\n1,7.83E-6,207,0.3,0.2,1.0,0\n\n";
  shells.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "2", "5"}, 10) +
                line({"-1", "1.0", "0", "0", "0", "0", "0", "0.1"}, 10) +
                line({"0.1", "0.2", "0.3", "0.4", "0.5"}, 10) + line({"1", "1.0"}, 10) + line({"0.6"}, 10);
  const model::Model model = read_clean(shells.text());
  const model::InitialStress& stress = model.shell_stresses.at(0);
  EXPECT_TRUE(stress.has_back_stress);
  EXPECT_EQ(stress.points.at(0).back_stress, (std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(stress.points.at(1).back_stress[0], 0.6);
  CubeDeck solids;
  solids.material = shells.material;
  solids.more = "*INITIAL_STRESS_SOLID\n" + line({"21", "1", "6", "1", "1"}, 10) +
                line({"1.0", "2.0", "3.0", "4.0", "5.0"}, 16) +
                line({"6.0", "0.1", "0.1", "0.2", "0.3"}, 16) + line({"0.4", "0.5", "1.01"}, 16);
  const model::InitialStress solid = read_clean(solids.text()).solid_stresses.at(0);
  EXPECT_EQ(solid.points.at(0).back_stress, (std::array<double, 5>{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_EQ(solid.volume, 1.01);
}

TEST(InitialStress, RefusesHistoryVariablesThatAreNot) {
  SmallDeck deck;
  deck.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "2", "3"}, 10) + line({"-1", "1.0"}, 10) +
              line({"0.1", "0.2", "0.3"}, 10) + line({"1", "1.0"}, 10) + line({"0", "0", "0"}, 10);
  EXPECT_NE(only_message(deck).find("field NHISV: read \"history variables that are not zero\""),
            std::string::npos)
      << only_message(deck);
  deck.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "2", "3"}, 10) + line({"-1", "1.0"}, 10) +
              line({"0", "0", "0"}, 10) + line({"1", "1.0"}, 10) + line({"0", "0", "0"}, 10);
  EXPECT_TRUE(messages_in(deck).empty());
  CubeDeck cube;
  cube.more = "*INITIAL_STRESS_SOLID\n" + line({"21", "1", "2"}, 10) + line({"1.0"}, 10);
  EXPECT_NE(only_message(cube).find("field NHISV: read \"2\", expected 0 with LARGE = 0"), std::string::npos)
      << only_message(cube);
}

TEST(InitialStress, IsRefusedWhereTheLawDoesNotGoOnFromIt) {
  SmallDeck deck;
  deck.more = with_shell({"11", "1", "2"});
  deck.material = "*MAT_NULL\n         1   7.83E-6\n";
  EXPECT_NE(only_message(deck).find("part 1: the material has no stress"), std::string::npos);
  const std::vector<std::string> flowed = {"-1", "1.0", "0", "0", "0", "0", "0", "0.1"};
  deck.more = with_shell({"11", "1", "2"}, flowed);
  deck.material = "*MAT_PLASTIC_KINEMATIC\n1,7.83E-6,207,0.3,0.2,1.0,0\n\n";
  EXPECT_NE(only_message(deck).find("centre of the yield surface"), std::string::npos);
  deck.material = "*MAT_PLASTIC_KINEMATIC\n1,7.83E-6,207,0.3,0.2,1.0,1\n\n";
  EXPECT_TRUE(messages_in(deck).empty());
  deck.more = with_shell({"11", "1", "2"}, {"-1", "1.0", "0", "0", "0", "0", "0", "-0.1"});
  EXPECT_NE(only_message(deck).find("plastic strain EPS is below zero"), std::string::npos);
  deck.material = "*MAT_RIGID\n1,7.83E-6,207,0.3\n\n\n";
  EXPECT_NE(only_message(deck).find("warning"), std::string::npos);
  EXPECT_NE(only_message(deck).find("part 1 is rigid, its elements have no stress"), std::string::npos);
  CubeDeck cube;
  cube.material = "*MAT_BLATZ-KO_RUBBER\n1,1E-6,0.001\n";
  cube.more = "*INITIAL_STRESS_SOLID\n" + line({"21", "1"}, 10) + line({"1.0"}, 10);
  EXPECT_NE(only_message(cube).find("part 1: the law does not go on from a stress"), std::string::npos)
      << only_message(cube);
}

TEST(InitialStress, ChecksPointsAndPlaces) {
  SmallDeck deck;
  deck.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "1"}, 10) + line({"0", "1.0"}, 10);
  EXPECT_NE(only_message(deck).find("field NTHICK: read \"1\", expected 2"), std::string::npos);
  deck.more = with_shell({"11", "1", "3"});
  EXPECT_NE(only_message(deck).find("expected 3 points (NPLANE times NTHICK), found 2"), std::string::npos)
      << only_message(deck);
  deck.more = with_shell({"11", "1", "2"}, {"0.5", "1.0"}, {"0.5", "2.0"});
  EXPECT_NE(only_message(deck).find("as many points at each T"), std::string::npos) << only_message(deck);
  deck.more = with_shell({"11", "1", "2"}, {"-1.5", "1.0"});
  EXPECT_NE(only_message(deck).find("field T: read \"-1.5\""), std::string::npos) << only_message(deck);
  deck.more = with_shell({"11", "1", "2"}) + with_shell({"11", "1", "2"});
  EXPECT_NE(only_message(deck).find("has them already"), std::string::npos) << only_message(deck);
  deck.more = with_shell({"13", "1", "2"});
  EXPECT_NE(only_message(deck).find("field EID: read \"13\""), std::string::npos) << only_message(deck);
  deck.section = "*SECTION_SHELL\n1,16,,2\n0.1\n";
  deck.more = with_shell({"11", "2", "1"}, {"0", "1.0"}, {"0", "1.0"});
  EXPECT_NE(messages_in(deck).at(0).find("field NPLANE: read \"2\", expected 1 or 4"), std::string::npos)
      << messages_in(deck)[0];
  CubeDeck cube;
  cube.section = "*SECTION_SOLID\n1,2\n";
  cube.more = "*INITIAL_STRESS_SOLID\n" + line({"21", "2"}, 10) + line({"1.0"}, 10) + line({"1.0"}, 10);
  EXPECT_NE(only_message(cube).find("field NINT: read \"2\", expected 1 or 8"), std::string::npos)
      << only_message(cube);
}

TEST(InitialStrain, HasNoEffect) {
  const auto found = messages_with("*INITIAL_STRAIN_SHELL\n         1         1         2\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("laws go on from the stress"), std::string::npos) << found[0];
}

constexpr const char* set_of_part_1 = "*SET_PART_LIST\n5\n1\n";

TEST(Springback, NamesPartsAndSupports) {
  const model::Model model =
      read_with(std::string(set_of_part_1) + "*INTERFACE_SPRINGBACK_LSDYNA\n5,100\nOPTCARD,0\n2,7,4\n3,1\n");
  const model::SpringbackRequest& request = model.output.springback;
  EXPECT_EQ(request.parts, (std::vector<Index>{0}));
  ASSERT_EQ(request.holds.size(), 2U);
  EXPECT_EQ(request.holds[0].node, 1);
  EXPECT_EQ(request.holds[0].translation, 7);
  EXPECT_EQ(request.holds[0].rotation, 4);
  EXPECT_EQ(request.holds[1].translation, 1);
}

TEST(Springback, HasBadCards) {
  SmallDeck deck;
  deck.more = "*INTERFACE_SPRINGBACK_LSDYNA\n5\n";
  EXPECT_NE(only_message(deck).find("the deck has no part set 5"), std::string::npos) << only_message(deck);
  deck.more = std::string(set_of_part_1) + "*INTERFACE_SPRINGBACK_LSDYNA\n5,0,3\n";
  EXPECT_NE(only_message(deck).find("field FTYPE: read \"3\""), std::string::npos) << only_message(deck);
  deck.more = std::string(set_of_part_1) + "*INTERFACE_SPRINGBACK_LSDYNA\n5,0,0,,0,0,1\n";
  EXPECT_NE(only_message(deck).find("masses and reference coordinates are not written"), std::string::npos);
  deck.more = std::string(set_of_part_1) + "*INTERFACE_SPRINGBACK_LSDYNA\n5\n99,1\n";
  EXPECT_NE(only_message(deck).find("the deck has no node 99"), std::string::npos) << only_message(deck);
  deck.more = std::string(set_of_part_1) + "*INTERFACE_SPRINGBACK_LSDYNA\n5\n2,8\n";
  EXPECT_NE(only_message(deck).find("field TC: read \"8\""), std::string::npos) << only_message(deck);
}

}  // namespace
}  // namespace crumple::deck::test::initial_stress_test
