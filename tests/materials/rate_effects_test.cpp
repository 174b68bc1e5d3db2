// SPDX-License-Identifier: BSD-3-Clause
// Yield stresses that depend on the strain rate and on temperature; fracture.
#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "materials/rate_cases.hpp"
#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::rate_effects_test {
namespace {

constexpr double step = 1e-6;

double effective(const Five& e) {
  return std::sqrt(4.0 / 3 * (e[0] * e[0] + e[0] * e[1] + e[1] * e[1]) +
                   (e[2] * e[2] + e[3] * e[3] + e[4] * e[4]) / 3);
}

/// After every step the stress lies on the yield surface of the plastic strain rate of that step.
template <class Real>
double worst_excess(const Case& one, Isa isa, int flows) {
  double worst = 0;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 40; ++sample) {
    PointDriver<Real> point(one.material, isa);
    int flowing = 0;
    for (int i = 0; i < 200 && flowing < flows; ++i) {
      Five strain;
      const double size = 1e-4 * std::exp2(4 * uniform(generator));
      for (double& e : strain) e = static_cast<double>(static_cast<Real>(size * (0.5 + uniform(generator))));
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

TEST(RateEffects, StressLiesOnTheYieldSurfaceOfTheRate) {
  for (const bool viscoplastic : {false, true}) {
    const std::string rate = viscoplastic ? "VP 1" : "VP 0";
    test::Largest singles(
        "plane stress, all laws, " + rate + ": stress off the yield surface, single precision",
        "yield stress, formulated independently", 1e-6);
    for (const Case& one : cases(viscoplastic)) {
      test::Largest doubles(std::string("plane stress, ") + one.name + ", " + rate +
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

/// Shear at a constant rate: the plastic rate is the total less what the hardening stretches elastically.
TEST(RateEffects, PlasticRateFollowsTheTotalOneInSteadyFlow) {
  const std::string steady = "plane stress, nine laws in steady flow at 0.01 to 5000 per s: ";
  test::Largest flows(steady + "plastic rate over the total one, error", "rate equation", 2e-4);
  test::Largest stresses(steady + "stress [MPa], error", "yield stress, formulated independently", 1e-9);
  for (const double rate : {0.01, 5.0, 300.0, 5000.0}) {
    const double dt = 1e-4 / rate;
    for (const Case& one : cases(true)) {
      PointDriver<double> point(one.material, available_isas().back());
      double before = 0;
      for (int i = 0; i < 5000; ++i) {
        before = point.item("plastic_strain");
        point.apply({0, 0, root3 * 1e-4, 0, 0}, dt);
      }
      const double flow = (point.item("plastic_strain") - before) / dt;
      const double p = point.item("plastic_strain");
      // d q = 3 G (d e - d p) and d q = dY/dp d p.
      const double hardening = (one.yield(p, flow) - one.yield(p - 1e-5, flow)) / 1e-5;
      flows.compare(flow, rate / (1 + hardening / (3 * shear_modulus)), rate, one.name);
      stresses.compare(root3 * point.stress()[2], one.yield(p, flow), 1, one.name);
    }
  }
}

/// A yield stress that falls with the plastic rate makes flow start with a jump; the stress behind it is that
/// of the rate all the same, below all yield stresses at rest.
TEST(RateEffects, ViscoplasticYieldStressMayFallWithTheRate) {
  model::Material material = tabulated({0, 0.02, 0.5}, {250, 300, 400});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.factor_rate = {0, 1, 50, 1000};
  law.rate_factor = {2, 1.6, 1.3, 1};
  law.viscoplastic = true;
  test::Largest off("plane stress, yield stress that falls with the plastic rate: stress [MPa], error",
                    "yield stress, formulated independently", 1e-11);
  for (const double rate : {5.0, 300.0, 5000.0}) {
    PointDriver<double> point(material, available_isas().back());
    const double strain = 0.02;
    point.apply({0, 0, root3 * strain, 0, 0}, strain / rate);
    const double p = point.item("plastic_strain");
    const double yield = interpolated({0, 0.02, 0.5}, {250, 300, 400}, p) *
                         interpolated({0, 1, 50, 1000}, {2, 1.6, 1.3, 1}, p / strain * rate);
    EXPECT_GT(p, 0.8 * strain);
    EXPECT_LT(yield, 2 * 250);
    off.compare(root3 * point.stress()[2], yield, 1, std::to_string(rate));
  }
}

/// Held at a strain, a viscoplastic point relaxes. With p = 1 and no hardening the overstress decays
/// exponentially: d q = -3 G d p and d p / dt = C (q / sigma_0 - 1).
TEST(RateEffects, OverstressRelaxesExponentially) {
  constexpr double c = 100;
  model::Material material = plastic_kinematic(0, 1, c, 1);
  set_viscoplastic(material, true);
  const double time_scale = initial_yield / (3 * shear_modulus * c);
  double errors[3];
  int run = 0;
  for (const int steps : {100, 200, 400}) {
    PointDriver<double> point(material, Isa::Scalar);
    // One very short step, in which nothing can flow.
    point.apply({0, 0, 0.003, 0, 0}, 1e-12 * time_scale);
    const double start = root3 * point.stress()[2];
    EXPECT_NEAR(start, root3 * shear_modulus * 0.003, 1e-6 * start);
    for (int i = 0; i < steps; ++i) point.apply({0, 0, 0, 0, 0}, time_scale / steps);
    const double exact = initial_yield + (start - initial_yield) * std::exp(-1.0);
    errors[run++] = std::fabs(root3 * point.stress()[2] - exact);
  }
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.1);
  const std::string relaxed = "plane stress, relaxation of the overstress: ";
  test::verified(relaxed + "stress over the yield stress after 400 steps, error", "exponential decay")
      .below(errors[2] / initial_yield, 1e-3);
  test::verified(relaxed + "error of 200 steps over that of 400", "first order")
      .near(errors[1] / errors[2], 2, 0.05);
}

/// The rate equations of Perzyna's form in five components, integrated independently (Runge-Kutta).
TEST(RateEffects, NonProportionalViscoplasticPathHasFirstOrder) {
  constexpr double c = 50;
  constexpr double p = 2;
  constexpr double duration = 1e-3;
  model::Material material = plastic_kinematic(2100, 1, c, p);
  set_viscoplastic(material, true);
  const double h = plastic_modulus(2100);
  const auto strain_rate = [&](double t) {
    const double x = t / duration;
    return Five{6 * std::cos(2 * x), -3 + 4 * std::sin(x), 12 * std::sin(2 * x), 3 * x, 2 * std::sin(3 * x)};
  };
  struct State {
    Five s{};
    double plastic = 0;
  };
  const auto rate_of = [&](const State& state, double t) {
    const Five& s = state.s;
    Five e = strain_rate(t);
    const double q = equivalent(s);
    const double yield = initial_yield + h * state.plastic;
    const double flow = q > yield ? c * std::pow(q / yield - 1, p) : 0;
    if (flow > 0) {
      e[0] -= flow * (2 * s[0] - s[1]) / (2 * q);
      e[1] -= flow * (2 * s[1] - s[0]) / (2 * q);
      for (int k = 2; k < components; ++k) e[k] -= flow * 3 * s[k] / q;
    }
    const double d = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
    return State{{d * (e[0] + poissons_ratio * e[1]), d * (e[1] + poissons_ratio * e[0]),
                  shear_modulus * e[2], shear_modulus * e[3], shear_modulus * e[4]},
                 flow};
  };
  const auto moved = [](State state, const State& r, double by) {
    for (int k = 0; k < components; ++k) state.s[k] += by * r.s[k];
    state.plastic += by * r.plastic;
    return state;
  };
  State exact;
  const int fine = 200000;
  for (int i = 0; i < fine; ++i) {
    const double dt = duration / fine;
    const double t = i * dt;
    const State k1 = rate_of(exact, t);
    const State k2 = rate_of(moved(exact, k1, dt / 2), t + dt / 2);
    const State k3 = rate_of(moved(exact, k2, dt / 2), t + dt / 2);
    const State k4 = rate_of(moved(exact, k3, dt), t + dt);
    exact = moved(moved(moved(moved(exact, k1, dt / 6), k2, dt / 3), k3, dt / 3), k4, dt / 6);
  }
  double errors[3];
  int run = 0;
  for (const int steps : {400, 800, 1600}) {
    PointDriver<double> point(material, Isa::Scalar);
    const double dt = duration / steps;
    for (int i = 0; i < steps; ++i) {
      Five strain{};
      // Gauss's rule with two points for the increment.
      for (const double place : {0.21132486540518712, 0.78867513459481288}) {
        const Five r = strain_rate((i + place) * dt);
        for (int k = 0; k < components; ++k) strain[k] += 0.5 * dt * r[k];
      }
      point.apply(strain, dt);
    }
    double error = 0;
    for (int k = 0; k < components; ++k)
      error = test::larger_of(error, std::fabs(point.stress()[k] - exact.s[k]));
    errors[run++] = error / initial_yield;
  }
  EXPECT_GT(errors[2], 1e-8);
  EXPECT_NEAR(errors[0] / errors[1], 2, 0.3);
  const std::string path = "viscoplastic in plane stress, path that turns while it yields: ";
  test::verified(path + "stress over the yield stress after 1600 steps, error",
                 "Perzyna's equations by Runge-Kutta")
      .below(errors[2], 5e-3);
  test::verified(path + "error of 800 steps over that of 1600", "first order")
      .near(errors[1] / errors[2], 2, 0.02);
}

/// Adiabatic shear: heat softens. The rate equations in one variable, integrated independently.
TEST(JohnsonCook, AdiabaticHeatingConvergesWithFirstOrder) {
  model::JohnsonCook law = johnson_cook_law();
  law.thermal_exponent = 1.03;
  law.melting_rise = 1500;
  law.heat_capacity = 477e6;  // mJ / (t K)
  const model::Material material = johnson_cook(law);
  constexpr double total = 0.6;  // effective
  constexpr double rate = 1000;
  const double rate_factor = 1 + 0.014 * std::log(rate);
  const double per_work = 1 / (7.83e-9 * 477e6);
  // Plastic strain as independent variable: d T / d p = Y(p, T) rho^-1 c^-1, until elastic and plastic strain
  // make up the total.
  const auto yield = [&](double p, double t) {
    return (792 + 510 * std::pow(p, 0.26)) * rate_factor * (1 - std::pow(t / 1500, 1.03));
  };
  double temperature = 0;
  double plastic = 0;
  const double dp = total / 400000;
  while (plastic + yield(plastic, temperature) / (3 * shear_modulus) < total) {
    const double k1 = per_work * yield(plastic, temperature);
    const double k2 = per_work * yield(plastic + dp / 2, temperature + dp / 2 * k1);
    temperature += dp * k2;
    plastic += dp;
  }
  const double exact = yield(plastic, temperature);
  EXPECT_GT(temperature, 100);
  const std::string heated = "Johnson-Cook steel 4340, adiabatic shear to 60 %: ";
  const char* const source = "rate equation by Runge-Kutta";
  test::Largest temperatures(heated + "rise of temperature, relative error", source, 0.01);
  test::Largest stresses(heated + "stress after 800 steps, relative error", source, 1e-3);
  test::Largest orders(heated + "error of 400 steps over that of 800, off 2", "first order", 0.2);
  for (const Isa isa : available_isas()) {
    double errors[3];
    int run = 0;
    for (const int steps : {200, 400, 800}) {
      PointDriver<double> point(material, isa);
      for (int i = 0; i < steps; ++i) point.apply({0, 0, root3 * total / steps, 0, 0}, total / steps / rate);
      errors[run++] = std::fabs(root3 * point.stress()[2] - exact) / exact;
      temperatures.compare(point.item("temperature_rise"), temperature, temperature);
    }
    stresses.add(errors[2]);
    EXPECT_NEAR(errors[0] / errors[1], 2, 0.2);
    orders.compare(errors[1] / errors[2], 2);
  }
}

/// At constant triaxiality and rate the point fails at the fracture strain itself.
TEST(JohnsonCook, FractureStrainDependsOnTriaxialityAndRate) {
  model::JohnsonCook law = johnson_cook_law();
  law.damage = {0.05, 0.3, -2.12, 0.002, 0.61};
  law.least_fracture_strain = 1e-6;
  const model::Material material = johnson_cook(law);
  ASSERT_TRUE(can_fail(material));
  struct Path {
    Five strain;
    double triaxiality;
  };
  test::Largest off("Johnson-Cook in plane stress, three triaxialities, two rates: fracture strain, error",
                    "closed form", 1.1e-4);
  for (const Path& path : {Path{{0, 0, root3, 0, 0}, 0}, Path{{0.5, 0.5, 0, 0, 0}, 2.0 / 3},
                           Path{{-0.5, -0.5, 0, 0, 0}, -2.0 / 3}})
    for (const double rate : {0.1, 1000.0})
      for (const Isa isa : available_isas()) {
        const double expected =
            (0.05 + 0.3 * std::exp(-2.12 * path.triaxiality)) * (1 + 0.002 * std::log(std::max(rate, 1.0)));
        PointDriver<double> point(material, isa);
        const double size = 1e-4;
        Five strain = path.strain;
        for (double& e : strain) e *= size;
        const double dt = effective(strain) / rate;
        int steps = 0;
        do point.apply(strain, dt);
        while (point.intact() && ++steps < 20000);
        EXPECT_FALSE(point.intact());
        off.compare(point.item("plastic_strain"), expected, 1, std::to_string(path.triaxiality));
        EXPECT_EQ(point.stress(), Five{});
      }
}

TEST(JohnsonCook, StressIsBoundedBeforeAndAfterTheRateEffect) {
  test::Largest off("Johnson-Cook, bounded before and after the rate effect: stress, relative error",
                    "the bound", 1e-11);
  for (const double rate : {0.5, 1000.0}) {
    const double factor = 1 + 0.014 * std::log(std::max(rate, 1.0));
    for (const bool saturation : {false, true}) {
      model::JohnsonCook law = johnson_cook_law();
      (saturation ? law.saturation_stress : law.largest_hardened) = 1000;
      PointDriver<double> point(johnson_cook(law), available_isas().back());
      for (int i = 0; i < 4000; ++i) point.apply({0, 0, root3 * 1e-4, 0, 0}, 1e-4 / rate);
      const double expected = saturation ? 1000 : 1000 * factor;
      off.compare(root3 * point.stress()[2], expected, expected);
    }
  }
}

/// The rate effect alone may reach the bound: the yield stress is the bound then, below A times the rate
/// factor.
TEST(JohnsonCook, StressIsBoundedWhereTheRateEffectAloneExceedsTheBound) {
  for (const double strain : {1.3e-3, 2e-3, 5e-3, 2e-2}) {
    model::JohnsonCook law = johnson_cook_law();
    law.yield_stress = 200;
    law.hardening = 0;
    law.rate_coefficient = 0.1;
    law.saturation_stress = 250;
    PointDriver<double> point(johnson_cook(law), available_isas().back());
    point.apply({0, 0, root3 * strain, 0, 0}, strain / 1000);
    EXPECT_LE(root3 * point.stress()[2], 250 * (1 + 1e-11)) << strain;
    EXPECT_GT(root3 * point.stress()[2], 0.5 * 250) << strain;
  }
}

/// Mild steel with a table of hardening, sheared at four rates; the plastic rate is that of the law.
TEST(RateEffects, StressOverStrainIsDrawn) {
  model::Material material = tabulated({0, 0.02, 0.1, 0.3}, {250, 300, 350, 420});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.cowper_symonds_rate = 40.4;
  law.cowper_symonds_exponent = 5;
  auto picture = test::drawn("Mild steel sheared at 1e-12, 1, 40 and 1000 per s", "effective strain",
                             "effective stress [MPa]");
  test::Largest off(
      "plane stress, piecewise linear with Cowper and Symonds, four rates: stress over strain, error",
      "closed form", 1e-12);
  for (const double rate : {1e-12, 1.0, 40.0, 1000.0}) {
    PointDriver<double> point(material, available_isas().back());
    test::Points exact{{0, 0}};
    test::Points found;
    double plastic = 0;
    for (int i = 1; i <= 100; ++i) {
      point.apply({0, 0, root3 * 2e-3, 0, 0}, 2e-3 / rate);
      const double strain = 2e-3 * i;
      // q = 3 G (e - p) and q = factor Y(p): the plastic strain by bisection.
      double low = plastic;
      double high = strain;
      for (int k = 0; k < 100; ++k) {
        const double p = 0.5 * (low + high);
        const double factor = 1 + std::pow((p - plastic) / 2e-3 * rate / 40.4, 0.2);
        const double yield = factor * interpolated({0, 0.02, 0.1, 0.3}, {250, 300, 350, 420}, p);
        (3 * shear_modulus * (strain - p) > yield ? low : high) = p;
      }
      plastic = low;
      const double stress = 3 * shear_modulus * (strain - low);
      off.compare(root3 * point.stress()[2], stress, stress);
      exact.push_back({strain, stress});
      if (i % 12 == 0) found.push_back({strain, root3 * point.stress()[2]});
    }
    picture.accepted(rate < 1 ? "Cowper and Symonds" : "", exact)
        .found(rate < 1 ? "one point of a shell" : "", found);
  }
  picture.note();
}

TEST(RateInput, BadNumbersAreNamed) {
  const auto refuses = [](const model::Material& material) {
    EXPECT_THROW(shell_material_constants(material), Error);
  };
  auto power = power_law();
  std::get<model::PowerLawPlasticity>(power.law).exponent = 1.5;
  refuses(power);
  power = power_law();
  std::get<model::PowerLawPlasticity>(power.law).yield_strain = 0;
  refuses(power);
  model::JohnsonCook law = johnson_cook_law();
  law.reference_rate = 0;
  refuses(johnson_cook(law));
  law = johnson_cook_law();
  law.saturation_stress = 10;
  refuses(johnson_cook(law));
  law = johnson_cook_law();
  law.damage[0] = 1;
  refuses(johnson_cook(law));
  auto table = by_rate(false);
  std::swap(std::get<model::PiecewiseLinearPlasticity>(table.law).by_rate[0],
            std::get<model::PiecewiseLinearPlasticity>(table.law).by_rate[1]);
  refuses(table);
}

}  // namespace
}  // namespace crumple::materials::testing::rate_effects_test
