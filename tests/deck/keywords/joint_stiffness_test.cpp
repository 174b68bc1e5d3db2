// SPDX-License-Identifier: BSD-3-Clause
// Resistance of joints in decks.
#include <numbers>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::joint_stiffness_test {
namespace {

/// Two rigid shells, coordinate systems by nodes and by points, two curves.
SmallDeck with(const std::string& cards) {
  SmallDeck deck;
  deck.shells =
      "*ELEMENT_SHELL\n"
      "      11       1       1       2       3       4\n"
      "      12       2      12       5       6      13\n";
  deck.nodes +=
      "      12             1.0             0.0             0.0\n"
      "      13             1.0             1.0             0.0\n";
  deck.part =
      "*PART\nleft\n         1         1         1\n"
      "*PART\nright\n         2         1         1\n";
  deck.material = "*MAT_RIGID\n         1   7.83E-6     207.0       0.3\n\n\n";
  deck.more =
      "*DEFINE_COORDINATE_NODES\n         3        12         5        13\n"
      "*DEFINE_COORDINATE_SYSTEM\n         4       1.0       0.0       0.0       1.0       1.0       0.0\n"
      "       0.0       0.0       0.0\n"
      "*DEFINE_CURVE\n         8\n                -1.0                -2.0\n"
      "                 1.0                 2.0\n"
      "*DEFINE_CURVE\n         9\n                -1.0                -3.0\n"
      "                 1.0                 3.0\n";
  deck.more += cards;
  return deck;
}

const std::string generalized =
    "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n"
    "         7         1         2         3         4\n"
    "         8         0         9         9         0         8\n"
    "       5.0       0.5       6.0       0.0       0.0       0.0\n"
    "     -30.0      45.0       0.0      90.0       0.0       0.0\n";

TEST(JointStiffness, OfAnglesIsRead) {
  const model::Model model = read_clean(with(generalized).text());
  ASSERT_EQ(model.joint_stiffnesses.size(), 1U);
  const model::JointStiffness& stiffness = model.joint_stiffnesses[0];
  EXPECT_EQ(stiffness.id, 7);
  EXPECT_FALSE(stiffness.is_translational);
  EXPECT_EQ(stiffness.body, (std::array<Index, 2>{0, 1}));
  EXPECT_EQ(stiffness.axes[0][0], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(stiffness.axes[1][0], (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(stiffness.axes[1][1], (std::array<double, 3>{-1, 0, 0}));
  EXPECT_EQ(stiffness.origin[0], (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(stiffness.origin[1], (std::array<double, 3>{1, 0, 0}));
  const model::JointResistance& phi = stiffness.resistance[0];
  EXPECT_EQ(phi.curve, 0);
  EXPECT_EQ(phi.damping_curve, 1);
  EXPECT_EQ(phi.stiffness, 5);
  EXPECT_EQ(phi.friction, 0.5);
  EXPECT_DOUBLE_EQ(*phi.negative_stop, -std::numbers::pi / 6);
  EXPECT_DOUBLE_EQ(*phi.positive_stop, std::numbers::pi / 4);
  EXPECT_EQ(stiffness.resistance[1].curve, no_index);
  EXPECT_FALSE(stiffness.resistance[1].negative_stop);
  EXPECT_DOUBLE_EQ(*stiffness.resistance[1].positive_stop, std::numbers::pi / 2);
  EXPECT_EQ(stiffness.resistance[2].curve, 1);
  EXPECT_EQ(stiffness.resistance[2].damping_curve, 0);
}

TEST(JointStiffness, OfDisplacementsIsRead) {
  const model::Model model = read_clean(with("*CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL\n"
                                             "         7         1         2         3\n"
                                             "         8\n       5.0       0.5\n       2.0       3.0\n")
                                            .text());
  ASSERT_EQ(model.joint_stiffnesses.size(), 1U);
  const model::JointStiffness& stiffness = model.joint_stiffnesses[0];
  EXPECT_TRUE(stiffness.is_translational);
  EXPECT_EQ(stiffness.axes[0], stiffness.axes[1]) << "CIDB is CIDA";
  EXPECT_EQ(*stiffness.resistance[0].negative_stop, -2);
  EXPECT_EQ(*stiffness.resistance[0].positive_stop, 3);
}

TEST(JointStiffness, NegativeFrictionIsACurve) {
  std::string cards = generalized;
  const std::string limit = "       5.0       0.5";
  cards.replace(cards.find(limit), limit.size(), "       5.0      -8.0");
  const model::JointResistance phi = read_clean(with(cards).text()).joint_stiffnesses[0].resistance[0];
  EXPECT_EQ(phi.friction_curve, 0);
  EXPECT_EQ(phi.friction, 0);
}

void expect_one(std::string cards, const std::string& from, const std::string& to, const std::string& text) {
  cards.replace(cards.find(from), from.size(), to);
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(with(cards).text()).diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(to_string(diagnostic));
  ASSERT_EQ(messages.size(), 1U) << cards;
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}

TEST(JointStiffness, WhatIsMissingIsNamed) {
  const std::string head = "         7         1         2         3         4\n";
  expect_one(generalized, head, "         7         1         1         3         4\n",
             "field PIDB: read \"1\", expected another rigid body than PIDA");
  expect_one(generalized, head, "         7         1         9         3         4\n",
             "field PIDB: read \"9\"");
  expect_one(generalized, head, "         7         1         2         5         4\n",
             "field CIDA: read \"5\"");
  expect_one(generalized, "         8         0         9 ", "        18         0         9 ",
             "card 2 field LCIDPH: read \"18\"");
  expect_one(generalized, "       5.0       0.5", "       5.0      -5.0",
             "card 3 field FMPH: read \"5\", expected the id of a curve");
  expect_one(generalized, "       6.0", "       0.0",
             "warning: *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED card 1 field EST");
}

/// A line of text goes before each, which a number may begin, unlike the card of other joints.
TEST(JointStiffness, MayHaveATitle) {
  std::string titled = generalized;
  titled.replace(titled.find('\n'), 1, "_TITLE\n     Shoulder, left\n");
  const model::Model model = read_clean(with(titled).text());
  ASSERT_EQ(model.joint_stiffnesses.size(), 1U);
  EXPECT_EQ(model.joint_stiffnesses[0].id, 7);
}

}  // namespace
}  // namespace crumple::deck::test::joint_stiffness_test
