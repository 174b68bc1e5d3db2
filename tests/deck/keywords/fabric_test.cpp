// SPDX-License-Identifier: BSD-3-Clause
// *MAT_FABRIC.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::fabric_test {
namespace {

SmallDeck membranes(const std::string& material) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1         9\n       0.3\n";
  deck.material = material;
  return deck;
}
model::Fabric law_of(const std::string& material) {
  return std::get<model::Fabric>(read_clean(membranes(material).text()).materials.at(0).law);
}
TEST(Fabric, WithEveryValue) {
  const auto law = law_of(
      "*MAT_FABRIC_TITLE\nnylon\n"
      "         1    9.0E-7       0.5       0.3                 0.1    0.1667\n"
      "      0.02                           1.0       0.1       0.4       0.2      0.05\n"
      "       2.0       0.0       0.0       0.5       0.0         1         1       0.0\n"
      "                 3.0         1       0.0       1.0       0.5\n"
      "       0.0       0.0       0.0                                    30.0         1\n");
  EXPECT_EQ(law.sheet.modulus_a, 0.5);
  EXPECT_EQ(law.sheet.modulus_b, 0.3);
  EXPECT_EQ(law.sheet.poisson_ba, 0.1);
  EXPECT_EQ(law.sheet.shear_ab, 0.02);
  EXPECT_TRUE(law.wrinkles);
  EXPECT_EQ(law.liner_modulus, 0.1);
  EXPECT_EQ(law.liner_ratio, 0.4);
  EXPECT_EQ(law.liner_share, 0.2);
  EXPECT_EQ(law.damping, 0.05);
  EXPECT_EQ(law.sheet.axes, model::OrthotropicElastic::Axes::Vector);
  EXPECT_EQ(law.sheet.direction, (std::array<double, 3>{0, 1, 0.5}));
  EXPECT_NEAR(law.sheet.angle, 0.52359877559829887, 1e-15);
  EXPECT_GT(law.youngs_modulus, 0.35);
}

/// EB and GAB of zero; the last cards may be missing.
TEST(Fabric, IsIsotropicWithoutTheOtherModuli) {
  const auto law =
      law_of("*MAT_034\n         1    9.0E-7       0.5                           0.3\n       0.0\n");
  EXPECT_EQ(law.sheet.modulus_b, 0.5);
  EXPECT_NEAR(law.sheet.shear_ab, 0.5 * 0.5 / 1.3, 1e-16);
  EXPECT_FALSE(law.wrinkles);
  EXPECT_NEAR(law.youngs_modulus, 0.5, 1e-12);
  EXPECT_NEAR(law.poissons_ratio, 0.3, 1e-9);
  const auto crossed = law_of("*MAT_034\n1,9e-7,.5,,,.3\n0\n3\n\n0,0,1\n");
  EXPECT_EQ(crossed.sheet.axes, model::OrthotropicElastic::Axes::CrossNormal);
  EXPECT_EQ(crossed.sheet.direction, (std::array<double, 3>{0, 0, 1}));
}

/// The cards of curves are read, so that the next material stands in its place.
TEST(Fabric, OfCurvesIsRefused) {
  SmallDeck deck = membranes(
      "*MAT_FABRIC\n1,9e-7,.5,.3,,.1\n.02\n0,,,,,-14\n\n\n11,12,13\n\n2,9e-7,.4,.3,,.1\n.02\n0\n\n\n");
  const auto found = messages_in(deck);
  ASSERT_EQ(found.size(), 1U) << found[0];
  EXPECT_NE(found[0].find("card 3 field FORM: read \"-14\""), std::string::npos) << found[0];
  ReadOptions options;
  options.allow_unsupported = true;
  const ReadResult loose = read_deck_text(deck.text(), options);
  ASSERT_TRUE(loose.model.has_value());
  EXPECT_EQ(std::get<model::Fabric>(loose.model->materials.at(1).law).sheet.modulus_a, 0.4);
}

TEST(Fabric, IsOfMembranesOnly) {
  SmallDeck deck = membranes("*MAT_FABRIC\n1,9e-7,.5,,,.3\n0\n0\n\n\n");
  deck.section = "*SECTION_SHELL\n         1         2\n       0.3\n";
  const auto found = messages_in(deck);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("*MAT_FABRIC is there for membranes only, ELFORM 5 and 9"), std::string::npos)
      << found[0];
}

TEST(Fabric, WarnsOfAnotherPoissonsRatio) {
  const auto found = messages_in(membranes("*MAT_FABRIC\n1,9e-7,.5,.3,,.1,.3\n.02\n0\n\n\n"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("PRAB"), std::string::npos);
}

}  // namespace
}  // namespace crumple::deck::test::fabric_test
