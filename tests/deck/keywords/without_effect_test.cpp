// SPDX-License-Identifier: BSD-3-Clause
// Cards of other people's decks that change nothing here: they are accepted, and refused where they would.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::without_effect_test {
namespace {

bool has(const std::vector<std::string>& messages, const std::string& words) {
  return std::any_of(messages.begin(), messages.end(),
                     [&](const std::string& message) { return message.find(words) != std::string::npos; });
}

std::vector<std::string> messages_of_deck(const SmallDeck& deck) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(to_string(diagnostic));
  return messages;
}

TEST(WithoutEffect, AreAccepted) {
  for (const char* cards :
       {"*CONTROL_SOLUTION\n", "*CONTROL_SOLUTION\n         0\n", "*CONTROL_UNITS\nmm,ms,kg\n",
        "*CONTROL_STRUCTURED\n", "*CONTROL_STRUCTURED_TERM\n",
        "*SENSOR_DEFINE_NODE\n         1         1         2\n", "*CONTROL_SOLID\n         1\n",
        "*CONTROL_SOLID\n         1\n         0\n", "*PART\nmirror\n         7\n"})
    EXPECT_FALSE(has(messages_with(cards), ": error: ")) << cards << messages_with(cards)[0];
}

TEST(WithoutEffect, AreAcceptedWithAWarning) {
  for (const char* cards : {"*INCLUDE\n", "*CONTROL_BULK_VISCOSITY\n       1.5      0.06        -2\n"}) {
    const std::vector<std::string> messages = messages_with(cards);
    ASSERT_EQ(messages.size(), 1U) << cards;
    EXPECT_NE(messages[0].find(": warning: "), std::string::npos) << messages[0];
  }
}

TEST(WithoutEffect, AreRefusedWhereTheyHaveAnEffect) {
  EXPECT_TRUE(has(messages_with("*CONTROL_SOLUTION\n         2\n"), "field SOLN: read \"2\""));
  EXPECT_TRUE(
      has(messages_with(
              "*CONTROL_SOLID\n\n\n*CONTROL_SOLID\n         0         0         0         0         3\n"),
          "field PSFAIL"));
  SmallDeck part;
  part.more = "*PART\nmirror\n         7\n*ELEMENT_SHELL\n      13       7       1       2       3       4\n";
  EXPECT_TRUE(has(messages_of_deck(part), "field SECID: read \"0\", expected the id of a section"));
}

TEST(WithoutEffect, OptionsOfWallsInAnyOrderAndADisplayCardThatIsMissing) {
  const model::Model model = read_with(
      "*RIGIDWALL_GEOMETRIC_CYLINDER_ID_DISPLAY\n         4pole\n0\n3,0,0,3,0,9\n0.5,2.5\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE_DISPLAY_ID\n         5ball\n0\n3,0,0\n0.5\n");
  ASSERT_EQ(model.rigid_walls.size(), 2U);
  EXPECT_EQ(model.rigid_walls[0].id, 4);
  EXPECT_EQ(model.rigid_walls[1].id, 5);
  EXPECT_EQ(model.rigid_walls[1].shape, model::WallShape::Sphere);
}

TEST(WithoutEffect, SortingIsRefusedForSolidsThatRepeatNodesOnly) {
  CubeDeck deck;
  deck.more = "*CONTROL_SOLID\n         1\n";
  EXPECT_TRUE(messages_of_deck(deck).empty());
  deck.shells =
      "*ELEMENT_SOLID\n      21       1       1       2       3       4       5       5       8       8\n";
  EXPECT_TRUE(has(messages_of_deck(deck), "solid 21 repeats nodes, and ESORT (deck.k:"));
  deck.more.clear();
  EXPECT_FALSE(has(messages_of_deck(deck), "ESORT"));
}

TEST(WithoutEffect, PressureCutOffOfNullShells) {
  SmallDeck deck;
  deck.material = "*MAT_NULL\n1,1.0E-6,0.1,0,0,0,200.0,0.3\n";
  EXPECT_TRUE(messages_of_deck(deck).empty());
}

}  // namespace
}  // namespace crumple::deck::test::without_effect_test
