// SPDX-License-Identifier: BSD-3-Clause
// Soil and foam along given paths.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::soil_and_foam_test {
namespace {

constexpr double shear = 60;       // MPa
constexpr double unloading = 400;  // bulk modulus
constexpr double cut_off = -0.3;
constexpr std::array<double, 3> yield{0.5, 0.4, 0.03};
const std::vector<double> compression{0, 0.05, 0.2, 0.4};  // -ln V
const std::vector<double> pressures{0, 4, 10, 60};

model::Material soil(bool crushes = true) {
  model::Material material;
  material.id = 5;
  material.density = 1.8e-9;
  model::SoilAndFoam law;
  law.youngs_modulus = 9 * unloading * shear / (3 * unloading + shear);
  law.poissons_ratio = (3 * unloading - 2 * shear) / (2 * (3 * unloading + shear));
  law.shear_modulus = shear;
  law.unloading_modulus = unloading;
  law.yield = yield;
  law.least_pressure = cut_off;
  law.crushes = crushes;
  law.compression = compression;
  law.pressure = pressures;
  material.law = law;
  return material;
}
/// The curve; its outer lines go on.
double curve_at(double strain) {
  std::size_t k = 0;
  while (k + 2 < compression.size() && strain > compression[k + 1]) ++k;
  return pressures[k] + (strain - compression[k]) * (pressures[k + 1] - pressures[k]) /
                            (compression[k + 1] - compression[k]);
}
/// von Mises stress at the yield surface.
double strength(double p) {
  return std::sqrt(std::max(3 * (yield[0] + yield[1] * p + yield[2] * p * p), 0.0));
}
Matrix compressed(double strain) {
  return volumetric(std::exp(-strain));
}

class Soil : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Soil, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Down, up to the cut-off, down again beyond where it was, up.
TEST_P(Soil, PressureFollowsTheCurveAndTheUnloadingLine) {
  test::Points exact;
  test::Points found;
  for (const bool crushes : {true, false}) {
    MotionDriver<double> point(soil(crushes), GetParam());
    test::Largest off(std::string("soil and foam, VCR = ") + (crushes ? "0" : "1") +
                          ", squeezed, released and squeezed: pressure, error [MPa]",
                      "given curve, and the line of KUN", 1e-11);
    double most = 0;
    for (int i = 0; i <= 400; ++i) {
      const double way = i / 400.0;
      const double strain = way < 0.25   ? 1.2 * way
                            : way < 0.5  ? 0.3 - 0.4 * (way - 0.25)
                            : way < 0.75 ? 0.2 + 1.2 * (way - 0.5)
                                         : 0.5 - 2.4 * (way - 0.75);
      point.move_to(compressed(strain));
      most = std::max(most, strain);
      const double expected =
          std::max(crushes ? curve_at(most) - unloading * (most - strain) : curve_at(strain), cut_off);
      off.compare(point.pressure(), expected);
      EXPECT_LT(equivalent(point.stress()), 1e-9);
      if (crushes) exact.push_back({strain, expected});
      if (crushes && i % 8 == 0) found.push_back({strain, point.pressure()});
    }
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Soil and foam, squeezed, released and squeezed again", "-ln V", "pressure [MPa]")
        .accepted("given curve, and the line of KUN", exact)
        .found("one point of material", found)
        .note();
}

/// Shear at a constant volume: elastic to sqrt(3 (a0 + a1 p + a2 p^2)), and then constant.
TEST_P(Soil, StrengthGrowsWithThePressure) {
  test::Largest off("soil and foam, sheared at pressures from -0.3 to 60 MPa: von Mises stress, error [MPa]",
                    "sqrt(3 (a0 + a1 p + a2 p^2))", 1e-10);
  for (const double strain : {-0.05, 0.0, 0.02, 0.1, 0.3, 0.4}) {
    MotionDriver<double> point(soil(), GetParam());
    const Matrix f = compressed(strain);
    point.move_in_steps(f, 50);
    const double p = std::max(strain < 0 ? unloading * strain : curve_at(strain), cut_off);
    for (int i = 1; i <= 100; ++i) {
      Matrix pure = unit;
      const double gamma = 2.0 * strength(p) / shear * i / 100;
      pure[0][0] = pure[1][1] = std::cosh(gamma / 2);
      pure[0][1] = pure[1][0] = std::sinh(gamma / 2);
      point.move_to(times(pure, f));
      if (i == 100 || i == 60) off.compare(equivalent(point.stress()), strength(p));
      EXPECT_NEAR(point.pressure(), p, 1e-6 * (1 + p));
    }
  }
}

/// Along one axis, yielding: the stress along is p and 2/3 of the strength, that across p less a third.
TEST_P(Soil, UniaxialStrainHasTheClosedForm) {
  MotionDriver<double> point(soil(), GetParam());
  test::Largest off("soil and foam, confined compression to 0.6: stresses, error [MPa]", "closed form",
                    1e-10);
  for (int i = 1; i <= 200; ++i) {
    const double side = std::pow(0.6, i / 200.0);
    point.move_to({{{1, 0, 0}, {0, side, 0}, {0, 0, 1}}});
    if (i < 40) continue;
    const double p = curve_at(-std::log(side));
    const Six s = point.stress();
    off.compare(s[1], -p - 2.0 / 3 * strength(p));
    off.compare(s[0], -p + strength(p) / 3);
    off.compare(s[2], -p + strength(p) / 3);
  }
}

TEST_P(Soil, WorkOfACycleIsTheAreaBetween) {
  double error[2];
  for (const int fine : {0, 1}) {
    MotionDriver<double> point(soil(), GetParam());
    const int steps = fine == 0 ? 400 : 800;
    double expected = 0;
    double most = 0;
    double before = 0;
    for (int i = 1; i <= steps; ++i) {
      const double strain = 0.2 * (1 - std::fabs(2.0 * i / steps - 1));
      point.move_to(compressed(strain));
      // The same by quadrature: integral of p V over -ln V, 50 times finer.
      for (int j = 0; j < 50; ++j) {
        const double at = before + (strain - before) * (j + 0.5) / 50;
        most = std::max(most, at);
        const double p = std::max(curve_at(most) - unloading * (most - at), cut_off);
        expected += p * std::exp(-at) * (strain - before) / 50;
      }
      before = strain;
    }
    error[fine] = std::fabs(point.work() / expected - 1);
  }
  test::verified("soil and foam, squeezed to 0.2 and back: work, relative error", "quadrature")
      .below(error[1], 1e-4);
  EXPECT_LT(error[1], error[0]);
}

TEST_P(Soil, TurnsWithTheBody) {
  MotionDriver<double> point(soil(), GetParam());
  const Matrix f{{{0.9, 0.1, 0}, {0, 0.95, 0.02}, {0.03, 0, 1}}};
  point.move_in_steps(f, 20);
  const Matrix before = matrix_of(point.stress());
  const std::array<double, 3> axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (int i = 1; i <= 60; ++i) point.move_to(times(rotation(axis, 0.1 * i), f));
  const Matrix q = rotation(axis, 6);
  test::verified("soil and foam, squeezed, then turned by 6 rad: stress, error [MPa]", "turned stress")
      .below(largest_difference(point.stress(), six_of(times(q, times(before, transposed(q))))), 1e-11);
}

TEST_P(Soil, WaveSpeedBoundsTheTangent) {
  for (const bool crushes : {true, false})
    for (const double strain : {-0.02, 0.0, 0.03, 0.1, 0.3}) {
      MotionDriver<double> point(soil(crushes), GetParam());
      point.move_to(compressed(strain));
      for (const double h : {1e-7, -1e-7}) {
        MotionDriver<double> moved(soil(crushes), GetParam());
        moved.move_to(compressed(strain));
        Matrix more = compressed(strain);
        const double side = more[0][0];
        more[0][0] *= 1 + h;
        moved.move_to(more);
        const double slope = (moved.stress()[0] - point.stress()[0]) / h;
        const double density = 1.8e-9 / (side * side * side);
        EXPECT_GT(density * point.wave_speed() * point.wave_speed(), 0.9999 * slope) << strain;
      }
    }
}

TEST_P(Soil, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(soil(), GetParam());
  MotionDriver<double> exact(soil(), GetParam());
  for (int i = 1; i <= 20000; ++i) {
    const double depth = i <= 15000 ? 2e-5 * i : 0.3 - 1e-5 * (i - 15000);
    const Matrix f{{{1 - depth, 0.3 * depth, 0}, {0, 1 + 0.1 * depth, 0}, {0.1 * depth, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  test::verified("soil and foam, 20000 steps in single precision: stress over KUN, error", "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()) / unloading, 1e-5);
}

TEST(SoilConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(soil()));
  const auto refuses = [](void (*change)(model::SoilAndFoam&)) {
    auto material = soil();
    change(std::get<model::SoilAndFoam>(material.law));
    EXPECT_THROW(solid_material_constants(material), Error);
  };
  refuses([](model::SoilAndFoam& law) { law.shear_modulus = 0; });
  refuses([](model::SoilAndFoam& law) { law.least_pressure = 1; });
  refuses([](model::SoilAndFoam& law) { law.unloading_modulus = 0; });
  refuses([](model::SoilAndFoam& law) { law.pressure[2] = 3; });
  refuses([](model::SoilAndFoam& law) { law.compression[2] = 0.05; });
  refuses([](model::SoilAndFoam& law) { law.compression[0] = 0.01; });
}

}  // namespace
}  // namespace crumple::materials::testing::soil_and_foam_test
