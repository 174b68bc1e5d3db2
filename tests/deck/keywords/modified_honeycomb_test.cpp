// SPDX-License-Identifier: BSD-3-Clause
// *MAT_MODIFIED_HONEYCOMB.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::modified_honeycomb_test {
namespace {

// Of a, b, shear, and of rates.
const std::string curves =
    "*DEFINE_CURVE\n11\n-0.5,6.0\n0.0,5.0\n0.6,5.5\n*DEFINE_CURVE\n12\n0.1,2.0\n0.5,3.0\n"
    "*DEFINE_CURVE\n13\n0.0,1.0\n0.7,3.0\n*DEFINE_CURVE\n14\n0.0,1.0\n100.0,2.0\n";
const std::string honeycomb =
    "*MAT_MODIFIED_HONEYCOMB\n1,8.3E-11,70000,0.33,240,0.25,0.08\n11,12,0,13,0,12,0,14\n"
    "1020,340,341,434,214,215,2\n0,0,0,1,2,3\n4,5,7,0.6,0.5,0,0,1\n";

CubeDeck deck_of(const std::string& material, const std::string& form) {
  CubeDeck deck;
  deck.material = material;
  deck.section = "*SECTION_SOLID\n1" + form + "\n";
  deck.more = curves;
  return deck;
}
model::Honeycomb law_of(const std::string& material, const std::string& form = ",1") {
  const model::Model model = read_clean(deck_of(material, form).text());
  return std::get<model::Honeycomb>(model.materials[static_cast<std::size_t>(model.parts[0].material)].law);
}
std::vector<std::string> messages(const std::string& material) {
  return messages_in(deck_of(material, ",1"));
}

TEST(ModifiedHoneycomb, Fields) {
  for (const std::string keyword : {"*MAT_MODIFIED_HONEYCOMB", "*MAT_126"}) {
    const auto law = law_of(replaced(honeycomb, "*MAT_MODIFIED_HONEYCOMB", keyword));
    EXPECT_EQ(law.over, model::Honeycomb::Abscissa::Strain);
    EXPECT_EQ(law.youngs_modulus, 70000);
    EXPECT_EQ(law.poissons_ratio, 0.33);
    EXPECT_EQ(law.yield_stress, 240);
    EXPECT_EQ(law.compacted_volume, 0.25);
    EXPECT_EQ(law.viscosity, 0.08);
    EXPECT_EQ(law.moduli, (std::array<double, 6>{1020, 340, 341, 434, 214, 215}));
    EXPECT_EQ(law.crush[0].crush, (std::vector<double>{-0.5, 0, 0.6}));
    EXPECT_EQ(law.crush[0].stress, (std::vector<double>{6, 5, 5.5}));
    // A strain, though it begins above zero.
    EXPECT_EQ(law.crush[1].crush, (std::vector<double>{0.1, 0.5}));
    EXPECT_EQ(law.crush[2].stress, law.crush[0].stress);
    EXPECT_EQ(law.crush[3].crush, (std::vector<double>{0, 0.7}));
    EXPECT_EQ(law.crush[4].stress, law.crush[1].stress);
    EXPECT_EQ(law.crush[5].stress, law.crush[3].stress);
    EXPECT_EQ(law.rates.rate, (std::vector<double>{0, 100}));
    EXPECT_EQ(law.rates.factor, (std::vector<double>{1, 2}));
    EXPECT_TRUE(law.own_rates[0].rate.empty());
    EXPECT_EQ(law.axes, model::Honeycomb::Axes::Vectors);
    EXPECT_EQ(law.a, (std::array<double, 3>{1, 2, 3}));
    EXPECT_EQ(law.d, (std::array<double, 3>{4, 5, 7}));
    EXPECT_EQ(law.failure_tension, 0.6);
    EXPECT_EQ(law.failure_shear, 0.5);
  }
}

TEST(ModifiedHoneycomb, StrainsAreNominalWithElform0And9) {
  using enum model::Honeycomb::Abscissa;
  EXPECT_EQ(law_of(honeycomb, ",0").over, NominalStrain);
  EXPECT_EQ(law_of(honeycomb, "").over, NominalStrain);
  EXPECT_EQ(law_of(honeycomb, ",2").over, Strain);
  const ReadResult result = read_deck_text(deck_of(honeycomb, ",9").text());
  ASSERT_TRUE(result.model);
  EXPECT_NE(listed(result.diagnostics).find("over the nominal strain"), std::string::npos);
  const model::Part& part = result.model->parts[0];
  EXPECT_EQ(
      std::get<model::Honeycomb>(result.model->materials[static_cast<std::size_t>(part.material)].law).over,
      NominalStrain);
}

/// With the card of V1 to V3, blank, of zeros or filled, and without it.
TEST(ModifiedHoneycomb, RatesOfEachComponent) {
  const std::string material = replaced(honeycomb, "12,0,14", "12,0,-1");
  for (const std::string vector : {"", "\n", "       0.0       0.0       0.0\n", "0.0,0.0,1.0\n"}) {
    const auto law = law_of(material + vector + "14,0,14\n");
    EXPECT_TRUE(law.rates.rate.empty());
    EXPECT_EQ(law.own_rates[0].factor, (std::vector<double>{1, 2}));
    EXPECT_TRUE(law.own_rates[1].rate.empty());
    EXPECT_EQ(law.own_rates[2].rate, (std::vector<double>{0, 100}));
    EXPECT_TRUE(law.own_rates[5].rate.empty());
  }
  // Of what follows, three numbers are that card as well, and more another material.
  law_of(honeycomb + "0,0,1\n");
  const auto two =
      read_deck_text(deck_of(honeycomb + "2" + honeycomb.substr(honeycomb.find(",8.3E-11")), ",1").text());
  ASSERT_TRUE(two.model);
  EXPECT_EQ(two.model->materials.size(), 2U);
  // The title of another material is no such card.
  const std::string titled = "first core\n" + honeycomb.substr(honeycomb.find("1,8.3E-11"));
  const auto named = read_deck_text(
      deck_of("*MAT_126_TITLE\n" + titled + replaced(titled, "first core\n1,", "second core\n2,"), ",1")
          .text());
  ASSERT_TRUE(named.model);
  ASSERT_EQ(named.model->materials.size(), 2U);
  EXPECT_EQ(named.model->materials[1].title, "second core");
}

TEST(ModifiedHoneycomb, Faults) {
  const auto with = [](const std::string& from, const std::string& to) {
    return messages(replaced(honeycomb, from, to));
  };
  only_message(with("0.25,", "1.25,"), "field VF");
  only_message(with(",434,", ",0,"), "field GABU");
  only_message(with("215,2", "215,3"), "field AOPT");
  only_message(with("0,0,0,1,2,3", "0,0,0"), "field A1");
  only_message(with("\n11,", "\n-11,"), "the transversely isotropic surface");
  only_message(with("\n11,", "\n16,"), "the deck has no curve 16");
  only_message(with("12,0,14", "12,0,15"), "the deck has no curve 15");
  only_message(with("0.6,0.5,0,0,1", "0.6,0.5,0.1,1e-6"), "they do not become springs");
  only_message(messages(replaced(honeycomb, "12,0,14", "12,0,-1") + "14,17\n"), "field LCSRB");
  CubeDeck deck = deck_of(honeycomb, ",1");
  deck.more = replaced(curves, "0.6,5.5", "0.6,-5.5");
  only_message(messages_in(deck), "over the strain of its component");
}

}  // namespace
}  // namespace crumple::deck::test::modified_honeycomb_test
