// SPDX-License-Identifier: BSD-3-Clause
// Materials and equations of state of solids, and what a part may put together.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::solid_materials_test {
namespace {

constexpr const char* gruneisen = "*EOS_GRUNEISEN\n4,3940,1.489,0.1,0.2,2.02,0.47,0.5\n0.9\n";
constexpr const char* water = "*MAT_NULL\n1,1.0E-6,-1E-6,1E-9,1.2,0.8\n";
constexpr const char* copper =
    "*MAT_JOHNSON_COOK\n1,8.93E-6,46.0,124.0,0.34\n0.09,0.292,0.31,0.025,1.09,1356,294,1E-3\n"
    "383,-1.2,3,0,0.54,4.89,-3.03,0.014\n1.12\n";

std::vector<std::string> messages(const std::string& material, const std::string& more, const char* eos) {
  CubeDeck deck;
  deck.material = material;
  deck.more = more;
  deck.part = std::string("*PART\nblock\n1,1,1,") + eos + "\n";
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity != Severity::Note) found.push_back(to_string(diagnostic));
  return found;
}
model::Model clean(const std::string& material, const std::string& more, const char* eos) {
  CubeDeck deck;
  deck.material = material;
  deck.more = more;
  deck.part = std::string("*PART\nblock\n1,1,1,") + eos + "\n";
  return read_clean(deck.text());
}
void only_message(const std::vector<std::string>& found, const std::string& part) {
  ASSERT_EQ(found.size(), 1U) << (found.empty() ? "" : found.back());
  EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
}

TEST(EquationOfState, Gruneisen) {
  for (const std::string keyword : {"*EOS_GRUNEISEN", "*EOS_004", "*EOS_4"}) {
    const auto model = clean(water, keyword + "\n4,3940,1.489,0.1,0.2,2.02,0.47,0.5\n0.9\n", "4");
    ASSERT_EQ(model.equations_of_state.size(), 1U);
    const model::EquationOfState& found = model.equations_of_state[0];
    const auto& law = std::get<model::Gruneisen>(found.law);
    EXPECT_EQ(found.id, 4);
    EXPECT_EQ(law.sound_speed, 3940);
    EXPECT_EQ(law.slopes, (std::array<double, 3>{1.489, 0.1, 0.2}));
    EXPECT_EQ(law.gamma, 2.02);
    EXPECT_EQ(law.volume_correction, 0.47);
    EXPECT_EQ(found.initial_energy, 0.5);
    EXPECT_EQ(found.initial_volume, 0.9);
    EXPECT_EQ(model.parts[0].equation_of_state, 0);
  }
}

TEST(EquationOfState, LinearPolynomial) {
  const auto model = clean(water, "*EOS_LINEAR_POLYNOMIAL_TITLE\nair\n1,1,2,3,4,0.4,0.5,0.6\n0.25\n", "1");
  const model::EquationOfState& found = model.equations_of_state.at(0);
  const auto& law = std::get<model::LinearPolynomial>(found.law);
  EXPECT_EQ(found.title, "air");
  EXPECT_EQ(law.coefficients, (std::array<double, 7>{1, 2, 3, 4, 0.4, 0.5, 0.6}));
  EXPECT_EQ(found.initial_energy, 0.25);
  EXPECT_EQ(found.initial_volume, 1);
}

TEST(EquationOfState, JohnsonCook) {
  const auto model = clean(copper, gruneisen, "4");
  const auto& law = std::get<model::JohnsonCook>(model.materials[0].law);
  EXPECT_EQ(law.shear_modulus, 46);
  EXPECT_EQ(law.least_pressure, -1.2);
  EXPECT_EQ(law.spall, model::JohnsonCook::Spall::Pressure);
}

TEST(EquationOfState, IsMissingOrOutOfPlace) {
  only_message(messages(water, "", "0"), "solids of *MAT_NULL have no other pressure");
  only_message(messages(water, gruneisen, "5"), "the deck has no equation of state 5");
  only_message(messages("*MAT_ELASTIC\n1,7.83E-6,207.0,0.3\n", gruneisen, "4"), "brings its own pressure");
  only_message(messages(water, "*EOS_GRUNEISEN\n4,3.94\n0,0,7\n", "4"), "field LCID");
  only_message(messages(water, "*EOS_GRUNEISEN\n4,0\n\n", "4"), "field C:");
  only_message(messages(copper, "", "0"), "LS-DYNA refuses solids of *MAT_JOHNSON_COOK without one");
  only_message(messages("*MAT_NULL\n1,1.0E-6,0.1\n", gruneisen, "4"), "field PC");
  // An equation of state that is not supported is named where the part refers to it.
  const auto unsupported = messages(water, "*EOS_JWL\n8,1,2,3\n", "8");
  ASSERT_EQ(unsupported.size(), 2U);
  EXPECT_NE((unsupported[0] + unsupported[1]).find("equation of state 8 is defined by *EOS_JWL"),
            std::string::npos);
}

TEST(EquationOfState, IsNotForShells) {
  SmallDeck deck;
  deck.part = "*PART\nplate\n1,1,1,4\n";
  deck.more = gruneisen;
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity != Severity::Note) found.push_back(to_string(diagnostic));
  only_message(found, "shells have no equation of state");
}

TEST(SolidMaterial, TwoShearModuli) {
  std::string other = copper;
  other.replace(other.find("46.0"), 4, "77.0");
  only_message(messages(other, gruneisen, "4"), "with an equation of state G is taken");
}

TEST(SolidMaterial, BlatzKo) {
  for (const std::string keyword : {"*MAT_BLATZ-KO_RUBBER", "*MAT_007"}) {
    const auto model = clean(keyword + "\n1,1.1E-9,1.04\n", "", "0");
    const auto& law = std::get<model::BlatzKo>(model.materials[0].law);
    EXPECT_NEAR(law.youngs_modulus / 2.926, 1.04, 1e-15);
    EXPECT_EQ(law.poissons_ratio, 0.463);
  }
  only_message(messages("*MAT_007\n1,1.1E-9,1.04,1\n", "", "0"), "field REF");
}

TEST(SolidMaterial, MooneyRivlin) {
  const auto model = clean("*MAT_MOONEY-RIVLIN_RUBBER\n1,1.1E-9,0.499,0.55,0.14\n\n", "", "0");
  const auto& law = std::get<model::MooneyRivlin>(model.materials[0].law);
  EXPECT_EQ(law.first, 0.55);
  EXPECT_EQ(law.second, 0.14);
  EXPECT_EQ(law.poissons_ratio, 0.499);
  EXPECT_NEAR(law.youngs_modulus, 4 * 0.69 * 1.499, 1e-15);
  only_message(messages("*MAT_027\n1,1.1E-9,0.5,0.55,0.14\n\n", "", "0"), "field PR");
  only_message(messages("*MAT_027\n1,1.1E-9,0.49,0.1,-0.2\n\n", "", "0"), "field A:");
  only_message(messages("*MAT_027\n1,1.1E-9,0.49,0.1,0.1\n50\n", "", "0"), "field SGL");
}

TEST(SolidMaterial, CrushableFoam) {
  const std::string curve = "*DEFINE_CURVE\n7\n0.0,0.0\n0.1,0.5\n0.6,0.8\n";
  const auto model = clean("*MAT_CRUSHABLE_FOAM\n1,6E-11,20,0.0,7,0.15\n", curve, "0");
  const auto& law = std::get<model::CrushableFoam>(model.materials[0].law);
  EXPECT_EQ(law.youngs_modulus, 20);
  EXPECT_EQ(law.crush, (std::vector<double>{0, 0.1, 0.6}));
  EXPECT_EQ(law.yield_stress, (std::vector<double>{0, 0.5, 0.8}));
  EXPECT_EQ(law.tensile_stress, 0.15);
  EXPECT_EQ(law.damping, 0.1);
  only_message(messages("*MAT_063\n1,6E-11,20,0.0,8,0.15\n", curve, "0"), "the deck has no curve 8");
  only_message(messages("*MAT_063\n1,6E-11,20,0.0,7\n", curve, "0"), "field TSC");
  only_message(messages("*MAT_063\n1,6E-11,20,0.0,7,0.1,0,1\n", curve, "0"), "field MODEL");
  only_message(messages("*MAT_063\n1,6E-11,20,0.0,7,0.1\n", "*DEFINE_CURVE\n7\n0,1\n0.5,-1\n", "0"),
               "positive in compression");
}

TEST(SolidMaterial, IsForTheElementsOfItsPart) {
  only_message(
      messages("*MAT_ORTHOTROPIC_ELASTIC\n1,1.6E-9,138000,9000,8000,0.02,0.02,0.3\n7000,3500,6500,0\n"
               "\n\n",
               "", "0"),
      "*MAT_ORTHOTROPIC_ELASTIC is there for shells only");
  only_message(messages_of("*MAT_BLATZ-KO_RUBBER\n1,1.1E-9,1.04\n"), "is there for solids only");
}

}  // namespace
}  // namespace crumple::deck::test::solid_materials_test
