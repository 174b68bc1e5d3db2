// SPDX-License-Identifier: BSD-3-Clause
// Foam that springs back, along given paths.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::low_density_foam_test {
namespace {

constexpr double modulus = 1.5;  // MPa
const std::vector<double> strain{0, 0.05, 0.5, 0.7, 0.8};
const std::vector<double> stress{0, 0.06, 0.1, 0.3, 0.9};

model::Material foam(double factor, double shape, double tension = 0, bool tears = false) {
  model::Material material;
  material.id = 57;
  material.density = 6e-11;
  model::LowDensityFoam law;
  law.youngs_modulus = modulus;
  law.compression = strain;
  law.stress = stress;
  law.tensile_stress = tension;
  law.tears = tears;
  law.unloading_factor = factor;
  law.unloading_shape = shape;
  material.law = law;
  return material;
}
/// Nominal stress of the curve, its last slope beyond, and the energy below it.
double curve_at(double at) {
  std::size_t k = 0;
  while (k + 2 < strain.size() && at > strain[k + 1]) ++k;
  return stress[k] + (at - strain[k]) * (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]);
}
double energy_at(double at) {
  double energy = 0;
  for (std::size_t k = 0; k + 1 < strain.size(); ++k) {
    const bool last = k + 2 == strain.size();
    if (at <= strain[k]) break;
    const double to = last ? at : std::min(at, strain[k + 1]);
    energy += 0.5 * (to - strain[k]) * (stress[k] + curve_at(to));
  }
  return energy;
}
Matrix stretch(double x, double y, double z) {
  return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}

class SoftFoam : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, SoftFoam, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Principal nominal stresses by the stretch of their own axis; true stresses are those over the area.
TEST_P(SoftFoam, LoadingFollowsTheCurveAxisByAxis) {
  test::Largest off("low density foam, compressed by 0.8 along one, two and three axes: stress, error [MPa]",
                    "given curve over the present area", 1e-12);
  for (int axes = 1; axes <= 3; ++axes) {
    MotionDriver<double> point(foam(0.2, 2), GetParam());
    for (int i = 1; i <= 160; ++i) {
      const double side = 1 - 0.005 * i;
      point.move_to(stretch(side, axes > 1 ? side : 1, axes > 2 ? side : 1));
      const double expected = -curve_at(1 - side) / std::pow(side, axes - 1);
      for (int k = 0; k < 3; ++k) off.compare(point.stress()[k], k < axes ? expected : 0);
    }
  }
}

/// Stress times HU + (1 - HU) (W / W_max)^SHAPE; reloading follows the same curve up to where it was.
TEST_P(SoftFoam, UnloadsByTheFormulaAndReloadsTheSameWay) {
  test::Points drawn_loading;
  test::Points drawn_unloading;
  for (const double shape : {0.5, 1.0, 5.0}) {
    constexpr double factor = 0.1;
    MotionDriver<double> point(foam(factor, shape), GetParam());
    test::Largest off("low density foam, loaded and unloaded twice, SHAPE " + std::to_string(shape) +
                          ": stress, error [MPa]",
                      "HU + (1 - HU) (W / W_max)^SHAPE of the curve", 1e-12);
    double largest = 0;
    for (int i = 0; i <= 300; ++i) {
      // Down to 0.7, up, down again to 0.75, up.
      const double way = i / 300.0;
      const double compression = way < 0.25   ? 2.8 * way
                                 : way < 0.5  ? 0.7 - 2.8 * (way - 0.25)
                                 : way < 0.75 ? 3 * (way - 0.5)
                                              : 0.75 - 3 * (way - 0.75);
      point.move_to(stretch(1 - compression, 1, 1));
      const double energy = energy_at(compression);
      largest = std::max(largest, energy);
      const double share = largest > 0 ? factor + (1 - factor) * std::pow(energy / largest, shape) : 1;
      off.compare(point.stress()[0], -share * curve_at(compression));
      if (shape == 1 && way <= 0.25) drawn_loading.push_back({compression, curve_at(compression)});
      if (shape == 1 && way <= 0.5) drawn_unloading.push_back({compression, -point.stress()[0]});
    }
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Low density foam, HU = 0.1, SHAPE = 1", "compression", "nominal stress [MPa]")
        .accepted("given curve", drawn_loading)
        .found("one point of material, there and back", drawn_unloading)
        .note();
}

/// A cycle loses (1 - HU) SHAPE / (1 + SHAPE) of the largest energy, in one axis or three.
TEST_P(SoftFoam, CycleLosesTheShareOfTheClosedForm) {
  for (const double shape : {1.0, 2.0, 5.0})
    for (const double factor : {1.0, 0.5, 0.1})
      for (const bool all_axes : {false, true}) {
        double error[2];
        for (const int fine : {0, 1}) {
          MotionDriver<double> point(foam(factor, shape), GetParam());
          const int steps = fine == 0 ? 400 : 800;
          for (const double side : {0.3, 1.0})
            point.move_in_steps(stretch(side, all_axes ? side : 1, all_axes ? side : 1), steps);
          const double largest = (all_axes ? 3 : 1) * energy_at(0.7);
          error[fine] = point.work() / largest - (1 - factor) * shape / (1 + shape);
        }
        test::verified("low density foam, HU " + std::to_string(factor) + ", SHAPE " + std::to_string(shape) +
                           (all_axes ? ", three axes" : ", one axis") +
                           ": work of a cycle over the energy, error",
                       "(1 - HU) SHAPE / (1 + SHAPE)")
            .below(std::fabs(error[1]), 2e-4);
        EXPECT_LT(std::fabs(error[0]), 8e-4);
      }
}

/// Whatever the path: what is put in and not given back is not below zero, and without hysteresis it is zero.
TEST_P(SoftFoam, RandomCyclesNeverGiveMoreThanTheyTake) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  std::uniform_real_distribution<double> along(-0.5, 0.15);
  test::Largest kept("low density foam without hysteresis, random closed paths: work over the largest, size",
                     "none", 1e-3);
  for (int i = 0; i < 10; ++i) {
    MotionDriver<double> lossy(foam(0.1, 3), GetParam());
    MotionDriver<double> elastic(foam(1, 1), GetParam());
    double largest = 0;
    for (int leg = 0; leg <= 6; ++leg) {
      Matrix to = unit;
      if (leg < 6)
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c) to[r][c] += r == c ? along(generator) : uniform(generator);
      lossy.move_in_steps(to, 300);
      elastic.move_in_steps(to, 300);
      largest = std::max(largest, elastic.work());
      EXPECT_GT(lossy.work(), -1e-4 * largest);
    }
    kept.add(std::fabs(elastic.work()) / largest);
  }
}

TEST_P(SoftFoam, TensionIsLinearToItsBound) {
  test::Largest off("low density foam, pulled to 0.2 and back: stress, error [MPa]", "closed form", 1e-12);
  for (const bool tears : {false, true}) {
    MotionDriver<double> point(foam(0.1, 1, 0.15, tears), GetParam());
    bool torn = false;
    for (int i = 1; i <= 400; ++i) {
      const double excess = i <= 200 ? 0.001 * i : 0.2 - 0.002 * (i - 200);
      torn = torn || (tears && modulus * excess > 0.15);
      point.move_to(stretch(1, 1 + excess, 1));
      const double tension = torn ? 0 : std::min(modulus * excess, 0.15);
      const double expected = excess >= 0 ? tension : -curve_at(-excess);
      off.compare(point.stress()[1], expected);
    }
    EXPECT_EQ(torn, tears);
  }
}

TEST_P(SoftFoam, KnowsNoRotation) {
  const Matrix stretched{{{1.1, 0.2, 0}, {0, 0.6, 0.1}, {0.05, 0, 0.85}}};
  const std::array<double, 3> axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
  MotionDriver<double> point(foam(0.3, 2), GetParam());
  for (int i = 1; i <= 600; ++i) point.move_to(rotation(axis, 0.1047197551196598 * i));
  test::verified("low density foam, ten turns without strain: stress [MPa]", "none")
      .below(largest_difference(point.stress(), {}), 1e-12);
  point.move_in_steps(stretched, 3);
  const Matrix before = matrix_of(point.stress());
  for (int i = 1; i <= 25; ++i) point.move_to(times(rotation(axis, 0.1 * i), stretched));
  const Matrix q = rotation(axis, 2.5);
  test::verified("low density foam, compressed, then turned: stress, error [MPa]", "turned stress")
      .below(largest_difference(point.stress(), six_of(times(q, times(before, transposed(q))))), 1e-12);
}

/// Along each axis, loading and unloading, by differences.
TEST_P(SoftFoam, WaveSpeedBoundsTheTangent) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0.25, 1.1);
  for (int i = 0; i < 40; ++i) {
    double side[3] = {uniform(generator), uniform(generator), uniform(generator)};
    const Matrix f = stretch(side[0], side[1], side[2]);
    MotionDriver<double> point(foam(0.1, 4), GetParam());
    point.move_to(f);
    const double speed = point.wave_speed();
    const double density = 6e-11 / determinant(f);
    for (int k = 0; k < 3; ++k)
      for (const double sign : {1.0, -1.0}) {
        const double h = 1e-6 * sign;
        MotionDriver<double> moved(foam(0.1, 4), GetParam());
        moved.move_to(f);
        Matrix more = f;
        more[k][k] += h;
        moved.move_to(more);
        const double slope = (moved.stress()[k] - point.stress()[k]) / h;
        EXPECT_GT(density * speed * speed, 0.999 * slope * side[k]);
      }
  }
}

TEST_P(SoftFoam, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(foam(0.2, 3), GetParam());
  MotionDriver<double> exact(foam(0.2, 3), GetParam());
  for (int i = 1; i <= 20000; ++i) {
    const double depth = i <= 15000 ? 4e-5 * i : 0.6 - 4e-5 * (i - 15000);
    const Matrix f{{{1 - depth, 0.3 * depth, 0}, {0, 1 + 0.1 * depth, 0}, {0.1 * depth, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  test::verified("low density foam, 20000 steps in single precision: stress, error [MPa]", "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()), 2e-6);
}

/// Twice the stress at 100 / s, three times at 1000 / s.
model::Material rate_foam(bool engineering, double factor = 1) {
  model::Material material = foam(factor, 1);
  auto& law = std::get<model::LowDensityFoam>(material.law);
  law.slowest = 1;
  law.engineering_rate = engineering;
  for (const double times : {2.0, 3.0}) {
    std::vector<double> scaled = stress;
    for (double& value : scaled) value *= times;
    law.faster.push_back({times == 2 ? 100.0 : 1000.0, strain, scaled});
  }
  return material;
}
double factor_at(double rate) {
  if (rate <= 1) return 1;
  return rate < 100 ? 1 + (rate - 1) / 99 : rate < 1000 ? 2 + (rate - 100) / 900 : 3;
}

/// Once the running mean has settled, the stress is that between the curves; twelve steps later it is
/// forgotten.
TEST_P(SoftFoam, LoadingAtAConstantRateIsBetweenTheCurves) {
  test::Largest off("foam with curves by rate, compressed to 0.7 at 0.1 to 5000 / s: stress, relative error",
                    "between the given curves", 1e-9);
  for (const bool engineering : {false, true})
    for (const double rate : {0.1, 1.0, 30.0, 100.0, 400.0, 5000.0}) {
      MotionDriver<double> point(rate_foam(engineering), GetParam());
      double side = 1;
      const int steps = 3000;
      for (int i = 1; i <= steps; ++i) {
        const double before = side;
        side = engineering ? 1 - 0.7 * i / steps : std::pow(0.3, static_cast<double>(i) / steps);
        // The strain of the middle of the step, and the stretch at its end for the engineering rate.
        const double increment = (before - side) / (0.5 * (before + side)) * (engineering ? side : 1);
        point.move_to(stretch(1, side, 1), increment / rate);
        if (i < 500) continue;
        const double expected = -factor_at(rate) * curve_at(1 - side);
        off.compare(point.stress()[1], expected, expected);
      }
    }
}

/// Held, the rate is forgotten by a twelfth in each step, and unloading follows the slowest curve.
TEST_P(SoftFoam, RateIsARunningMean) {
  MotionDriver<double> point(rate_foam(false, 0.3), GetParam());
  point.move_in_steps(stretch(1, 0.6, 1), 400, 1e-5);
  const double rate = point.item("compression_rate");
  EXPECT_GT(rate, 100);
  for (int i = 1; i <= 30; ++i) {
    point.move_to(stretch(1, 0.6, 1), 1e-5);
    EXPECT_NEAR(point.item("compression_rate") / (rate * std::pow(11.0 / 12, i)), 1, 1e-12);
  }
  for (int i = 0; i < 400; ++i) point.move_to(stretch(1, 0.6, 1), 1e-5);
  EXPECT_NEAR(point.stress()[1], -curve_at(0.4), 1e-9);
  point.move_in_steps(stretch(1, 0.8, 1), 100, 1e-5);
  const double share = 0.3 + 0.7 * energy_at(0.2) / energy_at(0.4);
  EXPECT_NEAR(point.stress()[1], -share * curve_at(0.2), 1e-9);
}

TEST(SoftFoamConstants, AreChecked) {
  const auto changed = [](auto change) {
    auto material = foam(0.5, 1);
    change(std::get<model::LowDensityFoam>(material.law));
    return material;
  };
  EXPECT_NO_THROW(solid_material_constants(foam(0.5, 1)));
  EXPECT_THROW(solid_material_constants(changed([](auto& law) { law.compression[1] = 0.6; })), Error);
  EXPECT_THROW(solid_material_constants(changed([](auto& law) { law.stress[2] = 0.05; })), Error);
  EXPECT_THROW(solid_material_constants(changed([](auto& law) { law.stress[0] = 0.01; })), Error);
  EXPECT_THROW(solid_material_constants(changed([](auto& law) { law.unloading_factor = 1.5; })), Error);
  EXPECT_THROW(solid_material_constants(changed([](auto& law) { law.unloading_shape = 0; })), Error);
  auto material = rate_foam(false);
  std::get<model::LowDensityFoam>(material.law).slowest = 100;
  EXPECT_THROW(solid_material_constants(material), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::low_density_foam_test
