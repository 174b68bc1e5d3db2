// SPDX-License-Identifier: BSD-3-Clause
// *PART_COMPOSITE, *ELEMENT_SHELL_COMPOSITE, *INTEGRATION_SHELL, ICOMP of *SECTION_SHELL.
#include <numbers>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::layups_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A second and a third material, light and orthotropic.
constexpr const char* materials =
    "*MAT_ELASTIC\n         1   7.83E-6     207.0       0.3\n"
    "*MAT_ELASTIC\n         2   1.00E-6      10.0       0.2\n"
    "*MAT_002\n3,1.6E-6,138,9,8,0.02\n7,3.5,6.5\n\n\n";

SmallDeck composite(const std::string& layers,
                    const std::string& card = "         1         2       0.8       1.0\n") {
  SmallDeck deck;
  deck.part = "*PART_COMPOSITE\nsandwich\n" + card + layers;
  deck.section.clear();
  deck.material = materials;
  return deck;
}

void expect_layer(const model::ShellLayer& layer, Index material, double place, double share, double angle) {
  EXPECT_EQ(layer.material, material);
  EXPECT_NEAR(layer.place, place, 1e-15);
  EXPECT_NEAR(layer.share, share, 1e-15);
  EXPECT_NEAR(layer.angle, angle * degree, 1e-15);
}

/// The only message of a deck.
void expect_message(const std::string& text, const std::string& expected) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(text).diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(to_string(diagnostic));
  ASSERT_EQ(messages.size(), 1U) << text << (messages.empty() ? "" : messages[0] + "\n" + messages.back());
  EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
}

TEST(Layups, PartComposite) {
  const model::Model model = read_clean(
      composite(
          "         1       0.2       0.0                   2       1.2\n         3       0.6      30.0\n")
          .text());
  ASSERT_EQ(model.layups.size(), 1U);
  ASSERT_EQ(model.layups[0].layers.size(), 3U);
  expect_layer(model.layups[0].layers[0], 0, -0.9, 0.1, 0);
  expect_layer(model.layups[0].layers[1], 1, -0.2, 0.6, 0);
  expect_layer(model.layups[0].layers[2], 2, 0.7, 0.3, 30);
  EXPECT_FALSE(model.layups[0].follows_rule);
  const model::Part& part = model.parts[0];
  EXPECT_EQ(part.layup, 0);
  EXPECT_EQ(part.title, "sandwich");
  EXPECT_NEAR(model.materials[part.material].density, 0.1 * 7.83e-6 + 0.6e-6 + 0.3 * 1.6e-6, 1e-20);
  const model::ShellSection& section = model.shell_sections[part.section];
  EXPECT_EQ(section.thickness, (std::array<double, 4>{2, 2, 2, 2}));
  EXPECT_EQ(section.shear_factor, 0.8);
  EXPECT_EQ(section.node_place, 1);
  EXPECT_EQ(section.formulation, model::ShellFormulation::BelytschkoTsay);
}

TEST(Layups, PartCompositeLongWithContactAndHourglass) {
  SmallDeck deck = composite("1,0.5,0,,17\n3,0.5,-45\n", "1,16,,,,7\n,,,,0.4,2\n");
  deck.part.replace(0, deck.part.find('\n'), "*PART_COMPOSITE_LONG_CONTACT");
  deck.more = "*HOURGLASS\n7,4,0.05\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.layups.size(), 1U);
  expect_layer(model.layups[0].layers[0], 0, -0.5, 0.5, 0);
  expect_layer(model.layups[0].layers[1], 2, 0.5, 0.5, -45);
  EXPECT_EQ(model.parts[0].contact_thickness, 0.4);
  EXPECT_EQ(model.parts[0].contact_thickness_scale, 2);
  EXPECT_EQ(model.parts[0].hourglass, 0);
  EXPECT_EQ(model.shell_sections[0].formulation, model::ShellFormulation::FullyIntegrated);
}

TEST(Layups, ElementsOfTheirOwn) {
  SmallDeck deck;
  deck.material = materials;
  deck.shells =
      "*ELEMENT_SHELL_COMPOSITE\n"
      "      11       1       1       2       3       4\n"
      "         3       0.2      10.0                   2       0.6\n"
      "         3       0.2      80.0\n"
      "      12       1       2       5       6       3\n"
      "         3       0.1      20.0                   2       0.3\n"
      "         3       0.1      70.0\n"
      "*ELEMENT_SHELL\n      13       1       1       2       3\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.layups.size(), 1U) << "the same materials and shares";
  EXPECT_EQ(model.shells[0].layup, 0);
  EXPECT_EQ(model.shells[1].layup, 0);
  EXPECT_EQ(model.shells[2].layup, no_index);
  EXPECT_EQ(model.shells[0].thickness[0], 1.0);
  EXPECT_EQ(model.shells[1].thickness[3], 0.5);
  EXPECT_NEAR(model.layer_angles.at(model.shells[1].layer_angles + 2), 70 * degree, 1e-15);
  expect_layer(model.layups[0].layers[1], 1, 0, 0.6, 0);
  EXPECT_EQ(model.parts[0].layup, no_index);
  EXPECT_NEAR(model::material_of(model, model.shells[0]).density, 0.4 * 1.6e-6 + 0.6e-6, 1e-20);
  EXPECT_EQ(model::material_of(model, model.shells[2]).density, 7.83e-6);
}

TEST(Layups, AnglesOfThePoints) {
  SmallDeck deck;
  deck.material = "*MAT_002\n1,1.6E-6,138,9,8,0.02\n7,3.5,6.5\n\n\n";
  deck.section =
      "*SECTION_SHELL\n         1         2       1.0         9         0         0         1\n       0.1\n"
      "       0.0      45.0     -45.0      90.0       0.0      90.0     -45.0      45.0\n      10.0\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.layups.size(), 1U);
  ASSERT_EQ(model.layups[0].layers.size(), 9U);
  EXPECT_TRUE(model.layups[0].follows_rule);
  EXPECT_NEAR(model.layups[0].layers[2].angle, -45 * degree, 1e-15);
  EXPECT_NEAR(model.layups[0].layers[8].angle, 10 * degree, 1e-15);
  EXPECT_EQ(model.layups[0].layers[8].material, 0);
}

TEST(Layups, RuleOfTheUser) {
  SmallDeck deck;
  deck.material = materials;
  deck.part = "*PART\nplate\n1,1,3\ncore\n2,1,2\n";
  deck.shells += "      13       2       1       2       3\n";
  deck.section = "*SECTION_SHELL\n1,2,1.0,3,0,-5,1\n0.1\n30,0,60\n";
  deck.more = "*INTEGRATION_SHELL\n5,3,0,1\n-0.9,0.1\n0,0.8,2\n0.9,0.1\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.layups.size(), 2U) << "one of each part with the section";
  const model::Layup& layup = model.layups[0];
  ASSERT_EQ(layup.layers.size(), 3U);
  EXPECT_TRUE(layup.unfailing_layers_hold);
  expect_layer(layup.layers[0], 2, -0.9, 0.1, 30);
  expect_layer(layup.layers[1], 1, 0, 0.8, 0);
  expect_layer(layup.layers[2], 2, 0.9, 0.1, 60);
  EXPECT_EQ(model.layups[1].layers[0].material, 1);
}

TEST(Layups, RuleOfEqualLayers) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n1,2,1.0,4,0,-5\n0.1\n";
  deck.more = "*INTEGRATION_SHELL\n5,4,1\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.layups.size(), 1U);
  for (std::size_t i = 0; i < 4; ++i)
    expect_layer(model.layups[0].layers[i], 0, -0.75 + 0.5 * static_cast<double>(i), 0.25, 0);
}

TEST(Layups, OfFilesWithOffsetsAndMirrored) {
  SmallDeck deck = composite("1,0.5,20,,3,0.5,30\n");
  deck.shells.clear();
  deck.more =
      "*PART\nruled\n2,2,3\n*SECTION_SHELL\n2,2,1.0,2,0,-5,1\n0.1\n40,50\n*INTEGRATION_SHELL\n5,2\n-0.5,0.5\n"
      "0.5,0.5,2\n*ELEMENT_SHELL\n       1       2       1       2       3       4\n"
      "*ELEMENT_SHELL_COMPOSITE\n       2       1       1       2       3       4\n"
      "         1       0.5      60.0                   3       0.5      70.0\n";
  const std::string text =
      "*KEYWORD\n*DEFINE_TRANSFORMATION\n9\nMIRROR,0,0,0,1,0,0\n*INCLUDE_TRANSFORM\npart.k\n"
      "100,200,300,400,500,600,700\n800\n\n9\n*CONTROL_TERMINATION\n1\n*END\n";
  deck.termination.clear();
  const ReadResult result = read_deck_text(text, {}, {{"part.k", deck.text()}});
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  const model::Model& model = *result.model;
  ASSERT_EQ(model.layups.size(), 3U);
  EXPECT_NEAR(model.layups[0].layers[1].angle, -30 * degree, 1e-15);
  EXPECT_NEAR(model.layups[1].layers[1].angle, -50 * degree, 1e-15);
  EXPECT_NEAR(model.layer_angles[1], -70 * degree, 1e-15);
  EXPECT_EQ(model.parts[0].id, 301);
}

TEST(Layups, Faults) {
  expect_message(composite("1,0.5,0,0,9,0.5\n").text(), "field MID2: read \"9\"");
  expect_message(composite("1,0.5,0,0,2,0\n").text(), "field THICK2");
  expect_message(composite("1,0.5,0,0,0,0.5\n").text(), "field MID2");
  expect_message(composite("1,0.5\n", "1,5\n").text(), "field ELFORM");
  expect_message(composite("1,0.5\n", "1,2,1,0,0.1\n").text(), "field MAREA");
  SmallDeck rigid = composite("1,0.5,0,0,4,0.5\n");
  rigid.more = "*MAT_RIGID\n4,7.83E-6,207,0.3\n\n\n";
  expect_message(rigid.text(), "it is rigid");
  SmallDeck foam = composite("1,0.5,0,0,4,0.5\n");
  foam.more = "*MAT_007\n4,1E-6,0.1\n";
  expect_message(foam.text(), "it is not there for shells");
  SmallDeck counted = composite("1,0.5,0,0,4,0.5\n");
  counted.more = "*MAT_123\n4,7.83E-6,200,0.3,0.25,2.0,0.3\n0,0,0,0,0,0,0,2\n\n\n";
  expect_message(counted.text(), "NUMINT");
  SmallDeck eroding = composite("1,0.5,0,0,2,0.5\n");
  eroding.more = "*MAT_ADD_EROSION\n1\n,,0.1\n";
  expect_message(eroding.text(), "*MAT_ADD_EROSION");
  std::string many;
  for (int i = 0; i < 21; ++i) many += "1,0.1\n";
  expect_message(composite(many).text(), "21 layers are too many");
  const auto with_rule = [](const std::string& rule, const std::string& section) {
    SmallDeck deck;
    deck.section = section;
    deck.more = rule;
    return deck.text();
  };
  const std::string ruled = "*SECTION_SHELL\n1,2,1.0,2,0,-5\n0.1\n";
  expect_message(with_rule("*INTEGRATION_SHELL\n5,2\n-0.5,1\n0.5,1\n", ruled), "sum to 2");
  expect_message(with_rule("*INTEGRATION_SHELL\n5,2\n-0.5,0.5\n0.5,0.5,7\n", ruled), "field PID");
  expect_message(with_rule("*INTEGRATION_SHELL\n5,1\n-1.5,1\n", ruled), "field S");
  expect_message(with_rule("*INTEGRATION_SHELL\n5,2,2\n-0.5,0.5\n0.5,0.5\n", ruled), "field ESOP");
  expect_message(with_rule("*INTEGRATION_SHELL\n5,2\n-0.5,0.5\n0.5,0.5\n",
                           "*SECTION_SHELL\n1,2,1.0,1,0,-5,1\n0.1\n30\n"),
                 "1 angles for the 2 points");
  expect_message(with_rule("", "*SECTION_SHELL\n1,2,1.0,2,0,2\n0.1\n"), "field QR");
}

}  // namespace
}  // namespace crumple::deck::test::layups_test
