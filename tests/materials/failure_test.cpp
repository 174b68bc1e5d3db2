// SPDX-License-Identifier: BSD-3-Clause
// Failure strain: what a point that has failed still does, which is nothing.
#include <gtest/gtest.h>

#include "materials/point_driver.hpp"
#include "support/verified.hpp"

namespace crumple::materials::testing::failure_test {
namespace {

constexpr double failure_strain = 0.05;

model::Material failing_kinematic(double beta) {
  model::Material material = plastic_kinematic(2100, beta);
  std::get<model::PlasticKinematic>(material.law).failure_strain = failure_strain;
  return material;
}
model::Material failing_table() {
  model::Material material = tabulated({0, 0.1}, {250, 400});
  std::get<model::PiecewiseLinearPlasticity>(material.law).failure_strain = failure_strain;
  return material;
}
std::vector<model::Material> failing_materials() {
  return {failing_kinematic(0), failing_kinematic(0.4), failing_kinematic(1), failing_table()};
}

TEST(Failure, OnlyMaterialsWithAFailureStrainCanFail) {
  EXPECT_FALSE(can_fail(plastic_kinematic(2100, 0.5)));
  EXPECT_FALSE(can_fail(tabulated({0, 0.1}, {250, 400})));
  for (const model::Material& material : failing_materials()) EXPECT_TRUE(can_fail(material));
}

/// Up to the failure strain the response is that of the same material without one, bit by bit. From then on
/// the point carries nothing, whichever way it is strained.
template <class Real>
void expect_stress_to_vanish(const model::Material& material, model::Material endless, Isa isa) {
  if (auto* law = std::get_if<model::PlasticKinematic>(&endless.law)) law->failure_strain = 0;
  if (auto* law = std::get_if<model::PiecewiseLinearPlasticity>(&endless.law)) law->failure_strain = 0;
  PointDriver<Real> point(material, isa);
  PointDriver<Real> same(endless, isa);
  const Five strain{0.002, -0.0007, 0.001, 0.0003, 0};
  int steps = 0;
  for (; same.item("plastic_strain") < failure_strain; ++steps) {
    if (steps > 0) {
      EXPECT_EQ(point.stress(), same.stress());
      EXPECT_TRUE(point.intact());
    }
    point.apply(strain);
    same.apply(strain);
  }
  EXPECT_GT(steps, 10);
  EXPECT_FALSE(point.intact());
  EXPECT_EQ(point.stress(), Five{});
  EXPECT_EQ(point.item("plastic_strain"), same.item("plastic_strain"));
  const double at_failure = point.item("plastic_strain");
  for (const double sign : {1.0, -1.0, -1.0, 1.0}) {
    point.apply({sign * 0.1, 0, sign * 0.05, 0, 0});
    EXPECT_EQ(point.stress(), Five{});
    EXPECT_EQ(point.energy(), 0);
    EXPECT_EQ(point.thickness_strain(), 0);
    EXPECT_EQ(point.item("plastic_strain"), at_failure);
    EXPECT_FALSE(point.intact());
  }
}

TEST(Failure, StressVanishesAtTheFailureStrainForGood) {
  for (const model::Material& material : failing_materials())
    for (const Isa isa : available_isas()) {
      expect_stress_to_vanish<double>(material, material, isa);
      expect_stress_to_vanish<float>(material, material, isa);
    }
}

/// In the step of failure the stress goes from its old value to zero: half its product with the strain.
TEST(Failure, WorkOfTheLastStepIsTheTrapezoid) {
  PointDriver<double> point(failing_kinematic(0.4), available_isas().back());
  const Five strain{0.002, -0.0007, 0.001, 0.0003, 0};
  Five before{};
  point.apply(strain);
  while (point.intact()) {
    before = point.stress();
    point.apply(strain);
  }
  double work = 0;
  for (int c = 0; c < components; ++c) work += 0.5 * before[c] * strain[c];
  EXPECT_GT(work, 0.1);
  test::verified("shell law at failure: work of the last step [MPa]", "half of old stress times strain")
      .within(point.energy(), work, 1e-14);
}

/// Three points of one element fail one by one, and each on its own; the element holds until the last.
TEST(Failure, PointsFailOneByOne) {
  for (const Isa isa : available_isas()) {
    PointDriver<double> element(failing_table(), isa, 3);
    int intact_points = 3;
    for (int step = 0; step < 60 && intact_points > 0; ++step) {
      for (int p = 0; p < 3; ++p) {
        element.set_strain(0, p, {0, 0, 0.004 * (p + 1), 0, 0});
        element.set_strain(5, p, {0, 0, 0.0001 * (p + 1), 0, 0});
      }
      element.apply();
      intact_points = 0;
      for (int p = 0; p < 3; ++p) {
        const bool holds = element.item("plastic_strain", 0, p) < failure_strain;
        EXPECT_EQ(element.stress(0, p) == Five{}, !holds);
        intact_points += holds ? 1 : 0;
      }
      EXPECT_EQ(element.intact(0), intact_points > 0);
      EXPECT_TRUE(element.intact(5)) << "a neighbour in the same pack";
      EXPECT_GT(element.stress(5, 0)[2], 0);
    }
    EXPECT_EQ(intact_points, 0);
  }
}

}  // namespace
}  // namespace crumple::materials::testing::failure_test
