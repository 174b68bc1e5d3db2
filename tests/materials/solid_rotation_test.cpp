// SPDX-License-Identifier: BSD-3-Clause
// Stresses of solids are the same whichever way the body, or the observer, is turned.
#include <gtest/gtest.h>

#include <limits>

#include "materials/solid_driver.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::solid_rotation_test {
namespace {

const std::array<double, 3> tilted_axis{2.0 / 7, -3.0 / 7, 6.0 / 7};
constexpr double full_turn = 6.283185307179586;

double distance(const Six& a, const Six& b) {
  double worst = 0;
  for (int c = 0; c < solid_components; ++c) worst = test::larger_of(worst, std::fabs(a[c] - b[c]));
  return worst;
}

/// A stress (and back stress) of about 300 that is turned without strain; returns how far it is from where it
/// should be after each quarter, and from where it started after the last.
template <class Real>
double worst_after_full_turn(Isa isa, int steps) {
  SolidDriver<Real> point(plastic_kinematic(2100, 0), isa);
  for (int i = 0; i < 10; ++i) point.apply({0.001, -0.0007, 0.0001, 0.0008, -0.0003, 0.0002});
  point.set_strain(0, 0, {});
  const Six stress = point.stress();
  const Six relative = point.relative();
  const double plastic = point.item("plastic_strain");
  point.set_turn(0, 0, turn_about(tilted_axis, full_turn / steps));
  double worst = 0;
  for (int i = 1; i <= steps; ++i) {
    point.apply();
    if (i % (steps / 4) != 0) continue;
    const Matrix turn = turn_about(tilted_axis, full_turn * i / steps);
    worst = test::larger_of(worst, distance(point.stress(), rotated(stress, turn)));
    worst = test::larger_of(worst, distance(point.relative(), rotated(relative, turn)));
  }
  // A stress on the yield surface is rounded over it now and then: by a few last places in a step at most.
  const double rounding = 4 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  EXPECT_NEAR(point.item("plastic_strain"), plastic,
              rounding * (plastic + steps * equivalent(stress) / (3 * shear_modulus)));
  return worst / equivalent(stress);
}

TEST(SolidRotation, StressComesBackAfterAFullTurnInManySteps) {
  const std::string turned =
      "solid, turned once in up to 40000 steps: stress and back stress, relative error, ";
  const char* const source = "rotation by tensor algebra";
  test::Largest doubles(turned + "double precision", source, 1e-13);
  test::Largest singles(turned + "single precision", source, 4e-5);
  for (const Isa isa : available_isas())
    for (const int steps : {4, 40, 4000, 40000}) {
      doubles.add(worst_after_full_turn<double>(isa, steps), std::to_string(steps));
      singles.add(worst_after_full_turn<float>(isa, steps), std::to_string(steps));
    }
}

std::vector<model::Material> materials() {
  model::Material elastic;
  elastic.id = 9;
  elastic.density = 7.85e-9;
  elastic.law = model::Elastic{youngs_modulus, poissons_ratio};
  auto all = all_materials_with_rates();
  all.push_back(elastic);
  return all;
}

Six strain_of_step(int i) {
  return {0.0005 * std::cos(0.3 * i), -0.0002, 0.0001 * i / 30, 0.0004 * std::sin(0.2 * i), 0.0003, -0.0002};
}

TEST(SolidRotation, ATurnedObserverSeesTheTurnedStress) {
  const Matrix turn = turn_about(tilted_axis, 1.1);
  test::Largest off("all laws of solids, seen by a turned observer: stress, relative error", "invariance",
                    1e-12);
  for (const model::Material& material : materials()) {
    SolidDriver<double> one(material, available_isas().back());
    SolidDriver<double> other(material, available_isas().back());
    for (int i = 0; i < 60; ++i) {
      one.apply(strain_of_step(i), 1e-5);
      other.apply(rotated(strain_of_step(i), turn, 0.5), 1e-5);
    }
    const double size = equivalent(one.stress());
    EXPECT_GT(size, 100);
    const std::string place = std::to_string(material.id);
    off.add(distance(other.stress(), rotated(one.stress(), turn)) / size, place);
    off.add(distance(other.relative(), rotated(one.relative(), turn)) / size, place);
  }
}

/// The body turns while it is strained, about an axis that changes: the stress is that of the body at rest,
/// turned along.
TEST(SolidRotation, ATurningBodyCarriesItsStressAlong) {
  const std::string turned = "all laws of solids, turning while strained: ";
  test::Largest off(turned + "stress, relative error", "strained at rest, then turned", 1e-12);
  test::Largest energies(turned + "energy of a step, error over it and 1 MPa", "strained at rest", 1e-12);
  for (const model::Material& material : materials())
    for (const Isa isa : available_isas()) {
      SolidDriver<double> rest(material, isa);
      SolidDriver<double> turning(material, isa);
      Matrix total{};
      for (int i = 0; i < 60; ++i) {
        const double a = 0.05 * i;
        const std::array<double, 3> axis{std::cos(a), 0, std::sin(a)};
        const Matrix turn = turn_about(axis, 0.2);
        // Strains are those of the middle of the step.
        const Matrix middle = after(turn_about(axis, 0.1), total);
        total = after(turn, total);
        rest.apply(strain_of_step(i), 1e-5);
        turning.set_turn(0, 0, turn);
        turning.apply(rotated(strain_of_step(i), middle, 0.5), 1e-5);
        energies.compare(turning.energy(), rest.energy(), 1 + std::fabs(rest.energy()));
      }
      const double size = equivalent(rest.stress());
      const std::string place = std::to_string(material.id);
      off.add(distance(turning.stress(), rotated(rest.stress(), total)) / size, place);
      off.add(distance(turning.relative(), rotated(rest.relative(), total)) / size, place);
    }
}

}  // namespace
}  // namespace crumple::materials::testing::solid_rotation_test
