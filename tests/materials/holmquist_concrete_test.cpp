// SPDX-License-Identifier: BSD-3-Clause
// Holmquist, Johnson & Cook's law of concrete along given paths.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "materials/brittle_cases.hpp"
#include "materials/solid_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::holmquist_concrete_test {
namespace {

class HolmquistConcrete : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, HolmquistConcrete, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

model::Material tough_ballistic_concrete() {
  model::Material material = ballistic_concrete();
  ballistic_law(material).least_fracture = 1e12;
  return material;
}

/// The pressure once more from its equations.
struct ThreeRegions {
  model::HolmquistConcrete law;
  double full = 0;

  explicit ThreeRegions(const model::HolmquistConcrete& of) : law(of) {
    double low = 0;
    double high = 0.1;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (dense(middle) < law.lock_pressure ? low : high) = middle;
    }
    full = law.lock_volume + (1 + law.lock_volume) * low;
  }
  double dense(double bar) const {
    return bar > 0
               ? law.bulk_modulus * bar + law.bulk_quadratic * bar * bar + law.bulk_cubic * bar * bar * bar
               : law.bulk_modulus * bar;
  }
  double elastic() const { return law.crush_pressure / law.crush_volume; }
  double envelope(double mu) const {
    if (mu <= law.crush_volume) return elastic() * mu;
    if (mu >= full) return dense((mu - law.lock_volume) / (1 + law.lock_volume));
    return law.crush_pressure +
           (law.lock_pressure - law.crush_pressure) * (mu - law.crush_volume) / (full - law.crush_volume);
  }
  double unloading(double most) const {
    const double share = (most - law.crush_volume) / (full - law.crush_volume);
    return (1 - share) * elastic() + share * law.bulk_modulus;
  }
  /// Without the limit in tension.
  double at(double mu, double most) const {
    if (most <= law.crush_volume) return elastic() * mu;
    if (most >= full) return dense((mu - law.lock_volume) / (1 + law.lock_volume));
    return envelope(most) - unloading(most) * (most - mu);
  }
  /// mu without pressure, after a largest mu between UC and full.
  double rest(double most) const { return most - envelope(most) / unloading(most); }
};

double strength_at(const model::HolmquistConcrete& law, double p, double damage) {
  const double fluid = p > 0 ? law.cohesion * (1 - damage) +
                                   law.pressure_factor * std::pow(p / law.strength, law.pressure_power)
                             : law.cohesion * std::max(1 - damage + p / law.tension, 0.0);
  return law.strength * std::min(fluid, law.largest_strength);
}

/// Up into each of the regions, back to tension, and on.
TEST_P(HolmquistConcrete, PressureHasThreeRegionsAndTheirUnloading) {
  model::Material material = tough_ballistic_concrete();
  const ThreeRegions exact(ballistic_law(material));
  MotionDriver<double> point(material, GetParam());
  test::Largest off("ballistic concrete, squeezed and released in all regions: pressure, error [MPa]",
                    "closed form of the three regions", 1e-8);
  test::Points curve;
  test::Points found;
  double most = 0;
  double mu = 0;
  for (const double target : {0.0008, -0.0001, 0.03, 0.02, 0.0299, 0.07, 0.055, 0.14, 0.09, 0.2}) {
    const double from = mu;
    for (int i = 1; i <= 60; ++i) {
      mu = from + (target - from) * i / 60;
      most = std::max(most, mu);
      point.move_to(squeezed_to(mu));
      const double expected = std::max(exact.at(mu, most), -4.0);
      off.compare(point.pressure(), expected);
      curve.push_back({mu, expected});
      if (i % 6 == 0) found.push_back({mu, point.pressure()});
    }
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Ballistic concrete squeezed and released in its three regions", "mu", "pressure [MPa]")
        .accepted("closed form", curve)
        .found("one point of material", found)
        .note();
}

TEST_P(HolmquistConcrete, StrengthFollowsThePressure) {
  model::Material material = tough_ballistic_concrete();
  const model::HolmquistConcrete& law = ballistic_law(material);
  const ThreeRegions exact(law);
  test::Largest off("ballistic concrete, sheared from -3 to 3500 MPa: von Mises stress, error [MPa]",
                    "FC (A + B P*^N), FC A (1 + P/T), FC SFMAX", 1e-6);
  for (const double mu : {-3.0 / 16000, 0.0, 0.001, 0.02, 0.1, 0.15}) {
    MotionDriver<double> point(material, GetParam());
    const Matrix f = squeezed_to(mu);
    point.move_in_steps(f, 20);
    for (int i = 1; i <= 40; ++i) point.move_to(sheared(0.1 * i / 40, f));
    off.compare(equivalent(point.stress()), strength_at(law, exact.envelope(mu), 0));
  }
  EXPECT_EQ(strength_at(law, exact.envelope(0.15), 0), 7 * 48);
}

/// Along one axis the deviator is on the yield surface: -s = p + 2/3 Y along it, p - Y/3 across.
TEST_P(HolmquistConcrete, UniaxialStrainHasTheClosedForm) {
  model::Material material = ballistic_concrete();
  const model::HolmquistConcrete& law = ballistic_law(material);
  const ThreeRegions exact(law);
  MotionDriver<double> point(material, GetParam());
  test::Largest off("ballistic concrete, confined compression to mu = 0.2: stresses, error [MPa]",
                    "closed form", 1e-7);
  for (int i = 1; i <= 1000; ++i) {
    const double mu = 0.2 * i / 1000;
    const double damage = point.item("damage");
    point.move_to(confined(mu));
    if (i < 40) continue;
    const double p = exact.envelope(mu);
    const double strength = strength_at(law, p, damage);
    const Six s = point.stress();
    off.compare(s[1], -p - 2.0 / 3 * strength);
    off.compare(s[0], -p + strength / 3);
    off.compare(s[2], -p + strength / 3);
  }
  EXPECT_GT(point.item("damage"), 0.1);
}

/// At a constant pressure the strength falls by FC A D; with D = (e - s/3G)/e_f that has the solution below.
TEST_P(HolmquistConcrete, FlowTakesItsShareOfTheStrainToFracture) {
  test::Largest off("ballistic concrete, sheared at 10 MPa: damage, error", "closed form", 2e-4);
  for (const double factor : {1.0, 0.0}) {  // by D1, by EFMIN
    model::Material material = ballistic_concrete();
    model::HolmquistConcrete& law = ballistic_law(material);
    law.fracture_factor = 0.1 * factor;
    MotionDriver<double> point(material, GetParam());
    const double p = 10;
    const Matrix f = squeezed_to(p / 16000);
    point.move_in_steps(f, 20);
    const double fracture = std::max(law.fracture_factor * (p + law.tension) / law.strength, 0.01);
    const double start = strength_at(law, p, 0);
    const double drop = law.strength * law.cohesion;
    for (int i = 1; i <= 8000; ++i) {
      const double strain = 0.05 * i / 8000;
      point.move_to(sheared(strain * std::sqrt(3.0), f));
      const double flow = strain - start / (3 * law.shear_modulus);
      off.compare(point.item("damage"),
                  std::clamp(flow / (fracture - drop / (3 * law.shear_modulus)), 0.0, 1.0));
    }
    EXPECT_EQ(point.item("damage"), 1);
    EXPECT_NEAR(equivalent(point.stress()), strength_at(law, p, 1), 1e-6);
  }
}

/// Pressure alone: the pores that collapse count, at the pressure of their collapse.
TEST_P(HolmquistConcrete, CollapseOfPoresTakesItsShare) {
  model::Material material = ballistic_concrete();
  model::HolmquistConcrete& law = ballistic_law(material);
  law.fracture_factor = 0.05;
  const ThreeRegions exact(law);
  MotionDriver<double> point(material, GetParam());
  test::Largest off("ballistic concrete under pressure alone: damage, error", "quadrature", 3e-4);
  double damage = 0;
  double before = law.crush_volume;
  for (int i = 1; i <= 12000; ++i) {
    const double mu = 0.15 * i / 12000;
    point.move_to(squeezed_to(mu));
    for (int j = 0; j < 10; ++j) {
      const double to = std::clamp(mu - 0.15 / 12000 * (9 - j) / 10, law.crush_volume, exact.full);
      const double p = exact.envelope(0.5 * (before + to));
      damage += (exact.rest(to) - exact.rest(before)) /
                std::max(law.fracture_factor * (p + law.tension) / law.strength, law.least_fracture);
      before = to;
    }
    off.compare(point.item("damage"), damage);
  }
  EXPECT_GT(damage, 0.2);
  EXPECT_LT(damage, 1);
  EXPECT_EQ(point.item("plastic_strain"), 0);
}

TEST_P(HolmquistConcrete, DamageTakesTheStrengthInTension) {
  model::Material material = ballistic_concrete();
  model::HolmquistConcrete& law = ballistic_law(material);
  law.fracture_factor = 0.1;
  MotionDriver<double> point(material, GetParam());
  const Matrix f = squeezed_to(10.0 / 16000);
  point.move_in_steps(f, 20);
  for (int i = 1; i <= 200; ++i) point.move_to(sheared(0.02 * i / 200, f));
  const double damage = point.item("damage");
  EXPECT_GT(damage, 0.1);
  EXPECT_LT(damage, 0.9);
  Matrix apart = point.at();
  for (auto& row : apart)
    for (double& value : row) value *= 1.01;
  point.move_to(apart);
  test::verified("ballistic concrete, damaged and pulled: pressure, error [MPa]", "-T (1 - D)")
      .below(std::fabs(point.pressure() + 4 * (1 - damage)), 1e-9);
  EXPECT_LT(equivalent(point.stress()), 1e-9);
}

TEST_P(HolmquistConcrete, RatesRaiseTheStrength) {
  model::Material material = tough_ballistic_concrete();
  ballistic_law(material).rate_coefficient = 0.007;
  test::Largest off("ballistic concrete at 0.1 to 1e4/s: strength, relative error", "1 + C ln(rate/EPS0)",
                    1e-4);
  for (const double rate : {0.1, 100.0, 1e4}) {
    MotionDriver<double> point(material, GetParam());
    const Matrix f = squeezed_to(0.03);
    point.move_in_steps(f, 20);
    const double p = ThreeRegions(ballistic_law(material)).envelope(0.03);
    for (int i = 1; i <= 100; ++i) point.move_to(sheared(5e-4 * i * std::sqrt(3.0), f), 5e-4 / rate);
    const double expected =
        (rate > 1 ? 1 + 0.007 * std::log(rate) : 1) * strength_at(ballistic_law(material), p, 0);
    off.compare(equivalent(point.stress()), expected, expected);
  }
}

TEST_P(HolmquistConcrete, PointsFailAsFsSays) {
  const auto pulled = [&](const model::BrittleErosion& erosion, double factor) {
    model::Material material = ballistic_concrete();
    ballistic_law(material).fracture_factor = 0.1;
    ballistic_law(material).erosion = erosion;
    MotionDriver<double> point(material, GetParam());
    const Matrix f = squeezed_to(10.0 / 16000);
    point.move_in_steps(f, 20);
    for (int i = 1; i <= 200; ++i) point.move_to(sheared(0.02 * i / 200, f));
    const double limit = erosion.by_damage ? 4 * (1 - point.item("damage")) : 4;
    EXPECT_GT(point.item("damage"), 0.1);
    EXPECT_TRUE(point.intact());
    point.move_to(sheared(0.02, squeezed_to(-factor * limit / 16000)));
    return !point.intact();
  };
  EXPECT_FALSE(pulled({true, false, 0}, 0.999));
  EXPECT_TRUE(pulled({true, false, 0}, 1.001));
  EXPECT_TRUE(pulled({true, true, 0}, 1.001));

  model::Material strained = ballistic_concrete();
  ballistic_law(strained).erosion = {false, false, 0.02};
  MotionDriver<double> flowing(strained, GetParam());
  const Matrix f = squeezed_to(0.01);
  flowing.move_in_steps(f, 20);
  for (int i = 1; i <= 400; ++i) {
    flowing.move_to(sheared(0.1 * i / 400, f));
    EXPECT_EQ(flowing.intact(), flowing.item("plastic_strain") <= 0.02);
  }
  EXPECT_FALSE(flowing.intact());
  EXPECT_EQ(flowing.pressure(), 0);
}

/// Crushing takes the area between the lines.
TEST_P(HolmquistConcrete, WorkOfACycleIsTheAreaBetween) {
  const model::Material material = tough_ballistic_concrete();
  model::Material copy = material;
  const ThreeRegions exact(ballistic_law(copy));
  MotionDriver<double> point(material, GetParam());
  double expected = 0;
  double most = 0;
  double before = 0;
  for (int i = 1; i <= 1200; ++i) {
    const double mu = i <= 800 ? 0.13 * i / 800 : 0.13 - 0.05 * (i - 800) / 400;
    point.move_to(squeezed_to(mu));
    for (int j = 0; j < 20; ++j) {
      const double at = before + (mu - before) * (j + 0.5) / 20;
      most = std::max(most, at);
      const double p = std::max(exact.at(at, most), -4.0);
      expected += p / ((1 + at) * (1 + at)) * (mu - before) / 20;
    }
    before = mu;
  }
  test::verified("ballistic concrete, compacted and released: work, relative error", "quadrature")
      .below(std::fabs(point.work() / expected - 1), 1e-4);
}

TEST_P(HolmquistConcrete, WaveSpeedBoundsTheTangent) {
  const model::Material material = tough_ballistic_concrete();
  for (const double mu : {-0.0001, 0.0005, 0.02, 0.09, 0.13, 0.2})
    for (const double sign : {1.0, -1.0}) {
      MotionDriver<double> point(material, GetParam());
      MotionDriver<double> moved(material, GetParam());
      point.move_to(squeezed_to(mu));
      moved.move_to(squeezed_to(mu));
      Matrix more = squeezed_to(mu);
      const double side = more[0][0];
      more[0][0] *= 1 + sign * 1e-7;
      moved.move_to(more);
      const double slope = (moved.stress()[0] - point.stress()[0]) / (sign * 1e-7);
      const double stiffness = material.density / (side * side * side) * std::pow(point.wave_speed(), 2);
      EXPECT_GT(stiffness, 0.9999 * slope) << mu;
    }
}

TEST_P(HolmquistConcrete, ATurnedObserverSeesTheTurnedStress) {
  const Matrix turn = turn_about({2.0 / 7, -3.0 / 7, 6.0 / 7}, 1.1);
  model::Material material = ballistic_concrete();
  ballistic_law(material).rate_coefficient = 0.01;
  SolidDriver<double> one(material, GetParam());
  SolidDriver<double> other(material, GetParam());
  test::Largest off("ballistic concrete, seen by a turned observer: stress, error [MPa]", "invariance", 1e-8);
  for (int i = 0; i < 120; ++i) {
    const Six strain{-5e-5 * std::cos(0.1 * i), -4e-5, 1e-5, 4e-5 * std::sin(0.2 * i), 3e-5, -2e-5};
    one.apply(strain, 1e-4);
    other.apply(rotated(strain, turn, 0.5), 1e-4);
    const Six expected = rotated(one.stress(), turn);
    for (int c = 0; c < 6; ++c) off.compare(other.stress()[c], expected[c]);
  }
}

TEST_P(HolmquistConcrete, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(ballistic_concrete(), GetParam());
  MotionDriver<double> exact(ballistic_concrete(), GetParam());
  for (int i = 1; i <= 5000; ++i) {
    const double depth = 3e-5 * i;
    const Matrix f{{{1 - 0.1 * depth, 0.3 * depth, 0}, {0, 1 - depth, 0}, {0.1 * depth, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  test::verified("ballistic concrete, 5000 steps in single precision: stress over PL, error",
                 "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()) / 800, 1e-4);
}

TEST(HolmquistConcreteConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(ballistic_concrete()));
  const auto refuses = [](void (*change)(model::HolmquistConcrete&)) {
    model::Material material = ballistic_concrete();
    change(ballistic_law(material));
    EXPECT_THROW(solid_material_constants(material), Error);
  };
  refuses([](model::HolmquistConcrete& law) { law.strength = 0; });
  refuses([](model::HolmquistConcrete& law) { law.tension = 0; });
  refuses([](model::HolmquistConcrete& law) { law.lock_pressure = 10; });
  refuses([](model::HolmquistConcrete& law) { law.lock_volume = 0.0005; });
  refuses([](model::HolmquistConcrete& law) { law.crush_volume = 0; });
  refuses([](model::HolmquistConcrete& law) { law.lock_volume = 0.005; });
  refuses([](model::HolmquistConcrete& law) { law.bulk_quadratic = -1e8; });
  refuses([](model::HolmquistConcrete& law) { law.least_fracture = law.fracture_factor = 0; });
}

}  // namespace
}  // namespace crumple::materials::testing::holmquist_concrete_test
