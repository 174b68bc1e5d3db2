// SPDX-License-Identifier: BSD-3-Clause
// *MAT_LAMINATED_COMPOSITE_FABRIC.
#include <numbers>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::laminated_fabric_test {
namespace {

using Law = model::LaminatedFabric;

std::vector<std::string> messages(const std::string& material) {
  SmallDeck deck;
  deck.material = material;
  return messages_in(deck);
}
Law law_of(const std::string& material) {
  SmallDeck deck;
  deck.material = material;
  return std::get<Law>(read_clean(deck.text()).materials.at(0).law);
}

const std::string fabric =
    "*MAT_LAMINATED_COMPOSITE_FABRIC\n1,1.8E-9,26000,24000,0,0.12,40,0.015\n4000,3900,3800,0.1,0.9,0.2,1,0."
    "6\n"
    "3,0,0.3,0,-1\n0,0,0,0,0,0,0.11,0.1\n0,1,0,0,0,0,45\n-0.018,0.024,0.02,0.022,0.05\n-300,450,280,400,70\n";

TEST(LaminatedFabric, EveryValue) {
  for (const std::string keyword : {"*MAT_LAMINATED_COMPOSITE_FABRIC", "*MAT_058", "*MAT_58"}) {
    const Law law = law_of(replaced(fabric, "*MAT_LAMINATED_COMPOSITE_FABRIC", keyword));
    EXPECT_EQ(law.modulus_a, 26000);
    EXPECT_EQ(law.modulus_b, 24000);
    EXPECT_EQ(law.modulus_c, 24000);
    EXPECT_EQ(law.poisson_ba, 0.12);
    EXPECT_EQ(law.poisson_ca, 0.11);
    EXPECT_EQ(law.poisson_cb, 0.1);
    EXPECT_EQ(law.shear_ab, 4000);
    EXPECT_EQ(law.shear_bc, 3900);
    EXPECT_EQ(law.shear_ca, 3800);
    EXPECT_EQ(law.surface, Law::Surface::Facets);
    EXPECT_EQ(law.erosion_strain, 0.3);
    EXPECT_EQ(law.axes, model::OrthotropicElastic::Axes::CrossNormal);
    EXPECT_EQ(law.direction, (std::array<double, 3>{0, 1, 0}));
    EXPECT_NEAR(law.angle, std::numbers::pi / 4, 1e-15);
    const auto is = [](const Law::Mode& mode, double strength, double strain, double left) {
      EXPECT_EQ(mode.strength, strength);
      EXPECT_EQ(mode.strain, strain);
      EXPECT_EQ(mode.left, left);
    };
    is(law.tension_a, 450, 0.024, 0.1);
    is(law.compression_a, 300, 0.018, 0.9);
    is(law.tension_b, 400, 0.022, 0.2);
    is(law.compression_b, 280, 0.02, 1);
    is(law.shear, 70, 0.05, 0.6);
    EXPECT_EQ(law.first_shear_stress, 40);
    EXPECT_EQ(law.first_shear_strain, 0.015);
  }
}

TEST(LaminatedFabric, Surfaces) {
  std::string plain = replaced(fabric, "40,0.015", "0,0");
  EXPECT_EQ(law_of(replaced(plain, "0,-1\n", "0,0\n")).surface, Law::Surface::Across);
  EXPECT_EQ(law_of(replaced(plain, "0,-1\n", "0,1\n")).surface, Law::Surface::Smooth);
  EXPECT_EQ(law_of(plain).first_shear_strain, 0);
  only_message(messages(replaced(fabric, "0,-1\n", "0,1\n")), "FS = -1 only");
}

TEST(LaminatedFabric, Faults) {
  only_message(messages(replaced(fabric, "0,-1\n", "0,2\n")), "field FS");
  only_message(messages(replaced(fabric, "3,0,0.3", "-3,0,0.3")), "field AOPT");
  only_message(messages(replaced(fabric, "3,0,0.3", "3,1E-7,0.3")), "field TSIZE");
  only_message(messages(replaced(fabric, "3,0,0.3", "3,0,-0.3")), "field ERODS");
  only_message(messages(replaced(fabric, "0,-1\n", "0,-1,0.1\n")), "field EPSF");
  only_message(messages(replaced(fabric, "0,0,0,45\n", "0,0,0,45,7\n")), "field LCDFAIL");
  only_message(messages(replaced(fabric, "26000,24000", "-7,24000")), "field EA");
  only_message(messages(replaced(fabric, "0.1,0.9", "1.1,0.9")), "field SLIMT1");
  only_message(messages(replaced(fabric, "0.024", "0.017")), "field E11T");
  only_message(messages(replaced(fabric, "0.022", "0")), "field E22T");
  only_message(messages(replaced(fabric, "450", "0")), "field XT");
  only_message(messages(replaced(fabric, "70\n", "0\n")), "field SC");
  only_message(messages(replaced(fabric, "40,0.015", "80,0.03")), "field TAU1");
  only_message(messages(replaced(fabric, "40,0.015", "40,0.009")), "field TAU1");
  only_message(messages(fabric + "0,7\n"), "field LCXT");
  only_message(messages(fabric + "\n0,0,7\n"), "field LCE22C");
}

/// Layers of *PART_COMPOSITE may have it, each at its angle.
TEST(LaminatedFabric, IsForLayers) {
  SmallDeck deck;
  deck.material = fabric;
  deck.part = "*PART_COMPOSITE\nlaminate\n1,2\n1,0.2,0,0,1,0.2,45\n1,0.2,90\n";
  deck.section.clear();
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.layups.size(), 1U);
  EXPECT_EQ(model.layups[0].layers.size(), 3U);
}

}  // namespace
}  // namespace crumple::deck::test::laminated_fabric_test
