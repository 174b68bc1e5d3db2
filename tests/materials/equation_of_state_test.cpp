// SPDX-License-Identifier: BSD-3-Clause
// Equations of state against Hugoniots and isentropes, and the laws that use them.
#include <gtest/gtest.h>

#include <functional>

#include "base/error.hpp"
#include "materials/eos/gruneisen.hpp"
#include "materials/eos/linear_polynomial.hpp"
#include "materials/motion_driver.hpp"
#include "support/copper.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::equation_of_state_test {
namespace {

constexpr double density = test::copper_density;

model::Gruneisen copper() {
  return {3.94, {1.489, 0, 0}, 2.02, 0.47};
}
model::EquationOfState equation(const model::PressureLaw& law, double energy = 0, double volume = 1) {
  return {4, "", energy, volume, law};
}
model::EquationOfState gas(double volume = 1) {
  return equation(model::LinearPolynomial{{0, 0, 0, 0, 0.4, 0.4, 0}}, 0.25, volume);
}
model::Material material(const model::ConstitutiveLaw& law) {
  model::Material found;
  found.id = 15;
  found.density = density;
  found.law = law;
  return found;
}
model::Material fluid(double least_pressure = 0) {
  return material(model::NullMaterial{0, 0, least_pressure});
}
EosPoint<double> gruneisen_at(const model::Gruneisen& law, double mu) {
  return GruneisenEquation::at<double>(GruneisenEquation::constants(law, fluid()).data(), mu);
}
EosPoint<double> polynomial_at(const model::LinearPolynomial& law, double mu) {
  return LinearPolynomialEquation::at<double>(LinearPolynomialEquation::constants(law, fluid()).data(), mu);
}

/// Rankine & Hugoniot: with eta = u / U, rho0 U u is the pressure, u^2/2 per mass the energy.
TEST(Gruneisen, HasTheHugoniotOfItsShockVelocity) {
  test::Largest off("Gruneisen: pressure on the Hugoniot, relative error",
                    "Rankine and Hugoniot; Steinberg 1991", 1e-13);
  for (const model::Gruneisen& law : {copper(), model::Gruneisen{3.94, {1.489, 0, 0}, 2.02, 0},
                                      model::Gruneisen{1.48, {2.56, -1.986, 0.2268}, 0.5, 0}})
    for (const double eta : {0.01, 0.05, 0.15, 0.3}) {
      // U = C + S1 u + S2 (u/U) u + S3 (u/U)^2 u, D.J. Steinberg, UCRL-MA-106439 (1991).
      const double speed = law.sound_speed / (1 - law.slopes[0] * eta - law.slopes[1] * eta * eta -
                                              law.slopes[2] * eta * eta * eta);
      const double particle = eta * speed;
      const double energy = 0.5 * density * particle * particle;
      const auto at = gruneisen_at(law, eta / (1 - eta));
      off.compare((at.cold + at.thermal * energy) / (density * speed * particle), 1);
    }
}

/// What a point reaches in one step along the Rayleigh line, drawn over the Hugoniot of U = C + S u.
TEST(Gruneisen, HugoniotIsDrawn) {
  test::Points exact;
  test::Points found;
  const auto law = equation(copper());
  test::Largest off("Gruneisen, copper, in one step to 30 %: pressure over that of the Hugoniot, error",
                    "Rankine and Hugoniot", 1e-12);
  for (int i = 0; i <= 30; ++i) {
    const double eta = 0.01 * i;
    const double speed = 3.94 / (1 - 1.489 * eta);
    const double pressure = density * speed * speed * eta;
    exact.push_back({eta, pressure});
    if (i % 2 != 0 || i == 0) continue;
    MotionDriver<double> point(fluid(), Isa::Scalar, &law);
    point.move_to(volumetric(1 - eta), 1, 0);
    off.compare(point.pressure(), pressure, pressure);
    found.push_back({eta, point.pressure()});
  }
  test::drawn("Copper compressed along the Rayleigh line", "1 - V / V0", "pressure [GPa]")
      .accepted("Hugoniot of U = C + S u", exact)
      .found("one step of one point", found)
      .note();
}

TEST(Gruneisen, IsLinearInTension) {
  const auto at = gruneisen_at(copper(), -0.1);
  test::verified("Gruneisen, 10 % expansion: cold pressure [GPa]", "rho c^2 mu")
      .near(at.cold, -0.1 * density * 3.94 * 3.94, 1e-12);
  EXPECT_NEAR(at.thermal, 2.02 - 0.047, 1e-15);
}

TEST(LinearPolynomial, DropsItsSquaresInTension) {
  const model::LinearPolynomial law{{0.1, 80, 120, 200, 1.5, 0.7, 0.3}};
  const auto squeezed = polynomial_at(law, 0.2);
  test::verified("linear polynomial, 20 % compression: cold pressure [GPa]", "closed form")
      .near(squeezed.cold, 0.1 + 16 + 4.8 + 1.6, 1e-13);
  EXPECT_NEAR(squeezed.thermal, 1.5 + 0.14 + 0.012, 1e-15);
  const auto pulled = polynomial_at(law, -0.2);
  test::verified("linear polynomial, 20 % expansion, without squares: cold pressure [GPa]", "closed form")
      .near(pulled.cold, 0.1 - 16 - 1.6, 1e-13);
  EXPECT_NEAR(pulled.thermal, 1.5 - 0.14, 1e-15);
}

TEST(EquationOfState, SlopesAreThoseOfTheCurves) {
  const model::LinearPolynomial law{{0.1, 80, 120, 200, 1.5, 0.7, 0.3}};
  test::Largest off("both equations of state, -30 % to 40 %: slope of the cold pressure, relative error",
                    "central differences", 2e-8);
  const auto check = [&](const std::function<EosPoint<double>(double)>& at, double mu) {
    constexpr double h = 1e-5;
    off.compare((at(mu + h).cold - at(mu - h).cold) / (2 * h), at(mu).cold_slope, at(mu).cold_slope);
    EXPECT_NEAR((at(mu + h).thermal - at(mu - h).thermal) / (2 * h), at(mu).thermal_slope, 1e-8);
  };
  for (const double mu : {-0.3, -0.01, 0.01, 0.1, 0.4}) {
    check([&](double x) { return polynomial_at(law, x); }, mu);
    check([&](double x) { return gruneisen_at(copper(), x); }, mu);
    check([&](double x) { return gruneisen_at({1.48, {2.56, -1.986, 0.2268}, 0.5, 0.1}, x); }, mu);
  }
}

class Eos : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Eos, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// A gamma-law gas: p v^1.4 stays what it is, and c^2 = 1.4 p / rho. V0 other than 1 shifts the start.
TEST_P(Eos, GasFollowsItsIsentropeWithSecondOrder) {
  const std::string moved = "gamma-law gas, compressed to 0.4 and expanded to 2: ";
  test::Largest off(moved + "pressure after 400 steps, relative error", "isentrope p V^1.4", 1e-5);
  test::Largest orders(moved + "error of 200 steps over that of 400, off 4", "second order", 0.001);
  test::Largest speeds(moved + "wave speed, error [mm/microsecond]", "c^2 = 1.4 p / rho", 1e-13);
  test::Largest works(moved + "work against internal energy, difference [GPa]", "first law", 1e-6);
  for (const double start : {1.0, 0.8})
    for (const double end : {0.4, 2.0}) {
      double error[2];
      for (const int fine : {0, 1}) {
        const auto equation = gas(start);
        MotionDriver<double> point(fluid(), GetParam(), &equation);
        point.move_to(unit, 0);
        EXPECT_NEAR(point.pressure(), 0.4 * 0.25 / start, 1e-15);
        const int steps = fine == 0 ? 200 : 400;
        for (int i = 1; i <= steps; ++i) point.move_to(volumetric(1 + (end - 1) * i / steps));
        const double expected = 0.4 * 0.25 / start * std::pow(end, -1.4);
        error[fine] = point.pressure() / expected - 1;
        const double rho = density / (start * end);
        speeds.compare(point.wave_speed(), std::sqrt(1.4 * point.pressure() / rho));
        // Work per volume at time zero is energy per reference volume over V0.
        works.compare(point.work(), point.item("internal_energy") / start);
      }
      off.add(std::fabs(error[1]));
      orders.compare(error[0] / error[1], 4);
    }
}

/// dE = -p dv integrated independently, by Runge & Kutta.
TEST_P(Eos, GruneisenFollowsItsIsentrope) {
  const auto pressure = [](double v, double e) {
    const auto at = gruneisen_at(copper(), 1 / v - 1);
    return at.cold + at.thermal * e;
  };
  const std::string moved = "Gruneisen, copper, isentropes to 0.75 and 1.15: ";
  const char* const source = "Runge-Kutta integration of dE = -p dV";
  test::Largest pressures(moved + "pressure after 1000 steps, relative error", source, 3e-6);
  test::Largest energies(moved + "energy after 1000 steps, relative error", source, 3e-6);
  test::Largest singles(moved + "pressure in single precision, relative error", "double precision", 3e-6);
  test::Largest speeds(moved + "wave speed, relative error", "differences along the isentrope", 1e-3);
  for (const double end : {0.75, 1.15}) {
    double energy = 0;
    const int pieces = 2000;
    const double h = (end - 1) / pieces;
    for (int i = 0; i < pieces; ++i) {
      const double v = 1 + h * i;
      const double k1 = -pressure(v, energy);
      const double k2 = -pressure(v + h / 2, energy + h / 2 * k1);
      const double k3 = -pressure(v + h / 2, energy + h / 2 * k2);
      const double k4 = -pressure(v + h, energy + h * k3);
      energy += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    const auto law = equation(copper());
    MotionDriver<double> point(fluid(), GetParam(), &law);
    MotionDriver<float> coarse(fluid(), GetParam(), &law);
    for (int i = 1; i <= 1000; ++i) {
      point.move_to(volumetric(1 + (end - 1) * i / 1000));
      coarse.move_to(volumetric(1 + (end - 1) * i / 1000));
    }
    pressures.compare(point.pressure() / pressure(end, energy), 1);
    energies.compare(point.item("internal_energy") / energy, 1);
    singles.compare(coarse.pressure() / point.pressure(), 1);
    EXPECT_NEAR(coarse.item("internal_energy") / point.item("internal_energy"), 1, 3e-6);
    // Tangent at constant entropy: dp/dv along the path.
    const double near = 1e-4;
    const double p_end = point.pressure();
    const double speed = point.wave_speed();
    point.move_to(volumetric(end * (1 + near)));
    const double bulk = -(point.pressure() - p_end) / near;
    speeds.compare(speed, std::sqrt(bulk * end / density), speed);
  }
}

/// In one step along the Rayleigh line viscosity makes up for what the pressure lacks: the energy is that of
/// the Hugoniot, in however large a step.
TEST_P(Eos, ViscousWorkTakesTheStateToTheHugoniot) {
  const double eta = 0.15;
  const double speed = 3.94 / (1 - 1.489 * eta);
  const double pressure = density * speed * speed * eta;
  const auto law = equation(copper());
  MotionDriver<double> point(fluid(), GetParam(), &law);
  // Half of (0 + p_H) is the trapezoid of the pressure; the rest of p_H / 2 on average is viscosity's.
  point.move_to(volumetric(1 - eta), 1, 0);
  const char* const source = "Rankine and Hugoniot";
  test::verified("shock of 15 % in copper in one step: pressure [GPa]", source)
      .within(point.pressure(), pressure, 1e-12);
  test::verified("shock of 15 % in copper in one step: energy [GPa]", source)
      .near(point.item("internal_energy"), pressure * eta / 2, 1e-12);
  // A viscosity that adds as much as a half sine would.
  MotionDriver<double> other(fluid(), GetParam(), &law);
  other.move_to(volumetric(1 - eta), 1, 0.1 * pressure);
  EXPECT_GT(other.item("internal_energy"), 0.6 * pressure * eta);
}

/// The deviator is that of the same law without an equation of state, the pressure that of the fluid with the
/// plastic work in its energy.
TEST_P(Eos, JohnsonCookKeepsItsDeviator) {
  const auto law = equation(copper());
  const auto metal = material(test::ofhc_copper());
  MotionDriver<double> point(metal, GetParam(), &law);
  MotionDriver<double> elastic(metal, GetParam());
  test::Largest off("Johnson-Cook with Gruneisen: deviator, difference [GPa]",
                    "the law without an equation of state", 1e-12);
  for (int i = 1; i <= 200; ++i) {
    const Matrix f{{{1 - 8e-4 * i, 5e-4 * i, 0}, {0, 1 + 1e-4 * i, 0}, {2e-4 * i, 0, 1}}};
    point.move_to(f, 1e-3);
    elastic.move_to(f, 1e-3);
    const Six a = point.stress();
    const Six b = elastic.stress();
    Six da = a;
    Six db = b;
    for (int k = 0; k < 3; ++k) {
      da[k] -= mean(a);
      db[k] -= mean(b);
    }
    off.add(largest_difference(da, db));
  }
  const double volume = determinant(point.at());
  const double energy = point.item("internal_energy");
  const auto at = gruneisen_at(copper(), 1 / volume - 1);
  test::verified("Johnson-Cook with Gruneisen: pressure at its energy and volume [GPa]", "equation of state")
      .near(point.pressure(), at.cold + at.thermal * energy, 1e-12);
  EXPECT_GT(energy, 0);
  test::verified("Johnson-Cook with Gruneisen: work over internal energy", "first law")
      .near(point.work() / energy, 1, 2e-7);
  EXPECT_GT(point.item("plastic_strain"), 0.1);
}

TEST_P(Eos, PressureCutOffIsKept) {
  const auto law = equation(copper());
  MotionDriver<double> water(fluid(-0.5), GetParam(), &law);
  water.move_in_steps(volumetric(1.02), 50);
  EXPECT_EQ(water.pressure(), -0.5);
  const double spent = water.item("internal_energy");
  EXPECT_GT(spent, 1e-3);
  // The pressure is a function of the state with the cut-off too: the way back gives the energy back.
  water.move_in_steps(volumetric(1.0), 50);
  test::verified("cut-off in tension and back to the volume at rest: energy left over that spent",
                 "reversible")
      .below(std::fabs(water.item("internal_energy")) / spent, 1e-12);
  EXPECT_NEAR(water.pressure(), 2.02 * water.item("internal_energy"), 1e-15);
  for (const auto spall : {model::Spall::None, model::Spall::Stress, model::Spall::Pressure}) {
    auto metal = test::ofhc_copper();
    metal.least_pressure = -1.2;
    metal.spall = spall;
    MotionDriver<double> point(material(metal), GetParam(), &law);
    point.move_in_steps({{{1.05, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 100, 1e-3);
    const bool rubble = spall != model::Spall::None;
    EXPECT_EQ(point.item("rubble") != 0, rubble);
    EXPECT_NEAR(point.pressure(), rubble ? 0 : -1.2, 1e-14);
    EXPECT_EQ(equivalent(point.stress()) > 0, !rubble);
    // Rubble carries pressure and nothing else.
    point.move_in_steps({{{0.95, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 100, 1e-3);
    EXPECT_GT(point.pressure(), 5);
    EXPECT_EQ(equivalent(point.stress()) > 1e-9, !rubble);
  }
}

/// Spall by stress comes when mean stress and deviator together reach the bound: before that of the pressure.
TEST_P(Eos, SpallByStressLooksAtTheLargestPrincipalStress) {
  const auto law = equation(copper());
  const auto volume_at_spall = [&](model::Spall spall) {
    auto metal = test::ofhc_copper();
    metal.least_pressure = -1.2;
    metal.spall = spall;
    MotionDriver<double> point(material(metal), GetParam(), &law);
    MotionDriver<double> whole(material(test::ofhc_copper()), GetParam(), &law);
    const Matrix q = rotation({0.6, 0, 0.8}, 0.7);
    for (int i = 1;; ++i) {
      Matrix f = unit;
      f[1][1] += 1e-5 * i;
      f = times(q, times(f, transposed(q)));
      whole.move_to(f, 1e-3);
      point.move_to(f, 1e-3);
      if (point.item("rubble") != 0) {
        const double tension = spall == model::Spall::Stress
                                   ? mean(whole.stress()) + 2.0 / 3 * equivalent(whole.stress())
                                   : mean(whole.stress());
        test::verified(std::string("spall by ") +
                           (spall == model::Spall::Stress ? "largest principal stress" : "pressure") +
                           ": tension when it comes [GPa]",
                       "the bound")
            .near(tension, 1.2, 3e-3);
        return determinant(f);
      }
      if (i > 10000) {
        ADD_FAILURE() << "no spall";
        return 0.0;
      }
    }
  };
  EXPECT_LT(volume_at_spall(model::Spall::Stress), volume_at_spall(model::Spall::Pressure));
}

TEST_P(Eos, FluidHasTheViscousDeviatorAndErodesByVolume) {
  const auto law = equation(copper());
  auto viscous = material(model::NullMaterial{0, 0, -0.1, 0.02, 1.1, 0.8});
  ASSERT_TRUE(solid_can_fail(viscous));
  ASSERT_FALSE(solid_can_fail(fluid()));
  MotionDriver<double> point(viscous, GetParam(), &law);
  const double step = 0.01;
  point.move_to({{{1, 1e-3, 0}, {0, 1, 0}, {0, 0, 1}}}, step);
  test::verified("viscous fluid in shear: shear stress [GPa]", "viscosity times rate")
      .near(point.stress()[3], 0.02 * 1e-3 / step, 1e-12);
  point.move_in_steps(volumetric(1.09), 10, step);
  EXPECT_TRUE(point.intact());
  point.move_to(volumetric(1.11), step);
  EXPECT_FALSE(point.intact());
  EXPECT_EQ(point.pressure(), 0);
  MotionDriver<double> pressed(viscous, GetParam(), &law);
  pressed.move_in_steps(volumetric(0.81), 10, step);
  EXPECT_TRUE(pressed.intact());
  pressed.move_to(volumetric(0.79), step);
  EXPECT_FALSE(pressed.intact());
}

TEST(EosStart, GivesDensityAndWaveSpeed) {
  const auto law = equation(copper());
  auto metal = test::ofhc_copper();
  metal.shear_modulus = 47;
  const SolidStart start = solid_start(material(metal), &law);
  EXPECT_TRUE(start.varies);
  test::verified("copper with Gruneisen at rest: wave speed [mm/microsecond]", "sqrt(c^2 + 4/3 G / rho)")
      .near(start.wave_speed, std::sqrt(3.94 * 3.94 + 4.0 / 3 * 47 / density), 1e-12);
  const auto squeezed = equation(copper(), 1.0, 0.9);
  EXPECT_NEAR(solid_start(fluid(), &squeezed).density, density / 0.9, 1e-12);
  const auto cold_gas = equation(model::LinearPolynomial{{0, 0, 0, 0, 0.4, 0.4, 0}});
  EXPECT_THROW(solid_start(fluid(), &cold_gas), Error);
  // The same slope, found in the description and in the kernel.
  MotionDriver<double> point(fluid(), Isa::Scalar, &squeezed);
  point.move_to(unit, 0);
  EXPECT_NEAR(point.wave_speed(), solid_start(fluid(), &squeezed).wave_speed, 1e-7);
}

template <class... Laws>
std::vector<model::ConstitutiveLaw> every_law(const std::variant<Laws...>& /*any*/) {
  return {model::ConstitutiveLaw(Laws{})...};
}

/// The deck tells from model::use_of what elements a law is for; the lists must agree.
TEST(EosStart, ListsAgreeWithTheDescription) {
  for (const model::ConstitutiveLaw& law : every_law(model::ConstitutiveLaw())) {
    EXPECT_EQ(model::use_of(law).shells, shell_material_kind(law) >= 0) << law.index();
    EXPECT_EQ(model::use_of(law).solids, solid_material_kind(law) >= 0) << law.index();
  }
}

}  // namespace
}  // namespace crumple::materials::testing::equation_of_state_test
