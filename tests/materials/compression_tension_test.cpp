// SPDX-License-Identifier: BSD-3-Clause
// *MAT_PLASTICITY_COMPRESSION_TENSION: the yield stress between two curves by the pressure.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "materials/point_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::compression_tension_test {
namespace {

model::CompressionTension plastic() {
  model::CompressionTension law;
  law.youngs_modulus = 2000;
  law.poissons_ratio = 0.4;
  law.compression_strain = {0, 0.05, 0.2};
  law.compression_stress = {50, 70, 90};
  law.tension_strain = {0, 0.1};
  law.tension_stress = {30, 45};
  law.compression_pressure = 15;
  law.tension_pressure = 8;
  return law;
}
model::Material material(const model::CompressionTension& law) {
  model::Material found;
  found.id = 124;
  found.density = 1.1e-9;
  found.law = law;
  return found;
}
double joined(const std::vector<double>& x, const std::vector<double>& y, double at) {
  std::size_t k = 1;
  while (k + 1 < x.size() && at > x[k]) ++k;
  return at >= x.back() ? y.back() : y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]);
}
/// By the formula of the manual, with the pressure p.
double yield_stress(const model::CompressionTension& law, double strain, double p) {
  const double scale = std::clamp(
      (law.compression_pressure - p) / (law.compression_pressure + law.tension_pressure), 0.0, 1.0);
  return scale * joined(law.tension_strain, law.tension_stress, strain) +
         (1 - scale) * joined(law.compression_strain, law.compression_stress, strain);
}
Matrix sheared(double gamma, double volume) {
  Matrix f = unit;
  f[0][1] = gamma;
  return times(f, volumetric(volume));
}

class TwoSided : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, TwoSided, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

template <class Real>
void expect_on_surface(Isa isa, test::Largest& off) {
  const model::CompressionTension law = plastic();
  MotionDriver<Real> point(material(law), isa);
  // Through all pressures from tension alone to compression alone, and back.
  for (int i = 1; i <= 400; ++i) {
    const double swing = i <= 200 ? -1 + 0.01 * i : 3 - 0.01 * i;
    point.move_to(sheared(2e-3 * i, 1 - 8e-3 * swing * std::min(1.0, 0.02 * i)));
    if (i > 30)
      off.compare(equivalent(point.stress()),
                  yield_stress(law, point.item("plastic_strain"), point.pressure()), 30);
  }
  EXPECT_GT(point.item("plastic_strain"), 0.3);
}

TEST_P(TwoSided, YieldStressIsThatOfThePressure) {
  test::Largest off("compression-tension plasticity, solids: von Mises stress over 30 MPa, error",
                    "the manual's formula", 1e-12);
  test::Largest singles("compression-tension plasticity, solids, single precision: the same", "the same",
                        1e-5);
  expect_on_surface<double>(GetParam(), off);
  expect_on_surface<float>(GetParam(), singles);
}

TEST_P(TwoSided, WithoutPcAndPtTheSignDecides) {
  model::CompressionTension law = plastic();
  law.compression_pressure = law.tension_pressure = 0;
  for (const double volume : {0.999, 1.001}) {
    MotionDriver<double> point(material(law), GetParam());
    point.move_in_steps(sheared(0.1, volume), 100);
    const double strain = point.item("plastic_strain");
    test::verified(volume < 1 ? "compression-tension plasticity, PC = PT = 0, pressed: von Mises stress [MPa]"
                              : "compression-tension plasticity, PC = PT = 0, pulled: von Mises stress [MPa]",
                   "the curve")
        .near(equivalent(point.stress()),
              volume < 1 ? joined(law.compression_strain, law.compression_stress, strain)
                         : joined(law.tension_strain, law.tension_stress, strain),
              1e-11);
  }
}

/// Cowper & Symonds by the rate of the plastic strain: what is found fulfils the equation.
TEST_P(TwoSided, RateRaisesBothCurves) {
  model::CompressionTension law = plastic();
  law.cowper_symonds_rate = 100;
  law.cowper_symonds_exponent = 3;
  test::Largest off("compression-tension plasticity with C and P: von Mises stress over 30 MPa, error",
                    "Cowper and Symonds", 1e-10);
  const double step = 1e-4;
  for (const double volume : {0.99, 1.0, 1.01}) {
    MotionDriver<double> point(material(law), GetParam());
    double before = 0;
    for (int i = 1; i <= 100; ++i) {
      point.move_to(sheared(2e-3 * i, 1 + (volume - 1) * std::min(1.0, 0.05 * i)), step);
      const double now = point.item("plastic_strain");
      if (i > 40)
        off.compare(equivalent(point.stress()),
                    yield_stress(law, now, point.pressure()) *
                        (1 + std::cbrt((now - before) / step / law.cowper_symonds_rate)),
                    30);
      before = now;
    }
  }
}

TEST_P(TwoSided, FailsAtAPlasticStrain) {
  model::CompressionTension law = plastic();
  EXPECT_FALSE(solid_can_fail(material(law)));
  law.failure_strain = 0.05;
  ASSERT_TRUE(solid_can_fail(material(law)));
  MotionDriver<double> point(material(law), GetParam());
  int i = 0;
  do {
    EXPECT_LT(point.item("plastic_strain"), 0.05);
    point.move_to(sheared(1e-3 * ++i, 1.005));
  } while (point.intact() && i < 300);
  EXPECT_GE(point.item("plastic_strain"), 0.05);
  EXPECT_LT(point.item("plastic_strain"), 0.051);
}

/// In uniaxial stress s the pressure is -s/3: beyond PC and PT the stress is that of one curve exactly,
/// between them to second order in what a step exceeds it by.
TEST_P(TwoSided, ShellsInUniaxialStress) {
  test::Largest off("compression-tension plasticity, shells, one curve alone: stress over 30 MPa, error",
                    "the curve", 1e-9);
  test::Largest between("compression-tension plasticity, shells, between the curves: the same",
                        "the manual's formula", 2e-3);
  for (const bool wide : {false, true})
    for (const double sign : {-1.0, 1.0}) {
      model::CompressionTension law = plastic();
      if (wide) law.compression_pressure = law.tension_pressure = 40;
      PointDriver<double> point(material(law), GetParam());
      for (int i = 1; i <= 200; ++i) {
        point.apply_uniaxial(sign * 5e-4, law.poissons_ratio);
        if (i < 100) continue;
        const double stress = point.stress()[0];
        const double expected = yield_stress(law, point.item("plastic_strain"), -stress / 3);
        (wide ? between : off).compare(sign * stress, expected, 30);
      }
      EXPECT_GT(point.item("plastic_strain"), 0.03);
    }
}

TEST(TwoSidedPlasticity, RefusesWhatHasNoSense) {
  EXPECT_NO_THROW(solid_material_constants(material(plastic()), nullptr));
  model::CompressionTension law = plastic();
  law.tension_pressure = -1;
  EXPECT_THROW(solid_material_constants(material(law), nullptr), Error);
  law = plastic();
  law.tension_stress = {};
  law.tension_strain = {};
  EXPECT_THROW(solid_material_constants(material(law), nullptr), Error);
  law = plastic();
  law.compression_strain[0] = 0.01;
  EXPECT_THROW(solid_material_constants(material(law), nullptr), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::compression_tension_test
