// SPDX-License-Identifier: BSD-3-Clause
// Traction over separation of ties that soften: the energy on every ray is that of the criterion.
#include "contact/tied/cohesive_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/largest.hpp"

namespace crumple::cohesive_law_test {
namespace {

using contact::CohesiveLaw;
using contact::CohesiveStiffness;
using Law = model::TieSoftening::Law;

constexpr model::TieFailure strengths{.normal_strength = 0.03, .shear_strength = 0.05};
constexpr double tension_energy = 0.0004;
constexpr double shear_energy = 0.001;
constexpr CohesiveStiffness stiffness{8, 3};

model::TieSoftening softening(Law law, double exponent) {
  return {.law = law,
          .normal_energy = tension_energy,
          .shear_energy = shear_energy,
          .exponent = exponent,
          .critical_opening = 0.05};
}

/// Energies per area that the two modes take on a ray until the tie is gone.
struct Taken {
  double normal = 0;
  double shear = 0;
  double largest = 0;  ///< of (stress / strength) summed up in squares
};

Taken pull(const CohesiveLaw& law, double across, double along) {
  const double length = law.range(across, along, stiffness).failure;
  constexpr int steps = 100000;
  const double step = 1.001 * length / steps;
  Taken taken;
  double damage = 0;
  double before = 0;
  for (int i = 1; i <= steps; ++i) {
    const double now = i * step;
    damage = law.damage(across * now, along * now, stiffness, damage);
    const double middle = 0.5 * (before + (1 - damage) * now);  // of what the damage leaves
    before = (1 - damage) * now;
    taken.normal += middle * stiffness.normal * across * across * step;
    taken.shear += middle * stiffness.shear * along * along * step;
    taken.largest = std::max(taken.largest, std::pow(before * stiffness.normal * across / 0.03, 2) +
                                                std::pow(before * stiffness.shear * along / 0.05, 2));
  }
  EXPECT_EQ(damage, 1);
  return taken;
}

TEST(CohesiveLaw, EnergyOnEveryRayIsThatOfTheCriterion) {
  test::Largest by_power("ties that soften on rays of all modes: energy by the power law, error", "criterion",
                         1e-6);
  test::Largest by_kenane("ties that soften on rays of all modes: energy by Benzeggagh and Kenane, error",
                          "criterion", 1e-6);
  for (const double exponent : {1.0, 1.45, 2.0})
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 90.0}) {
      const double across = std::cos(degrees * M_PI / 180);
      const double along = degrees == 0 ? 0 : std::sin(degrees * M_PI / 180);
      const Taken power = pull(CohesiveLaw(strengths, softening(Law::PowerLaw, exponent)), across, along);
      const double sum =
          std::pow(power.normal / tension_energy, exponent) + std::pow(power.shear / shear_energy, exponent);
      by_power.compare(sum, 1);
      EXPECT_NEAR(power.largest, 1, 1e-3);
      const Taken kenane =
          pull(CohesiveLaw(strengths, softening(Law::BenzeggaghKenane, exponent)), across, along);
      const double total = kenane.normal + kenane.shear;
      const double expected =
          tension_energy + (shear_energy - tension_energy) * std::pow(kenane.shear / total, exponent);
      by_kenane.compare(total / expected, 1);
    }
}

TEST(CohesiveLaw, CriticalOpeningTakesHalfOfStrengthTimesOpening) {
  const CohesiveLaw law(strengths, softening(Law::CriticalOpening, 1));
  EXPECT_NEAR(pull(law, 1, 0).normal / (0.5 * 0.03 * 0.05), 1, 1e-6);
  EXPECT_NEAR(pull(law, 0, 1).shear / (0.5 * 0.05 * 0.05), 1, 1e-6);
}

TEST(CohesiveLaw, DamageDoesNotHealAndPressureMakesNone) {
  const CohesiveLaw law(strengths, softening(Law::PowerLaw, 1));
  const auto [onset, failure] = law.range(1, 0, stiffness);
  EXPECT_NEAR(onset, 0.03 / 8, 1e-15);
  EXPECT_NEAR(failure, 2 * tension_energy / 0.03, 1e-12);
  const double damaged = law.damage(0.5 * (onset + failure), 0, stiffness, 0);
  EXPECT_GT(damaged, 0.5);
  EXPECT_LT(damaged, 1);
  EXPECT_EQ(law.damage(0.1 * onset, 0, stiffness, damaged), damaged);
  EXPECT_EQ(law.damage(-10 * failure, 0, stiffness, 0), 0);
  EXPECT_EQ(law.damage(0, 0, stiffness, 0.3), 0.3);
  EXPECT_EQ(law.damage(2 * failure, 0, stiffness, damaged), 1);
}

TEST(CohesiveLaw, SaysInWhichModeItCannotSoften) {
  const CohesiveLaw law(strengths, softening(Law::PowerLaw, 1));
  EXPECT_EQ(std::string(law.brittle_mode(stiffness)), "");
  EXPECT_EQ(std::string(law.brittle_mode({0.03 * 0.03 / (2.01 * tension_energy), 3})), "tension");
  EXPECT_EQ(std::string(law.brittle_mode({8, 0.05 * 0.05 / (2.01 * shear_energy)})), "shear");
}

/// Either mode alone softens, but with an exponent of 0.5 mixtures take a quarter of the energy.
TEST(CohesiveLaw, SaysThatMixedModesCannotSoften) {
  const CohesiveStiffness soft{0.03 * 0.03 / (1.5 * tension_energy), 0.05 * 0.05 / (1.5 * shear_energy)};
  const CohesiveLaw law(strengths, softening(Law::PowerLaw, 0.5));
  const auto softens = [&](double degrees) {
    const double angle = degrees * M_PI / 180;
    const auto [onset, failure] = law.range(std::cos(angle), degrees == 0 ? 0 : std::sin(angle), soft);
    return failure > onset;
  };
  EXPECT_TRUE(softens(0));
  EXPECT_TRUE(softens(90));
  EXPECT_FALSE(softens(45));
  EXPECT_EQ(std::string(law.brittle_mode(soft)), "mixed modes");
  EXPECT_EQ(std::string(CohesiveLaw(strengths, softening(Law::PowerLaw, 1)).brittle_mode(soft)), "");
}

}  // namespace
}  // namespace crumple::cohesive_law_test
