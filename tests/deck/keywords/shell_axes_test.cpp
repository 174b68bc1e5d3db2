// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_SHELL_MCID, _OFFSET and _DOF.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::shell_axes_test {
namespace {

const std::string system =
    "*DEFINE_COORDINATE_VECTOR\n"
    "         9       1.0       2.0       5.0      -1.0       1.0       0.0\n";

/// The plate of two squares; the second is a triangle.
SmallDeck plate(const std::string& aopt, const std::string& mcid) {
  SmallDeck deck;
  deck.shells =
      "*ELEMENT_SHELL_MCID\n      11       1       2       3       4       1\n             0.5             "
      "0.5             0.5             0.5" +
      std::string(16 - mcid.size(), ' ') + mcid + "\n      12       1       2       5       6       0\n\n";
  deck.material = "*MAT_ORTHOTROPIC_ELASTIC\n1,1.6E-6,130,9,9,0.02,0.02,0.4\n5,3,5," + aopt +
                  "\n0,0,0,1,0,0\n0,0,0,0,0,0,30\n";
  deck.more = system;
  return deck;
}

std::string messages(const SmallDeck& deck) {
  return listed(read_deck_text(deck.text()).diagnostics);
}

TEST(ShellAxes, McidTurnsTheMaterialToTheSystem) {
  const model::Model model = read_clean(plate("0", "9").text());
  // The first side goes along y.
  EXPECT_NEAR(model.shells.at(0).material_angle, -std::atan2(1, 2), 1e-12);
  EXPECT_EQ(model.shells[0].thickness[2], 0.5);
  EXPECT_EQ(model.shells[1].material_angle, 0);
}

TEST(ShellAxes, EveryLawWithAxesTurns) {
  const auto angle_with = [](const std::string& material) {
    SmallDeck deck = plate("0", "9");
    deck.material = material;
    return read_clean(deck.text()).shells.at(0).material_angle;
  };
  const double exact = -std::atan2(1, 2);
  EXPECT_NEAR(angle_with("*MAT_022\n1,1.5E-9,127000,8400,9000,0.021,0.03,0.04\n4200,3000,4200,0,0\n"
                         "0,0,0,0,0,0\n0,0,0,0,0,0,30\n154,2200,49,199,2E-8\n"),
              exact, 1e-12);
  EXPECT_NEAR(angle_with("*MAT_058\n1,1.8E-9,26000,24000,0,0.12,40,0.015\n4000,3900,3800,0.1,0.9,0.2,1,0.6\n"
                         "0,0,0.3,0,-1\n0,0,0,0,0,0,0.11,0.1\n0,0,0,0,0,0,30\n-0.018,0.024,0.02,0.022,0.05\n"
                         "-300,450,280,400,70\n"),
              exact, 1e-12);
  EXPECT_NEAR(angle_with("*MAT_036\n1,2.7E-9,70000,0.33,2,400,0.25\n8,0.71,0.58,0.7\n0\n\n\n"), exact, 1e-12);
}

/// Where the axis a is in the plane z = 0.
std::array<double, 2> axis_of(const model::Model& model, std::size_t shell) {
  const model::ShellElement& element = model.shells.at(shell);
  const auto x = [&](std::size_t k) {
    return model.nodes.position[static_cast<std::size_t>(element.node[k])];
  };
  const double first = std::atan2(x(1)[1] - x(0)[1], x(1)[0] - x(0)[0]);
  return {std::cos(first + element.material_angle), std::sin(first + element.material_angle)};
}

TEST(ShellAxes, TrianglesTurnHoweverTheyAreWritten) {
  for (const std::string triangle : {"       2       5       6       6", "       2       2       5       6",
                                     "       2       5       5       6", "       2       5       6       2",
                                     "       2       5       6       0"}) {
    SmallDeck deck = plate("0", "9");
    deck.shells = "*ELEMENT_SHELL_MCID\n      11       1" + triangle +
                  "\n             0.5             0.5             0.5             0.5               9\n"
                  "      12       1       1       2       3       4\n\n";
    const std::array<double, 2> axis = axis_of(read_clean(deck.text()), 0);
    EXPECT_NEAR(axis[0], 1 / std::sqrt(5.0), 1e-12) << triangle;
    EXPECT_NEAR(axis[1], 2 / std::sqrt(5.0), 1e-12) << triangle;
  }
}

TEST(ShellAxes, RefusedMcidLeavesAWholeShellWhereThatIsAllowed) {
  ReadOptions options;
  options.allow_unsupported = true;
  SmallDeck deck = plate("2", "9");
  deck.shells =
      "*ELEMENT_SHELL_MCID\n      11       1       2       2       3       4\n"
      "             0.3             0.0             0.0             0.0               9\n"
      "      12       1       2       5       6       0\n\n";
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
  EXPECT_TRUE(model::faults(*result.model).empty());
  const model::ShellElement& shell = result.model->shells.at(0);
  EXPECT_EQ(shell.thickness, (std::array<double, 4>{0.1, 0.1, 0.3, 0.3})) << "zero takes the section's";
  EXPECT_EQ(shell.node[2], shell.node[3]);
  EXPECT_NE(listed(result.diagnostics).find("the material's own axes are used"), std::string::npos);
}

TEST(ShellAxes, McidOfZeroAndOfWhatHasNoAxes) {
  EXPECT_EQ(read_clean(plate("2", "0").text()).shells.at(0).material_angle, 0);
  SmallDeck isotropic = plate("0", "9");
  isotropic.material = SmallDeck().material;
  EXPECT_EQ(read_clean(isotropic.text()).shells.at(0).material_angle, 0);
}

TEST(ShellAxes, Faults) {
  EXPECT_NE(messages(plate("2", "9")).find("expected 0, or a material with AOPT = 0"), std::string::npos);
  EXPECT_NE(messages(plate("0", "8")).find("MCID: read \"8\""), std::string::npos);
  SmallDeck upright = plate("0", "9");
  upright.more = "*DEFINE_COORDINATE_VECTOR\n9,0,0,1,1,0,0\n";
  EXPECT_NE(messages(upright).find("a system whose x axis is not along the normal"), std::string::npos)
      << messages(upright);
}

TEST(ShellAxes, OffsetAndScalarNodes) {
  SmallDeck deck;
  const std::string first = "      11       1       1       2       3       4\n";
  deck.shells = "*ELEMENT_SHELL_OFFSET\n" + first + "             0.0\n";
  EXPECT_EQ(read_clean(deck.text()).shells.size(), 1U);
  deck.shells = "*ELEMENT_SHELL_THICKNESS_OFFSET\n" + first + "0.3,0.3,0.3,0.3\n\n";
  EXPECT_EQ(read_clean(deck.text()).shells.at(0).thickness[0], 0.3);
  deck.shells = "*ELEMENT_SHELL_DOF\n" + first + "                     101     102     103     104\n";
  EXPECT_EQ(read_clean(deck.text()).shells.size(), 1U);
  deck.shells = "*ELEMENT_SHELL_OFFSET\n" + first + "             0.2\n";
  EXPECT_NE(messages(deck).find("field OFFSET: read \"0.2\""), std::string::npos) << messages(deck);
}

}  // namespace
}  // namespace crumple::deck::test::shell_axes_test
