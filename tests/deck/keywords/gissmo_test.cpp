// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_DAMAGE_GISSMO, and *MAT_ADD_EROSION with IDAM = 1.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::gissmo_test {
namespace {

const std::string metal = "*MAT_PLASTIC_KINEMATIC\n1,7.8E-9,2.1E5,0.3,250,1000\n\n";
const std::string curves =
    "*DEFINE_CURVE\n1\n0,0.5\n0.5,0.2\n*DEFINE_CURVE\n2\n0,0.3\n0.5,0.1\n"
    "*DEFINE_CURVE\n3\n1,1\n5,0.4\n*DEFINE_CURVE\n4\n0,1\n100,2\n*DEFINE_CURVE\n5\n-1,1\n5,2\n"
    "*DEFINE_CURVE\n6\n0,0.1\n1,0\n*DEFINE_CURVE\n7\n1,1.5\n5,2\n"
    "*DEFINE_TABLE_2D\n11\n-1,1\n0,2\n1,1\n";

CubeDeck cube(const std::string& cards) {
  CubeDeck deck;
  deck.material = metal + cards + curves;
  return deck;
}
model::GissmoDamage damage(const std::string& cards) {
  const model::Model model = read_clean(cube(cards).text());
  EXPECT_TRUE(model.materials.at(0).damage) << cards;
  return model.materials[0].damage.value_or(model::GissmoDamage{});
}
void only_message(const std::string& cards, const std::string& part) {
  SCOPED_TRACE(cards);
  expect_one(cube(cards), part);
}
/// Curves 1 to 4 and 7 by their fields, on the cards of either keyword.
void expect_all_fields(const model::GissmoDamage& read) {
  EXPECT_TRUE(read.acts);
  EXPECT_EQ(read.points, -60);
  EXPECT_NEAR(read.failure_strain.at(0, 0.25), 0.35, 1e-15);
  EXPECT_NEAR(read.critical_strain.at(0, 0.25), 0.2, 1e-15);
  EXPECT_EQ(read.exponent, 2.5);
  EXPECT_EQ(read.fading_exponent.at(0, 1), 1.5);
  EXPECT_NEAR(read.size_factor.at(0, 3), 0.7, 1e-15);
  ASSERT_TRUE(read.rate_factor);
  EXPECT_EQ(read.rate_factor->at(50), 1.5);
  EXPECT_EQ(read.shear_reduction, 0.25);
  EXPECT_EQ(read.biaxial_reduction, 0.75);
}
const std::string gissmo = "*MAT_ADD_DAMAGE_GISSMO\n";

TEST(MatAddDamageGissmo, EveryField) {
  const auto read =
      damage("*MAT_ADD_DAMAGE_GISSMO_TITLE\nlimits\n1,,1,5.0,-60\n1,-2,2.5,,-7,3,1\n4,0.25,0.75\n");
  expect_all_fields(read);
  EXPECT_FALSE(read.logarithmic_rates);
  EXPECT_TRUE(read.rates_scale_critical);
}

TEST(MatAddDamageGissmo, OtherMeaningsBySign) {
  const auto read = damage(gissmo + "1,,1\n11,0.15,1,0.4,2.5,-11\n-5\n");
  EXPECT_EQ(read.failure_strain.curve.size(), 3U);
  EXPECT_NEAR(read.failure_strain.at(-0.5, 0), 0.4, 1e-15) << "between Lode's parameters";
  EXPECT_EQ(read.critical_strain.at(0.3, 0.7), 0.15);
  EXPECT_EQ(read.fading_exponent.at(0, 3), 2.5);
  EXPECT_EQ(read.size_factor.curve.size(), 3U);
  EXPECT_TRUE(read.logarithmic_rates);
  EXPECT_FALSE(read.rates_scale_critical);
}

TEST(MatAddDamageGissmo, Defaults) {
  const auto read = damage(gissmo + "1\n1,,,0.4\n");
  EXPECT_FALSE(read.acts);
  EXPECT_EQ(read.points, 1);
  EXPECT_EQ(read.exponent, 1);
  EXPECT_EQ(read.critical_damage, 0.4);
  EXPECT_EQ(read.fading_exponent.at(0, 1), 1);
  EXPECT_TRUE(read.critical_strain.empty());
  EXPECT_TRUE(read.size_factor.empty());
  EXPECT_FALSE(read.rate_factor);
}

TEST(MatAddDamageGissmo, SaysWhatDoesNotFit) {
  only_message(gissmo + "9,,1\n1,,,0.4\n", "the deck has no material 9");
  only_message(gissmo + "1,,1\n9,,,0.4\n", "LCSDG");
  only_message(gissmo + "1,,1\n0,,,0.4\n", "the id of a curve or of a table of curves");
  only_message(gissmo + "1,,1\n-1,,,0.4\n", "*DEFINE_FUNCTION is not supported");
  only_message(gissmo + "1,,1\n6,,,0.4\n", "a curve above zero; curve 6 has 0");
  only_message(gissmo + "1,,1\n1\n", "the stress fades from the first plastic strain on");
  only_message(gissmo + "1,,1\n1,,,1.4\n", "field DCRIT");
  only_message(gissmo + "1,,1\n1,,,0.4,-11\n", "the exponent depends on the size of the element alone");
  only_message(gissmo + "1,,1\n1,,,0.4,,11\n", "the factor does not depend on the strain rate");
  only_message(gissmo + "1,,1\n1,,,0.4,,-11\n,0.5\n", "a table over triaxiality stands in the place of both");
  only_message(gissmo + "1,,1\n1,,,0.4,,,2\n", "field INSTF");
  only_message(gissmo + "1,,1\n1,,,0.4\n,-0.5\n", "field SHRF");
  only_message(gissmo + "1,,1\n1,,,0.4\n,,1.5\n", "field BIAXF");
  for (const auto& [card, field] : {std::pair{",,,1", "LCDLIM"},
                                    {",,,,1", "MIDFAIL"},
                                    {",,,,,1", "HISVN"},
                                    {",,,,,,0.5", "SOFT"},
                                    {",,,,,,,1", "LP2BI"},
                                    {"\n0.2", "RGTR1"},
                                    {"\n,0.5", "RGTR2"}})
    only_message(gissmo + "1,,1\n1,,,0.4\n" + card + "\n", std::string("field ") + field);
  only_message(gissmo + "1,,61\n1,,,0.4\n", "field DTYP");
  only_message(gissmo + "1,,1,,120\n1,,,0.4\n", "field NUMFIP");
  only_message(gissmo + "1,,1\n1,,,0.4\n" + gissmo + "1,,1\n1,,,0.4\n", "by an earlier keyword");
}

TEST(MatAddDamageGissmo, NeedsAPlasticStrain) {
  CubeDeck deck = cube(gissmo + "1,,1\n1,,,0.4\n");
  deck.material.replace(0, metal.size(), "*MAT_ELASTIC\n1,7.8E-9,2.1E5,0.3\n");
  expect_one(deck, "a law with a plastic strain");
}

TEST(MatAddDamageGissmo, IsNotForBeams) {
  SmallDeck deck;
  deck.part += "rod\n3,3,3\n";
  deck.section += "*SECTION_BEAM\n3,3\n0.5\n";
  deck.material += "*MAT_PLASTIC_KINEMATIC\n3,7.8E-6,210,0.3,0.3,1\n\n" + gissmo + "3,,1\n1,,,0.4\n" + curves;
  deck.more = "*ELEMENT_BEAM\n31,3,5,6,1\n";
  expect_one(deck, "damage is there for shells and solids");
}

TEST(MatAddDamageGissmo, LeavesRigidBodiesAlone) {
  CubeDeck deck;
  deck.material = "*MAT_RIGID\n1,7.8E-9,2.1E5,0.3\n\n\n" + gissmo + "1,,1\n1,,,0.4\n" + curves;
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  EXPECT_FALSE(result.model->materials[0].damage);
}

TEST(MatAddDamageGissmo, ReachesLayersOfOneMaterial) {
  SmallDeck deck;
  deck.part = "*PART_COMPOSITE\nplate\n1,2\n1,0.05,0,,1,0.05,0\n";
  deck.section.clear();
  deck.material = metal + gissmo + "1,,1\n1,,,0.4\n" + curves;
  const model::Model model = read_clean(deck.text());
  EXPECT_TRUE(model.materials.at(model.parts.at(0).material).damage);
}

TEST(MatAddErosion, DamageOfIdam1) {
  const auto read = damage("*MAT_ADD_EROSION\n1,,,,,,-60\n\n1,1,1,-2,2.5,,1.5,3\n,,,4,0.25,0.75\n");
  expect_all_fields(read);
  // Beside criteria, and with the cards behind.
  const model::Model model = read_clean(cube("*MAT_ADD_EROSION\n1,,,,0.5\n\n1,1,1,,,0.4\n\n0\n0\n").text());
  EXPECT_TRUE(model.materials[0].damage);
  EXPECT_EQ(model.materials[0].erosion->effective_strain, 0.5);
  only_message("*MAT_ADD_EROSION\n1\n\n1,1,1,,,0.4\n1\n", "field SIZFLG");
  only_message("*MAT_ADD_EROSION\n1\n\n1,1,1,,,0.4\n\n0,0,0.2\n", "field EPSTHIN");
  only_message("*MAT_ADD_EROSION\n1,,,,0.5\n\n-1,1,1,,,0.4\n", "field IDAM");
}

}  // namespace
}  // namespace crumple::deck::test::gissmo_test
