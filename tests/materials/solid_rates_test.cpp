// SPDX-License-Identifier: BSD-3-Clause
// Yield stresses of solids that depend on the strain rate and on temperature; fracture; a
// million small steps.
#include <gtest/gtest.h>

#include <random>

#include "materials/rate_cases.hpp"
#include "materials/solid_driver.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::solid_rates_test {
namespace {

constexpr double step = 1e-6;

/// After every step the stress lies on the yield surface of the plastic strain rate of that step.
template <class Real>
double worst_excess(const Case& one, Isa isa, int flows) {
  double worst = 0;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 40; ++sample) {
    SolidDriver<Real> point(one.material, isa);
    int flowing = 0;
    for (int i = 0; i < 200 && flowing < flows; ++i) {
      Six strain;
      const double size = 1e-4 * std::exp2(4 * uniform(generator));
      for (double& e : strain) e = size * (0.5 + uniform(generator));
      // Without pressure, whose rounding would hide the yield function.
      strain[2] = -strain[0] - strain[1];
      for (double& e : strain) e = static_cast<double>(static_cast<Real>(e));
      const double before = point.item("plastic_strain");
      point.apply(strain, step);
      const double flow = point.item("plastic_strain") - before;
      if (!(flow > 0)) continue;
      ++flowing;
      const double dt = static_cast<double>(static_cast<Real>(step));
      const double yield = one.yield(before + flow, flow / dt);
      worst = test::larger_of(worst, std::fabs(equivalent(point.stress()) - yield) / yield);
    }
    EXPECT_EQ(flowing, flows) << one.name;
  }
  return worst;
}

TEST(SolidRates, StressLiesOnTheYieldSurfaceOfTheRate) {
  for (const bool viscoplastic : {false, true}) {
    const std::string rate = viscoplastic ? "VP 1" : "VP 0";
    test::Largest singles("solid, all laws, " + rate + ": stress off the yield surface, single precision",
                          "yield stress, formulated independently", 1e-6);
    for (const Case& one : cases(viscoplastic)) {
      test::Largest doubles(std::string("solid, ") + one.name + ", " + rate +
                                ": stress off the yield surface, double precision",
                            "yield stress, formulated independently", 1e-12);
      for (const Isa isa : available_isas()) {
        doubles.add(worst_excess<double>(one, isa, 60), std::string(isa_name(isa)));
        // In float the increment of plastic strain can be told from the state in the first step only.
        singles.add(worst_excess<float>(one, isa, 1), std::string(one.name) + std::string(isa_name(isa)));
      }
    }
  }
}

/// A change of volume is no strain rate for the yield stress.
TEST(SolidRates, VolumetricRatesHaveNoEffect) {
  test::Largest off("solid, seven laws strained in volume besides: effective stress [MPa], change",
                    "without strain of volume", 1e-10);
  for (const Case& one : cases(false)) {
    SolidDriver<double> calm(one.material, Isa::Scalar);
    SolidDriver<double> pressed(one.material, Isa::Scalar);
    for (int i = 0; i < 20; ++i) {
      calm.apply({0.001, -0.001, 0, 0.0005, 0, 0}, step);
      pressed.apply({0.001 - 0.003, -0.001 - 0.003, -0.003, 0.0005, 0, 0}, step);
    }
    off.compare(equivalent(pressed.stress()), equivalent(calm.stress()), 1, one.name);
  }
}

/// Held at a strain, a viscoplastic point relaxes. With p = 1 and no hardening the overstress decays
/// exponentially: d q = -3 G d p and d p / dt = C (q / sigma_0 - 1).
TEST(SolidRates, OverstressRelaxesExponentially) {
  constexpr double c = 100;
  model::Material material = plastic_kinematic(0, 1, c, 1);
  set_viscoplastic(material, true);
  const double time_scale = initial_yield / (3 * shear_modulus * c);
  double errors[3];
  int run = 0;
  for (const int steps : {100, 200, 400}) {
    SolidDriver<double> point(material, Isa::Scalar);
    // One very short step, in which nothing can flow.
    point.apply({0, 0, 0, 0, 0.003, 0}, 1e-12 * time_scale);
    const double start = root3 * point.stress()[4];
    EXPECT_NEAR(start, root3 * shear_modulus * 0.003, 1e-6 * start);
    for (int i = 0; i < steps; ++i) point.apply(Six{}, time_scale / steps);
    const double exact = initial_yield + (start - initial_yield) * std::exp(-1.0);
    errors[run++] = std::fabs(root3 * point.stress()[4] - exact);
  }
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.1);
  const std::string relaxed = "solid, relaxation of the overstress: ";
  test::verified(relaxed + "stress over the yield stress after 400 steps, error", "exponential decay")
      .below(errors[2] / initial_yield, 1e-3);
  test::verified(relaxed + "error of 200 steps over that of 400", "first order")
      .near(errors[1] / errors[2], 2, 0.05);
}

/// A yield stress that falls with the plastic rate: see the same test of shells.
TEST(SolidRates, ViscoplasticYieldStressMayFallWithTheRate) {
  model::Material material = tabulated({0, 0.02, 0.5}, {250, 300, 400});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.factor_rate = {0, 1, 50, 1000};
  law.rate_factor = {2, 1.6, 1.3, 1};
  law.viscoplastic = true;
  test::Largest off("solid, yield stress that falls with the plastic rate: stress [MPa], error",
                    "yield stress, formulated independently", 1e-11);
  for (const double rate : {5.0, 300.0, 5000.0}) {
    SolidDriver<double> point(material, available_isas().back());
    const double strain = 0.02;
    point.apply({0, 0, 0, root3 * strain, 0, 0}, strain / rate);
    const double p = point.item("plastic_strain");
    const double yield = interpolated({0, 0.02, 0.5}, {250, 300, 400}, p) *
                         interpolated({0, 1, 50, 1000}, {2, 1.6, 1.3, 1}, p / strain * rate);
    EXPECT_GT(p, 0.8 * strain);
    EXPECT_LT(yield, 2 * 250);
    off.compare(root3 * point.stress()[3], yield, 1, std::to_string(rate));
  }
}

/// Without hardening and rate effect the triaxiality under a pressure set before stays what it is.
TEST(SolidRates, FractureStrainDependsOnTriaxiality) {
  model::JohnsonCook law = johnson_cook_law();
  law.hardening = 0;
  law.rate_coefficient = 0;
  law.damage = {0.05, 0.3, -2.12, 0, 0};
  law.least_fracture_strain = 1e-6;
  test::Largest off("Johnson-Cook solid, triaxialities from -1 to 1.4: fracture strain, error", "closed form",
                    1.1e-4);
  for (const double triaxiality : {-1.0, 0.0, 0.5, 1.4})
    for (const Isa isa : available_isas()) {
      SolidDriver<double> point(johnson_cook(law), isa);
      const double volume = triaxiality * 792 * (1 - 2 * poissons_ratio) / youngs_modulus;
      point.apply({volume, volume, volume, 0, 0, 0}, step);
      const double size = 1e-4;
      int steps = 0;
      do point.apply({0, 0, 0, root3 * size, 0, 0}, step);
      while (point.intact() && ++steps < 50000);
      EXPECT_FALSE(point.intact());
      const double expected = 0.05 + 0.3 * std::exp(-2.12 * triaxiality);
      off.compare(point.item("plastic_strain"), expected, 1, std::to_string(triaxiality));
      EXPECT_EQ(point.stress(), Six{});
    }
}

/// Adiabatic shear without rate effect and with linear softening (m = 1): d T / d p = Y / (rho c) has
/// the solution Y = A exp(-A p / (rho c T_m)).
TEST(SolidRates, AdiabaticHeatSoftensExponentially) {
  model::JohnsonCook law = johnson_cook_law();
  law.hardening = 0;
  law.rate_coefficient = 0;
  law.thermal_exponent = 1;
  law.melting_rise = 1500;
  law.heat_capacity = 477e6;  // mJ / (t K)
  const std::string heated = "Johnson-Cook solid, adiabatic shear with linear softening: ";
  test::Largest temperatures(heated + "rise of temperature, relative error", "exponential", 0.01);
  double errors[2];
  int run = 0;
  for (const int steps : {400, 800}) {
    SolidDriver<double> point(johnson_cook(law), available_isas().back());
    for (int i = 0; i < steps; ++i) point.apply({0, 0, 0, 0, 0, root3 * 0.6 / steps}, step);
    const double exact = 792 * std::exp(-792 * point.item("plastic_strain") / (7.83e-9 * 477e6 * 1500));
    const double temperature = 1500 * (1 - exact / 792);
    temperatures.compare(point.item("temperature_rise"), temperature, temperature);
    errors[run++] = std::fabs(root3 * point.stress()[5] - exact) / exact;
  }
  test::verified(heated + "stress after 800 steps, relative error", "exponential").below(errors[1], 1e-3);
  test::verified(heated + "error of 400 steps over that of 800", "first order")
      .near(errors[0] / errors[1], 2, 0.01);
}

constexpr int million = 1000000;
constexpr double tangent = 2100;

/// Pure shear, in which the answer is exact (see EachPureShearIsExact).
double exact_plastic(double strain) {
  const double h = plastic_modulus(tangent);
  const double stress = (strain + root3 * initial_yield / h) / (1 / shear_modulus + 3 / h);
  return (strain - stress / shear_modulus) / root3;
}

TEST(SolidSlowLoading, AMillionFloatStepsGiveThePlasticStrain) {
  const auto line = plastic_kinematic(tangent, 1);
  const auto table = tabulated({0, 10}, {initial_yield, initial_yield + 10 * plastic_modulus(tangent)});
  const std::array<model::Material, 2> both{line, table};
  for (const double strain : {0.02, 0.2})
    for (const model::Material& material : both) {
      SolidDriver<float> point(material, available_isas().back());
      for (int i = 0; i < million; ++i) point.apply({0, 0, 0, strain / million, 0, 0}, step);
      // Rounding the stress turns elastic into plastic strain: at most half a last place, twice a step.
      const double last_place = 3.0517578125e-5 / 2;
      const std::string slow = std::string("solid, a million steps in single precision to ") +
                               (strain < 0.1 ? "2 %, " : "20 %, ") +
                               (&material == &both[0] ? "bilinear: " : "table: ");
      test::verified(slow + "plastic strain", "closed form; what rounding allows")
          .near(point.item("plastic_strain"), exact_plastic(strain),
                million * last_place / (root3 * shear_modulus));
      // The stress is that of the yield surface at this strain.
      const double yield = initial_yield + plastic_modulus(tangent) * point.item("plastic_strain");
      test::verified(slow + "stress off the yield surface [MPa]", "bilinear curve")
          .below(std::fabs(root3 * point.stress()[3] - yield), 3e-4);
    }
}

}  // namespace
}  // namespace crumple::materials::testing::solid_rates_test
