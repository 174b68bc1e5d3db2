// SPDX-License-Identifier: BSD-3-Clause
// *MAT_JOHNSON_HOLMQUIST_CERAMICS, *MAT_JOHNSON_HOLMQUIST_CONCRETE.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::johnson_holmquist_test {
namespace {

const std::string ceramic =
    "*MAT_JOHNSON_HOLMQUIST_CERAMICS\n1,3.7E-9,90160,0.93,0.31,0.007,0.61,0.6\n"
    "10,200,0.5,2790,1460,0.9\n0.005,1.1,130950,1000,-2000,1.5\n";
const std::string concrete =
    "*MAT_JOHNSON_HOLMQUIST_CONCRETE\n1,2.44E-9,14860,0.79,1.6,0.007,0.61,48\n"
    "4,2,0.01,7,16,0.001,800,0.1\n0.04,1.1,85000,-171000,208000,0.3\n";

TEST(JohnsonHolmquistMaterial, EveryFieldOfCeramics) {
  for (const std::string keyword : {"*MAT_JOHNSON_HOLMQUIST_CERAMICS", "*MAT_110"}) {
    const auto law =
        law_of_cube<model::HolmquistCeramic>(replaced(ceramic, "*MAT_JOHNSON_HOLMQUIST_CERAMICS", keyword));
    EXPECT_EQ(law.shear_modulus, 90160);
    EXPECT_EQ(law.intact_factor, 0.93);
    EXPECT_EQ(law.fractured_factor, 0.31);
    EXPECT_EQ(law.rate_coefficient, 0.007);
    EXPECT_EQ(law.fractured_power, 0.61);
    EXPECT_EQ(law.intact_power, 0.6);
    EXPECT_EQ(law.reference_rate, 10);
    EXPECT_EQ(law.tension, 200);
    EXPECT_EQ(law.largest_fractured, 0.5);
    EXPECT_EQ(law.elastic_limit, 2790);
    EXPECT_EQ(law.limit_pressure, 1460);
    EXPECT_EQ(law.bulking, 0.9);
    EXPECT_EQ(law.fracture_factor, 0.005);
    EXPECT_EQ(law.fracture_power, 1.1);
    EXPECT_EQ(law.bulk_modulus, 130950);
    EXPECT_EQ(law.bulk_quadratic, 1000);
    EXPECT_EQ(law.bulk_cubic, -2000);
    EXPECT_EQ(law.erosion.plastic_strain, 1.5);
    EXPECT_FALSE(law.erosion.at_tension);
    EXPECT_NEAR(law.youngs_modulus, 9.0 * 130950 * 90160 / (3 * 130950 + 90160), 1e-9);
    EXPECT_NEAR(law.youngs_modulus / (2 * (1 + law.poissons_ratio)), 90160, 1e-9);
  }
}

TEST(JohnsonHolmquistMaterial, EveryFieldOfConcrete) {
  for (const std::string keyword : {"*MAT_JOHNSON_HOLMQUIST_CONCRETE", "*MAT_111"}) {
    const auto law =
        law_of_cube<model::HolmquistConcrete>(replaced(concrete, "*MAT_JOHNSON_HOLMQUIST_CONCRETE", keyword));
    EXPECT_EQ(law.shear_modulus, 14860);
    EXPECT_EQ(law.cohesion, 0.79);
    EXPECT_EQ(law.pressure_factor, 1.6);
    EXPECT_EQ(law.rate_coefficient, 0.007);
    EXPECT_EQ(law.pressure_power, 0.61);
    EXPECT_EQ(law.strength, 48);
    EXPECT_EQ(law.tension, 4);
    EXPECT_EQ(law.reference_rate, 2);
    EXPECT_EQ(law.least_fracture, 0.01);
    EXPECT_EQ(law.largest_strength, 7);
    EXPECT_EQ(law.crush_pressure, 16);
    EXPECT_EQ(law.crush_volume, 0.001);
    EXPECT_EQ(law.lock_pressure, 800);
    EXPECT_EQ(law.lock_volume, 0.1);
    EXPECT_EQ(law.fracture_factor, 0.04);
    EXPECT_EQ(law.fracture_power, 1.1);
    EXPECT_EQ(law.bulk_modulus, 85000);
    EXPECT_EQ(law.bulk_quadratic, -171000);
    EXPECT_EQ(law.bulk_cubic, 208000);
    EXPECT_EQ(law.erosion.plastic_strain, 0.3);
    EXPECT_FALSE(law.erosion.at_tension);
    EXPECT_NEAR(law.youngs_modulus / (3 * (1 - 2 * law.poissons_ratio)), 16000, 1e-9);
  }
}

TEST(JohnsonHolmquistMaterial, FsOfBothKeywords) {
  const auto erosion = [](const std::string& text, const std::string& old, const std::string& value) {
    const std::string changed = replaced(text, old, value);
    return text == ceramic ? law_of_cube<model::HolmquistCeramic>(changed).erosion
                           : law_of_cube<model::HolmquistConcrete>(changed).erosion;
  };
  const model::BrittleErosion kept = erosion(ceramic, ",1.5\n", "\n");
  EXPECT_FALSE(kept.at_tension);
  EXPECT_EQ(kept.plastic_strain, 0);
  const model::BrittleErosion pulled = erosion(ceramic, ",1.5\n", ",-1\n");
  EXPECT_TRUE(pulled.at_tension);
  EXPECT_FALSE(pulled.by_damage);
  const model::BrittleErosion torn = erosion(concrete, ",0.3\n", ",0\n");
  EXPECT_TRUE(torn.at_tension);
  EXPECT_FALSE(torn.by_damage);
  EXPECT_EQ(torn.plastic_strain, 0);
  const model::BrittleErosion worn = erosion(concrete, ",0.3\n", ",-1\n");
  EXPECT_TRUE(worn.at_tension);
  EXPECT_TRUE(worn.by_damage);
}

TEST(JohnsonHolmquistMaterial, ZeroOrHugeSfmaxIsNoLimit) {
  EXPECT_EQ(law_of_cube<model::HolmquistCeramic>(replaced(ceramic, ",0.5,", ",0,")).largest_fractured, 0);
  EXPECT_EQ(law_of_cube<model::HolmquistCeramic>(replaced(ceramic, ",0.5,", ",1E20,")).largest_fractured, 0);
  EXPECT_EQ(law_of_cube<model::HolmquistConcrete>(replaced(concrete, ",7,", ",,")).largest_strength, 0);
}

TEST(JohnsonHolmquistMaterial, AMissingReferenceRateMattersWhereThereIsARateEffect) {
  only_message(messages_of_cube(replaced(ceramic, "\n10,", "\n0,")), "EPS0");
  const std::string still = replaced(ceramic, ",0.007,", ",0,");
  EXPECT_EQ(law_of_cube<model::HolmquistCeramic>(replaced(still, "\n10,", "\n0,")).reference_rate, 1);
}

TEST(JohnsonHolmquistMaterial, ThePressureOfTheLimitIsBelowIt) {
  only_message(messages_of_cube(replaced(ceramic, ",1460,", ",2800,")), "PHEL");
}

}  // namespace
}  // namespace crumple::deck::test::johnson_holmquist_test
