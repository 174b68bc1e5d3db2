// SPDX-License-Identifier: BSD-3-Clause
// *MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC, *MAT_3-PARAMETER_BARLAT.
#include <cmath>
#include <numbers>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::sheet_materials_test {
namespace {

const std::string curve = "*DEFINE_CURVE\n7\n0.0,150.0\n0.1,200.0\n0.3,240.0\n";

std::vector<std::string> messages(const std::string& material) {
  SmallDeck deck;
  deck.material = material;
  deck.more = curve;
  return messages_in(deck);
}
model::SheetPlasticity law_of(const std::string& material) {
  SmallDeck deck;
  deck.material = material;
  deck.more = curve;
  return std::get<model::SheetPlasticity>(read_clean(deck.text()).materials.at(0).law);
}

TEST(SheetMaterial, NormalAnisotropy) {
  for (const std::string keyword : {"*MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC", "*MAT_037", "*MAT_37"}) {
    const auto law = law_of(keyword + "\n1,7.85E-9,210000,0.3,180,1000,1.6\n");
    EXPECT_TRUE(law.is_normal);
    EXPECT_EQ(law.youngs_modulus, 210000);
    EXPECT_EQ(law.poissons_ratio, 0.3);
    EXPECT_EQ(law.r00, 1.6);
    EXPECT_EQ(law.plastic_strain, (std::vector<double>{0, 10}));
    EXPECT_EQ(law.yield_stress, (std::vector<double>{180, 10180}));
  }
  const auto law = law_of("*MAT_037\n1,7.85E-9,210000,0.3,0,0,1.6,7\n");
  // The last slope goes on.
  EXPECT_EQ(law.plastic_strain, (std::vector<double>{0, 0.1, 0.3, 10}));
  EXPECT_NEAR(law.yield_stress.back(), 240 + 200 * 9.7, 1e-9);
}

/// A negative R is its amount, with a warning.
TEST(SheetMaterial, NormalAnisotropyByItsAmount) {
  SmallDeck deck;
  deck.material = "*MAT_037\n1,7.85E-9,210000,0.3,180,1000,-1.6,0\n";
  const ReadResult result = read_deck_text(deck.text());
  only_message(messages(deck.material), "warning: *MAT_037 card 1 field R: read \"-1.6\"");
  ASSERT_TRUE(result.model.has_value());
  const auto& law = std::get<model::SheetPlasticity>(result.model->materials.at(0).law);
  EXPECT_EQ(law.r00, 1.6);
  EXPECT_EQ(law.r45, 1.6);
  EXPECT_EQ(law.r90, 1.6);
}

TEST(SheetMaterial, NormalAnisotropyFaults) {
  const std::string card = "*MAT_037\n1,7.85E-9,210000,0.3,180,1000,1.6,0\n";
  only_message(messages(replaced(card, "1.6", "0")), "error: *MAT_037 card 1 field R");
  only_message(messages(replaced(card, "180", "0")), "field SIGY");
  only_message(messages(replaced(card, ",1000,", ",-1000,")), "field ETAN");
  only_message(messages(replaced(card, "1.6,0", "1.6,8")), "the deck has no curve 8");
  const auto unknown = messages(replaced(card, "MAT_037", "MAT_037_NLP_FAILURE"));
  ASSERT_EQ(unknown.size(), 2U);
  EXPECT_NE(unknown[1].find("this keyword is not supported; nearest is *MAT_TRANSVERSELY"),
            std::string::npos);
}

const std::string barlat =
    "*MAT_3-PARAMETER_BARLAT\n1,2.7E-9,70000,0.33,3,0,0\n8,0.71,0.58,0.7,7\n3,6500,4\n\n1,0,0,0,0,0,30\n";

TEST(SheetMaterial, Barlat) {
  for (const std::string keyword : {"*MAT_3-PARAMETER_BARLAT", "*MAT_036", "*MAT_36"}) {
    const auto law = law_of(replaced(barlat, "*MAT_3-PARAMETER_BARLAT", keyword));
    EXPECT_FALSE(law.is_normal);
    EXPECT_EQ(law.yield_exponent, 8);
    EXPECT_EQ(law.r00, 0.71);
    EXPECT_EQ(law.r45, 0.58);
    EXPECT_EQ(law.r90, 0.7);
    EXPECT_EQ(law.cowper_symonds_rate, 6500);
    EXPECT_EQ(law.cowper_symonds_exponent, 4);
    EXPECT_EQ(law.axes.axes, model::OrthotropicElastic::Axes::CrossNormal);
    EXPECT_EQ(law.axes.direction, (std::array<double, 3>{1, 0, 0}));
    EXPECT_NEAR(law.axes.angle, std::numbers::pi / 6, 1e-15);
    EXPECT_EQ(law.yield_stress.front(), 150);
  }
}

TEST(SheetMaterial, BarlatHardening) {
  const std::string rest = "\n8,0.71,0.58,0.7\n0\n\n\n";
  // HR of zero is linear; P1 is a slope over the whole strain.
  for (const char* rule : {"0", "1"}) {
    const auto law = law_of(std::string("*MAT_036\n1,2.7E-9,70000,0.33,") + rule + ",700,120" + rest);
    EXPECT_EQ(law.yield_stress.front(), 120);
    EXPECT_NEAR(law.yield_stress.back(), 120 + 10 * 70000.0 * 700 / 69300, 1e-9);
    EXPECT_EQ(law.axes.axes, model::OrthotropicElastic::Axes::Side);
  }
  const std::string power = "*MAT_036\n1,2.7E-9,70000,0.33,2,400,0.25";
  const auto crossing = law_of(power + rest);
  EXPECT_TRUE(crossing.plastic_strain.empty());
  EXPECT_EQ(crossing.strength, 400);
  EXPECT_EQ(crossing.hardening_exponent, 0.25);
  EXPECT_NEAR(70000 * crossing.yield_strain, 400 * std::pow(crossing.yield_strain, 0.25), 1e-9);
  const auto given = law_of(power + "\n8,0.71,0.58,0.7,0,0.005,0\n0\n\n\n");
  EXPECT_EQ(given.yield_strain, 0.005);
  const auto small = law_of(power + "\n8,0.71,0.58,0.7,0,0,0.02\n0\n\n\n");
  EXPECT_EQ(small.yield_strain, 0.02);
  const auto stress = law_of(power + "\n8,0.71,0.58,0.7,0,0,120\n0\n\n\n");
  EXPECT_NEAR(400 * std::pow(stress.yield_strain, 0.25), 120, 1e-9);
  only_message(messages(power + "\n8,0.71,0.58,0.7,0,0,500\n0\n\n\n"), "field SPI");
  only_message(messages("*MAT_036\n1,2.7E-9,70000,0.33,2,0,0.25" + rest), "field P1");
  only_message(messages("*MAT_036\n1,2.7E-9,70000,0.33,2,400,1.25" + rest), "field P2");
  only_message(messages("*MAT_036\n1,2.7E-9,70000,0.33,1,80000,120" + rest), "field P1");
  only_message(messages("*MAT_036\n1,2.7E-9,70000,0.33,1,700,0" + rest), "field P2");
}

TEST(SheetMaterial, BarlatFaults) {
  only_message(messages(replaced(barlat, "0.33,3,", "0.33,7,")), "field HR");
  only_message(messages(replaced(barlat, "8,0.71", "1,0.71")), "field M");
  only_message(messages(replaced(barlat, "0.71", "-0.71")), "field R00");
  only_message(messages(replaced(barlat, "0.7,7", "0.7,0")), "field LCID");
  only_message(messages(replaced(barlat, "0.7,7", "0.7,9")), "the deck has no curve 9");
  only_message(messages(replaced(barlat, "3,6500,4", "-3,6500,4")), "field AOPT");
  only_message(messages(replaced(barlat, "3,6500,4", "3,6500,0")), "field P");
  only_message(messages(replaced(barlat, "3,6500,4", "3,6500,4,7")), "field VLCID");
  only_message(messages(replaced(barlat, "3,6500,4", "3,6500,4,0,0,1.1")), "field PB");
  only_message(messages(replaced(barlat, "3,6500,4", "3,6500,4,0,0,0,7")), "field HTA");
  only_message(messages(replaced(barlat, "3,6500,4\n\n1,", "3,6500,4\n\n0,")), "field V1");
  only_message(messages(replaced(barlat, "0,30\n", "0,30,1\n")), "field HTFLAG");
  only_message(messages(barlat + "1\n"), "field USRFAIL");
}

}  // namespace
}  // namespace crumple::deck::test::sheet_materials_test
