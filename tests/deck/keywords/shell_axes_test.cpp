// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_SHELL_MCID, _OFFSET and _DOF.
#include <gtest/gtest.h>

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
