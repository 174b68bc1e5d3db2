// SPDX-License-Identifier: BSD-3-Clause
// The stiffness form of hourglass control where the metal yields: exact limits, and what flow leaves of an
// hourglass stress (docs/theory/hourglass.md).
#include <gtest/gtest.h>

#include <cmath>

#include "elements/shell_harness.hpp"

namespace crumple::elements::testing::hourglass_yield_test {
namespace {

constexpr double side = 5;
constexpr double yield_stress = 250;
constexpr double coefficient = 0.5;
constexpr double dt = 1e-7;

/// A square of perfectly plastic metal under a strong control: it yields while the element is a square still.
model::Model square(const Kind& kind, const model::Material& material) {
  model::Model model = plate(kind.formulation, 1, 0, 5, material);
  model.control.hourglass = {model::HourglassForm::Stiffness, coefficient, coefficient, coefficient};
  return model;
}

enum Mode { MembraneX, MembraneY, Warping, BendingX, BendingY };

/// Moves the nodes by the pattern of a mode: `amplitude` at each, four times that as the mode's own measure.
void move_by(Driven& body, Mode mode, double amplitude) {
  const domain::NodeFields& nodes = body.domain.nodes;
  std::vector<Vec3> u(nodes.count());
  std::vector<Vec3> r(nodes.count());
  for (Index i = 0; i < nodes.count(); ++i) {
    const bool right = nodes.position[i].x > 0.5 * side;
    const bool upper = nodes.position[i].y > 0.5 * side;
    const double move = right == upper ? amplitude : -amplitude;
    if (mode <= Warping)
      u[i][mode] = move;
    else
      r[i][mode - BendingX] = move;
  }
  body.step(dt, u, r);
}

/// Yields everywhere: the halves of the element in tension and pressure, bent, or twisted.
double limit_of(Mode mode) {
  if (mode <= MembraneY) return yield_stress * thickness * side / 4;
  if (mode == Warping) return yield_stress / std::sqrt(3.0) * thickness * thickness / 2;
  return yield_stress * thickness * thickness * side / 16;
}

double stiffness_of(Mode mode) {
  if (mode <= MembraneY) return coefficient * youngs_modulus * thickness / 8;
  const double t3 = thickness * thickness * thickness;
  const double shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio));
  if (mode == Warping) return coefficient * shear_modulus * t3 / (12 * side * side);
  return coefficient * youngs_modulus * t3 / 192;
}

class HourglassYield : public ::testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(OnePoint, HourglassYield, ::testing::ValuesIn(one_point_kinds),
                         [](const auto& of) { return std::string(of.param.name); });

TEST_P(HourglassYield, AModeAloneIsElasticAndThenStopsAtThePlasticLimit) {
  for (const domain::Execution& execution : all_executions())
    for (const Mode mode : {MembraneX, MembraneY, Warping, BendingX, BendingY}) {
      Driven body(square(GetParam(), plastic(0, 0)), execution);
      const double limit = limit_of(mode);
      const double at_limit = limit / (4 * stiffness_of(mode));  // amplitude
      constexpr int steps = 200;
      for (int i = 1; i <= 2 * steps; ++i) {
        move_by(body, mode, at_limit / steps);
        const double wanted = std::fmin(1.0, static_cast<double>(i) / steps) * limit;
        // The element gets a little longer and tilts its axes as the pattern grows.
        ASSERT_NEAR(std::fabs(body.item("hourglass", 0, mode)), wanted, 0.01 * limit)
            << name_of(execution) << ", mode " << mode << ", step " << i;
      }
      // Back it goes elastically.
      move_by(body, mode, -at_limit / 2);
      EXPECT_NEAR(std::fabs(body.item("hourglass", 0, mode)), 0.5 * limit, 0.01 * limit);
    }
}

TEST_P(HourglassYield, ElasticShellsHaveNoLimit) {
  Driven body(square(GetParam(), elastic()), {Precision::Double, available_isas().back(), 1});
  const double at_limit = limit_of(MembraneX) / (4 * stiffness_of(MembraneX));
  for (int i = 0; i < 300; ++i) move_by(body, MembraneX, at_limit / 100);
  EXPECT_NEAR(std::fabs(body.item("hourglass", 0)), 3 * limit_of(MembraneX), 0.03 * limit_of(MembraneX));
}

/// Equal stretch in both directions keeps the stress at the yield stress, and the return multiplies what
/// rides on it by 1 - (E / (3 (1 - nu)) + E / (1 + nu)) / 2 * 3 d(strain) / yield stress each step.
TEST_P(HourglassYield, FlowTakesAnHourglassStressAsTheReturnTakesAStressBesideIt) {
  Driven body(square(GetParam(), plastic(0, 0)), {Precision::Double, available_isas().back(), 1});
  move_by(body, MembraneX, 0.25 * limit_of(MembraneX) / (4 * stiffness_of(MembraneX)));
  const double increment = 2e-6;
  const auto stretch = [&] {
    body.step(
        dt, [&](const Vec3& x) { return (1 + increment) * x; }, [](const Vec3&) { return Vec3{}; });
  };
  const double to_yield = yield_stress * (1 - poissons_ratio) / youngs_modulus;
  for (int i = 0; i < 1.5 * to_yield / increment; ++i) stretch();
  const double before = body.item("hourglass", 0);
  EXPECT_GT(std::fabs(before), 0.1 * limit_of(MembraneX));
  constexpr int steps = 500;
  for (int i = 0; i < steps; ++i) stretch();
  const double slopes = youngs_modulus / (3 * (1 - poissons_ratio)) + youngs_modulus / (1 + poissons_ratio);
  const double wanted = std::exp(-0.5 * slopes * 3 * steps * increment / yield_stress);
  EXPECT_NEAR(body.item("hourglass", 0) / before, wanted, 0.01 * wanted);
}

/// No path makes energy: what the control holds elastically has been put in.
TEST_P(HourglassYield, RandomPathsGiveNoMoreThanTheyTook) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Driven body(square(GetParam(), plastic(0.4, 2100)), {Precision::Double, available_isas().back(), 1});
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    double drift[5];
    for (double& d : drift) d = uniform(generator);
    double stretch = 0;
    for (int i = 0; i < 2000; ++i) {
      if (i % 100 == 0) {
        for (double& d : drift) d = uniform(generator);
        stretch = 2e-5 * uniform(generator);
      }
      for (int mode = 0; mode < 5; ++mode)
        move_by(body, static_cast<Mode>(mode),
                drift[mode] * 0.01 * limit_of(static_cast<Mode>(mode)) /
                    stiffness_of(static_cast<Mode>(mode)) / 4);
      body.step(
          dt,
          [&](const Vec3& x) {
            return Vec3{(1 + stretch) * x.x, x.y, x.z};
          },
          [](const Vec3&) { return Vec3{}; });
      double held = 0;
      double most = 0;
      for (int mode = 0; mode < 5; ++mode) {
        const double q = body.item("hourglass", 0, mode);
        const Mode of = static_cast<Mode>(mode);
        held += 0.5 * q * q / stiffness_of(of);
        most += 0.5 * limit_of(of) * limit_of(of) / stiffness_of(of);
      }
      ASSERT_GT(body.block().hourglass_energy, 0.8 * held - 1e-3 * most) << "seed " << seed << ", step " << i;
    }
  }
}

}  // namespace
}  // namespace crumple::elements::testing::hourglass_yield_test
