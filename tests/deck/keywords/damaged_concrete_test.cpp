// SPDX-License-Identifier: BSD-3-Clause
// *MAT_CONCRETE_DAMAGE_REL3.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::damaged_concrete_test {
namespace {

model::ThreeSurfaceConcrete clean(const std::string& material) {
  return law_of_cube<model::ThreeSurfaceConcrete>(material);
}

const std::string by_strength =
    "*MAT_CONCRETE_DAMAGE_REL3\n1,2.4E-9,0.19\n0,-45.4\n100,2,1,0.03937,145,0,0,13\n\n\n\n\n";
const std::string given =
    "*MAT_CONCRETE_DAMAGE_REL3\n1,2.4E-9,0.2\n3.1,11,0.45,0.002,1.5,0.6,0.44\n"
    "100,2,1,0,145,0,30,13\n"
    "0,1E-5,2E-5,4E-5,6E-5,8E-5,1E-4,3E-4\n5E-4,6E-4,1,10,1E10,1.2,8,0.63\n"
    "0,0.8,0.9,0.95,1,0.98,0.96,0.6\n0.2,0.1,0.05,0.02,0,1.3,0.003,0.006\n";

TEST(DamagedConcrete, ByStrength) {
  for (const std::string keyword : {"*MAT_CONCRETE_DAMAGE_REL3", "*MAT_072R3"}) {
    const model::ThreeSurfaceConcrete law =
        clean(replaced(by_strength, "*MAT_CONCRETE_DAMAGE_REL3", keyword));
    const model::ThreeSurfaceConcrete same = model::three_surface_concrete(45.4, 0.19, 145, 0.03937);
    EXPECT_EQ(law.tensile_strength, same.tensile_strength);
    EXPECT_EQ(law.maximum.constant, same.maximum.constant);
    EXPECT_EQ(law.yield.second, same.yield.second);
    EXPECT_EQ(law.residual.first, same.residual.first);
    EXPECT_EQ(law.width, 1 / 0.03937);
    EXPECT_EQ(law.damage, same.damage);
    EXPECT_EQ(law.share, same.share);
    EXPECT_EQ(law.pressure, same.pressure);
    EXPECT_EQ(law.unloading, same.unloading);
    EXPECT_NEAR(law.youngs_modulus, 57000 * std::sqrt(45.4 * 145) / 145, 1e-6);
    EXPECT_EQ(law.poissons_ratio, 0.19);
  }
}

TEST(DamagedConcrete, NumbersThatAreGivenGoBeforeThoseOfTheStrength) {
  const model::ThreeSurfaceConcrete law = clean(
      "*MAT_CONCRETE_DAMAGE_REL3\n1,2.4E-9,0.19\n3,-45.4,0,0,1.7,0.8\n100,2,1,0.03937,145,0,20,13\n\n"
      "0,0,0,0,0,1.25\n\n0,0,0,0,0,1.45\n");
  EXPECT_EQ(law.tensile_strength, 3);
  EXPECT_EQ(law.compression_power, 1.7);
  EXPECT_EQ(law.dilatancy, 0.8);
  EXPECT_EQ(law.width, 20);
  EXPECT_EQ(law.opening_damage, 1.25);
  EXPECT_EQ(law.tension_power, 1.45);
  EXPECT_EQ(law.maximum.first, 0.4463);
}

TEST(DamagedConcrete, EveryField) {
  const model::ThreeSurfaceConcrete law = clean(given);
  EXPECT_EQ(law.tensile_strength, 3.1);
  EXPECT_EQ(law.maximum.constant, 11);
  EXPECT_EQ(law.maximum.first, 0.45);
  EXPECT_EQ(law.maximum.second, 0.002);
  EXPECT_EQ(law.compression_power, 1.5);
  EXPECT_EQ(law.dilatancy, 0.6);
  EXPECT_EQ(law.residual.first, 0.44);
  EXPECT_EQ(law.residual.second, 0.003);
  EXPECT_EQ(law.width, 30);
  EXPECT_EQ(law.opening_damage, 1.2);
  EXPECT_EQ(law.yield.constant, 8);
  EXPECT_EQ(law.yield.first, 0.63);
  EXPECT_EQ(law.yield.second, 0.006);
  EXPECT_EQ(law.tension_power, 1.3);
  EXPECT_EQ(law.damage,
            (std::vector<double>{0, 1e-5, 2e-5, 4e-5, 6e-5, 8e-5, 1e-4, 3e-4, 5e-4, 6e-4, 1, 10, 1e10}));
  EXPECT_EQ(law.share, (std::vector<double>{0, 0.8, 0.9, 0.95, 1, 0.98, 0.96, 0.6, 0.2, 0.1, 0.05, 0.02, 0}));
  const double strength = model::unconfined_strength(law.maximum);
  const double p = strength / 3;
  EXPECT_NEAR(11 + p / (0.45 + 0.002 * p), strength, 1e-9);
  EXPECT_NEAR(law.youngs_modulus, 57000 * std::sqrt(strength * 145) / 145, 1e-6);
}

TEST(DamagedConcrete, RatesByACurveOrByTheStrength) {
  const std::string with_curve = replaced(by_strength, "0.03937,145,0", "0.03937,145,7");
  const model::ThreeSurfaceConcrete law =
      clean(with_curve + "*DEFINE_CURVE\n7\n-30,6\n-1,2\n0,1\n10,1.2\n100,1.5\n");
  EXPECT_EQ(law.tension_rates.rate, (std::vector<double>{0, 1, 30}));
  EXPECT_EQ(law.tension_rates.factor, (std::vector<double>{1, 2, 6}));
  EXPECT_EQ(law.compression_rates.rate, (std::vector<double>{0, 10, 100}));
  EXPECT_EQ(law.compression_rates.factor, (std::vector<double>{1, 1.2, 1.5}));
  // One that begins at zero holds for both.
  const model::ThreeSurfaceConcrete alike = clean(with_curve + "*DEFINE_CURVE\n7\n0,1\n10,1.2\n");
  EXPECT_EQ(alike.tension_rates.factor, alike.compression_rates.factor);
  EXPECT_TRUE(clean(by_strength).tension_rates.rate.empty());

  model::ThreeSurfaceConcrete same;
  model::set_rate_factors(same, 45.4, 145, 1);
  const model::ThreeSurfaceConcrete own = clean(replaced(by_strength, "0.03937,145,0", "0.03937,145,-1"));
  ASSERT_EQ(own.tension_rates.rate.size(), same.tension_rates.rate.size());
  EXPECT_NEAR(own.tension_rates.factor.back(), same.tension_rates.factor.back(), 1e-9);
  // kg, mm, ms: GPa.
  const model::ThreeSurfaceConcrete other =
      clean("*MAT_072R3\n1,2.4E-6,0.19\n0,-0.0454\n100,2,1,0.03937,145000,-1,0,13\n\n\n\n\n");
  EXPECT_NEAR(other.tension_rates.rate.back(), 1e-3 * own.tension_rates.rate.back(), 1e-9);
  EXPECT_NEAR(other.tension_rates.factor.back(), own.tension_rates.factor.back(), 1e-9);
}

TEST(DamagedConcrete, WrongFields) {
  const std::string with_curve = replaced(by_strength, "0.03937,145,0", "0.03937,145,7");
  only_message(messages_of_cube(with_curve), "LCRATE");
  only_message(messages_of_cube(with_curve + "*DEFINE_CURVE\n7\n-1,0.5\n10,1.2\n"), "factors of at least 1");
  only_message(messages_of_cube(replaced(by_strength, "0.03937,145,0", "0.03937,145,-2")),
               "a curve, 0 or -1");
  only_message(messages_of_cube("*MAT_072R3\n1,2.4E-10,0.19\n0,-45.4\n100,2,1,0.03937,145,-1,0,13\n\n\n\n\n"),
               "RO is far from that of concrete");
  only_message(messages_of_cube(replaced(by_strength, "100,2,1,", "100,2,3,")), "EDROP");
  only_message(messages_of_cube(replaced(by_strength, "0.03937,145,0,0,13", "0.03937,145,0,0,9")), "NPTS");
  only_message(messages_of_cube(replaced(by_strength, "0.03937,145", "0,145")), "RSIZE");
  only_message(messages_of_cube(replaced(by_strength, "0.03937,145", "0.03937,1.45E-4")),
               "which is no concrete");
  only_message(messages_of_cube(replaced(given, "3.1,11", "3.1,0")),
               "the bulk modulus follows from the strength");
  only_message(messages_of_cube(replaced(given, "4E-5,6E-5", "6E-5,6E-5")), "LAMBDA05");
  only_message(messages_of_cube(replaced(given, "4E-5,6E-5", "0,6E-5")), "LAMBDA05");
}

TEST(DamagedConcrete, ABlankEndLeavesTheTableShort) {
  const std::string short_table = replaced(given, "5E-4,6E-4,1,10,1E10", "5E-4,6E-4,,,");
  EXPECT_EQ(clean(short_table).damage,
            (std::vector<double>{0, 1e-5, 2e-5, 4e-5, 6e-5, 8e-5, 1e-4, 3e-4, 5e-4, 6e-4}));
}

}  // namespace
}  // namespace crumple::deck::test::damaged_concrete_test
