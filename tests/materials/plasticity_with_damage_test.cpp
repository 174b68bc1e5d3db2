// SPDX-License-Identifier: BSD-3-Clause
// *MAT_PLASTICITY_WITH_DAMAGE: a point that hardens, softens and ruptures, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "materials/section_driver.hpp"
#include "materials/solid_driver.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::plasticity_with_damage_test {
namespace {

constexpr double begin = 0.02;
constexpr double rupture = 0.08;
constexpr double hardening = 1500;

model::Material damaged(int points = 0, double share = 0) {
  model::Material material = tabulated({0, 0.1}, {initial_yield, initial_yield + 0.1 * hardening});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.damage_strain = {0, begin, rupture};
  law.damage = {0, 0, 1};
  law.failure_strain = rupture;
  law.failed_points = points;
  law.failed_share = share;
  return material;
}
model::Material undamaged() {
  model::Material material = damaged();
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.damage_strain.clear();
  law.damage.clear();
  law.failure_strain = 0;
  return material;
}

/// 1 - w.
double left_of(double plastic) {
  return plastic < begin ? 1 : (rupture - plastic) / (rupture - begin);
}
double yield_of(double plastic) {
  return initial_yield + hardening * plastic;
}

/// The work of uniaxial stress per volume up to a plastic strain, the integral of (1 - w)(Y + H p) over the
/// strain Y / E + p in closed form, with the elastic energy up to first yield.
double work_of(double plastic) {
  const double per_strain = 1 + hardening / youngs_modulus;
  const auto primitive = [](double p) { return initial_yield * p + 0.5 * hardening * p * p; };
  double work = 0.5 * initial_yield * initial_yield / youngs_modulus;
  if (plastic <= begin) return work + per_strain * primitive(plastic);
  // (rupture - p) times the yield stress.
  const auto fading = [](double p) {
    return (initial_yield * rupture * p + 0.5 * (hardening * rupture - initial_yield) * p * p -
            hardening * p * p * p / 3) /
           (rupture - begin);
  };
  work += per_strain * (primitive(begin) + fading(plastic) - fading(begin));
  return work;
}

/// Pulls a point with uniaxial stress until it ruptures: stress by plastic strain, plastic strain by total
/// strain, work.
template <class Point, class Pull>
void expect_closed_form(Point& point, const Pull& pull, const char* kind, double tolerance,
                        double work_error) {
  test::Largest off(std::string(kind) + ", MAT_081 pulled until it ruptures: stress, error [yield stress]",
                    "closed form", tolerance);
  constexpr double step = 2e-5;
  double work = 0;
  double strain = 0;
  double plastic = 0;
  int softening = 0;
  while (strain < 0.2) {
    pull(step);
    strain += step;
    work += point.energy();
    if (!point.intact()) break;
    plastic = point.item("plastic_strain");
    const double own = yield_of(plastic);
    if (plastic > 0) {
      off.compare(point.stress()[0], left_of(plastic) * own, initial_yield);
      EXPECT_NEAR(plastic + own / youngs_modulus, strain, 10 * tolerance * strain);
      EXPECT_NEAR(work, work_of(plastic), work_error * work_of(rupture));
    }
    softening += plastic > begin ? 1 : 0;
  }
  EXPECT_GT(softening, 1000);
  EXPECT_NEAR(strain, rupture + yield_of(rupture) / youngs_modulus, 2 * step);
  EXPECT_EQ(point.stress()[0], 0);
  test::verified(std::string(kind) + ", MAT_081 pulled until it ruptures: work per volume", "closed form")
      .within(work, work_of(rupture), work_error);
}

TEST(PlasticityWithDamage, ShellFollowsTheClosedForm) {
  for (const Isa isa : available_isas()) {
    PointDriver<double> point(damaged(), isa);
    expect_closed_form(
        point, [&](double step) { point.apply_uniaxial(step, poissons_ratio); }, "shell", 1e-9, 1e-6);
  }
}

TEST(PlasticityWithDamage, SolidFollowsTheClosedForm) {
  for (const Isa isa : available_isas()) {
    SolidDriver<double> point(damaged(), isa);
    expect_closed_form(
        point, [&](double step) { point.apply_uniaxial(step); }, "solid", 1e-9, 1e-6);
  }
}

/// Plastic strain, thickness and what is left of the stress are those of the law without damage.
template <class Real>
void expect_same_flow(Isa isa, double tolerance) {
  PointDriver<Real> point(damaged(), isa);
  PointDriver<Real> whole(undamaged(), isa);
  const Five paths[] = {{3e-4, 1e-4, 2e-4, 0, 1e-4}, {-2e-4, 3e-4, 0, 2e-4, 0}, {3e-4, -3e-4, 1e-4, 0, 0}};
  double largest = 0;
  double thickness = 0;
  double whole_thickness = 0;
  for (int i = 0; i < 150; ++i) {
    point.apply(paths[i / 10 % 3]);
    whole.apply(paths[i / 10 % 3]);
    thickness += point.thickness_strain();
    whole_thickness += whole.thickness_strain();
    const double plastic = whole.item("plastic_strain");
    ASSERT_LT(plastic, rupture);
    EXPECT_NEAR(point.item("plastic_strain"), plastic, tolerance);
    EXPECT_NEAR(thickness, whole_thickness, tolerance);
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NEAR(point.stress()[k], left_of(plastic) * whole.stress()[k], 1e5 * tolerance);
    largest = std::max(largest, plastic);
  }
  EXPECT_GT(largest, 0.035);
}
TEST(PlasticityWithDamage, FlowsAsTheLawWithoutDamage) {
  for (const Isa isa : available_isas()) {
    expect_same_flow<double>(isa, 1e-12);
    expect_same_flow<float>(isa, 3e-6);
  }
}

/// Unloading is elastic with what damage has left of the modulus, and gives back what it took.
TEST(PlasticityWithDamage, UnloadsWithTheModulusThatIsLeft) {
  PointDriver<double> point(damaged(), available_isas().back());
  for (int i = 0; i < 1000; ++i) point.apply_uniaxial(5e-5, poissons_ratio);
  const double left = left_of(point.item("plastic_strain"));
  ASSERT_LT(left, 0.6);
  const double before = point.stress()[0];
  double work = 0;
  for (int i = 0; i < 100; ++i) {
    point.apply({-1e-5, 0.3e-5, 0, 0, 0});
    work += point.energy();
  }
  test::verified("shell, MAT_081 unloaded while it softens: slope over the modulus", "1 - damage")
      .within((before - point.stress()[0]) / 1e-3 / youngs_modulus, left, 1e-9);
  for (int i = 0; i < 100; ++i) {
    point.apply({1e-5, -0.3e-5, 0, 0, 0});
    work += point.energy();
  }
  EXPECT_NEAR(point.stress()[0], before, 1e-9 * before);
  EXPECT_NEAR(work, 0, 1e-12 * before);
}

/// A beam's point, in tension and in torsion.
TEST(PlasticityWithDamage, BeamFollowsTheClosedForm) {
  SectionPoint pulled(damaged());
  SectionPoint twisted(damaged());
  for (int i = 0; i < 2500; ++i) {
    pulled.advance(2e-5, 0, 0, 1);
    twisted.advance(0, 3e-5, 0, 1);
    for (const SectionPoint* point : {&pulled, &twisted}) {
      const double plastic = point->plastic_strain();
      if (plastic == 0) continue;
      const double stress = point == &pulled ? point->stress(0) : std::sqrt(3.0) * point->stress(1);
      EXPECT_NEAR(stress, left_of(plastic) * yield_of(plastic), 1e-9 * initial_yield);
    }
  }
  EXPECT_GT(pulled.plastic_strain(), 2 * begin);
  EXPECT_GT(twisted.plastic_strain(), begin);
  for (int i = 0; i < 3000; ++i) pulled.advance(2e-5, 0, 0, 1);
  EXPECT_EQ(pulled.stress(0), 0);
  EXPECT_EQ(pulled.intact(), 0);
}

/// Four points of which each is strained more than the one before.
int points_at_failure(const model::Material& material, Isa isa) {
  PointDriver<double> element(material, isa, 4);
  int failed = 0;
  for (int step = 0; step < 400; ++step) {
    for (int p = 0; p < 4; ++p) element.set_strain(0, p, {0, 0, 0.001 * (p + 1), 0, 0});
    element.apply();
    EXPECT_TRUE(element.intact(5)) << "a neighbour in the same pack";
    int now = 0;
    for (int p = 0; p < 4; ++p) now += element.item("plastic_strain", 0, p) >= rupture ? 1 : 0;
    if (!element.intact(0)) {
      for (int p = 0; p < 4; ++p) EXPECT_EQ(element.stress(0, p), Five{});
      return now;
    }
    failed = now;
  }
  return -failed;
}
TEST(PlasticityWithDamage, ShellGoesWithItsNumberOfPoints) {
  for (const Isa isa : available_isas()) {
    EXPECT_EQ(points_at_failure(damaged(), isa), 4);
    EXPECT_EQ(points_at_failure(damaged(1), isa), 1);
    EXPECT_EQ(points_at_failure(damaged(3), isa), 3);
    EXPECT_EQ(points_at_failure(damaged(0, 0.5), isa), 2);
  }
}

/// A curve that ends below one leaves a share of the strength, and nothing fails.
TEST(PlasticityWithDamage, MayKeepAShareOfTheStrength) {
  model::Material material = damaged();
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.damage_strain = {0, 0.01, 0.02};
  law.damage = {0, 0.5, 0.75};
  law.failure_strain = 0;
  EXPECT_FALSE(can_fail(material));
  PointDriver<double> point(material, available_isas().back());
  for (int i = 0; i < 1000; ++i) point.apply_uniaxial(1e-4, poissons_ratio);
  EXPECT_NEAR(point.stress()[0], 0.25 * yield_of(point.item("plastic_strain")), 1e-7);
}

TEST(PlasticityWithDamage, IsChecked) {
  const auto changed = [](std::vector<double> strain, std::vector<double> damage) {
    model::Material material = damaged();
    auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
    law.damage_strain = std::move(strain);
    law.damage = std::move(damage);
    return material;
  };
  EXPECT_THROW(shell_material_constants(changed({0, 0.1}, {0, 1.1})), Error);
  EXPECT_THROW(shell_material_constants(changed({0, 0.1}, {0.5, 0.4})), Error);
  EXPECT_THROW(shell_material_constants(changed({0.1, 0.2}, {0, 1})), Error);
  EXPECT_THROW(solid_material_constants(changed({0, 0}, {0, 1}), nullptr), Error);
  EXPECT_THROW(shell_material_constants(damaged(0, 1.5)), Error);
  EXPECT_NE(shell_material_kind(damaged().law), shell_material_kind(undamaged().law));
  EXPECT_NE(solid_material_kind(damaged().law), solid_material_kind(undamaged().law));
}

}  // namespace
}  // namespace crumple::materials::testing::plasticity_with_damage_test
