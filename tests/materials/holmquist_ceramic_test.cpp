// SPDX-License-Identifier: BSD-3-Clause
// Johnson & Holmquist's law of ceramics along given paths.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "materials/brittle_cases.hpp"
#include "materials/solid_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::holmquist_ceramic_test {
namespace {

class HolmquistCeramic : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, HolmquistCeramic, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Breaks at no plastic strain that a test reaches.
model::Material tough_ceramic() {
  model::Material material = alumina();
  ceramic_law(material).fracture_factor = 1e12;
  ceramic_law(material).bulking = 0;
  return material;
}
double limit_stress(const model::HolmquistCeramic& law) {
  return 1.5 * (law.elastic_limit - law.limit_pressure);
}
double intact(const model::HolmquistCeramic& law, double p) {
  return limit_stress(law) * law.intact_factor *
         std::pow(std::max((p + law.tension) / law.limit_pressure, 0.0), law.intact_power);
}
double fractured(const model::HolmquistCeramic& law, double p) {
  const double strength =
      law.fractured_factor * std::pow(std::max(p / law.limit_pressure, 0.0), law.fractured_power);
  return limit_stress(law) *
         (law.largest_fractured > 0 ? std::min(strength, law.largest_fractured) : strength);
}

TEST_P(HolmquistCeramic, PressureIsThePolynomialAndTheLimitInTension) {
  model::Material material = tough_ceramic();
  model::HolmquistCeramic& law = ceramic_law(material);
  law.bulk_quadratic = 2e5;
  law.bulk_cubic = -3e5;
  MotionDriver<double> point(material, GetParam());
  test::Largest off("ceramic, squeezed, released and pulled: pressure, error [MPa]", "K1, K2, K3 and T",
                    1e-8);
  for (int i = 1; i <= 300; ++i) {
    const double mu = i <= 150 ? 0.1 * i / 150 : 0.1 - 0.11 * (i - 150) / 150;
    point.move_to(squeezed_to(mu));
    const double curve =
        law.bulk_modulus * mu + (mu > 0 ? law.bulk_quadratic * mu * mu + law.bulk_cubic * mu * mu * mu : 0);
    off.compare(point.pressure(), std::max(curve, -law.tension));
  }
}

TEST_P(HolmquistCeramic, IntactStrengthFollowsThePressure) {
  model::Material material = tough_ceramic();
  const model::HolmquistCeramic& law = ceramic_law(material);
  test::Largest off("ceramic, intact, sheared from -150 to 6000 MPa: von Mises stress, error [MPa]",
                    "sigma_HEL A (P* + T*)^N", 1e-6);
  for (const double p : {-150.0, 0.0, 500.0, 1460.0, 6000.0}) {
    MotionDriver<double> point(material, GetParam());
    const Matrix f = squeezed_to(p / law.bulk_modulus);
    point.move_in_steps(f, 20);
    for (int i = 1; i <= 60; ++i) point.move_to(sheared(0.1 * i / 60, f));
    off.compare(equivalent(point.stress()), intact(law, p));
    EXPECT_NEAR(point.pressure(), p, 1e-6);
  }
}

TEST_P(HolmquistCeramic, FracturedStrengthFollowsThePressure) {
  for (const double largest : {0.0, 0.4}) {
    model::Material material = alumina();
    model::HolmquistCeramic& law = ceramic_law(material);
    law.fracture_factor = law.bulking = 0;
    law.largest_fractured = largest;
    test::Largest off(std::string("ceramic, fractured, SFMAX = ") + (largest > 0 ? "0.4" : "none") +
                          ": von Mises stress, error [MPa]",
                      "sigma_HEL B P*^M", 1e-6);
    for (const double p : {0.0, 500.0, 1460.0, 6000.0}) {
      MotionDriver<double> point(material, GetParam());
      const Matrix f = squeezed_to(p / law.bulk_modulus);
      point.move_in_steps(f, 20);
      for (int i = 1; i <= 60; ++i) point.move_to(sheared(0.1 * i / 60, f));
      EXPECT_EQ(point.item("damage"), 1);
      off.compare(equivalent(point.stress()), fractured(law, p));
    }
  }
}

/// At a constant pressure s = s_i - D (s_i - s_f) and D = (e - s/3G)/e_f have the solution below, e being the
/// effective strain.
TEST_P(HolmquistCeramic, DamageIsTheShareOfTheStrainToFracture) {
  model::Material material = alumina();
  model::HolmquistCeramic& law = ceramic_law(material);
  law.fracture_factor = 0.05;
  law.bulking = 0;
  test::Largest off("ceramic, sheared at 1000 and 3000 MPa: damage, error", "closed form", 2e-4);
  test::Largest stress("ceramic, sheared at 1000 and 3000 MPa: strength, relative error",
                       "s_i - D (s_i - s_f)", 1e-8);
  for (const double p : {1000.0, 3000.0}) {
    MotionDriver<double> point(material, GetParam());
    const Matrix f = squeezed_to(p / law.bulk_modulus);
    point.move_in_steps(f, 20);
    const double fracture =
        law.fracture_factor * std::pow((p + law.tension) / law.limit_pressure, law.fracture_power);
    const double start = intact(law, p);
    const double drop = start - fractured(law, p);
    constexpr int steps = 8000;
    for (int i = 1; i <= steps; ++i) {
      const double strain = 0.2 * i / steps;
      const double before = point.item("damage");
      point.move_to(sheared(strain * std::sqrt(3.0), f));
      const double flow = strain - start / (3 * law.shear_modulus);
      const double damage = std::clamp(flow / (fracture - drop / (3 * law.shear_modulus)), 0.0, 1.0);
      off.compare(point.item("damage"), damage);
      if (flow > 0) stress.compare(equivalent(point.stress()), start - before * drop, start);
    }
    EXPECT_EQ(point.item("damage"), 1);
  }
}

TEST_P(HolmquistCeramic, RatesRaiseTheStrength) {
  model::Material material = tough_ceramic();
  model::HolmquistCeramic& law = ceramic_law(material);
  law.rate_coefficient = 0.03;
  law.reference_rate = 10;
  test::Largest off("ceramic at 1 to 1e5/s: strength, relative error", "1 + C ln(rate/EPS0)", 1e-4);
  for (const double rate : {1.0, 100.0, 1e5}) {
    MotionDriver<double> point(material, GetParam());
    const Matrix f = squeezed_to(1000 / law.bulk_modulus);
    point.move_in_steps(f, 20);
    for (int i = 1; i <= 100; ++i) point.move_to(sheared(5e-4 * i * std::sqrt(3.0), f), 5e-4 / rate);
    const double factor = rate > 10 ? 1 + 0.03 * std::log(rate / 10) : 1;
    off.compare(equivalent(point.stress()), factor * intact(law, 1000), factor * intact(law, 1000));
  }
}

/// HEL and PHEL are figures of the experiment, A, N and T a fit of other ones: the stress along a confined
/// compression at which the law begins to flow must be HEL again.
TEST_P(HolmquistCeramic, ConfinedCompressionYieldsAtTheHugoniotElasticLimit) {
  MotionDriver<double> point(tough_ceramic(), GetParam());
  double stress = 0;
  double pressure = 0;
  for (int i = 1; i <= 2000 && !(point.item("plastic_strain") > 0); ++i) {
    stress = -point.stress()[1];
    pressure = point.pressure();
    point.move_to(confined(1e-5 * i));
  }
  test::verified("alumina, confined: stress at first flow over HEL, less 1", "published HEL of 2790 MPa")
      .below(std::fabs(stress / 2790 - 1), 0.02);
  test::verified("alumina, confined: pressure at first flow over PHEL, less 1", "published PHEL of 1460 MPa")
      .below(std::fabs(pressure / 1460 - 1), 0.02);
}

/// Strengths that do not depend on the pressure, so that the lost energy is that of two stresses.
TEST_P(HolmquistCeramic, BulkingKeepsItsShareOfTheElasticEnergy) {
  test::Largest off("ceramic, fractured at constant volume: bulking pressure, relative error",
                    "(K1 mu + dP)^2 = (K1 mu)^2 + 2 BETA K1 (U0 - U1)", 1e-9);
  for (const double share : {0.5, 1.0})
    for (const double mu : {0.0, 0.01}) {
      model::Material material = alumina();
      model::HolmquistCeramic& law = ceramic_law(material);
      law.intact_power = law.fractured_power = law.fracture_power = 0;
      law.fracture_factor = 0.02;
      law.fractured_factor = mu > 0 ? 0.31 : 0;
      law.bulking = share;
      MotionDriver<double> point(material, GetParam());
      const Matrix f = squeezed_to(mu);
      point.move_in_steps(f, 20);
      for (int i = 1; i <= 400; ++i) point.move_to(sheared(0.2 * i / 400, f));
      ASSERT_EQ(point.item("damage"), 1);
      const double before = std::pow(limit_stress(law) * law.intact_factor, 2);
      const double after = std::pow(limit_stress(law) * law.fractured_factor, 2);
      const double k1 = law.bulk_modulus;
      const double gain = 2 * share * k1 * (before - after) / (6 * law.shear_modulus);
      const double expected = std::sqrt(k1 * mu * k1 * mu + gain) - k1 * mu;
      EXPECT_GT(expected, 100);
      off.compare(point.item("bulking_pressure"), expected, expected);
      off.compare(point.pressure(), k1 * mu + expected, expected);
    }
}

TEST_P(HolmquistCeramic, DamageTakesTheStrengthInTension) {
  model::Material material = alumina();
  model::HolmquistCeramic& law = ceramic_law(material);
  law.fracture_factor = 0.5;
  law.bulking = 0;
  MotionDriver<double> point(material, GetParam());
  const Matrix f = squeezed_to(0.005);
  point.move_in_steps(f, 20);
  for (int i = 1; i <= 100; ++i) point.move_to(sheared(0.3 * i / 100, f));
  const double damage = point.item("damage");
  EXPECT_GT(damage, 0.2);
  EXPECT_LT(damage, 0.9);
  const double side = std::cbrt(1.05);
  Matrix apart = point.at();
  for (auto& row : apart)
    for (double& value : row) value *= side;
  point.move_to(apart);
  test::verified("ceramic, damaged and pulled: pressure, error [MPa]", "-T (1 - D)")
      .below(std::fabs(point.pressure() + law.tension * (1 - damage)), 1e-9);
}

TEST_P(HolmquistCeramic, PointsFailAsFsSays) {
  model::Material never = alumina();
  MotionDriver<double> kept(never, GetParam());
  EXPECT_FALSE(solid_can_fail(never));
  kept.move_to(squeezed_to(-0.01));
  EXPECT_LT(kept.pressure(), -199);

  model::Material torn = alumina();
  ceramic_law(torn).erosion = {true, false, 0};
  MotionDriver<double> pulled(torn, GetParam());
  const double limit = 200 / ceramic_law(torn).bulk_modulus;
  pulled.move_to(squeezed_to(-0.999 * limit));
  EXPECT_TRUE(pulled.intact());
  EXPECT_LT(pulled.pressure(), -199);
  pulled.move_to(squeezed_to(-1.001 * limit));
  EXPECT_FALSE(pulled.intact());
  EXPECT_EQ(pulled.pressure(), 0);
  pulled.move_to(squeezed_to(0.01));
  EXPECT_EQ(pulled.pressure(), 0);

  model::Material strained = alumina();
  ceramic_law(strained).erosion = {false, false, 0.02};
  MotionDriver<double> flowing(strained, GetParam());
  const Matrix f = squeezed_to(0.01);
  flowing.move_in_steps(f, 20);
  for (int i = 1; i <= 400; ++i) {
    flowing.move_to(sheared(0.1 * i / 400, f));
    EXPECT_EQ(flowing.intact(), flowing.item("plastic_strain") <= 0.02);
  }
  EXPECT_FALSE(flowing.intact());
}

TEST_P(HolmquistCeramic, ElasticWorkComesBack) {
  MotionDriver<double> point(tough_ceramic(), GetParam());
  double most = 0;
  for (int i = 1; i <= 400; ++i) {
    const double depth = 0.008 * (1 - std::fabs(i / 200.0 - 1));
    point.move_to({{{1 + 0.2 * depth, 0.3 * depth, 0}, {0, 1 - depth, 0}, {0, 0, 1 - 0.2 * depth}}});
    most = std::max(most, point.work());
  }
  EXPECT_EQ(point.item("plastic_strain"), 0);
  EXPECT_GT(most, 1);
  test::verified("ceramic, loaded below its strength and released: work over the largest", "0")
      .below(std::fabs(point.work() / most), 1e-4);
}

TEST_P(HolmquistCeramic, ATurnedObserverSeesTheTurnedStress) {
  const Matrix turn = turn_about({2.0 / 7, -3.0 / 7, 6.0 / 7}, 1.1);
  model::Material material = alumina();
  ceramic_law(material).rate_coefficient = 0.01;
  SolidDriver<double> one(material, GetParam());
  SolidDriver<double> other(material, GetParam());
  test::Largest off("ceramic, seen by a turned observer: stress, error [MPa]", "invariance", 1e-7);
  for (int i = 0; i < 120; ++i) {
    const Six strain{-5e-4 * std::cos(0.1 * i), -4e-4, 1e-4, 4e-4 * std::sin(0.2 * i), 3e-4, -2e-4};
    one.apply(strain, 1e-4);
    other.apply(rotated(strain, turn, 0.5), 1e-4);
    const Six expected = rotated(one.stress(), turn);
    for (int c = 0; c < 6; ++c) off.compare(other.stress()[c], expected[c]);
  }
}

TEST_P(HolmquistCeramic, WaveSpeedBoundsTheTangent) {
  model::Material material = tough_ceramic();
  ceramic_law(material).bulk_quadratic = 3e5;
  for (const double mu : {-0.001, 0.0, 0.02, 0.1}) {
    MotionDriver<double> point(material, GetParam());
    MotionDriver<double> moved(material, GetParam());
    point.move_to(squeezed_to(mu));
    moved.move_to(squeezed_to(mu));
    Matrix more = squeezed_to(mu);
    const double side = more[0][0];
    more[0][0] *= 1 - 1e-7;
    moved.move_to(more);
    const double slope = (point.stress()[0] - moved.stress()[0]) / 1e-7;
    const double stiffness = material.density / (side * side * side) * std::pow(point.wave_speed(), 2);
    EXPECT_GT(stiffness, 0.9999 * slope) << mu;
    EXPECT_LT(stiffness, 1.1 * slope) << mu;
  }
}

TEST_P(HolmquistCeramic, FloatAgreesWithDouble) {
  model::Material material = alumina();
  ceramic_law(material).fracture_factor = 0.05;
  MotionDriver<float> coarse(material, GetParam());
  MotionDriver<double> exact(material, GetParam());
  for (int i = 1; i <= 5000; ++i) {
    const double depth = 1e-5 * i;
    const Matrix f{{{1 - 0.3 * depth, 0.3 * depth, 0}, {0, 1 - depth, 0}, {0.1 * depth, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  EXPECT_GT(exact.item("damage"), 0.05);
  test::verified("ceramic, 5000 steps in single precision: stress over HEL, error", "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()) / 2790, 2e-3);
}

TEST(HolmquistCeramicConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(alumina()));
  const auto refuses = [](void (*change)(model::HolmquistCeramic&)) {
    model::Material material = alumina();
    change(ceramic_law(material));
    EXPECT_THROW(solid_material_constants(material), Error);
  };
  refuses([](model::HolmquistCeramic& law) { law.limit_pressure = 3000; });
  refuses([](model::HolmquistCeramic& law) { law.tension = 0; });
  refuses([](model::HolmquistCeramic& law) { law.intact_factor = 0; });
  refuses([](model::HolmquistCeramic& law) { law.fracture_factor = -1; });
  refuses([](model::HolmquistCeramic& law) { law.bulking = 2; });
  refuses([](model::HolmquistCeramic& law) { law.reference_rate = 0; });
  refuses([](model::HolmquistCeramic& law) { law.intact_power = -1; });
}

}  // namespace
}  // namespace crumple::materials::testing::holmquist_ceramic_test
