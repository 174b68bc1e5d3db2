// SPDX-License-Identifier: BSD-3-Clause
// Cards of the materials with rate effects and failure.
#include <cmath>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::materials_test {
namespace {

model::Material material_of(const std::string& text) {
  SmallDeck deck;
  deck.material = text;
  return read_clean(deck.text()).materials.at(0);
}

template <class Law>
Law law_of(const std::string& text) {
  return std::get<Law>(material_of(text).law);
}

TEST(RateMaterial, PowerLawWithEveryValue) {
  const auto law = law_of<model::PowerLawPlasticity>(
      "*MAT_POWER_LAW_PLASTICITY\n"
      "         1   7.83E-6     207.0       0.3       0.5      0.22      40.0       5.0\n"
      "     0.002       1.0      0.25\n");
  EXPECT_EQ(law.youngs_modulus, 207);
  EXPECT_EQ(law.strength, 0.5);
  EXPECT_EQ(law.exponent, 0.22);
  EXPECT_EQ(law.cowper_symonds_rate, 40);
  EXPECT_EQ(law.cowper_symonds_exponent, 5);
  EXPECT_TRUE(law.viscoplastic);
  EXPECT_EQ(law.failure_strain, 0.25);
  EXPECT_EQ(law.yield_strain, 0.002);
}

/// Sources have either of two orders: what can be no VP is the failure strain.
TEST(RateMaterial, PowerLawFailsInEitherOrder) {
  const std::string head = "*MAT_018\n1,7.83E-9,207000,0.3,500,0.22,40,5\n";
  const auto first = law_of<model::PowerLawPlasticity>(head + "0,0.05,1\n");
  EXPECT_EQ(first.failure_strain, 0.05);
  EXPECT_TRUE(first.viscoplastic);
  EXPECT_FALSE(law_of<model::PowerLawPlasticity>(head + "0,0.05,0\n").viscoplastic);
  EXPECT_EQ(law_of<model::PowerLawPlasticity>(head + "0,0.05,\n").failure_strain, 0.05);
  const auto last = law_of<model::PowerLawPlasticity>(head + "0,1,0.05\n");
  EXPECT_EQ(last.failure_strain, 0.05);
  EXPECT_TRUE(last.viscoplastic);
  EXPECT_FALSE(law_of<model::PowerLawPlasticity>(head + "0,0,0.05\n").viscoplastic);
  for (const char* either : {"0,1,0\n", "0,0,1\n"}) {
    const auto doubts = messages_of(head + either);
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_NE(doubts[0].find("sources differ"), std::string::npos) << doubts[0];
  }
}

TEST(RateMaterial, AnyVpPassesWithoutRates) {
  const auto without = messages_of("*MAT_018\n1,7.83E-9,207000,0.3,500,0.22\n0,0.4876,0.3\n");
  ASSERT_EQ(without.size(), 1U);
  EXPECT_NE(without[0].find("warning: *MAT_018 card 2 field VP"), std::string::npos) << without[0];
  EXPECT_NE(without[0].find("no effect, as there is no rate effect"), std::string::npos) << without[0];
  const auto with = messages_of("*MAT_018\n1,7.83E-9,207000,0.3,500,0.22,40,5\n0,0.4876,0.3\n");
  ASSERT_EQ(with.size(), 1U);
  EXPECT_NE(with[0].find("error: *MAT_018 card 2 field VP"), std::string::npos) << with[0];
}

/// Below 0.02 SIGY is a strain, from there on a stress on the curve; zero is the intersection with the
/// elastic line.
TEST(RateMaterial, PowerLawFindsItsYieldStrain) {
  const std::string card = "*MAT_018\n1,7.83E-9,207000,0.3,500,0.22\n";
  const auto crossing = law_of<model::PowerLawPlasticity>(card + "\n").yield_strain;
  EXPECT_NEAR(207000 * crossing, 500 * std::pow(crossing, 0.22), 1e-9);
  const auto stress = law_of<model::PowerLawPlasticity>(card + "180\n").yield_strain;
  EXPECT_NEAR(500 * std::pow(stress, 0.22), 180, 1e-9);
  EXPECT_EQ(law_of<model::PowerLawPlasticity>(card + "0.001\n").yield_strain, 0.001);
  const auto messages = messages_of(card + "600\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("a strain at yield below 0.02 or a yield stress below K"), std::string::npos);
}

/// G = 80000 and BULK = 520000 / 3 are E = 208000 and PR = 0.3; ETAN is over the plastic strain.
TEST(IsotropicMaterial, IsThePlasticKinematicOneWithBetaOfOne) {
  for (const std::string name : {"*MAT_ISOTROPIC_ELASTIC_PLASTIC", "*MAT_012", "*MAT_12"}) {
    const auto law = law_of<model::PlasticKinematic>(name + "\n1,7.83E-9,80000,250,1000,173333.3333333333\n");
    EXPECT_NEAR(law.youngs_modulus, 208000, 1e-6);
    EXPECT_NEAR(law.poissons_ratio, 0.3, 1e-12);
    EXPECT_EQ(law.yield_stress, 250);
    EXPECT_NEAR(1 / (1 / law.tangent_modulus - 1 / law.youngs_modulus), 1000, 1e-9);
    EXPECT_EQ(law.isotropic_fraction, 1);
  }
  const auto messages = messages_of("*MAT_012\n1,7.83E-9,80000,250,1000,50000\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("field BULK: read \"50000\", expected at least two thirds of G"),
            std::string::npos);
}

/// LS-DYNA takes ES1 to ES8 for no curve where all strains are zero.
TEST(PiecewiseMaterial, StressesWithoutStrainsAreNoCurve) {
  SmallDeck deck;
  deck.material = "*MAT_024\n1,7.83E-6,200,0.3,0.25,2\n\n0,0\n0.3,0.4\n";
  expect_one(deck, "warning: *MAT_024 card 4: EPS1 to EPS8 are all zero");
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model.has_value());
  const auto& law = std::get<model::PiecewiseLinearPlasticity>(result.model->materials.at(0).law);
  EXPECT_EQ(law.yield_stress.at(0), 0.25);
  EXPECT_NEAR(law.yield_stress.at(1), 0.25 + 10 * 200.0 * 2 / 198, 1e-12);
  deck.material = "*MAT_024\n1,7.83E-6,200,0.3\n\n0,0\n0.3,0.4\n";
  EXPECT_NE(listed(read_deck_text(deck.text()).diagnostics).find("error: *MAT_024 card 1 field SIGY"),
            std::string::npos);
}

TEST(RateMaterial, JohnsonCookWithEveryValue) {
  const auto law = law_of<model::JohnsonCook>(
      "*MAT_JOHNSON_COOK\n"
      "         1   7.83E-9   81000.0  210000.0       0.3       0.0       1.0       0.0\n"
      "     792.0     510.0      0.26     0.014      1.03    1793.0     293.0       1.0\n"
      "   477.0E6    -9.0E9       2.0       0.0      0.05      3.44     -2.12     0.002\n"
      "      0.61       0.0       0.0      0.01\n");
  EXPECT_EQ(law.youngs_modulus, 210000);
  EXPECT_FALSE(law.simplified);
  EXPECT_TRUE(law.viscoplastic);
  EXPECT_EQ(law.yield_stress, 792);
  EXPECT_EQ(law.hardening, 510);
  EXPECT_EQ(law.exponent, 0.26);
  EXPECT_EQ(law.rate_coefficient, 0.014);
  EXPECT_EQ(law.reference_rate, 1);
  EXPECT_EQ(law.thermal_exponent, 1.03);
  EXPECT_EQ(law.melting_rise, 1500);
  EXPECT_EQ(law.heat_capacity, 477e6);
  EXPECT_EQ(law.damage, (std::array<double, 5>{0.05, 3.44, -2.12, 0.002, 0.61}));
  EXPECT_EQ(law.least_fracture_strain, 0.01);
}

/// Fits give exponents above 1, too: the curve then steepens.
TEST(RateMaterial, JohnsonCookTakesAnyExponent) {
  const auto law = law_of<model::JohnsonCook>("*MAT_015\n1,7.83E-9,80000,0,0.3\n792,510,1.5\n\n\n");
  EXPECT_EQ(law.exponent, 1.5);
  const auto simplified = law_of<model::JohnsonCook>("*MAT_098\n1,7.83E-9,2E5,0.3\n792,510,1.2\n");
  EXPECT_EQ(simplified.exponent, 1.2);
}

TEST(RateMaterial, JohnsonCookTakesEFromG) {
  const auto law = law_of<model::JohnsonCook>("*MAT_015\n1,7.83E-9,80000,0,0.3\n792,510,0.26\n\n\n");
  EXPECT_EQ(law.youngs_modulus, 208000);
  EXPECT_EQ(law.damage, (std::array<double, 5>{}));
  EXPECT_EQ(law.heat_capacity, 0);
}

TEST(RateMaterial, JohnsonCookFaults) {
  const auto only = [](const std::string& text, const std::string& expected) {
    const auto messages = messages_of(text);
    ASSERT_EQ(messages.size(), 1U) << text;
    EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
  };
  const std::string first = "*MAT_015\n1,7.83E-9,0,210000,0.3\n";
  only(first + "792,510,0.26,0.014\n\n\n", "field EPS0");
  only(first + "792,510\n\n\n", "field N");
  only(first + "792,510,0.26,0,1,200,293\n477e6\n\n", "field TM");
  only(first + "792,510,0.26\n0,0,0,0,0.05,3.44,2.12\n\n", "D3 is 2.12");
  only("*MAT_015\n1,7.83E-9,0,0,0.3\n792\n\n\n", "field E");
  only("*MAT_015\n1,7.83E-9,0,210000,0.3,0,0,3\n792\n\n\n", "field RATEOP");
}

TEST(RateMaterial, SimplifiedJohnsonCook) {
  const auto law = law_of<model::JohnsonCook>(
      "*MAT_SIMPLIFIED_JOHNSON_COOK_TITLE\nsteel\n1,7.83E-9,210000,0.3,0\n"
      "792,510,0.26,0.014,0.4,1200,1300,0.001\n");
  EXPECT_TRUE(law.simplified);
  EXPECT_EQ(law.failure_strain, 0.4);
  EXPECT_EQ(law.largest_hardened, 1200);
  EXPECT_EQ(law.saturation_stress, 1300);
  EXPECT_EQ(law.reference_rate, 0.001);
  const auto plain = law_of<model::JohnsonCook>("*MAT_098\n1,7.83E-9,210000,0.3\n792,510,0.26,0.014\n");
  EXPECT_EQ(plain.failure_strain, 0);
  EXPECT_EQ(plain.largest_hardened, 0);
  EXPECT_EQ(plain.saturation_stress, 0);
  EXPECT_EQ(plain.reference_rate, 1);
  const auto messages = messages_of("*MAT_098\n1,7.83E-9,210000,0.3\n792,510,0.26,0,0,500\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("field SIGMAX"), std::string::npos);
}

/// A curve that begins behind zero goes on to there with its first slope, and its place is told.
TEST(Hardening, ThatBeginsBehindZeroStrain) {
  const auto look = [](const std::string& material, const std::string& expected) {
    SmallDeck deck;
    deck.material = material;
    const ReadResult result = read_deck_text(deck.text());
    ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
    const auto& law = std::get<model::PiecewiseLinearPlasticity>(result.model->materials[0].law);
    const auto& strain = law.by_rate.empty() ? law.plastic_strain : law.by_rate[0].plastic_strain;
    const auto& stress = law.by_rate.empty() ? law.yield_stress : law.by_rate[0].yield_stress;
    EXPECT_EQ(strain[0], 0);
    EXPECT_NEAR(stress[0], 0.3, 1e-15);
    EXPECT_EQ(strain[1], 0.1);
    ASSERT_EQ(messages_of(material).size(), 1U) << listed(result.diagnostics);
    EXPECT_EQ(messages_of(material)[0],
              expected +
                  ": the yield stress of material 1 is given from plastic strain 0.1 on; its first slope is "
                  "continued to zero, where it gives the yield stress 0.3; start it at zero");
  };
  const std::string curve = "*DEFINE_CURVE\n5,\n0.1,0.4\n0.2,0.5\n";
  look("*MAT_024\n1,7.83E-6,200,0.3\n0,0,5\n\n\n" + curve, "deck.k:26: warning: *DEFINE_CURVE card 1");
  look("*MAT_024\n1,7.83E-6,200,0.3\n0,0,7\n\n\n*DEFINE_TABLE_2D\n7,\n0.0,5\n" + curve,
       "deck.k:29: warning: *DEFINE_CURVE card 1");
  look("*MAT_024\n1,7.83E-6,200,0.3\n\n0.1,0.2\n0.4,0.5\n", "deck.k:21: warning: *MAT_024 card 1");
}

/// Whatever gives the first yield stress: above a tenth of the modulus it is doubted, up to there it is not.
TEST(YieldStress, AboveATenthOfTheModulusIsDoubted) {
  const std::string words = "the first yield stress 21 is above a tenth of the modulus 207";
  for (const std::string material :
       {"*MAT_003\n1,7.83E-6,207,0.3,X\n\n", "*MAT_024\n1,7.83E-6,207,0.3,X\n\n\n\n",
        "*MAT_024\n1,7.83E-6,207,0.3\n\n0,0.1\nX,22\n",
        "*MAT_024\n1,7.83E-6,207,0.3\n0,0,5\n\n\n*DEFINE_CURVE\n5,\n0,X\n1,22\n",
        "*MAT_018\n1,7.83E-6,207,0.3,X,0\n\n", "*MAT_098\n1,7.83E-6,207,0.3\nX\n"}) {
    const auto with = [&](const std::string& stress) {
      std::string text = material;
      return text.replace(text.find('X'), 1, stress);
    };
    const auto messages = messages_of(with("21.0"));
    ASSERT_EQ(messages.size(), 1U) << material;
    EXPECT_NE(messages[0].find(words), std::string::npos) << messages[0];
    EXPECT_TRUE(messages[0].starts_with("deck.k:21: warning: *MAT_0")) << messages[0];
    EXPECT_EQ(messages_of(with("20.0")).size(), 0U) << material;
  }
}

TEST(RateMaterial, ViscoplasticForms) {
  EXPECT_TRUE(law_of<model::PlasticKinematic>("*MAT_003\n1,7.83E-6,207,0.3,0.2\n40,5,0,1\n").viscoplastic);
  EXPECT_FALSE(law_of<model::PlasticKinematic>("*MAT_003\n1,7.83E-6,207,0.3,0.2\n40,5\n").viscoplastic);
  const auto law =
      law_of<model::PiecewiseLinearPlasticity>("*MAT_024\n1,7.83E-6,200,0.3,0.25,2.0,0.3\n40,5,0,0,1\n\n\n");
  EXPECT_TRUE(law.viscoplastic);
  EXPECT_EQ(law.viscoplastic_base, 0.25);
  EXPECT_EQ(law.failure_strain, 0.3);
  EXPECT_EQ(messages_of("*MAT_024\n1,7.83E-6,200,0.3,0.25\n40,5,0,0,3\n\n\n").size(), 1U);
}

TEST(ElasticMaterial, Orthotropic) {
  const auto law = law_of<model::OrthotropicElastic>(
      "*MAT_ORTHOTROPIC_ELASTIC\n"
      "         1    1.6E-9  138000.0    9000.0    8000.0      0.02      0.03      0.40\n"
      "    7000.0    3500.0    6500.0       2.0\n"
      "       0.0       0.0       0.0       0.0       1.0       0.5\n"
      "       0.0       0.0       0.0       0.0       0.0       0.0      30.0\n");
  EXPECT_EQ(law.modulus_b, 9000);
  EXPECT_EQ(law.poisson_cb, 0.4);
  EXPECT_EQ(law.shear_bc, 3500);
  EXPECT_EQ(law.axes, model::OrthotropicElastic::Axes::Vector);
  EXPECT_EQ(law.direction, (std::array<double, 3>{0, 1, 0.5}));
  EXPECT_NEAR(law.angle, 0.52359877559829887, 1e-15);
  EXPECT_GT(law.youngs_modulus, 100000);
  const auto crossed =
      law_of<model::OrthotropicElastic>("*MAT_002\n1,1.6E-9,138000,9000,8000\n7000,3500,6500,3\n\n0,0,1\n");
  EXPECT_EQ(crossed.axes, model::OrthotropicElastic::Axes::CrossNormal);
  EXPECT_EQ(crossed.direction[2], 1);
}

TEST(CompositeMaterial, Enhanced) {
  const std::string start =
      "_TITLE\nply\n         1    1.5E-9  127000.0    8400.0       0.0     0.021\n"
      "    4200.0    4100.0    3000.0       0.0       3.0\n"
      "       0.0       0.0       0.0       0.0       0.0       0.0      30.0\n"
      "       0.0       1.0       0.5       0.0       0.0       0.0      0.04      0.05\n"
      "       0.0     1E-11       0.5       0.4       1.5      0.03     -0.02       0.2\n"
      "   -1470.0    2200.0     199.0      49.0     154.0";
  const auto law =
      law_of<model::CompositeDamage>("*MAT_ENHANCED_COMPOSITE_DAMAGE" + start + "      54.0       0.7\n");
  EXPECT_EQ(law.modulus_c, 8400);
  EXPECT_EQ(law.shear_bc, 4100);
  EXPECT_EQ(law.axes, model::OrthotropicElastic::Axes::CrossNormal);
  EXPECT_EQ(law.direction, (std::array<double, 3>{0, 1, 0.5}));
  EXPECT_NEAR(law.angle, 0.52359877559829887, 1e-15);
  EXPECT_EQ(law.matrix, model::CompositeDamage::Matrix::Chang);
  EXPECT_EQ(law.compression_a, 1470);
  EXPECT_EQ(law.tension_a, 2200);
  EXPECT_EQ(law.compression_b, 199);
  EXPECT_EQ(law.tension_b, 49);
  EXPECT_EQ(law.shear_strength, 154);
  EXPECT_EQ(law.shear_in_fibre_mode, 0.7);
  EXPECT_EQ(law.shear_softening, 1e-11);
  EXPECT_EQ(law.fibre_tension_left, 0.4);
  EXPECT_EQ(law.fibre_compression_by_matrix, 1.5);
  EXPECT_EQ(law.failure_tension, 0.03);
  EXPECT_EQ(law.failure_compression, -0.02);
  EXPECT_EQ(law.failure_matrix, 0.04);
  EXPECT_EQ(law.failure_shear, 0.05);
  EXPECT_EQ(law.failure_effective, 0.2);
  EXPECT_FALSE(law.goes_by_fibre_tension);
  EXPECT_GT(law.youngs_modulus, 100000);
  EXPECT_EQ(messages_of("*MAT_054" + start + "      55.0\n").size(), 5U) << "strains of failure are left out";
  EXPECT_EQ(messages_of("*MAT_055" + start + "\n").size(), 5U);
}

TEST(CompositeMaterial, DefaultsOfEnhanced) {
  const std::string cards =
      "\n1,1.5E-9,127000,8400,0,0.021\n4200,3000,4200\n\n\n,,,,,,,\n1470,2200,199,49,154\n";
  const auto law = law_of<model::CompositeDamage>("*MAT_54" + cards);
  EXPECT_EQ(law.matrix, model::CompositeDamage::Matrix::Chang);
  EXPECT_EQ(law.fibre_compression_by_matrix, 2);
  EXPECT_EQ(law.fibre_tension_left, 0);
  EXPECT_TRUE(law.goes_by_fibre_tension);
  EXPECT_EQ(law_of<model::CompositeDamage>("*MAT_055" + cards).matrix,
            model::CompositeDamage::Matrix::TsaiWu);
}

TEST(CompositeMaterial, Damage) {
  const auto law = law_of<model::CompositeDamage>(
      "*MAT_022\n1,1.5E-9,127000,8400,9000,0.021,0.03,0.04\n4200,3000,4200,0,2\n0,0,0,0,1,0\n0,0,0,0,0,0,-"
      "45\n"
      "154,2200,49,199,2E-8\n");
  EXPECT_EQ(law.modulus_c, 9000);
  EXPECT_EQ(law.poisson_cb, 0.04);
  EXPECT_EQ(law.matrix, model::CompositeDamage::Matrix::ChangShear);
  EXPECT_EQ(law.shear_strength, 154);
  EXPECT_EQ(law.tension_a, 2200);
  EXPECT_EQ(law.tension_b, 49);
  EXPECT_EQ(law.compression_b, 199);
  EXPECT_EQ(law.shear_softening, 2e-8);
  EXPECT_EQ(law.shear_in_fibre_mode, 1);
  EXPECT_FALSE(law.goes_by_fibre_tension);
  EXPECT_NEAR(law.angle, -0.78539816339744828, 1e-15);
  EXPECT_EQ(law.direction, (std::array<double, 3>{0, 1, 0}));
}

TEST(CompositeMaterial, Faults) {
  const auto only = [](const std::string& fourth, const std::string& fifth, const std::string& rest,
                       const std::string& expected) {
    const auto messages = messages_of("*MAT_054\n1,1.5E-9,127000,8400,0,0.021\n4200,3000,4200\n\n" + fourth +
                                      "\n" + fifth + "\n" + rest);
    ASSERT_EQ(messages.size(), 1U) << rest;
    EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
  };
  const std::string strengths = "1470,2200,199,49,154\n";
  only("", "1E-8", strengths, "field TFAIL");
  only("", "", "1470,2200,199,0,154\n", "field YT");
  only("", "", "0,2200,199,49,154\n", "field XC");
  only("", "", "1470,2200,199,49,154,22\n", "field CRIT");
  only("", "", "1470,2200,199,49,154,54,2\n", "field BETA");
  only("", ",,,1.5", strengths, "field FBRT");
  only("", ",,,,,0.02,0.01", strengths, "field DFAILC");
  only(",,,,,,0.02", "", strengths, "field DFAILM");
  only("", "", strengths + ",0.1\n", "field EPSF");
  only("", "", strengths + "\n0.5\n", "field SLIMT1");
  only("", "", strengths + "\n\n7\n", "field LCXC");
}

TEST(ElasticMaterial, OrthotropicFaults) {
  const auto only = [](const std::string& text, const std::string& expected) {
    const auto messages = messages_of(text);
    ASSERT_EQ(messages.size(), 1U) << text;
    EXPECT_NE(messages[0].find(expected), std::string::npos) << messages[0];
  };
  only("*MAT_002\n1,1.6E-9,138000,9000,8000,0.3\n7000,3500,6500\n\n\n", "field PRBA");
  only("*MAT_002\n1,1.6E-9,138000,9000,8000\n7000,3500,6500,2\n\n\n", "field A1");
  only("*MAT_002\n1,1.6E-9,138000,9000,8000\n7000,3500,6500,4\n\n\n", "field AOPT");
  only("*MAT_002\n1,1.6E-9,138000,9000,8000\n7000,0,6500\n\n\n", "field GBC");
}

TEST(ElasticMaterial, AngleOfTheElement) {
  SmallDeck deck;
  deck.shells =
      "*ELEMENT_SHELL_BETA\n      11       1       1       2       3       4\n"
      "             0.0             0.0             0.0             0.0            90.0\n"
      "      12       1       2       5       6       3\n\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_NEAR(model.shells[0].material_angle, std::acos(0.0), 1e-15);
  EXPECT_EQ(model.shells[1].material_angle, 0);
  EXPECT_EQ(model::shell_thickness(model, model.shells[0])[0], 0.1);
}

TEST(ElasticMaterial, Null) {
  const auto law = law_of<model::NullMaterial>("*MAT_NULL\n1,7.83E-9,0,0,0,0,210000,0.3\n");
  EXPECT_EQ(law.youngs_modulus, 210000);
  EXPECT_EQ(law.poissons_ratio, 0.3);
  const auto fluid = law_of<model::NullMaterial>("*MAT_NULL\n1,7.83E-9,-0.1,1E-9,1.1,0.8,210000,0.3\n");
  EXPECT_EQ(fluid.least_pressure, -0.1);
  EXPECT_EQ(fluid.viscosity, 1e-9);
  EXPECT_EQ(fluid.largest_volume, 1.1);
  EXPECT_EQ(fluid.smallest_volume, 0.8);
  // Shells need it for contact alone.
  EXPECT_TRUE(messages_of("*MAT_009\n1,7.83E-9\n").empty());
}

constexpr const char* two_curves =
    "*DEFINE_CURVE\n21\n0.0,0.2\n0.1,0.3\n"
    "*DEFINE_CURVE\n22\n0.0,0.3\n0.2,0.5\n";

TEST(RateMaterial, TableOfCurvesInOrder) {
  const auto law = law_of<model::PiecewiseLinearPlasticity>(
      "*DEFINE_CURVE\n9\n0,0\n1,1\n"
      "*MAT_024\n1,7.83E-6,200,0.3\n0,0,12\n\n\n"
      "*DEFINE_TABLE\n12,2.0,0.5\n0.0\n10.0\n" +
      std::string(two_curves));
  ASSERT_EQ(law.by_rate.size(), 2U);
  EXPECT_FALSE(law.logarithmic_rates);
  EXPECT_EQ(law.by_rate[0].rate, 1);
  EXPECT_EQ(law.by_rate[1].rate, 21);
  EXPECT_EQ(law.by_rate[0].yield_stress[1], 0.3);
  EXPECT_EQ(law.by_rate[1].plastic_strain[1], 0.2);
  // Continued with the last slope.
  EXPECT_NEAR(law.by_rate[0].yield_stress.back(), 0.2 + 10, 1e-12);
}

TEST(RateMaterial, TableByCurveNumbersWithLogarithms) {
  const auto law = law_of<model::PiecewiseLinearPlasticity>(
      "*MAT_024\n1,7.83E-6,200,0.3\n0,0,12\n\n\n" + std::string(two_curves) +
      "*DEFINE_TABLE_2D\n12\n                -6.9                  22\n                 2.3                  "
      "21\n");
  ASSERT_EQ(law.by_rate.size(), 2U);
  EXPECT_TRUE(law.logarithmic_rates);
  EXPECT_EQ(law.by_rate[0].rate, -6.9);
  EXPECT_EQ(law.by_rate[0].yield_stress[0], 0.3);
  EXPECT_EQ(law.by_rate[1].yield_stress[0], 0.2);
}

TEST(RateMaterial, TableWhoseLinesNameTheirCurves) {
  const std::string start = "*MAT_024\n1,7.83E-6,200,0.3\n0,0,12\n\n\n" + std::string(two_curves);
  const auto law =
      law_of<model::PiecewiseLinearPlasticity>(start +
                                               "*DEFINE_TABLE\n12\n                 1.0                  "
                                               "22\n                10.0                  21\n");
  ASSERT_EQ(law.by_rate.size(), 2U);
  EXPECT_EQ(law.by_rate[0].yield_stress[0], 0.3);
  EXPECT_EQ(law.by_rate[1].yield_stress[0], 0.2);
  const auto mixed = messages_of(start + "*DEFINE_TABLE\n12\n1.0,22\n10.0\n");
  ASSERT_FALSE(mixed.empty());
  EXPECT_NE(mixed[0].find("all values of a table name their curves"), std::string::npos) << mixed[0];
}

TEST(RateMaterial, LogarithmicInterpolationOfRates) {
  const auto material = [](const std::string& first) {
    return "*MAT_PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION\n1,7.83E-6,200,0.3\n0,0,12\n\n\n" +
           std::string(two_curves) + "*DEFINE_TABLE_2D\n12\n" + first + ",21\n100,22\n";
  };
  const auto law = law_of<model::PiecewiseLinearPlasticity>(material("0.01"));
  EXPECT_TRUE(law.logarithmic_rates);
  EXPECT_DOUBLE_EQ(law.by_rate[0].rate, std::log(0.01));
  EXPECT_DOUBLE_EQ(law.by_rate[1].rate, std::log(100.0));
  // They are logarithms already.
  EXPECT_EQ(law_of<model::PiecewiseLinearPlasticity>(material("-4")).by_rate[1].rate, 100);
  const auto messages = messages_of(material("0"));
  ASSERT_FALSE(messages.empty());
  EXPECT_NE(messages[0].find("has no logarithm"), std::string::npos) << messages[0];
}

TEST(RateMaterial, CurveOfFactors) {
  const auto law = law_of<model::PiecewiseLinearPlasticity>(
      "*MAT_024\n1,7.83E-6,200,0.3,0.25\n0,0,0,7\n\n\n*DEFINE_CURVE\n7\n1,1.1\n100,1.5\n");
  EXPECT_EQ(law.factor_rate, (std::vector<double>{0, 1, 100}));
  EXPECT_EQ(law.rate_factor, (std::vector<double>{1.1, 1.1, 1.5}));
  const auto messages =
      messages_of("*MAT_024\n1,7.83E-6,200,0.3,0.25\n0,0,0,7\n\n\n*DEFINE_CURVE\n7\n1,0\n100,1.5\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("curve 7 gives the factor 0"), std::string::npos);
}

TEST(RateMaterial, TableFaults) {
  const std::string start = "*MAT_024\n1,7.83E-6,200,0.3\n0,0,12\n\n\n";
  const auto first = [](const std::vector<std::string>& messages) {
    return messages.empty() ? std::string("none") : messages[0];
  };
  EXPECT_NE(first(messages_of(start + "*DEFINE_TABLE\n12\n2.0\n1.0\n" + two_curves)).find("field VALUE"),
            std::string::npos);
  EXPECT_NE(first(messages_of(start + "*DEFINE_TABLE\n12\n")).find("has no values"), std::string::npos);
  EXPECT_NE(first(messages_of(start + "*DEFINE_TABLE_2D\n12\n1.0,99\n")).find("field CURVEID"),
            std::string::npos);
}

TEST(RateMaterial, ModifiedPiecewiseLinearWithEveryValue) {
  for (const std::string keyword : {"*MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY", "*MAT_123"}) {
    const auto law = law_of<model::PiecewiseLinearPlasticity>(
        keyword + "\n1,7.83E-6,200,0.3,0.25,2.0,0.3\n40,5,0,0,1,0.2,0.15,3\n0,0.1\n0.25,0.4\n");
    EXPECT_EQ(law.failure_strain, 0.3);
    EXPECT_EQ(law.failure_thinning, 0.2);
    EXPECT_EQ(law.failure_major, 0.15);
    EXPECT_EQ(law.failed_points, 3);
    EXPECT_EQ(law.failed_share, 0);
    EXPECT_TRUE(law.viscoplastic);
    EXPECT_EQ(law.cowper_symonds_rate, 40);
    EXPECT_EQ(law.yield_stress.at(1), 0.4);
  }
  const std::string start = "*MAT_123\n1,7.83E-6,200,0.3,0.25\n0,0,0,0,0,";
  EXPECT_EQ(law_of<model::PiecewiseLinearPlasticity>(start + "0,0,-60\n").failed_share, 0.6);
  EXPECT_FALSE(has_strain_limits(law_of<model::PiecewiseLinearPlasticity>(start + "1E20\n")));
  const auto only = [&](const std::string& fields, const std::string& part) {
    const auto messages = messages_of(start + fields + "\n");
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages[0].find(part), std::string::npos) << messages[0];
  };
  only("0,-0.2", "field EPSMAJ");
  only("-0.2", "field EPSTHIN");
  only("0,0,2.5", "field NUMINT");
  only("0,0,-101", "field NUMINT");
}

}  // namespace
}  // namespace crumple::deck::test::materials_test
