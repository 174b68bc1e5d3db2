// SPDX-License-Identifier: BSD-3-Clause
// Shells that fail by thinning, by their major strain, and by a number of points.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::strain_limits_test {
namespace {

model::Material limited(double thinning, double major, int points = 0, double share = 0) {
  model::Material material = tabulated({0, 0.1}, {250, 400});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.failure_thinning = thinning;
  law.failure_major = major;
  law.failed_points = points;
  law.failed_share = share;
  return material;
}

/// Up to failure the response is that of the same material without limits, bit by bit; then there is none.
template <class Real>
void expect_failure_by_thinning(Isa isa) {
  constexpr double limit = 0.03;
  PointDriver<Real> point(limited(limit, 0), isa);
  PointDriver<Real> endless(tabulated({0, 0.1}, {250, 400}), isa);
  const Five strain{0.0005, -0.0001, 0.0003, 0.0002, 0};
  double thinned = 0;
  int steps = 0;
  for (; thinned < limit && steps < 1000; ++steps) {
    if (steps > 0) {
      EXPECT_EQ(point.stress(), endless.stress());
      EXPECT_TRUE(point.intact());
    }
    point.apply(strain);
    endless.apply(strain);
    thinned -= endless.thickness_strain();
  }
  EXPECT_GT(steps, 20);
  EXPECT_LT(steps, 1000);
  EXPECT_FALSE(point.intact());
  EXPECT_EQ(point.stress(), Five{});
  for (const double sign : {-1.0, -1.0, 1.0}) {
    point.apply({sign * 0.1, 0, sign * 0.05, 0, 0});
    EXPECT_EQ(point.stress(), Five{});
    EXPECT_EQ(point.energy(), 0);
    EXPECT_FALSE(point.intact());
  }
}
TEST(StrainLimits, PointsFailByThinning) {
  for (const Isa isa : available_isas()) {
    expect_failure_by_thinning<double>(isa);
    expect_failure_by_thinning<float>(isa);
  }
}

/// Plastic flow keeps the volume: pulled both ways the sheet thins by twice its strain, beside elastic
/// strains.
TEST(StrainLimits, SheetPulledBothWaysThinsTwiceItsStrain) {
  constexpr double limit = 0.06;
  PointDriver<double> point(limited(limit, 0), available_isas().back());
  int steps = 0;
  do {
    point.apply({1e-4, 1e-4, 0, 0, 0});
    ++steps;
  } while (point.intact() && steps < 1000);
  // Elastic: 2 (1 - nu) / E of the yield stress less of twice the strain than plastic flow.
  const double plastic = limit / 2;
  const double stress = 250 + 1500 * 2 * plastic;
  const double volume = 2 * (1 - 2 * poissons_ratio) / youngs_modulus * stress;
  test::verified("sheet pulled both ways, thinning limit 0.06: strain at failure", "closed form")
      .near(1e-4 * steps, (limit + volume) / 2, 1.5e-4);
}

/// The major strain in whatever direction it comes.
TEST(StrainLimits, PointsFailByTheMajorStrain) {
  constexpr double limit = 0.05;
  test::Largest off(
      "shell, major strain limit 0.05 in twelve directions: strain at failure, error [steps of 1e-3]",
      "the limit", 1.001);
  for (const Isa isa : available_isas())
    for (int direction = 0; direction < 12; ++direction) {
      const double angle = direction * std::acos(-1.0) / 12;
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      // Major 1e-3, minor -0.4e-3.
      const Five strain{1e-3 * (c * c - 0.4 * s * s), 1e-3 * (s * s - 0.4 * c * c), 2 * 1.4e-3 * c * s, 0, 0};
      PointDriver<double> point(limited(0, limit), isa);
      int steps = 0;
      do {
        point.apply(strain);
        ++steps;
      } while (point.intact() && steps < 1000);
      off.add(std::fabs(steps - limit / 1e-3));
    }
}

/// Four points of which each is strained more than the one before.
int points_at_failure(const model::Material& material, Isa isa) {
  PointDriver<double> element(material, isa, 4);
  int failed = 0;
  for (int step = 0; step < 200; ++step) {
    for (int p = 0; p < 4; ++p) {
      element.set_strain(0, p, {0.0021 * (p + 1), 0, 0, 0, 0});
      element.set_strain(5, p, {0.0001, 0, 0, 0, 0});
    }
    element.apply();
    EXPECT_TRUE(element.intact(5)) << "a neighbour in the same pack";
    int now = 0;
    for (int p = 0; p < 4; ++p) now += 0.0021 * (p + 1) * (step + 1) >= 0.0999999 ? 1 : 0;
    if (!element.intact(0)) {
      for (int p = 0; p < 4; ++p) EXPECT_EQ(element.stress(0, p), Five{});
      return now;
    }
    failed = now;
    for (int p = 0; p < 4; ++p)
      EXPECT_EQ(element.stress(0, p) == Five{}, 0.0021 * (p + 1) * (step + 1) >= 0.0999999);
  }
  return failed;
}
TEST(StrainLimits, ElementFailsWithItsNumberOfPoints) {
  for (const Isa isa : available_isas()) {
    EXPECT_EQ(points_at_failure(limited(0, 0.1), isa), 4);
    EXPECT_EQ(points_at_failure(limited(0, 0.1, 1), isa), 1);
    EXPECT_EQ(points_at_failure(limited(0, 0.1, 2), isa), 2);
    EXPECT_EQ(points_at_failure(limited(0, 0.1, 9), isa), 4);
    EXPECT_EQ(points_at_failure(limited(0, 0.1, 0, 0.75), isa), 3);
  }
}

/// With FAIL too: whichever comes first.
TEST(StrainLimits, PlasticStrainStillCounts) {
  model::Material material = limited(0, 0.1, 2);
  std::get<model::PiecewiseLinearPlasticity>(material.law).failure_strain = 0.02;
  PointDriver<double> element(material, available_isas().back(), 3);
  int steps = 0;
  do {
    for (int p = 0; p < 3; ++p) element.set_strain(0, p, {0, 0, 0.004 * (p + 1), 0, 0});
    element.apply();
  } while (element.intact() && ++steps < 100);
  EXPECT_GE(element.item("plastic_strain", 0, 1), 0.02);
  EXPECT_LT(element.item("plastic_strain", 0, 0), 0.02);
}

TEST(StrainLimits, AreChecked) {
  EXPECT_THROW(shell_material_constants(limited(-0.1, 0.1)), Error);
  EXPECT_THROW(shell_material_constants(limited(0.1, 0, 0, 1.5)), Error);
  EXPECT_EQ(shell_material_kind(limited(0, 0).law), shell_material_kind(tabulated({0}, {250}).law));
  EXPECT_NE(shell_material_kind(limited(0.1, 0).law), shell_material_kind(tabulated({0}, {250}).law));
}

}  // namespace
}  // namespace crumple::materials::testing::strain_limits_test
