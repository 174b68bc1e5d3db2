// SPDX-License-Identifier: BSD-3-Clause
// Failure strain of solids: what a point that has failed still does, which is nothing.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "materials/solid_driver.hpp"
#include "support/verified.hpp"

namespace crumple::materials::testing::solid_failure_test {
namespace {

constexpr double failure_strain = 0.05;
const Six pull{0.002, -0.0007, 0.0001, 0.001, 0.0003, 0};

std::vector<model::Material> with_failure(double strain) {
  std::vector<model::Material> all;
  for (const double beta : {0.0, 0.4, 1.0}) {
    all.push_back(plastic_kinematic(2100, beta));
    std::get<model::PlasticKinematic>(all.back().law).failure_strain = strain;
  }
  all.push_back(tabulated({0, 0.1}, {250, 400}));
  std::get<model::PiecewiseLinearPlasticity>(all.back().law).failure_strain = strain;
  all.push_back(power_law());
  std::get<model::PowerLawPlasticity>(all.back().law).failure_strain = strain;
  return all;
}

/// Up to the failure strain the response is that of the same material without one, bit by bit. From then on
/// the point carries nothing, whichever way it is strained and turned.
template <class Real>
void expect_stress_to_vanish(const model::Material& material, const model::Material& endless, Isa isa) {
  SolidDriver<Real> point(material, isa);
  SolidDriver<Real> same(endless, isa);
  int steps = 0;
  for (; same.item("plastic_strain") < failure_strain; ++steps) {
    if (steps > 0) {
      EXPECT_EQ(point.stress(), same.stress());
      EXPECT_TRUE(point.intact());
    }
    point.apply(pull);
    same.apply(pull);
  }
  EXPECT_GT(steps, 10);
  EXPECT_FALSE(point.intact());
  EXPECT_TRUE(point.intact(1)) << "a neighbour in the same pack";
  EXPECT_EQ(point.stress(), Six{});
  EXPECT_EQ(point.item("plastic_strain"), same.item("plastic_strain"));
  const double at_failure = point.item("plastic_strain");
  point.set_turn(0, 0, turn_about({0, 0.6, 0.8}, 0.2));
  for (const double sign : {1.0, -1.0, -1.0, 1.0}) {
    point.apply({sign * 0.1, 0, sign * 0.2, sign * 0.05, 0, 0});
    EXPECT_EQ(point.stress(), Six{});
    EXPECT_EQ(point.energy(), 0);
    EXPECT_EQ(point.item("plastic_strain"), at_failure);
    EXPECT_FALSE(point.intact());
  }
}

TEST(SolidFailure, StressVanishesAtTheFailureStrainForGood) {
  const auto failing = with_failure(failure_strain);
  const auto endless = with_failure(0);
  for (std::size_t k = 0; k < failing.size(); ++k)
    for (const Isa isa : available_isas()) {
      EXPECT_TRUE(can_fail(failing[k]));
      EXPECT_FALSE(can_fail(endless[k]));
      expect_stress_to_vanish<double>(failing[k], endless[k], isa);
      expect_stress_to_vanish<float>(failing[k], endless[k], isa);
    }
}

/// In the step of failure the stress goes from its old value to zero: half its product with the strain.
TEST(SolidFailure, WorkOfTheLastStepIsTheTrapezoid) {
  SolidDriver<double> point(with_failure(failure_strain)[1], available_isas().back());
  Six before{};
  point.apply(pull);
  while (point.intact()) {
    before = point.stress();
    point.apply(pull);
  }
  double work = 0;
  for (int c = 0; c < solid_components; ++c) work += 0.5 * before[c] * pull[c];
  EXPECT_GT(work, 0.1);
  test::verified("solid law at failure: work of the last step [MPa]", "half of old stress times strain")
      .within(point.energy(), work, 1e-14);
}

/// The points of an element with eight fail one by one; the element holds until the last.
TEST(SolidFailure, PointsFailOneByOne) {
  for (const Isa isa : available_isas()) {
    SolidDriver<double> element(with_failure(failure_strain).back(), isa, max_solid_points);
    int intact_points = max_solid_points;
    bool was_mixed = false;
    for (int i = 0; i < 60 && intact_points > 0; ++i) {
      for (int p = 0; p < max_solid_points; ++p) {
        element.set_strain(0, p, {0, 0, 0, 0.002 * (p + 1), 0, 0});
        element.set_strain(5, p, {0, 0, 0, 0.00005 * (p + 1), 0, 0});
      }
      element.apply();
      intact_points = 0;
      for (int p = 0; p < max_solid_points; ++p) {
        const bool holds = element.item("plastic_strain", 0, p) < failure_strain;
        EXPECT_EQ(element.stress(0, p) == Six{}, !holds);
        intact_points += holds ? 1 : 0;
      }
      was_mixed |= intact_points > 0 && intact_points < max_solid_points;
      EXPECT_EQ(element.intact(0), intact_points > 0);
      EXPECT_TRUE(element.intact(5)) << "a neighbour in the same pack";
      EXPECT_GT(element.stress(5, 0)[3], 0);
    }
    EXPECT_EQ(intact_points, 0);
    EXPECT_TRUE(was_mixed);
  }
}

TEST(SolidRegistry, TellsWhichLawsSolidsHave) {
  EXPECT_GE(solid_material_kind(model::Elastic{}), 0);
  EXPECT_GE(solid_material_kind(model::JohnsonCook{}), 0);
  EXPECT_EQ(solid_material_kind(model::OrthotropicElastic{}), -1);
  EXPECT_THROW(solid_material_constants(plastic_kinematic(youngs_modulus, 0.5)), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::solid_failure_test
