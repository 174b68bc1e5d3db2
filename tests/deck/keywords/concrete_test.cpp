// SPDX-License-Identifier: BSD-3-Clause
// *MAT_CSCM, *MAT_CSCM_CONCRETE.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::concrete_test {
namespace {

model::CapConcrete clean(const std::string& material) {
  return law_of_cube<model::CapConcrete>(material);
}

const std::string own =
    "*MAT_CSCM\n1,2.4E-9,2,0.001,1,1.05,10.4,0\n0.2\n"
    "11460,12550,14.5,0.297,10.5,0.0193,1,0\n"
    "0.747,0.0011,0.17,0.0706,0.66,0.0013,0.16,0.0716\n"
    "5,90.5,0.05,2.5E-4,3.49E-7\n"
    "101,7.2,0.11,0.072,0.073,5.5,1.5,0.1\n"
    "1.0E-4,0.78,6.2E-5,0.48,21,22,1.1,0.9\n";
const std::string by_strength = "*MAT_CSCM_CONCRETE\n1,2.4E-9,1,0,0,0.99,0,0\n0\n38,25,2\n";

TEST(ConcreteMaterial, EveryField) {
  for (const std::string keyword : {"*MAT_CSCM", "*MAT_159"}) {
    const model::CapConcrete law = clean(replaced(own, "*MAT_CSCM", keyword));
    EXPECT_TRUE(law.has_rate_effects);
    EXPECT_TRUE(law.erodes);
    EXPECT_NEAR(law.erosion_strain, 0.05, 1e-15);
    EXPECT_TRUE(law.recovers_by_volume);
    EXPECT_NEAR(law.kept_damage, 0.4, 1e-14);
    EXPECT_EQ(law.first_damage, 0.2);
    EXPECT_EQ(law.shear_modulus, 11460);
    EXPECT_EQ(law.bulk_modulus, 12550);
    EXPECT_NEAR(law.youngs_modulus, 9.0 * 12550 * 11460 / (3 * 12550 + 11460), 1e-9);
    EXPECT_NEAR(law.youngs_modulus / (2 * (1 + law.poissons_ratio)), 11460, 1e-9);
    EXPECT_EQ(law.compression.constant, 14.5);
    EXPECT_EQ(law.compression.linear, 0.297);
    EXPECT_EQ(law.compression.nonlinear, 10.5);
    EXPECT_EQ(law.compression.exponent, 0.0193);
    EXPECT_EQ(law.torsion.constant, 0.747);
    EXPECT_EQ(law.torsion.linear, 0.0011);
    EXPECT_EQ(law.torsion.nonlinear, 0.17);
    EXPECT_EQ(law.torsion.exponent, 0.0706);
    EXPECT_EQ(law.extension.constant, 0.66);
    EXPECT_EQ(law.extension.linear, 0.0013);
    EXPECT_EQ(law.extension.nonlinear, 0.16);
    EXPECT_EQ(law.extension.exponent, 0.0716);
    EXPECT_EQ(law.cap_ratio, 5);
    EXPECT_EQ(law.cap_start, 90.5);
    EXPECT_EQ(law.crush_volume, 0.05);
    EXPECT_EQ(law.crush_linear, 2.5e-4);
    EXPECT_EQ(law.crush_quadratic, 3.49e-7);
    EXPECT_EQ(law.ductile_shape, 101);
    EXPECT_EQ(law.compression_energy, 7.2);
    EXPECT_EQ(law.brittle_shape, 0.11);
    EXPECT_EQ(law.tension_energy, 0.072);
    EXPECT_EQ(law.shear_energy, 0.073);
    EXPECT_EQ(law.compression_power, 5.5);
    EXPECT_EQ(law.tension_power, 1.5);
    EXPECT_EQ(law.pressure_power, 0.1);
    EXPECT_EQ(law.compression_rate.coefficient, 1e-4);
    EXPECT_EQ(law.compression_rate.exponent, 0.78);
    EXPECT_EQ(law.compression_rate.limit, 21);
    EXPECT_EQ(law.tension_rate.coefficient, 6.2e-5);
    EXPECT_EQ(law.tension_rate.exponent, 0.48);
    EXPECT_EQ(law.tension_rate.limit, 22);
    EXPECT_EQ(law.shear_fluidity, 1.1);
    EXPECT_EQ(law.energy_power, 0.9);
  }
}

TEST(ConcreteMaterial, ByStrength) {
  for (const std::string keyword : {"*MAT_CSCM_CONCRETE", "*MAT_159_CONCRETE"}) {
    const model::CapConcrete law = clean(replaced(by_strength, "*MAT_CSCM_CONCRETE", keyword));
    EXPECT_EQ(law.compression.constant, model::normal_strength_concrete(38, 25, {}).compression.constant);
    EXPECT_EQ(law.tension_energy, model::normal_strength_concrete(38, 25, {}).tension_energy);
    EXPECT_FALSE(law.has_rate_effects);
    EXPECT_FALSE(law.erodes);
    EXPECT_EQ(law.kept_damage, 0);
  }
  const model::CapConcrete titled =
      clean("*MAT_CSCM_CONCRETE_TITLE\nbarrier\n1,2.4E-9,1,0,0,1.0,1,0\n\n0,0,2\n");
  EXPECT_EQ(titled.compression.constant, model::normal_strength_concrete(30, 19, {}).compression.constant);
  EXPECT_TRUE(titled.erodes);
  EXPECT_EQ(titled.erosion_strain, 0);
  EXPECT_EQ(titled.kept_damage, 1);
}

/// The same concrete in the units of every UNITS.
TEST(ConcreteMaterial, Units) {
  const model::CapConcrete metric = clean("*MAT_CSCM_CONCRETE\n1,2.4E-9\n\n30,19,2\n");
  const auto check = [&](const std::string& card, double stress, double length, double time) {
    const model::CapConcrete law = clean("*MAT_CSCM_CONCRETE\n1,1\n\n" + card + "\n");
    const auto near = [](double a, double b) { EXPECT_NEAR(a / b, 1, 1e-9); };
    near(law.youngs_modulus * stress, metric.youngs_modulus);
    near(law.compression.nonlinear * stress, metric.compression.nonlinear);
    near(law.extension.linear / stress, metric.extension.linear);
    near(law.crush_quadratic / (stress * stress), metric.crush_quadratic);
    near(law.compression_energy * stress * length, metric.compression_energy);
    near(law.tension_rate.limit * stress, metric.tension_rate.limit);
    // eta at 2 /s is a time.
    const auto eta = [](const model::CapConcrete& of, double rate) {
      return of.compression_rate.coefficient / std::pow(rate, of.compression_rate.exponent);
    };
    near(eta(law, 2 * time) * time, eta(metric, 2));
  };
  check("0.03,19,0", 1000, 1, 1e-3);
  check("30,19,1", 1, 1, 1e-3);
  check("4351.132132,0.748031496,3", 0.00689475729, 25.4, 1);
  check("3.0E7,0.019,4", 1e-6, 1000, 1);
}

TEST(ConcreteMaterial, Faults) {
  const auto with = [](const std::string& from, const std::string& to) {
    return messages_of_cube(replaced(own, from, to));
  };
  only_message(with("1.05,10.4,0", "1.05,10.4,1"), "field ITRETRC");
  only_message(with("1.05,10.4,0", "1.05,1.4,0"), "field RECOV");
  only_message(with("0.001,1,", "0.001,2,"), "field IRATE");
  only_message(with("\n0.2\n", "\n1.0\n"), "field PRED");
  only_message(with(",1,0\n0.747", ",0.7,0\n0.747"), "field NH");
  only_message(with(",1,0\n0.747", ",1,100\n0.747"), "field CH");
  only_message(with("14.5,0.297,10.5", "14.5,0.297,15"), "field LAMDA");
  only_message(with("5,90.5", "0,90.5"), "field R:");
  only_message(with("7.2,0.11,0.072", "7.2,0.11,0"), "field GFT");
  only_message(with("0.78,6.2E-5", "1.2,6.2E-5"), "field NC");
  only_message(messages_of_cube(replaced(by_strength, "38,25,2", "38,25,5")), "field UNITS");
  only_message(messages_of_cube(replaced(by_strength, "38,25,2", "0.038,25,2")), "which is no concrete");
  only_message(messages_of_cube(replaced(by_strength, "38,25,2", "15,25,2")), "fitted from 20 to 58 MPa");
}

TEST(ConcreteMaterial, IsForSolidsAlone) {
  SmallDeck deck;
  deck.material = own;
  bool is_refused = false;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    is_refused = is_refused || to_string(diagnostic).find("is there for solids only") != std::string::npos;
  EXPECT_TRUE(is_refused);
}

}  // namespace
}  // namespace crumple::deck::test::concrete_test
