// SPDX-License-Identifier: BSD-3-Clause
// Plasticity of solids on paths without a closed form: the rate equations, the yield function, the bits.
#include <gtest/gtest.h>

#include <algorithm>

#include "materials/solid_driver.hpp"
#include "support/alike.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::solid_general_test {
namespace {

constexpr double tangent = 2100;

/// Rate equations with mixed hardening in six components: Prandtl & Reuss', or Perzyna's if `rate` is set.
struct RateForm {
  double isotropic = 0;
  double kinematic = 0;
  double rate_constant = 0;  ///< Cowper & Symonds' C; 0: no rate effect
  double exponent = 1;
  struct State {
    Six stress{};
    Six back{};
    double plastic = 0;
  };

  static Six elastic(const Six& e) {
    const double lame = youngs_modulus * poissons_ratio / ((1 + poissons_ratio) * (1 - 2 * poissons_ratio));
    const double volume = lame * (e[0] + e[1] + e[2]);
    return {volume + 2 * shear_modulus * e[0],
            volume + 2 * shear_modulus * e[1],
            volume + 2 * shear_modulus * e[2],
            shear_modulus * e[3],
            shear_modulus * e[4],
            shear_modulus * e[5]};
  }
  State rate(const State& s, const Six& strain_rate) const {
    Six xi;
    for (int c = 0; c < solid_components; ++c) xi[c] = s.stress[c] - s.back[c];
    const double q = equivalent(xi);
    const double yield = initial_yield + isotropic * s.plastic;
    State r;
    r.stress = elastic(strain_rate);
    if (q < yield * (1 - 1e-12)) return r;
    Six normal = xi;  // as a tensor, d q / d sigma
    for (int c = 0; c < 3; ++c) normal[c] -= mean(xi);
    double drive = 0;
    for (int c = 0; c < solid_components; ++c) {
      normal[c] *= 1.5 / q;
      drive += 2 * shear_modulus * normal[c] * strain_rate[c];
    }
    r.plastic = rate_constant > 0 ? rate_constant * std::pow(std::max(q / yield - 1, 0.0), exponent)
                                  : std::max(drive / (3 * shear_modulus + isotropic + kinematic), 0.0);
    for (int c = 0; c < solid_components; ++c) {
      r.stress[c] -= 2 * shear_modulus * r.plastic * normal[c];
      r.back[c] = 2.0 / 3 * kinematic * r.plastic * normal[c];
    }
    return r;
  }
  static State advanced(State s, const State& r, double h) {
    for (int c = 0; c < solid_components; ++c) {
      s.stress[c] += h * r.stress[c];
      s.back[c] += h * r.back[c];
    }
    s.plastic += h * r.plastic;
    return s;
  }
  template <class Path>
  State integrate(State s, double from, double to, int steps, const Path& strain_rate) const {
    const double h = (to - from) / steps;
    for (int i = 0; i < steps; ++i) {
      const double t = from + i * h;
      const State k1 = rate(s, strain_rate(t));
      const State k2 = rate(advanced(s, k1, h / 2), strain_rate(t + h / 2));
      const State k3 = rate(advanced(s, k2, h / 2), strain_rate(t + h / 2));
      const State k4 = rate(advanced(s, k3, h), strain_rate(t + h));
      s = advanced(advanced(advanced(advanced(s, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
    }
    return s;
  }
};

/// A path that turns while it yields; strains over a time of 1.5.
Six path_rate(double t) {
  return {0.006 * std::cos(2 * t),
          -0.003 + 0.004 * std::sin(t),
          0.002 - 0.003 * t,
          0.012 * std::sin(2 * t),
          0.003 * t,
          0.002 * std::sin(3 * t)};
}
/// The exact integral of the rate.
Six path_increment(double a, double b) {
  const double squares = b * b - a * a;
  return {0.003 * (std::sin(2 * b) - std::sin(2 * a)),
          -0.003 * (b - a) - 0.004 * (std::cos(b) - std::cos(a)),
          0.002 * (b - a) - 0.0015 * squares,
          -0.006 * (std::cos(2 * b) - std::cos(2 * a)),
          0.0015 * squares,
          -0.002 / 3 * (std::cos(3 * b) - std::cos(3 * a))};
}

/// Relative errors of the stress at the end of the path after 200, 400 and 800 steps.
std::array<double, 3> errors_on_path(const std::string& path, const model::Material& material,
                                     const RateForm& reference, double duration) {
  // To first yield the path is elastic: find that time, then integrate the plastic part alone.
  double low = 0;
  double high = 1;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (equivalent(RateForm::elastic(path_increment(0, middle))) < initial_yield ? low : high) = middle;
  }
  RateForm::State start;
  start.stress = RateForm::elastic(path_increment(0, high));
  RateForm scaled = reference;
  scaled.rate_constant *= duration;
  const RateForm::State exact = scaled.integrate(start, high, 1.5, 100000, path_rate);
  std::array<double, 3> errors{};
  test::Largest pressures(path + "mean stress over the yield stress, error", "elastic, no plastic volume",
                          1e-11);
  for (int run = 0; run < 3; ++run) {
    const int steps = 200 << run;
    SolidDriver<double> point(material, Isa::Scalar);
    for (int i = 0; i < steps; ++i)
      point.apply(path_increment(1.5 * i / steps, 1.5 * (i + 1) / steps), 1.5 * duration / steps);
    for (int c = 0; c < solid_components; ++c)
      errors[run] =
          test::larger_of(errors[run], std::fabs(point.stress()[c] - exact.stress[c]) / initial_yield);
    pressures.compare(mean(point.stress()), mean(exact.stress), initial_yield);
    EXPECT_NEAR(point.item("plastic_strain"), exact.plastic, 1.6 / steps * exact.plastic);
  }
  return errors;
}

TEST(SolidPlasticity, NonProportionalPathConvergesToTheRateEquationsWithFirstOrder) {
  const std::string path = "solid, path that turns while it yields, three kinds of hardening: ";
  test::Largest coarse(path + "stress over the yield stress after 200 steps, error",
                       "Prandtl-Reuss equations by Runge-Kutta", 2e-2);
  test::Largest orders(path + "error of 400 steps over that of 800, off 2", "first order", 0.2);
  for (const double beta : {0.0, 0.5, 1.0}) {
    const double h = plastic_modulus(tangent);
    const auto errors =
        errors_on_path(path, plastic_kinematic(tangent, beta), RateForm{beta * h, (1 - beta) * h}, 1);
    EXPECT_GT(errors[0], 1e-7) << "the path must not be proportional";
    EXPECT_NEAR(errors[0] / errors[1], 2, 0.4) << "beta " << beta;
    coarse.add(errors[0]);
    orders.compare(errors[1] / errors[2], 2, 1, "beta " + std::to_string(beta));
  }
}

TEST(SolidPlasticity, NonProportionalViscoplasticPathHasFirstOrder) {
  constexpr double c = 50;
  constexpr double p = 2;
  const std::string path = "viscoplastic solid, path that turns while it yields: ";
  test::Largest fine(path + "stress over the yield stress after 800 steps, error",
                     "Perzyna's equations by Runge-Kutta", 5e-3);
  test::Largest orders(path + "error of 400 steps over that of 800, off 2", "first order", 0.02);
  for (const double beta : {0.5, 1.0}) {
    model::Material material = plastic_kinematic(tangent, beta, c, p);
    std::get<model::PlasticKinematic>(material.law).viscoplastic = true;
    const double h = plastic_modulus(tangent);
    const auto errors = errors_on_path(path, material, RateForm{beta * h, (1 - beta) * h, c, p}, 1e-3);
    EXPECT_GT(errors[2], 1e-8);
    EXPECT_NEAR(errors[0] / errors[1], 2, 0.3) << "beta " << beta;
    fine.add(errors[2]);
    orders.compare(errors[1] / errors[2], 2, 1, "beta " + std::to_string(beta));
  }
}

/// Turns of every element and point by up to 0.3 about axes that change.
template <class Real>
void turn_all(SolidDriver<Real>& driver, int seed) {
  for (Index e = 0; e < tile_lanes; ++e)
    for (int p = 0; p < 3; ++p) {
      const double a = seed + 0.7 * static_cast<double>(e) + p;
      const std::array<double, 3> axis{std::cos(a) * std::sin(2 * a), std::sin(a) * std::sin(2 * a),
                                       std::cos(2 * a)};
      driver.set_turn(e, p, turn_about(axis, 0.3 * std::sin(3 * a)));
    }
}

/// Largest excess of the equivalent stress over the yield stress, by the yield stress. Each stress component
/// is rounded to its own size, so that a pressure's rounding is allowed for.
template <class Real>
double worst_excess(const model::Material& material, Isa isa) {
  SolidDriver<Real> driver(material, isa, 3);
  double worst = 0;
  for (int i = 0; i < 30; ++i) {
    turn_all(driver, i);
    random_walk(driver, i, 1, 2e-4, 1);
    for (Index e = 0; e < tile_lanes; ++e)
      for (int p = 0; p < 3; ++p) {
        const double yield = yield_stress(material, driver.item("plastic_strain", e, p));
        const double size = std::max(yield, std::fabs(mean(driver.stress(e, p))));
        worst = test::larger_of(worst, (equivalent(driver.relative(e, p)) - yield) / size);
      }
  }
  return worst;
}

TEST(SolidPlasticity, YieldFunctionIsKeptToRoundOffAfterEveryStep) {
  const std::string walk =
      "solid, nine laws on random strains and turns: excess over the yield stress or a larger pressure, ";
  test::Largest doubles(walk + "double precision", "yield surface", 1e-12);
  test::Largest singles(walk + "single precision", "yield surface", 1e-6);
  for (const model::Material& material : all_materials())
    for (const Isa isa : available_isas()) {
      const std::string place = std::string(isa_name(isa)) + " material " + std::to_string(material.id);
      doubles.add(worst_excess<double>(material, isa), place);
      singles.add(worst_excess<float>(material, isa), place);
    }
}

template <class Real>
void expect_equal_bits_in_pairs() {
  for (const model::Material& material : all_materials_with_rates()) {
    std::vector<std::vector<Real>> bits;
    for (const Isa isa : available_isas()) {
      SolidDriver<Real> driver(material, isa, 3);
      for (int i = 0; i < 20; ++i) {
        turn_all(driver, i);
        random_walk(driver, i, 1, 2e-4, 1e-5);
      }
      bits.push_back(driver.bits());
    }
    SCOPED_TRACE("material " + std::to_string(material.id));
    test::expect_alike(bits, [](const auto& a, const auto& b) { return same_bits(a, b); });
    for (std::size_t i = 0; i < bits[0].size(); ++i)
      for (const auto& other : bits)
        ASSERT_NEAR(other[i], bits[0][i], (sizeof(Real) == 4 ? 2e-4 : 1e-12) * 3000);
  }
}

TEST(SolidPlasticity, InstructionSetsWithTheSameRoundingGiveTheSameBits) {
  expect_equal_bits_in_pairs<double>();
  expect_equal_bits_in_pairs<float>();
}

/// The energy of a step is the trapezoid of stress over strain, with the old stress turned.
TEST(SolidPlasticity, EnergyIsTheTrapezoidOfStressOverStrain) {
  SolidDriver<double> point(plastic_kinematic(tangent, 0.3), available_isas().back(), 2);
  double energy = 0;
  double work = 0;
  for (int i = 0; i < 50; ++i) {
    const Six strain{0.0004, 0.0001, -0.0003, 0.0002 * std::sin(i), 0.0001, -0.0002};
    const double angle = 0.1 * std::cos(i);
    const Matrix turn = turn_about({0.6, 0, 0.8}, angle);
    const Six on = rotated(strain, turn_about({0.6, 0, 0.8}, 0.5 * angle), 0.5);
    const Six before = rotated(point.stress(3, 1), turn);
    point.set_strain(3, 1, strain);
    point.set_turn(3, 1, turn);
    point.apply();
    const Six after = point.stress(3, 1);
    for (int c = 0; c < solid_components; ++c) work += 0.5 * (before[c] + after[c]) * on[c];
    energy += point.energy(3, 1);
    EXPECT_EQ(point.energy(3, 0), 0);
  }
  test::verified("solid, fifty plastic steps with turns: energy over the work",
                 "trapezoid of stress over strain")
      .near(energy / work, 1, 1e-13);
}

}  // namespace
}  // namespace crumple::materials::testing::solid_general_test
