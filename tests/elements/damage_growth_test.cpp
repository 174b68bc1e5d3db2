// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_DAMAGE_GISSMO: D = (integral of d eps_p / eps_f)^n, the stress that is left, and when elements go,
// on points whose plastic strain is given and on elements that are driven.
#include <gtest/gtest.h>

#include "elements/common/damage_growth.hpp"
#include "elements/solid_harness.hpp"
#include "support/verified.hpp"

namespace crumple::elements::testing::damage_growth_test {
namespace {

using model::GissmoDamage;

/// Failure strains of 0.5, 0.2 and 0.4 in shear, uniaxial and equibiaxial tension.
GissmoDamage damage_over_triaxiality() {
  GissmoDamage damage;
  damage.failure_strain = {{0}, {{1, {-1.0 / 3, 0, 1.0 / 3, 2.0 / 3}, {2, 0.5, 0.2, 0.4}}}};
  damage.fading_exponent = model::constant_family(1);
  damage.exponent = 2;
  return damage;
}

/// One lane of one group of solids with one point, as the driver calls damage; the plastic strain is given.
template <class Real>
struct OneDamagedPoint {
  explicit OneDamagedPoint(const GissmoDamage& damage, double size = 1) {
    block.points = 1;
    block.elements = 1;
    block.damage = damage;
    domain::add_item(block, "stress", "stress", 6);
    plastic = domain::add_item(block, "plastic_strain", "-", 1);
    domain::add_item(block, "plastic_strain_rest", "-", 1);
    declare_damage(block);
    block.allocate(std::is_same_v<Real, float> ? Precision::Mixed : Precision::Double);
    set_damage_size(block, 0, size);
    strain.assign(std::size_t{6} * materials::tile_lanes, Real(0));
    turn.assign(std::size_t{9} * materials::tile_lanes, Real(0));
    energy.assign(materials::tile_lanes, Real(0));
    intact.assign(materials::tile_lanes, Real(1));
  }
  Real& state(Index component) {
    return domain::state_of<Real>(block)[static_cast<std::size_t>(component * lanes)];
  }
  double item(const char* name, Index which = 0) { return block.state(0, block.find(name)->first + which); }

  /// A step in which the law finds this plastic strain more and the undamaged stress xx, yy, xy.
  void step(double more, double xx, double yy = 0, double xy = 0, double time_step = 0) {
    const PointTile<Real> tile{.state = domain::state_of<Real>(block).data(),
                               .groups = 1,
                               .strain = strain.data(),
                               .turn = turn.data(),
                               .energy = energy.data(),
                               .intact = intact.data()};
    const DamageGrowth growth = damage_growth(block, time_step);
    restore_stress(growth, tile);
    restored = double(state(0));
    state(plastic) += static_cast<Real>(more);
    state(0) = static_cast<Real>(xx);
    state(1) = static_cast<Real>(yy);
    state(3) = static_cast<Real>(xy);
    grow_damage(growth, tile);
  }
  double damage() { return item("gissmo_damage"); }
  double stress() { return double(state(0)); }
  bool gone() const { return intact[0] == Real(0); }

  domain::SolidBlock block;
  Index plastic = 0;
  double restored = 0;  ///< stress xx that the law was given
  std::vector<Real> strain, turn, energy, intact;
};

TEST(GissmoDamage, GrowsWithThePowerOfTheStrainUnderOneState) {
  for (const double exponent : {1.0, 2.0, 3.5}) {
    GissmoDamage law = damage_over_triaxiality();
    law.exponent = exponent;
    law.critical_damage = 1;
    OneDamagedPoint<double> point(law);
    for (int k = 1; k < 20; ++k) {
      point.step(0.01, 300);
      EXPECT_NEAR(point.damage(), std::pow(0.01 * k / 0.2, exponent), 1e-13);
      EXPECT_EQ(point.stress(), 300) << "nothing fades before DCRIT";
    }
    EXPECT_FALSE(point.gone());
    point.step(0.0100001, 300);
    EXPECT_EQ(point.damage(), 1);
    EXPECT_EQ(point.stress(), 0);
    EXPECT_TRUE(point.gone());
  }
}

/// Half of the failure strain in shear, then in tension along two axes: the roots of D add up.
TEST(GissmoDamage, AddsUpUnderChangingStates) {
  GissmoDamage law = damage_over_triaxiality();
  law.critical_damage = 1;
  OneDamagedPoint<double> point(law);
  for (int k = 0; k < 10; ++k) point.step(0.015, 0, 0, 200);
  EXPECT_NEAR(point.damage(), std::pow(0.15 / 0.5, 2), 1e-14);
  for (int k = 0; k < 10; ++k) point.step(0.02, 250, 250);
  EXPECT_NEAR(point.damage(), std::pow(0.15 / 0.5 + 0.2 / 0.4, 2), 1e-14);
  for (int k = 0; k < 10; ++k) point.step(0.02, -300);
  EXPECT_NEAR(point.damage(), std::pow(0.15 / 0.5 + 0.2 / 0.4 + 0.2 / 2, 2), 1e-14)
      << "compression, at the end of the curve";
}

TEST(GissmoDamage, FadesBehindTheCriticalDamage) {
  for (const double exponent : {0.5, 1.0, 3.0}) {
    GissmoDamage law = damage_over_triaxiality();
    law.critical_damage = 0.25;
    law.fading_exponent = model::constant_family(exponent);
    OneDamagedPoint<double> point(law);
    double before = 0;
    for (int k = 1; k < 20; ++k) {
      point.step(0.01, 300);
      EXPECT_NEAR(point.restored, before, 1e-12) << "the law is given what it has left";
      before = 300;
      const double damage = std::pow(0.05 * k, 2);
      const double left = 1 - std::pow(std::max(0.0, damage - 0.25) / 0.75, exponent);
      EXPECT_NEAR(point.stress(), 300 * left, 1e-11) << exponent << " " << k;
    }
  }
}

/// Instability at 0.08 of 0.2: D is (0.4)^2 then.
TEST(GissmoDamage, InstabilitySetsTheCriticalDamage) {
  GissmoDamage law = damage_over_triaxiality();
  law.critical_damage = 0.9;
  law.critical_strain = model::constant_family(0.0799999);
  OneDamagedPoint<double> point(law);
  for (int k = 1; k < 20; ++k) {
    point.step(0.01, 300);
    const double damage = std::pow(0.05 * k, 2);
    const double left = 1 - std::max(0.0, damage - 0.16) / 0.84;
    EXPECT_NEAR(point.stress(), 300 * left, 1e-10) << k;
  }
  // Over triaxiality: 0.3 in shear, 0.1 in tension; half of the one and half of the other.
  law.critical_strain = {{0}, {{2, {0, 1.0 / 3}, {0.3, 0.0999999}}}};
  OneDamagedPoint<double> changing(law);
  changing.step(0.15, 0, 0, 200);
  changing.step(0.0499, 300);
  EXPECT_EQ(changing.stress(), 300);
  changing.step(0.0002, 300);
  const double critical = std::pow(0.15 / 0.5 + 0.0501 / 0.2, 2);
  EXPECT_EQ(changing.stress(), 300) << "it fades from the next step on";
  changing.step(0.02, 300);
  const double damage = std::pow(0.15 / 0.5 + 0.0701 / 0.2, 2);
  EXPECT_NEAR(changing.stress(), 300 * (1 - (damage - critical) / (1 - critical)), 1e-10);
}

/// A factor of 0.6 at size 3 in tension; SHRF and BIAXF take 0.5 of what it takes in shear, all of it in
/// tension along two axes.
TEST(GissmoDamage, RegularizesBySize) {
  GissmoDamage law = damage_over_triaxiality();
  law.exponent = 1;
  law.critical_damage = 1;
  law.size_factor = {{0}, {{3, {1, 5}, {1, 0.2}}}};
  law.shear_reduction = 0.5;
  law.biaxial_reduction = 1;
  const auto damage_of = [](const GissmoDamage& of, double xx, double yy, double xy) {
    OneDamagedPoint<double> point(of, 3);
    point.step(0.05, xx, yy, xy);
    return point.damage();
  };
  EXPECT_NEAR(damage_of(law, 300, 0, 0), 0.05 / (0.6 * 0.2), 1e-13);
  EXPECT_NEAR(damage_of(law, 0, 0, 200), 0.05 / (0.8 * 0.5), 1e-13);
  EXPECT_NEAR(damage_of(law, 250, 250, 0), 0.05 / 0.4, 1e-13);
  EXPECT_NEAR(damage_of(law, -300, 0, 0), 0.05 / (0.8 * 2), 1e-13) << "as in shear";
  // By a table over triaxiality: 0.6 at 0, 0.3 at 1/3 for the size 3.
  law.shear_reduction = law.biaxial_reduction = 0;
  law.size_factor = {{0, 1.0 / 3}, {{3, {1, 5}, {1, 0.2}}, {4, {1, 5}, {0.5, 0.1}}}};
  EXPECT_NEAR(damage_of(law, 0, 0, 200), 0.05 / (0.6 * 0.5), 1e-13);
  EXPECT_NEAR(damage_of(law, 300, 0, 0), 0.05 / (0.3 * 0.2), 1e-13);
  // The exponent of fading over the size: 2 at 3.
  law.size_factor = {};
  law.critical_damage = 0.5;
  law.fading_exponent = {{0}, {{5, {1, 5}, {1, 3}}}};
  OneDamagedPoint<double> point(law, 3);
  point.step(0.16, 300);
  EXPECT_NEAR(point.stress(), 300 * (1 - 0.6 * 0.6), 1e-10);
}

/// Lode's parameter is 1 in tension, 0 in shear, -1 in compression and in tension along two axes.
TEST(GissmoDamage, LooksUpTablesByLodesParameter) {
  GissmoDamage law = damage_over_triaxiality();
  law.exponent = 1;
  law.critical_damage = 1;
  law.failure_strain = {{-1, 0, 1},
                        {{1, {0, 1}, {0.1, 0.1}}, {2, {0, 1}, {0.2, 0.2}}, {3, {0, 1}, {0.8, 0.8}}}};
  const auto damage_of = [&](double xx, double yy, double xy) {
    OneDamagedPoint<double> point(law);
    point.step(0.05, xx, yy, xy);
    return point.damage();
  };
  EXPECT_NEAR(damage_of(300, 0, 0), 0.05 / 0.8, 1e-12);
  EXPECT_NEAR(damage_of(0, 0, 200), 0.05 / 0.2, 1e-12);
  EXPECT_NEAR(damage_of(-300, 0, 0), 0.05 / 0.1, 1e-12);
  EXPECT_NEAR(damage_of(250, 250, 0), 0.05 / 0.1, 1e-12);
}

TEST(GissmoDamage, FailsLaterOrEarlierAtHigherRates) {
  GissmoDamage law = damage_over_triaxiality();
  law.exponent = 1;
  law.critical_damage = 1;
  law.rate_factor = model::Curve{7, {0, 100}, {1, 2}};
  const auto damage_at = [&](double rate) {
    OneDamagedPoint<double> point(law);
    point.step(0.05, 300, 0, 0, 0.05 / rate);
    return point.damage();
  };
  EXPECT_NEAR(damage_at(50), 0.05 / (1.5 * 0.2), 1e-13);
  law.rate_factor = model::Curve{8, {-2, 2}, {1, 3}};
  law.logarithmic_rates = true;
  EXPECT_NEAR(damage_at(std::exp(1.0)), 0.05 / (2.5 * 0.2), 1e-13);
  // The factor of 2.5 holds for the critical strain of 0.1, too, or does not.
  law.critical_strain = model::constant_family(0.1);
  for (const bool scales : {true, false}) {
    law.rates_scale_critical = scales;
    OneDamagedPoint<double> point(law);
    for (int k = 0; k < 2; ++k) point.step(0.12, 300, 0, 0, 0.12 / std::exp(1.0));
    EXPECT_EQ(point.stress() < 300, !scales);
  }
}

TEST(GissmoDamage, OnlyAddsUpWhereItDoesNotAct) {
  GissmoDamage law = damage_over_triaxiality();
  law.acts = false;
  OneDamagedPoint<double> point(law);
  for (int k = 0; k < 30; ++k) point.step(0.01, 300);
  EXPECT_EQ(point.damage(), 1);
  EXPECT_EQ(point.stress(), 300);
  EXPECT_FALSE(point.gone());
}

TEST(GissmoDamage, SmallIncrementsAreNotLostInFloat) {
  GissmoDamage law = damage_over_triaxiality();
  law.critical_damage = 1;
  OneDamagedPoint<float> point(law);
  point.state(point.plastic) = 0.5F;
  constexpr double more = 0x1p-24;  // a unit in the last place of 0.5
  int steps = 0;
  while (!point.gone() && steps < 4'000'000) {
    point.step(more, 300);
    ++steps;
  }
  EXPECT_NEAR(steps, 0.2 / more, 2);
}

/// The work is that of the stresses which the point had: half of the old and of the new one.
TEST(GissmoDamage, WorkIsThatOfTheDamagedStress) {
  GissmoDamage law = damage_over_triaxiality();
  law.exponent = 1;
  OneDamagedPoint<double> point(law);
  point.strain[0] = 0.02;
  double before = 0;
  double undamaged = 0;
  for (int k = 1; k <= 10; ++k) {
    const double now = 300 + 5 * k;
    point.energy[0] = 0.5 * (undamaged + now) * 0.02;  // as a law books it
    undamaged = now;
    point.step(0.0200000001, now);
    EXPECT_NEAR(point.energy[0], 0.5 * (before + point.stress()) * 0.02, 1e-12) << k;
    before = point.stress();
  }
  EXPECT_TRUE(point.gone());
  EXPECT_EQ(before, 0);
}

constexpr double dt = 1e-6;

/// Steps of logarithmic strain `growth` along x, the volume kept, until elements fail; the number of the
/// step, or 0.
int step_of_failure(const model::Model& model, const domain::Execution& execution, double growth) {
  Driven body(model, execution);
  const double along = (1 + 0.5 * growth) / (1 - 0.5 * growth);
  const double across = (1 - 0.25 * growth) / (1 + 0.25 * growth);
  for (int step = 1; step <= 400; ++step) {
    body.step(
        dt,
        [&](const Vec3& x) {
          return Vec3{along * x.x, across * x.y, across * x.z};
        },
        [](const Vec3&) { return Vec3{}; });
    for (const domain::ElementBlock* block : body.domain.blocks())
      if (block->eroded > 0) return block->eroded == block->elements ? step : -1;
  }
  return 0;
}

/// The volume is kept, so that the deviator is in the direction of the strain: without hardening the von
/// Mises stress 250 is 3 mu (eps - eps_p).
TEST(GissmoDamage, EndsDrivenElementsAtTheStrainOfFailure) {
  constexpr double growth = 0.002;
  constexpr double shear = youngs_modulus / (2 * (1 + poissons_ratio));
  model::Material material = plastic(1, 0);
  GissmoDamage law = damage_over_triaxiality();
  law.failure_strain = model::constant_family(0.1);
  law.critical_damage = 0.3;
  material.damage = law;
  const double strain = 0.1 + 250 / (3 * shear);
  const int expected = static_cast<int>(std::ceil(strain / growth));
  for (const auto& execution : all_executions()) {
    for (const SolidCase& solid : solid_cases) {
      SCOPED_TRACE(name_of(solid, execution));
      EXPECT_EQ(step_of_failure(solid_cube(solid, 1, 0, material), execution, growth), expected);
    }
    for (const Kind& kind : all_kinds) {
      // With a stress zz of zero the elastic strain is sigma / E, a little less.
      SCOPED_TRACE(std::string(kind.name) + " " + name_of(execution));
      const int step = step_of_failure(plate(kind.formulation, 1, 0, 3, material), execution, growth);
      EXPECT_GE(step, expected - 1);
      EXPECT_LE(step, expected);
    }
  }
}

/// The same body with and without damage: what the law keeps does not know of it, whatever the stress is.
TEST(GissmoDamage, LeavesTheLawAsItIs) {
  model::Material without = plastic(0.4, 2100);
  model::Material with = without;
  with.damage = damage_over_triaxiality();
  with.damage->failure_strain = model::constant_family(0.1);
  for (const auto& execution : all_executions())
    for (const Kind& kind : all_kinds) {
      SCOPED_TRACE(std::string(kind.name) + " " + name_of(execution));
      Driven sound(plate(kind.formulation, 1, 0, 3, without), execution);
      Driven damaged(plate(kind.formulation, 1, 0, 3, with), execution);
      const auto stretch = [](const Vec3& x) { return Vec3{1.002 * x.x + 0.001 * x.y, 0.9995 * x.y, x.z}; };
      const auto none = [](const Vec3&) { return Vec3{}; };
      for (int step = 0; step < 30; ++step) {
        sound.step(dt, stretch, none);
        damaged.step(dt, stretch, none);
      }
      const double plastic_strain = sound.item("plastic_strain", 0);
      ASSERT_GT(plastic_strain, 0.04);
      EXPECT_NEAR(damaged.item("plastic_strain", 0), plastic_strain, 30 * round_off(execution));
      const double left = 1 - std::pow(plastic_strain / 0.1, 2);
      ASSERT_LT(left, 0.8);
      EXPECT_NEAR(damaged.stress(0, 0, 0), left * sound.stress(0, 0, 0), 3e4 * round_off(execution));
      EXPECT_NEAR(damaged.item("thickness", 0), sound.item("thickness", 0), 100 * round_off(execution));
    }
}

/// Johnson & Cook's fracture strain 0.4, GISSMO's 0.1: each damage grows as it would alone.
TEST(GissmoDamage, StandsBesideTheDamageOfTheLaw) {
  model::Material material = plastic();
  model::JohnsonCook law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.yield_stress = 250;
  law.damage = {0.4, 0, 0, 0, 0};
  law.least_fracture_strain = 1e-6;
  material.law = law;
  model::Material with = material;
  with.damage = damage_over_triaxiality();
  with.damage->failure_strain = model::constant_family(0.1);
  const auto stretch = [](const Vec3& x) { return Vec3{1.002 * x.x, 0.999 * x.y, 0.999 * x.z}; };
  const auto none = [](const Vec3&) { return Vec3{}; };
  for (const auto& execution : all_executions()) {
    for (const auto& model :
         {solid_cube(solid_cases[0], 1, 0, with), plate(belytschko_tsay.formulation, 1, 0, 3, with)}) {
      Driven body(model, execution);
      for (int step = 0; step < 30; ++step) body.step(dt, stretch, none);
      const domain::ElementBlock& block = *body.domain.blocks().front();
      const auto first = [&](const char* name) { return block.state(0, block.find(name)->first); };
      const double plastic_strain = first("plastic_strain");
      ASSERT_GT(plastic_strain, 0.04);
      EXPECT_NEAR(first("damage"), plastic_strain / 0.4, 100 * round_off(execution));
      EXPECT_NEAR(first("gissmo_damage"), std::pow(plastic_strain / 0.1, 2), 100 * round_off(execution));
    }
  }
}

/// Two of four layers; of formulations with four points in plane any point counts for its layer.
TEST(GissmoDamage, PercentCountLayers) {
  for (const Kind& kind : {belytschko_tsay, fully_integrated}) {
    for (const double points : {-50.0, -51.0}) {
      model::Material material = plastic(1, 0);
      material.damage = damage_over_triaxiality();
      material.damage->failure_strain = model::constant_family(0.02);
      material.damage->critical_damage = 1;
      material.damage->points = points;
      Driven body(plate(kind.formulation, 1, 0, 4, material),
                  {Precision::Double, available_isas().back(), 1});
      // Bending: the two outer layers yield first.
      Index failed_layers = 0;
      while (body.block().eroded == 0 && failed_layers < 3) {
        const domain::NodeFields& nodes = body.domain.nodes;
        std::vector<Vec3> turn;
        for (const Vec3& x : nodes.position) turn.push_back({0, 0.002 * (x.x - 2.5), 0});
        body.step(dt, std::vector<Vec3>(turn.size()), turn);
        failed_layers = 0;
        for (Index layer = 0; layer < 4; ++layer)
          for (Index plane = 0; plane < body.block().plane_points; ++plane)
            if (body.item("gissmo_damage", 0, plane * 4 + layer) == 1) {
              ++failed_layers;
              break;
            }
        if (points == -50.0) {
          EXPECT_EQ(body.block().eroded, failed_layers >= 2 ? 1 : 0) << kind.name;
        } else if (failed_layers == 2) {
          EXPECT_EQ(body.block().eroded, 0) << kind.name;
          failed_layers = 3;  // seen
        }
      }
      EXPECT_GE(failed_layers, 2);
    }
  }
}

}  // namespace
}  // namespace crumple::elements::testing::damage_growth_test
