// SPDX-License-Identifier: BSD-3-Clause
// Plane-stress plasticity on paths without a closed form: the rate equations, the yield function, the bits.
#include <gtest/gtest.h>

#include <algorithm>

#include "materials/point_driver.hpp"
#include "support/alike.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::plasticity_general_test {
namespace {

constexpr double tangent = 2100;

/// Prandtl-Reuss rate equations with mixed hardening, in the five components.
struct RateForm {
  double isotropic = 0;
  double kinematic = 0;
  struct State {
    Five stress{};
    Five back{};
    double plastic = 0;
  };

  static Five elastic(const Five& e) {
    const double d = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
    return {d * (e[0] + poissons_ratio * e[1]), d * (e[1] + poissons_ratio * e[0]), shear_modulus * e[2],
            shear_modulus * e[3], shear_modulus * e[4]};
  }
  State rate(const State& s, const Five& strain_rate) const {
    Five xi;
    for (int c = 0; c < components; ++c) xi[c] = s.stress[c] - s.back[c];
    const double q = equivalent(xi);
    State r;
    r.stress = elastic(strain_rate);
    if (q < (initial_yield + isotropic * s.plastic) * (1 - 1e-12)) return r;
    const Five normal{(2 * xi[0] - xi[1]) / (2 * q), (2 * xi[1] - xi[0]) / (2 * q), 3 * xi[2] / q,
                      3 * xi[3] / q, 3 * xi[4] / q};
    const Five flow = elastic(normal);
    double drive = 0;
    double resist = isotropic + kinematic;
    for (int c = 0; c < components; ++c) {
      drive += normal[c] * r.stress[c];
      resist += normal[c] * flow[c];
    }
    const double multiplier = std::max(drive / resist, 0.0);
    for (int c = 0; c < components; ++c) {
      r.stress[c] -= multiplier * flow[c];
      r.back[c] = kinematic * multiplier * xi[c] / q;
    }
    r.plastic = multiplier;
    return r;
  }
  static State advanced(const State& s, const State& r, double h) {
    State n = s;
    for (int c = 0; c < components; ++c) {
      n.stress[c] += h * r.stress[c];
      n.back[c] += h * r.back[c];
    }
    n.plastic += h * r.plastic;
    return n;
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
      s = advanced(s, k1, h / 6);
      s = advanced(s, k2, h / 3);
      s = advanced(s, k3, h / 3);
      s = advanced(s, k4, h / 6);
    }
    return s;
  }
};

/// Loading to yield along xx, then a turn into shear and the other direct strain while yielding.
TEST(Plasticity, NonProportionalPathConvergesToTheRateEquationsWithFirstOrder) {
  const auto strain_rate = [](double t) {
    return Five{0.006 * std::cos(2 * t), -0.003 + 0.004 * std::sin(t), 0.012 * std::sin(2 * t), 0.003 * t,
                0.002 * std::sin(3 * t)};
  };
  const auto increment = [&](double a, double b) {
    // Exact integral of the rate.
    return Five{0.003 * (std::sin(2 * b) - std::sin(2 * a)),
                -0.003 * (b - a) - 0.004 * (std::cos(b) - std::cos(a)),
                -0.006 * (std::cos(2 * b) - std::cos(2 * a)), 0.0015 * (b * b - a * a),
                -0.002 / 3 * (std::cos(3 * b) - std::cos(3 * a))};
  };
  const std::string path = "plane stress, path that turns while it yields, three kinds of hardening: ";
  const char* const source = "Prandtl-Reuss equations by Runge-Kutta";
  test::Largest coarse(path + "stress over the yield stress after 200 steps, error", source, 2e-2);
  test::Largest strains(path + "plastic strain after 800 steps, relative error", source, 2e-3);
  test::Largest orders(path + "error of 400 steps over that of 800, off 2", "first order", 0.2);
  for (const double beta : {0.0, 0.5, 1.0}) {
    const double h = plastic_modulus(tangent);
    RateForm reference{beta * h, (1 - beta) * h};
    // To first yield the path is elastic: find that time, then integrate the plastic part alone.
    double low = 0;
    double high = 1;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (equivalent(RateForm::elastic(increment(0, middle))) < initial_yield ? low : high) = middle;
    }
    RateForm::State start;
    start.stress = RateForm::elastic(increment(0, high));
    const RateForm::State exact = reference.integrate(start, high, 1.5, 40000, strain_rate);
    double errors[3];
    int run = 0;
    for (const int steps : {200, 400, 800}) {
      PointDriver<double> point(plastic_kinematic(tangent, beta), Isa::Scalar);
      for (int i = 0; i < steps; ++i) point.apply(increment(1.5 * i / steps, 1.5 * (i + 1) / steps));
      double error = 0;
      for (int c = 0; c < components; ++c)
        error = test::larger_of(error, std::fabs(point.stress()[c] - exact.stress[c]));
      errors[run++] = error / initial_yield;
      if (steps == 800) {
        strains.compare(point.item("plastic_strain"), exact.plastic, exact.plastic);
      }
    }
    EXPECT_GT(errors[0], 1e-7) << "the path must not be proportional";
    EXPECT_NEAR(errors[0] / errors[1], 2, 0.4) << "beta " << beta;
    coarse.add(errors[0]);
    orders.compare(errors[1] / errors[2], 2, 1, "beta " + std::to_string(beta));
  }
}

template <class Real>
double worst_excess(const model::Material& material, Isa isa) {
  PointDriver<Real> driver(material, isa, 3);
  double worst = 0;
  for (int i = 0; i < 30; ++i) {
    random_walk(driver, i, 1, 2e-4, 1);
    for (Index e = 0; e < tile_lanes; ++e)
      for (int p = 0; p < 3; ++p) {
        const double yield = yield_stress(material, driver.item("plastic_strain", e, p));
        worst = test::larger_of(worst, (equivalent(driver.relative(e, p)) - yield) / yield);
      }
  }
  return worst;
}

TEST(Plasticity, YieldFunctionIsKeptToRoundOffAfterEveryStep) {
  const std::string walk = "plane stress, nine laws on random strains: excess over the yield stress, ";
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
      PointDriver<Real> driver(material, isa, 3);
      random_walk(driver, 7, 20, 2e-4, 1e-5);
      bits.push_back(driver.bits());
    }
    SCOPED_TRACE("material " + std::to_string(material.id));
    test::expect_alike(bits, [](const auto& a, const auto& b) { return same_bits(a, b); });
    for (std::size_t i = 0; i < bits[0].size(); ++i)
      for (const auto& other : bits)
        ASSERT_NEAR(other[i], bits[0][i], (sizeof(Real) == 4 ? 2e-4 : 1e-12) * 300);
  }
}

TEST(Plasticity, InstructionSetsWithTheSameRoundingGiveTheSameBits) {
  expect_equal_bits_in_pairs<double>();
  expect_equal_bits_in_pairs<float>();
}

/// The sum of all energy increments is the work of the stress on the strain path.
TEST(Plasticity, EnergyIsTheTrapezoidOfStressOverStrain) {
  PointDriver<double> point(plastic_kinematic(tangent, 0.3), available_isas().back());
  double energy = 0;
  double work = 0;
  for (int i = 0; i < 50; ++i) {
    const Five strain{0.0004, 0.0001, -0.0003, 0.0002 * std::sin(i), 0.0001};
    const Five before = point.stress();
    point.apply(strain);
    const Five after = point.stress();
    for (int c = 0; c < components; ++c) work += 0.5 * (before[c] + after[c]) * strain[c];
    energy += point.energy();
  }
  EXPECT_GT(work, 0);
  test::verified("plane stress, fifty plastic steps: energy over the work", "trapezoid of stress over strain")
      .near(energy / work, 1, 1e-13);
}

}  // namespace
}  // namespace crumple::materials::testing::plasticity_general_test
