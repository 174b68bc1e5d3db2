// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_EROSION: elastic elements under a known strain fail in the step in which a closed form reaches the
// limit.
#include <gtest/gtest.h>

#include <functional>

#include "elements/common/erosion_check.hpp"
#include "elements/solid_harness.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::elements::testing::erosion_criteria_test {
namespace {

using model::ErosionCriteria;
using Limit = std::optional<double> ErosionCriteria::*;

constexpr double growth = 0.001;  // logarithmic strain of a step
constexpr double dt = 1e-6;
constexpr double shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio));
constexpr double bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio));

/// A criterion and what it measures where the strain along x is `strain` and the sides are held.
struct Measured {
  const char* name;
  Limit limit;
  double sign;  ///< of the strain
  std::function<double(double strain)> value;
};

std::vector<Measured> measured_in_solids() {
  constexpr double confined = bulk_modulus + 4.0 / 3 * shear_modulus;
  return {
      {"MXEPS", &ErosionCriteria::largest_principal_strain, 1, [](double e) { return e; }},
      {"VOLEPS", &ErosionCriteria::volumetric_strain, 1, [](double e) { return e; }},
      {"EFFEPS", &ErosionCriteria::effective_strain, 1, [](double e) { return 2.0 / 3 * e; }},
      {"EPSSH", &ErosionCriteria::shear_strain, 1, [](double e) { return 0.5 * e; }},
      {"SIGP1", &ErosionCriteria::largest_principal_stress, 1, [](double e) { return confined * e; }},
      {"SIGVM", &ErosionCriteria::largest_equivalent_stress, 1,
       [](double e) { return 2 * shear_modulus * e; }},
      {"MNPRES", &ErosionCriteria::smallest_pressure, 1, [](double e) { return -bulk_modulus * e; }},
      {"MNEPS", &ErosionCriteria::smallest_principal_strain, -1, [](double e) { return e; }},
      {"VOLEPS < 0", &ErosionCriteria::volumetric_strain, -1, [](double e) { return e; }},
      {"MXPRES", &ErosionCriteria::largest_pressure, -1, [](double e) { return -bulk_modulus * e; }},
  };
}

/// At zero stress across the shell.
std::vector<Measured> measured_in_shells() {
  constexpr double nu = poissons_ratio;
  constexpr double across = -nu / (1 - nu);
  constexpr double along = youngs_modulus / (1 - nu * nu);
  return {
      {"MXEPS", &ErosionCriteria::largest_principal_strain, 1, [](double e) { return e; }},
      {"VOLEPS", &ErosionCriteria::volumetric_strain, 1, [](double e) { return (1 + across) * e; }},
      {"EPSSH", &ErosionCriteria::shear_strain, 1, [](double e) { return 0.5 * (1 - across) * e; }},
      {"SIGP1", &ErosionCriteria::largest_principal_stress, 1, [](double e) { return along * e; }},
      {"SIGVM", &ErosionCriteria::largest_equivalent_stress, 1,
       [](double e) { return along * std::sqrt(1 - nu + nu * nu) * e; }},
      {"MNPRES", &ErosionCriteria::smallest_pressure, 1, [](double e) { return -along * (1 + nu) / 3 * e; }},
      {"MNEPS", &ErosionCriteria::smallest_principal_strain, -1, [](double e) { return e; }},
      {"MXPRES", &ErosionCriteria::largest_pressure, -1, [](double e) { return -along * (1 + nu) / 3 * e; }},
  };
}

/// Steps of strain along x until elements fail; the number of the step, or 0.
int step_of_failure(const model::Model& model, const domain::Execution& execution, double sign) {
  Driven body(model, execution);
  // At the middle of the step (f - 1) / (f + 1) * 2 is the strain: this factor makes it `growth`.
  const double factor = (1 + 0.5 * sign * growth) / (1 - 0.5 * sign * growth);
  for (int step = 1; step <= 30; ++step) {
    body.step(
        dt,
        [&](const Vec3& x) {
          return Vec3{factor * x.x, x.y, x.z};
        },
        [](const Vec3&) { return Vec3{}; });
    for (const domain::ElementBlock* block : body.domain.blocks())
      if (block->eroded > 0) return block->eroded == block->elements ? step : -1;
  }
  return 0;
}

model::Material with(ErosionCriteria criteria) {
  model::Material material = elastic();
  material.erosion = criteria;
  return material;
}

constexpr int expected_step = 20;

void expect_failure(const Measured& of, const std::function<model::Model(const model::Material&)>& body) {
  ErosionCriteria criteria;
  criteria.*of.limit = of.value(of.sign * growth * (expected_step - 0.5));
  for (const auto& execution : all_executions())
    EXPECT_EQ(step_of_failure(body(with(criteria)), execution, of.sign), expected_step)
        << of.name << " " << name_of(execution);
}

TEST(ErosionCriteria, FailSolidsAtTheirLimit) {
  for (const Measured& of : measured_in_solids())
    for (const SolidCase& solid : solid_cases) {
      if (solid.form != solid_cases[1].form) continue;  // one of the hexahedron's hourglass forms
      SCOPED_TRACE(solid.name);
      expect_failure(of, [&](const model::Material& m) { return solid_cube(solid, 1, 0, m); });
    }
}

TEST(ErosionCriteria, FailShellsAtTheirLimit) {
  for (const Measured& of : measured_in_shells())
    for (const Kind& kind : all_kinds) {
      SCOPED_TRACE(kind.name);
      expect_failure(of, [&](const model::Material& m) { return plate(kind.formulation, 1, 0, 3, m); });
    }
}

TEST(ErosionCriteria, ImpulseIsTheIntegralOfTheSquaredExcess) {
  constexpr double along = youngs_modulus / (1 - poissons_ratio * poissons_ratio);
  ErosionCriteria criteria;
  criteria.threshold_stress = 5.5 * along * growth;
  double sum = 0;
  for (int step = 6; step <= expected_step; ++step) {
    const double excess = along * growth * (step - 5.5);
    if (step == expected_step) criteria.impulse = sum + 0.5 * excess * excess * dt;
    sum += excess * excess * dt;
  }
  for (const auto& execution : all_executions())
    EXPECT_EQ(step_of_failure(plate(belytschko_tsay.formulation, 1, 0, 3, with(criteria)), execution, 1),
              expected_step);
}

TEST(ErosionCriteria, ConditionsAreCounted) {
  ErosionCriteria criteria;
  criteria.largest_principal_strain = 4.5 * growth;
  criteria.volumetric_strain = (expected_step - 0.5) * growth;
  const domain::Execution execution{Precision::Double, available_isas().back(), 1};
  EXPECT_EQ(step_of_failure(solid_cube(solid_cases[1], 1, 0, with(criteria)), execution, 1), 5);
  criteria.conditions = 2;
  EXPECT_EQ(step_of_failure(solid_cube(solid_cases[1], 1, 0, with(criteria)), execution, 1), expected_step);
  criteria.conditions = 3;
  EXPECT_EQ(step_of_failure(solid_cube(solid_cases[1], 1, 0, with(criteria)), execution, 1), 0);
}

/// One lane of one group of solids, as the driver calls the check.
template <class Real>
struct OnePoint {
  explicit OnePoint(const ErosionCriteria& criteria, Index points = 1) {
    block.points = points;
    block.erosion = criteria;
    domain::add_item(block, "stress", "stress", 6 * points);
    declare_erosion(block);
    state.assign(static_cast<std::size_t>(block.components) * lanes, Real(0));
    strain.assign(static_cast<std::size_t>(6 * points) * materials::tile_lanes, Real(0));
    turn.assign(static_cast<std::size_t>(9 * points) * materials::tile_lanes, Real(0));
    energy.assign(static_cast<std::size_t>(points) * materials::tile_lanes, Real(0));
  }
  Real& stress(int point, int c) { return state[static_cast<std::size_t>((6 * point + c) * lanes)]; }
  Real& growth_of(int point, int c) {
    return strain[static_cast<std::size_t>((6 * point + c) * materials::tile_lanes)];
  }
  /// Turns about z by `angle` in the step.
  void set_turn(double angle) {
    const double s = std::sin(angle);
    const double c = std::cos(angle) - 1;
    const double r[9] = {c, -s, 0, s, c, 0, 0, 0, 0};
    for (std::size_t k = 0; k < 9; ++k) turn[k * materials::tile_lanes] = static_cast<Real>(r[k]);
  }
  /// True if the element has gone.
  bool check(double time = 0) {
    std::vector<Real> intact(materials::tile_lanes, Real(1));
    check_erosion(erosion_check(block, time, dt), PointTile<Real>{.state = state.data(),
                                                                  .groups = 1,
                                                                  .points = block.points,
                                                                  .strain = strain.data(),
                                                                  .turn = turn.data(),
                                                                  .energy = energy.data(),
                                                                  .intact = intact.data()});
    return intact[0] == Real(0);
  }

  domain::ElementBlock block;
  std::vector<Real> state, strain, turn, energy;
};

TEST(ErosionCriteria, StrainTurnsWithTheMaterial) {
  ErosionCriteria criteria;
  criteria.largest_principal_strain = 0.149;
  OnePoint<float> point(criteria);
  point.growth_of(0, 0) = 0.1F;
  EXPECT_FALSE(point.check());
  point.growth_of(0, 0) = 0;
  point.set_turn(0.01 * std::acos(0.0));
  for (int step = 0; step < 100; ++step) EXPECT_FALSE(point.check());
  point.set_turn(0);
  // What was x is y now: another 0.06 along x is no larger principal strain, along y it is.
  point.growth_of(0, 0) = 0.06F;
  EXPECT_FALSE(point.check());
  point.growth_of(0, 0) = 0;
  point.growth_of(0, 1) = 0.05F;
  EXPECT_TRUE(point.check());
}

/// The increment belongs to the middle of the step, half of the rotation is still to come: 0.1 along x is
/// along (1, 1) at the end of a quarter turn.
TEST(ErosionCriteria, IncrementsTurnByHalfOfTheStep) {
  ErosionCriteria criteria;
  criteria.largest_principal_strain = 0.149;
  OnePoint<double> point(criteria);
  point.growth_of(0, 0) = 0.1;
  point.set_turn(std::acos(0.0));
  EXPECT_FALSE(point.check());
  point.set_turn(0);
  point.growth_of(0, 0) = 0;
  point.growth_of(0, 3) = 0.1;
  EXPECT_TRUE(point.check()) << "0.05 + 0.05 + 0.05 along (1, 1); 0.121 had it stayed along x";
  // The work that the failed stress had in its step is that of the turned increment.
  OnePoint<double> loaded(criteria);
  loaded.growth_of(0, 0) = 0.3;
  loaded.set_turn(std::acos(0.0));
  loaded.stress(0, 0) = 120;
  loaded.energy[0] = 20;
  EXPECT_TRUE(loaded.check());
  EXPECT_NEAR(loaded.energy[0], 20 - 0.5 * 120 * 0.15, 1e-12);
}

TEST(ErosionCriteria, SmallIncrementsAreNotLostInFloat) {
  ErosionCriteria criteria;
  criteria.volumetric_strain = 0.3;
  OnePoint<float> point(criteria);
  point.growth_of(0, 2) = 3e-8F;  // a unit in the last place of 0.3 is as large
  int steps = 1;
  constexpr int most = 11'000'000;
  while (steps < most && !point.check()) ++steps;
  EXPECT_NEAR(steps, 1e7, 10);
}

TEST(ErosionCriteria, PointsFailOneByOne) {
  ErosionCriteria criteria;
  criteria.largest_principal_stress = 100;
  criteria.points = -60;
  OnePoint<double> of(criteria, 5);
  for (int p = 0; p < 3; ++p) {
    of.stress(p, 0) = 120;
    of.growth_of(p, 0) = 0.01;
    of.energy[static_cast<std::size_t>(p) * materials::tile_lanes] = 2;
    of.stress(4, 1) = 40;
    const bool gone = of.check();
    EXPECT_EQ(gone, p == 2) << "60 percent of five points are three";
    EXPECT_EQ(of.stress(p, 0), 0);
    EXPECT_NEAR(of.energy[static_cast<std::size_t>(p) * materials::tile_lanes], 2 - 0.5 * 120 * 0.01, 1e-15);
    EXPECT_EQ(of.stress(4, 1), gone ? 0 : 40) << "all points of what goes lose their stress";
  }
}

TEST(ErosionCriteria, TimeAlone) {
  ErosionCriteria criteria;
  criteria.time = 1e-3;
  OnePoint<double> point(criteria);
  EXPECT_FALSE(point.check(0.99e-3));
  EXPECT_TRUE(point.check(1e-3));
}

TEST(ErosionCriteria, PlasticStrainOfTheLaw) {
  model::Material material = plastic();
  ErosionCriteria criteria;
  criteria.effective_plastic_strain = 0.01;
  material.erosion = criteria;
  for (const auto& execution : all_executions()) {
    // Strain along x less the elastic part, whose deviator stays at the yield stress.
    const int step = step_of_failure(solid_cube(solid_cases[1], 1, 0, material), execution, 1);
    EXPECT_GE(step, 16);
    EXPECT_LE(step, 17);
  }
}

}  // namespace
}  // namespace crumple::elements::testing::erosion_criteria_test
