// SPDX-License-Identifier: BSD-3-Clause
// Viscous foam along given paths.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::viscous_foam_test {
namespace {

constexpr double poisson = 0.2;
constexpr double modulus = 0.036;  // MPa
constexpr double exponent = 4;
constexpr double viscosity = 0.0015;  // MPa s
constexpr double viscosity_exponent = 0.2;
constexpr double least = 100;

model::Material foam(double damping = viscosity) {
  model::Material material;
  material.id = 62;
  material.density = 6e-11;
  model::ViscousFoam law;
  law.youngs_modulus = least;
  law.poissons_ratio = poisson;
  law.elastic_modulus = modulus;
  law.elastic_exponent = exponent;
  law.viscosity = damping;
  law.viscosity_exponent = viscosity_exponent;
  material.law = law;
  return material;
}
Matrix squeezed(double side) {
  return {{{1, 0, 0}, {0, side, 0}, {0, 0, 1}}};
}

class SlowFoam : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, SlowFoam, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// sigma = M (1 - l^-n1) / n1 with the confined modulus M of E1, and nu / (1 - nu) of it across.
TEST_P(SlowFoam, ConfinedCompressionHasTheClosedForm) {
  const double confined = modulus * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  test::Points exact;
  test::Points found;
  double error[2];
  for (const int fine : {0, 1}) {
    const int steps = fine == 0 ? 200 : 400;
    MotionDriver<double> point(foam(0), GetParam());
    for (int i = 1; i <= steps; ++i) {
      const double side = 1 - 0.7 * i / steps;
      point.move_to(squeezed(side));
      const double expected = confined * (1 - std::pow(side, -exponent)) / exponent;
      error[fine] = point.stress()[1] / expected - 1;
      EXPECT_NEAR(point.stress()[0] / point.stress()[1], poisson / (1 - poisson), 1e-12);
      if (fine == 1) exact.push_back({1 - side, -expected});
      if (fine == 1 && i % 10 == 0) found.push_back({1 - side, -point.stress()[1]});
    }
  }
  test::verified("viscous foam without viscosity, squeezed to 0.3: stress of 400 steps, relative error",
                 "closed form")
      .below(std::fabs(error[1]), 2e-4);
  test::verified("viscous foam without viscosity: error of 200 steps over that of 400", "second order")
      .near(error[0] / error[1], 4, 0.1);
  if (GetParam() == Isa::Scalar)
    test::drawn("Viscous foam without viscosity, confined", "1 - V", "stress [MPa]")
        .accepted("closed form", exact)
        .found("one point of material", found)
        .note();
}

/// The stress above that without viscosity is 2 V2 |1 - V|^n2 times the deviatoric rate.
TEST_P(SlowFoam, ViscousStressIsThatOfTheRate) {
  test::Largest off("viscous foam squeezed at 0.1 to 100 / s: viscous stress, relative error",
                    "2 V2 |1 - V|^n2 e'", 1e-9);
  for (const double rate : {0.1, 1.0, 100.0}) {
    MotionDriver<double> point(foam(), GetParam());
    MotionDriver<double> elastic(foam(0), GetParam());
    for (int i = 1; i <= 100; ++i) {
      const double before = std::pow(0.4, (i - 1) / 100.0);
      const double side = std::pow(0.4, i / 100.0);
      const double strain = 2 * (before - side) / (before + side);
      point.move_to(squeezed(side), strain / rate);
      elastic.move_to(squeezed(side), strain / rate);
      const double eta = viscosity * std::pow(1 - 0.5 * (before + side), viscosity_exponent);
      const double size = 4.0 / 3 * eta * rate;
      off.compare(point.stress()[1] - elastic.stress()[1], -size, size);
      off.compare(point.stress()[0] - elastic.stress()[0], 0.5 * size, size);
      // Both stiffnesses are in the wave speed.
      const double confined = (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) * least;
      const double speed = point.wave_speed();
      EXPECT_NEAR(6e-11 / side * speed * speed, confined + 8.0 / 3 * eta * rate / strain,
                  1e-9 * (confined + eta * rate / strain));
    }
  }
}

TEST_P(SlowFoam, TurnsWithTheBody) {
  MotionDriver<double> point(foam(), GetParam());
  const Matrix f{{{0.8, 0.1, 0}, {0, 0.7, 0.02}, {0.03, 0, 1}}};
  point.move_in_steps(f, 20, 0.01);
  point.move_to(f, 0.01);  // at rest: no viscous stress is left
  const Matrix before = matrix_of(point.stress());
  const std::array<double, 3> axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (int i = 1; i <= 60; ++i) point.move_to(times(rotation(axis, 0.1 * i), f), 0.01);
  const Matrix q = rotation(axis, 6);
  test::verified("viscous foam, squeezed, then turned by 6 rad: stress, error [MPa]", "turned stress")
      .below(largest_difference(point.stress(), six_of(times(q, times(before, transposed(q))))), 1e-13);
}

TEST_P(SlowFoam, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(foam(), GetParam());
  MotionDriver<double> exact(foam(), GetParam());
  for (int i = 1; i <= 20000; ++i) {
    const Matrix f{{{1 - 3e-5 * i, 1e-5 * i, 0}, {0, 1 + 2e-6 * i, 0}, {1e-5 * i, 0, 1}}};
    coarse.move_to(f, 1e-5);
    exact.move_to(f, 1e-5);
  }
  test::verified("viscous foam, 20000 steps in single precision: stress, relative error", "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()) / equivalent(exact.stress()), 2e-5);
}

TEST(SlowFoamConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(foam()));
  auto material = foam();
  std::get<model::ViscousFoam>(material.law).elastic_modulus = 0;
  EXPECT_THROW(solid_material_constants(material), Error);
  EXPECT_THROW(solid_material_constants(foam(-1)), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::viscous_foam_test
