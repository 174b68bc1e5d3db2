// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ELASTIC_PLASTIC_HYDRO against closed forms: the yield stress, the pressure, spall, failure.
#include <gtest/gtest.h>

#include <vector>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "model/elastic_moduli.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::hydro_plasticity_test {
namespace {

constexpr double bulk = 140;
constexpr double shear = 46;
constexpr double yield = 0.12;

/// In GPa, mm, microseconds and mg. p = bulk mu, without energy, so that the pressure has a closed form.
model::EquationOfState equation() {
  return {4, "", 0, 1, model::LinearPolynomial{{0, bulk, 0, 0, 0, 0, 0}}};
}
double pressure_at(double volume) {
  return bulk * (1 / volume - 1);
}
model::HydroPlasticity line(double hardening = 0) {
  model::HydroPlasticity law;
  law.shear_modulus = shear;
  law.plastic_strain = {0};
  law.yield_stress = {yield};
  law.hardening = hardening;
  model::set_moduli(law, bulk, shear);
  return law;
}
model::HydroPlasticity table() {
  model::HydroPlasticity law = line();
  law.plastic_strain = {0, 0.02, 0.05, 0.1};
  law.yield_stress = {0.12, 0.2, 0.17, 0.21};
  return law;
}
model::Material material(const model::HydroPlasticity& law) {
  model::Material found;
  found.id = 10;
  found.density = 8.93;
  found.law = law;
  return found;
}
/// A shear at constant volume after a compression.
Matrix sheared(double gamma, double volume) {
  Matrix f = unit;
  f[0][1] = gamma;
  return times(f, volumetric(volume));
}
/// The points of `law` joined by straight lines, the last of which goes on.
double joined(const model::HydroPlasticity& law, double strain) {
  const auto& x = law.plastic_strain;
  const auto& y = law.yield_stress;
  if (x.size() == 1) return y[0] + law.hardening * strain;
  std::size_t k = 1;
  while (k + 1 < x.size() && strain > x[k]) ++k;
  return y[k - 1] + (y[k] - y[k - 1]) * (strain - x[k - 1]) / (x[k] - x[k - 1]);
}

class Hydro : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Hydro, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

template <class Real>
void expect_on_surface(Isa isa, test::Largest& off) {
  const auto law_of_pressure = equation();
  for (const model::HydroPlasticity& law : {line(), line(0.5), table()}) {
    MotionDriver<Real> point(material(law), isa, &law_of_pressure);
    for (int i = 1; i <= 150; ++i) {
      point.move_to(sheared(2e-3 * i, 1 - 2e-4 * i));
      if (point.item("plastic_strain") == 0) continue;
      off.compare(equivalent(point.stress()), joined(law, point.item("plastic_strain")), yield);
    }
    EXPECT_GT(point.item("plastic_strain"), 0.15);
  }
}

TEST_P(Hydro, StressLiesOnTheYieldSurface) {
  test::Largest off("elastic-plastic hydro, line and table: von Mises stress over SIGY, error",
                    "EPS and ES joined by straight lines", 1e-12);
  test::Largest singles("elastic-plastic hydro in single precision: the same", "the same", 3e-6);
  expect_on_surface<double>(GetParam(), off);
  expect_on_surface<float>(GetParam(), singles);
}

TEST_P(Hydro, ElasticDeviatorHasTheShearModulusWhateverPoissonsRatio) {
  const auto law_of_pressure = equation();
  model::HydroPlasticity law = line();
  law.poissons_ratio = 0.1;
  MotionDriver<double> point(material(law), GetParam(), &law_of_pressure);
  const double gamma = 1e-6;
  point.move_to(sheared(gamma, 1));
  test::verified("elastic-plastic hydro, elastic: shear stress over G gamma", "Hooke")
      .near(point.stress()[3] / (shear * gamma), 1, 1e-9);
  EXPECT_NEAR(solid_start(material(line()), &law_of_pressure).wave_speed,
              std::sqrt((bulk + 4.0 / 3 * shear) / 8.93), 1e-12);
}

TEST_P(Hydro, PressureIsThatOfTheEquationOfState) {
  const auto law_of_pressure = equation();
  MotionDriver<double> point(material(table()), GetParam(), &law_of_pressure);
  test::Largest off("elastic-plastic hydro: pressure over the bulk modulus, error", "bulk mu", 1e-12);
  for (int i = 1; i <= 100; ++i) {
    const double volume = 1 - 2e-3 * i;
    point.move_to(sheared(3e-3 * i, volume));
    off.compare(point.pressure(), pressure_at(determinant(point.at())), bulk);
  }
  // The energy has no part in the pressure, but is there.
  test::verified("elastic-plastic hydro: work over internal energy", "first law")
      .near(point.work() / point.item("internal_energy"), 1, 1e-6);
}

/// SIGY + EH p + (A1 + A2 P) max(P, 0), with the pressure P at the start of the step.
TEST_P(Hydro, YieldStressRisesWithThePressure) {
  const auto law_of_pressure = equation();
  model::HydroPlasticity law = line(0.3);
  law.pressure_factor = 0.02;
  law.pressure_square = 0.004;
  test::Largest off("elastic-plastic hydro, A1 and A2: von Mises stress over SIGY, error", "the formula",
                    1e-11);
  MotionDriver<double> point(material(law), GetParam(), &law_of_pressure);
  MotionDriver<float> coarse(material(law), GetParam(), &law_of_pressure);
  double before = 0;
  for (int i = 1; i <= 200; ++i) {
    // Compressed, then pulled.
    const double volume = i <= 100 ? 1 - 8e-4 * i : 0.92 + 1.2e-3 * (i - 100);
    point.move_to(sheared(4e-3 * i, volume));
    coarse.move_to(sheared(4e-3 * i, volume));
    const double p = std::max(before, 0.0);
    if (i > 5)
      off.compare(equivalent(point.stress()),
                  yield + 0.3 * point.item("plastic_strain") + (0.02 + 0.004 * p) * p, yield);
    before = point.pressure();
  }
  EXPECT_LT(before, -0.1 * yield);
  EXPECT_NEAR(coarse.item("plastic_strain"), point.item("plastic_strain"), 1e-5);
}

TEST_P(Hydro, StrengthMayComeFromThePressureAlone) {
  const auto law_of_pressure = equation();
  model::HydroPlasticity law = line();
  law.yield_stress = {0};
  law.pressure_factor = 0.5;
  MotionDriver<double> point(material(law), GetParam(), &law_of_pressure);
  point.move_in_steps(sheared(0.2, 1), 20);
  EXPECT_LT(equivalent(point.stress()), 1e-8 * shear);
  point.move_in_steps(sheared(0.2, 0.99), 20);
  const double p = point.pressure();
  point.move_in_steps(sheared(0.4, 0.99), 20);
  test::verified("elastic-plastic hydro, A1 alone: von Mises stress over the pressure", "A1")
      .near(equivalent(point.stress()) / p, 0.5, 1e-9);
  point.move_in_steps(sheared(0.4, 1.01), 50);
  EXPECT_LT(equivalent(point.stress()), 1e-8 * shear);
}

TEST_P(Hydro, CutOffAndSpall) {
  const auto law_of_pressure = equation();
  for (const model::Spall spall : {model::Spall::None, model::Spall::Stress, model::Spall::Pressure}) {
    model::HydroPlasticity law = line();
    law.least_pressure = -0.8;
    law.spall = spall;
    MotionDriver<double> point(material(law), GetParam(), &law_of_pressure);
    const bool by_stress = spall == model::Spall::Stress;
    // Along x alone the largest principal stress is 2/3 of the yield stress above the mean.
    const double tension = by_stress ? 0.8 - 2.0 / 3 * yield : 0.8;
    const double reached = 1 / (1 - tension / bulk);
    const Matrix below{{{reached - 1e-5, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Matrix beyond{{{reached + 1e-5, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    point.move_in_steps(below, 100);
    EXPECT_EQ(point.item("rubble"), 0);
    EXPECT_NEAR(equivalent(point.stress()), yield, 1e-12);
    point.move_to(beyond);
    const bool rubble = spall != model::Spall::None;
    EXPECT_EQ(point.item("rubble") != 0, rubble);
    EXPECT_NEAR(point.pressure(), rubble ? 0 : -0.8, 1e-13);
    EXPECT_EQ(equivalent(point.stress()) > 0, !rubble);
    point.move_in_steps({{{0.98, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 50);
    EXPECT_NEAR(point.pressure(), pressure_at(0.98), 1e-10);
    EXPECT_EQ(equivalent(point.stress()) > 1e-9, !rubble);
  }
}

TEST_P(Hydro, FailsAtAPlasticStrain) {
  const auto law_of_pressure = equation();
  model::HydroPlasticity law = line();
  EXPECT_FALSE(solid_can_fail(material(law)));
  law.failure_strain = 0.05;
  ASSERT_TRUE(solid_can_fail(material(law)));
  MotionDriver<double> point(material(law), GetParam(), &law_of_pressure);
  int i = 0;
  do {
    EXPECT_LT(point.item("plastic_strain"), 0.05);
    point.move_to(sheared(1e-3 * ++i, 1));
  } while (point.intact() && i < 200);
  EXPECT_GE(point.item("plastic_strain"), 0.05);
  EXPECT_LT(point.item("plastic_strain"), 0.05 + 1e-3);
  EXPECT_EQ(equivalent(point.stress()), 0);
}

TEST_P(Hydro, TurnsWithItsObserver) {
  const auto law_of_pressure = equation();
  model::HydroPlasticity law = table();
  MotionDriver<double> point(material(law), GetParam(), &law_of_pressure);
  MotionDriver<double> turned(material(law), GetParam(), &law_of_pressure);
  test::Largest off("elastic-plastic hydro: stresses of turned observers, difference [GPa]", "objectivity",
                    1e-4);
  Matrix q = unit;
  for (int i = 1; i <= 400; ++i) {
    const Matrix f = sheared(1e-3 * i, 1 - 1e-4 * i);
    q = rotation({0.6, 0, 0.8}, 2e-3 * i);
    point.move_to(f);
    turned.move_to(times(q, f));
  }
  const Matrix back = times(transposed(q), times(matrix_of(turned.stress()), q));
  off.add(largest_difference(six_of(back), point.stress()));
}

TEST(HydroMaterial, RefusesWhatHasNoSense) {
  const auto refused = [](const model::HydroPlasticity& law) {
    EXPECT_THROW(solid_material_constants(material(law), nullptr), Error);
  };
  EXPECT_NO_THROW(solid_material_constants(material(table()), nullptr));
  model::HydroPlasticity law = line();
  law.shear_modulus = 0;
  refused(law);
  law = line(-1);
  refused(law);
  law = line();
  law.failure_strain = -1;
  refused(law);
  law = table();
  law.yield_stress.back() = 0.1;  // falls at its end
  refused(law);
  law = table();
  law.plastic_strain[0] = 0.001;
  refused(law);
  law = line();
  law.least_pressure = 1;
  EXPECT_THROW(eos_constants(material(law), equation(), 2), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::hydro_plasticity_test
