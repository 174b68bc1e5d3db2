// SPDX-License-Identifier: BSD-3-Clause
// *INITIAL_STRESS_SHELL, *INITIAL_STRESS_SOLID, both formats.
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

std::vector<std::string> messages(const SmallDeck& deck) {
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity != Severity::Note) found.push_back(to_string(diagnostic));
  return found;
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
      EXPECT_EQ(stress.points[k].stress[0], 0.5 + static_cast<double>(k / 3));
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

TEST(InitialStress, IsRefusedWhereItIsNotAll) {
  SmallDeck deck;
  deck.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "1", "3"}, 10) + line({"0", "1.0"}, 10) +
              line({"0.1", "0.2", "0.3"}, 10);
  std::vector<std::string> found = messages(deck);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].find("field NHISV: read \"3\", expected 0"), std::string::npos) << found[0];
  EXPECT_NE(found[1].find("field NTHICK"), std::string::npos) << found[1];
  deck.material = "*MAT_NULL\n         1   7.83E-6\n";
  deck.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "2"}, 10) + line({"-1", "1.0"}, 10) +
              line({"1", "1.0"}, 10);
  found = messages(deck);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("part 1: the material has no stress"), std::string::npos) << found[0];
  deck.material = "*MAT_PLASTIC_KINEMATIC\n1,7.83E-6,207,0.3,0.2,1.0,0\n\n";
  deck.more = "*INITIAL_STRESS_SHELL\n" + line({"11", "1", "2"}, 10) +
              line({"-1", "1.0", "0", "0", "0", "0", "0", "0.1"}, 10) + line({"1", "1.0"}, 10);
  found = messages(deck);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("centre of the yield surface"), std::string::npos) << found[0];
}

TEST(InitialStrain, HasNoEffect) {
  const auto found = messages_with("*INITIAL_STRAIN_SHELL\n         1         1         2\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("laws go on from the stress"), std::string::npos) << found[0];
}

}  // namespace
}  // namespace crumple::deck::test::initial_stress_test
