// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/penalty.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace crumple::contact::penalty_test {
namespace {

/// Speed after the rebound of a unit mass with unit speed, by central differences with unit steps, from a
/// linear spring that it first touches after `phase` of a step. `square` is (omega dt)^2.
double rebound(double square, double phase, bool with_factors) {
  double x = phase;  // penetration
  double v = -1;     // of parting
  double last_v = 0;
  double last_x = 0;
  while (x > 0) {
    const double depth = x / std::fabs(v);
    double factor = 1;
    if (with_factors && last_x == 0) factor = landing_factor(depth, square);
    if (with_factors && last_x > 0 && v > 0)
      factor = leaving_factor(depth, std::clamp((v - last_v) / last_x, 0.0, 1.0));
    last_v = v;
    last_x = x;
    v += square * factor * x;
    x -= v;
  }
  return v;
}

// Without the factors an impact gains or loses energy with the phases at which it begins and ends.
TEST(Penalty, ALinearImpactGivesBackItsEnergyWhateverItsPhase) {
  test::Largest off("linear impact at any phase of the step, four stiffnesses: rebound, error",
                    "energy at first", 1e-13);
  double worst_without = 0;
  for (const double square : {0.05, 0.2, 0.35, 0.5})
    for (double phase = 0.02; phase < 1; phase += 0.02) {
      off.compare(rebound(square, phase, true), 1, 1, std::to_string(square) + " " + std::to_string(phase));
      worst_without = test::larger_of(worst_without, std::fabs(rebound(square, phase, false) - 1));
    }
  EXPECT_GT(worst_without, 0.02);
}

// A spring that keeps account of its energy never meets the bound on its force, from landing to leaving: a
// mass on a linear spring, as in the rebound above.
TEST(Penalty, ALinearSpringNeverReachesThePassiveForce) {
  double nearest = HUGE_VAL;
  for (const double square : {0.05, 0.2, 0.35, 0.9})
    for (double phase = 0.02; phase < 1; phase += 0.02) {
      double x = phase;
      double v = -1;
      double last_v = 0;
      double last_x = 0;
      double force = 0;
      double energy = 0;
      while (x > 0) {
        energy -= 0.5 * force * v;
        const double depth = x / std::fabs(v);
        double factor = 1;
        if (last_x == 0) factor = landing_factor(depth, square);
        if (last_x > 0 && v > 0) factor = leaving_factor(depth, std::clamp((v - last_v) / last_x, 0.0, 1.0));
        force = square * factor * x;
        nearest = std::min(nearest, passive_force(energy, v, 1, 1) / force);
        EXPECT_LE(force, (1 + 1e-9) * passive_force(energy, v, 1, 1)) << square << ' ' << phase;
        energy -= 0.5 * force * v;
        last_v = v;
        last_x = x;
        v += force;
        x -= v;
      }
    }
  EXPECT_LT(nearest, 1 + 1e-6) << "where the mass leaves, the bound is what the spring needs";
}

// Without energy a spring may stop what comes and throw it back, and may not push what goes.
TEST(Penalty, AnEmptySpringOnlyThrowsBack) {
  constexpr double inverse_mass = 4;
  constexpr double step = 0.5;
  EXPECT_EQ(passive_force(0, 3, inverse_mass, step), 0);
  EXPECT_EQ(passive_force(-1, 3, inverse_mass, step), 0);
  const double force = passive_force(0, -3, inverse_mass, step);
  EXPECT_NEAR(-3 + force * step * inverse_mass, 3, 1e-14);
  // All of the energy goes into the speed.
  const double speed = 1 + passive_force(2, 1, inverse_mass, step) * step * inverse_mass;
  EXPECT_NEAR(0.5 * speed * speed / inverse_mass, 0.5 / inverse_mass + 2, 1e-13);
}

TEST(Penalty, FactorsEndWhereTheWholeStepIsInside) {
  for (const double square : {0.0, 0.35, 0.9}) {
    EXPECT_NEAR(landing_factor(1 - 1e-12, square), 1, 1e-11);
    EXPECT_EQ(landing_factor(3, square), 1);
    EXPECT_EQ(leaving_factor(30, square), 1);
    EXPECT_NEAR(landing_factor(0, square), 0.5, 1e-15);
    EXPECT_NEAR(leaving_factor(0, square), 0.5, 1e-15);
  }
}

}  // namespace
}  // namespace crumple::contact::penalty_test
