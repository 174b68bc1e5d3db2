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
  return messages_in(deck);
}
model::Model clean(const std::string& material, const std::string& more, const char* eos) {
  CubeDeck deck;
  deck.material = material;
  deck.more = more;
  deck.part = std::string("*PART\nblock\n1,1,1,") + eos + "\n";
  return read_clean(deck.text());
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
  EXPECT_EQ(law.spall, model::Spall::Pressure);
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

constexpr const char* compression = "*DEFINE_CURVE\n7\n0.0,0.0\n0.1,0.5\n0.6,0.8\n";

TEST(SolidMaterial, LowDensityFoam) {
  for (const std::string keyword : {"*MAT_LOW_DENSITY_FOAM", "*MAT_057", "*MAT_57"}) {
    const auto model = clean(keyword + "\n1,6E-11,20,7,0.15,0.1,0,0.2\n5,1,1,0,0,3\n", compression, "0");
    const auto& law = std::get<model::LowDensityFoam>(model.materials[0].law);
    EXPECT_EQ(law.youngs_modulus, 20);
    EXPECT_EQ(law.compression, (std::vector<double>{0, 0.1, 0.6}));
    EXPECT_EQ(law.stress, (std::vector<double>{0, 0.5, 0.8}));
    EXPECT_EQ(law.tensile_stress, 0.15);
    EXPECT_TRUE(law.tears);
    EXPECT_EQ(law.unloading_factor, 0.1);
    EXPECT_EQ(law.unloading_shape, 5);
    EXPECT_EQ(law.damping, 0.2);
    EXPECT_TRUE(law.faster.empty());
  }
  // Defaults: no bound of tension, no hysteresis.
  const auto model = clean("*MAT_057\n1,6E-11,20,7\n", compression, "0");
  const auto& law = std::get<model::LowDensityFoam>(model.materials[0].law);
  EXPECT_EQ(law.tensile_stress, 0);
  EXPECT_FALSE(law.tears);
  EXPECT_EQ(law.unloading_factor, 1);
  EXPECT_EQ(law.unloading_shape, 1);
  only_message(messages("*MAT_057\n1,6E-11,20,8\n", compression, "0"), "the deck has no curve 8");
  only_message(messages("*MAT_057\n1,6E-11,20,7,0,1.5\n", compression, "0"), "field HU");
  only_message(messages("*MAT_057\n1,6E-11,20,7,0,1,10\n", compression, "0"), "field BETA");
  only_message(messages("*MAT_057\n1,6E-11,20,7,0,1,0,0.51\n", compression, "0"),
               "warning: *MAT_057 card 1 field DAMP: read \"0.51\", expected 0.05 to 0.5");
  only_message(messages("*MAT_057\n1,6E-11,20,7\n1,0,0,5\n", compression, "0"), "field ED");
  only_message(messages("*MAT_057\n1,6E-11,20,7\n", "*DEFINE_CURVE\n7\n0,0\n0.5,1\n0.6,0.9\n", "0"),
               "must not fall");
  only_message(messages("*MAT_057\n1,6E-11,20,7\n", "*DEFINE_CURVE\n7\n0,0.1\n0.5,1\n", "0"),
               "must start at (0, 0)");
}

TEST(SolidMaterial, FuChangFoam) {
  const std::string table =
      "*DEFINE_TABLE\n9\n0.001\n10\n*DEFINE_CURVE\n7\n0.0,0.0\n0.1,0.5\n0.6,0.8\n"
      "*DEFINE_CURVE\n8\n0.0,0.0\n0.1,0.7\n0.6,1.2\n";
  for (const std::string keyword : {"*MAT_FU_CHANG_FOAM", "*MAT_083"}) {
    const auto model =
        clean(keyword + "\n1,6E-11,20,0,0.15,0,0.2,9\n0,1,0,0,0,0,0,0.4\n\n0,0,0,0,0,0,0,3\n", table, "0");
    const auto& law = std::get<model::LowDensityFoam>(model.materials[0].law);
    EXPECT_EQ(law.stress, (std::vector<double>{0, 0.5, 0.8}));
    EXPECT_EQ(law.slowest, 0.001);
    ASSERT_EQ(law.faster.size(), 1U);
    EXPECT_EQ(law.faster[0].rate, 10);
    EXPECT_EQ(law.faster[0].stress, (std::vector<double>{0, 0.7, 1.2}));
    EXPECT_TRUE(law.engineering_rate);
    EXPECT_EQ(law.unloading_factor, 0.4);
    EXPECT_EQ(law.unloading_shape, 3);
    EXPECT_EQ(law.damping, 0.2);
    EXPECT_EQ(law.tensile_stress, 0.15);
  }
  // A curve alone has no rate; HU of zero unloads by the curve.
  const auto model = clean("*MAT_083\n1,6E-11,20,0,0,0,0,7\n", compression, "0");
  const auto& law = std::get<model::LowDensityFoam>(model.materials[0].law);
  EXPECT_TRUE(law.faster.empty());
  EXPECT_EQ(law.unloading_factor, 1);
  only_message(messages("*MAT_083\n1,6E-11,20\n", compression, "0"), "field TBID");
  only_message(messages("*MAT_083\n1,6E-11,20,0,0,0,0,9\n0,0,1\n", table, "0"), "field RFLAG");
  only_message(messages("*MAT_083\n1,6E-11,20,0,0,0,0,9\n",
                        "*DEFINE_TABLE_2D\n9\n-1,7\n10,7\n" + std::string(compression), "0"),
               "strain rates that ascend");
}

TEST(SolidMaterial, OgdenRubber) {
  for (const std::string keyword : {"*MAT_OGDEN_RUBBER", "*MAT_077_O", "*MAT_77_O"}) {
    const auto model = clean(keyword + "\n1,1.1E-9,0.499\n0.63,0.0012,-0.01\n1.3,5,-2\n", "", "0");
    const auto& law = std::get<model::OgdenRubber>(model.materials[0].law);
    EXPECT_EQ(law.modulus, (std::array<double, 8>{0.63, 0.0012, -0.01}));
    EXPECT_EQ(law.exponent, (std::array<double, 8>{1.3, 5, -2}));
    EXPECT_EQ(law.poissons_ratio, 0.499);
    EXPECT_NEAR(law.youngs_modulus, 2 * 0.4225 * 1.499, 1e-14);
  }
  only_message(messages("*MAT_077_O\n1,1.1E-9,0.5\n0.63\n1.3\n", "", "0"), "field PR");
  only_message(messages("*MAT_077_O\n1,1.1E-9,0.49\n0.63\n-1.3\n", "", "0"), "field MU1");
  only_message(messages("*MAT_077_O\n1,1.1E-9,0.49,2\n1,1,1,7\n\n", "", "0"), "field N");
  only_message(messages("*MAT_077_O\n1,1.1E-9,0.49\n0.63\n1.3\n-0.2,100\n", "", "0"), "field GI");
  only_message(messages("*MAT_077_O\n1,1.1E-9,0.49\n0.63\n1.3\n0.2,100,1\n", "", "0"), "field VFLAG");
}

TEST(SolidMaterial, RubberMayRelax) {
  const std::string series = "0.2,100\n0,7\n0.5,3\n";
  const auto expect = [](const std::vector<model::Relaxation>& terms) {
    ASSERT_EQ(terms.size(), 2U);
    EXPECT_EQ(terms[0].modulus, 0.2);
    EXPECT_EQ(terms[0].decay, 100);
    EXPECT_EQ(terms[1].modulus, 0.5);
    EXPECT_EQ(terms[1].decay, 3);
  };
  const auto ogden = clean("*MAT_077_O\n1,1.1E-9,0.49\n0.63\n1.3\n" + series, "", "0");
  expect(std::get<model::OgdenRubber>(ogden.materials[0].law).relaxing);
  const auto polynomial = clean("*MAT_077_H\n1,1.1E-9,0.499\n0.3,0.05\n" + series, "", "0");
  expect(std::get<model::PolynomialRubber>(polynomial.materials[0].law).relaxing);
}

TEST(SolidMaterial, HyperelasticRubber) {
  for (const std::string keyword : {"*MAT_HYPERELASTIC_RUBBER", "*MAT_077_H"}) {
    const auto model = clean(keyword + "\n1,1.1E-9,0.499\n0.3,0.05,0.01,-0.02,0.004,0.003\n", "", "0");
    const auto& law = std::get<model::PolynomialRubber>(model.materials[0].law);
    EXPECT_EQ(law.c10, 0.3);
    EXPECT_EQ(law.c01, 0.05);
    EXPECT_EQ(law.c11, 0.01);
    EXPECT_EQ(law.c20, -0.02);
    EXPECT_EQ(law.c02, 0.004);
    EXPECT_EQ(law.c30, 0.003);
    EXPECT_NEAR(law.youngs_modulus, 4 * 0.35 * 1.499, 1e-14);
  }
  only_message(messages("*MAT_077_H\n1,1.1E-9,0.49\n0.1,-0.2\n", "", "0"), "field C10");
  only_message(messages("*MAT_077_H\n1,1.1E-9,0.49,0,0,5\n0.1,0.2\n", "", "0"), "field G");
}

TEST(SolidMaterial, Viscoelastic) {
  for (const std::string keyword : {"*MAT_VISCOELASTIC", "*MAT_006"}) {
    const auto model = clean(keyword + "\n1,1.1E-9,20,3,1,50\n", "", "0");
    const auto& law = std::get<model::Viscoelastic>(model.materials[0].law);
    ASSERT_EQ(law.shear.size(), 2U);
    EXPECT_EQ(law.shear[0].modulus, 1);
    EXPECT_EQ(law.shear[0].decay, 0);
    EXPECT_EQ(law.shear[1].modulus, 2);
    EXPECT_EQ(law.shear[1].decay, 50);
    ASSERT_EQ(law.bulk.size(), 1U);
    EXPECT_EQ(law.bulk[0].modulus, 20);
    EXPECT_NEAR(law.youngs_modulus, 9 * 20.0 * 3 / 63, 1e-14);
    EXPECT_NEAR(law.poissons_ratio, 54.0 / 126, 1e-15);
  }
  only_message(messages("*MAT_006\n1,1.1E-9,20,3,4,50\n", "", "0"), "field GI");
  only_message(messages("*MAT_006\n1,1.1E-9,0,3,1,50\n", "", "0"), "field BULK");
}

TEST(SolidMaterial, GeneralViscoelastic) {
  for (const std::string keyword : {"*MAT_GENERAL_VISCOELASTIC", "*MAT_076"}) {
    const auto model = clean(keyword + "\n1,1.1E-9,20\n\n1.0,0.0\n0.0,7.0\n2.0,30.0\n", "", "0");
    const auto& law = std::get<model::Viscoelastic>(model.materials[0].law);
    ASSERT_EQ(law.shear.size(), 2U);
    EXPECT_EQ(law.shear[1].modulus, 2);
    EXPECT_EQ(law.shear[1].decay, 30);
    ASSERT_EQ(law.bulk.size(), 1U);
    EXPECT_EQ(law.bulk[0].modulus, 20);
  }
  const auto model = clean("*MAT_076\n1,1.1E-9,20\n\n1.0,5.0,8.0,6.0\n0.0,0.0,9.0,0.0\n", "", "0");
  const auto& law = std::get<model::Viscoelastic>(model.materials[0].law);
  ASSERT_EQ(law.bulk.size(), 2U);
  EXPECT_EQ(law.bulk[0].decay, 6);
  EXPECT_EQ(law.bulk[1].modulus, 9);
  only_message(messages("*MAT_076\n1,1.1E-9,20\n\n", "", "0"), "expected a term with GI above zero");
  only_message(messages("*MAT_076\n1,1.1E-9,20\n5\n1.0,5.0\n", "", "0"), "field LCID");
  only_message(messages("*MAT_076\n1,1.1E-9,0\n\n1.0,5.0\n", "", "0"), "field BULK");
  std::string many = "*MAT_076\n1,1.1E-9,20\n\n";
  for (int i = 0; i < 19; ++i) many += "1.0,5.0\n";
  only_message(messages(many, "", "0"), "19 terms, expected at most 18");
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
