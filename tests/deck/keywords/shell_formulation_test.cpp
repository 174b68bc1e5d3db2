// SPDX-License-Identifier: BSD-3-Clause
// ELFORM, THEORY, BWC and triangles.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::shell_formulation_test {
namespace {

using model::ShellFormulation;

/// The formulation of the small deck's section.
ShellFormulation formulation(const std::string& elform, const std::string& control_shell = "") {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1" + elform + "\n       0.1\n";
  deck.more = control_shell;
  return read_clean(deck.text()).shell_sections[0].formulation;
}

TEST(ShellFormulation, FollowsElform) {
  EXPECT_EQ(formulation("         1"), ShellFormulation::HughesLiu);
  EXPECT_EQ(formulation("         2"), ShellFormulation::BelytschkoTsay);
  EXPECT_EQ(formulation("         6"), ShellFormulation::HughesLiuSelectiveReduced);
  EXPECT_EQ(formulation("        10"), ShellFormulation::BelytschkoWongChiang);
  EXPECT_EQ(formulation("        16"), ShellFormulation::FullyIntegrated);
  EXPECT_EQ(formulation("         5"), ShellFormulation::Membrane);
  EXPECT_EQ(formulation("         9"), ShellFormulation::FullyIntegratedMembrane);
  EXPECT_EQ(formulation(""), ShellFormulation::BelytschkoTsay);
}

/// Membranes have one point over the thickness, in the middle, whatever the section says.
TEST(ShellFormulation, OfMembranesHasOnePoint) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1         5                   4                   1\n       0.1";
  deck.section += std::string(30, ' ') + "       1.0\n";
  const ReadResult result = read_deck_text(deck.text(), {});
  const std::string warnings = listed(result.diagnostics);
  ASSERT_TRUE(result.model.has_value()) << warnings;
  const model::ShellSection& section = result.model->shell_sections[0];
  EXPECT_EQ(section.thickness_points, 1);
  EXPECT_EQ(section.thickness_rule, model::ThicknessRule::Gauss);
  EXPECT_EQ(section.node_place, 0);
  EXPECT_NE(warnings.find("NLOC"), std::string::npos) << warnings;
}

/// Fields: WRPANG, ESORT, IRNXX, ISTUPD, THEORY, BWC, MITER, PROJ.
TEST(ShellFormulation, FollowsControlShell) {
  const std::string theory_10 = "*CONTROL_SHELL\n                                                10\n";
  EXPECT_EQ(formulation("", theory_10), ShellFormulation::BelytschkoWongChiang);
  EXPECT_EQ(formulation("         1", theory_10), ShellFormulation::HughesLiu);
  const std::string theory_16 = "*CONTROL_SHELL\n                                                16\n";
  EXPECT_EQ(formulation("", theory_16), ShellFormulation::FullyIntegrated);
  const std::string theory_5 = "*CONTROL_SHELL\n                                                 5\n";
  EXPECT_EQ(formulation("", theory_5), ShellFormulation::Membrane);
  const std::string warping =
      "*CONTROL_SHELL\n      20.0         1        -1         0         2         1         1         1\n";
  EXPECT_EQ(formulation("         2", warping), ShellFormulation::BelytschkoWongChiang);
  EXPECT_EQ(formulation("", warping), ShellFormulation::BelytschkoWongChiang);
  EXPECT_EQ(formulation("         1", warping), ShellFormulation::HughesLiu);
  const std::string none =
      "*CONTROL_SHELL\n      20.0         0        -1         0         2         2         1         0\n";
  EXPECT_EQ(formulation("         2", none), ShellFormulation::BelytschkoTsay);
}

/// Whichever corner is given twice, and with a fourth node of zero, the model's triangle repeats its third
/// node and runs around in the same sense.
TEST(Triangle, RepeatsItsThirdNode) {
  for (const std::string nodes : {"       2       5       3       3", "       5       3       3       2",
                                  "       3       3       2       5", "       2       5       3       2",
                                  "       2       5       3       0"}) {
    SmallDeck deck;
    deck.shells =
        "*ELEMENT_SHELL\n      11       1       1       2       3       4\n      12       1" + nodes + "\n";
    const model::Model model = read_clean(deck.text());
    const auto& node = model.shells[1].node;
    EXPECT_EQ(node[3], node[2]) << nodes;
    std::array<Index, 3> corner{node[0], node[1], node[2]};
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    EXPECT_EQ(corner, (std::array<Index, 3>{1, 4, 2})) << nodes;
  }
}

TEST(Triangle, TakesTheThicknessOfItsThreeCorners) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1         2\n";
  deck.section += "\n";
  deck.shells =
      "*ELEMENT_SHELL_THICKNESS\n      11       1       1       2       3       4\n"
      "             1.0             1.0             1.0             1.0\n"
      "      12       1       2       5       3       3\n"
      "             1.0             2.0             3.0\n";
  const model::Model model = read_clean(deck.text());
  const auto at = model::shell_thickness(model, model.shells[1]);
  EXPECT_EQ(at[0], 1);
  EXPECT_EQ(at[1], 2);
  EXPECT_EQ(at[2], 3);
  EXPECT_EQ(at[3], 2);
}

TEST(Triangle, HasASectionOfItsOwn) {
  SmallDeck deck;
  deck.shells =
      "*ELEMENT_SHELL\n      11       1       1       2       3       3\n      12       1       2       5    "
      "   3       3\n";
  deck.section = "*SECTION_SHELL\n         1         4\n       0.1\n";
  EXPECT_EQ(read_clean(deck.text()).shell_sections[0].formulation, ShellFormulation::Triangle);
}

}  // namespace
}  // namespace crumple::deck::test::shell_formulation_test
