// SPDX-License-Identifier: BSD-3-Clause
// Foam with an ellipse in pressure and von Mises stress, against its curves and against algebra.
#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::bilkhu_dubois_foam_test {
namespace {

constexpr double modulus = 40;  // MPa
constexpr double tension = 0.15;
const model::PointCurve pressure{{0, 0.2, 0.9, 1.5}, {0.5, 0.6, 1.1, 4}};
const model::PointCurve uniaxial{{0, 0.1, 1.0, 1.4}, {0.6, 0.7, 1.3, 4.5}};

model::Material foam(double poisson = 0) {
  model::Material material;
  material.id = 75;
  material.density = 6e-11;
  model::BilkhuDuboisFoam law;
  law.youngs_modulus = modulus;
  law.poissons_ratio = poisson;
  law.pressure = pressure;
  law.uniaxial = uniaxial;
  law.tension_pressure = tension;
  material.law = law;
  return material;
}
model::BilkhuDuboisFoam& law_of(model::Material& material) {
  return std::get<model::BilkhuDuboisFoam>(material.law);
}
Matrix stretch(double x, double y, double z) {
  return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}
/// (p - middle)^2 / half^2 + q^2 / height^2 - 1 of the ellipse through three points.
double ellipse(const Six& s, double compression, double strength, double pull) {
  const double half = (compression + pull) / 2;
  const double middle = (compression - pull) / 2;
  const auto square = [](double x) { return x * x; };
  const double height_square = square(strength) / (1 - square((strength / 3 - middle) / half));
  return square((-mean(s) - middle) / half) + square(equivalent(s)) / height_square - 1;
}

class BilkhuDubois : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, BilkhuDubois, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

TEST_P(BilkhuDubois, CrushFollowsBothCurves) {
  for (const bool hydrostatic : {false, true}) {
    MotionDriver<double> point(foam(hydrostatic ? 0.3 : 0), GetParam());
    const std::string crushed =
        std::string("Bilkhu-Dubois foam crushed along ") + (hydrostatic ? "three axes" : "one axis");
    test::Largest off(crushed + ": stress off the given curve [MPa]", "given curve", 1e-12);
    test::Largest across(crushed + ": lateral stress, error [MPa]", "given curve", 1e-12);
    for (int i = 1; i <= 160; ++i) {
      const double volume = 1 - 0.005 * i;
      point.move_to(hydrostatic ? volumetric(volume) : stretch(1, volume, 1));
      if (i < 20) continue;  // elastic still, at most
      const Six s = point.stress();
      const double expected = -value_at(hydrostatic ? pressure : uniaxial, -std::log(volume));
      off.compare(s[1], expected);
      across.compare(s[0], hydrostatic ? expected : 0);
      across.compare(s[2], hydrostatic ? expected : 0);
    }
  }
}

/// Under stress along one axis the lateral strain is that of Poisson's ratio throughout, elastic and plastic.
TEST_P(BilkhuDubois, PoissonsRatioIsThatOfElasticAndPlasticStrains) {
  test::Largest off("Bilkhu-Dubois foam, stress along one axis: stress off the given curve [MPa]",
                    "given curve", 1e-10);
  test::Largest ratio("Bilkhu-Dubois foam, stress along one axis: lateral stress over Young's modulus",
                      "none at the lateral strain of Poisson's ratio", 1e-9);
  for (const double poisson : {-0.1, 0.1, 0.3}) {
    SolidDriver<double> point(foam(poisson), GetParam());
    double volume = 1;
    for (int i = 0; i < 60; ++i) {
      const double axial = -0.01;
      // The lateral increment that leaves no lateral stress is the one looked for.
      point.apply({axial, -poisson * axial, -poisson * axial, 0, 0, 0});
      const double trace = (1 - 2 * poisson) * axial;
      volume = 1 + point.item("volume_change");
      EXPECT_NEAR(std::log(volume), (i + 1) * trace, 1e-4);
      ratio.add(std::fabs(point.stress()[1]) / modulus, std::to_string(i));
      if (i > 3) off.compare(point.stress()[0], -value_at(uniaxial, -std::log(volume)));
    }
  }
}

TEST_P(BilkhuDubois, EveryStrengthInTensionIsMet) {
  const auto pulled = [&](const model::Material& material, bool hydrostatic, double crushed) {
    MotionDriver<double> point(material, GetParam());
    if (crushed > 0) point.move_in_steps(volumetric(1 - crushed), 200);
    const double side = std::cbrt(1 - crushed);
    const double pull = hydrostatic ? 1.01 : 1.02;
    point.move_in_steps(hydrostatic ? volumetric((1 - crushed) * 1.15) : stretch(side * pull, side, side),
                        400);
    return std::pair(point.stress()[0], -std::log(determinant(point.at())));
  };
  test::Largest off("Bilkhu-Dubois foam: strength in tension, error [MPa]", "PC, VPC, TSC, VTSC", 1e-12);
  off.compare(pulled(foam(), true, 0).first, tension);
  auto material = foam();
  law_of(material).tension_pressure = 0;
  off.compare(pulled(material, true, 0).first, 0.1 * pressure.ordinate[0], 1, "none given");
  law_of(material).tension_pressure_share = 0.3;
  const auto [by_share, strain] = pulled(material, true, 0.3);
  off.compare(by_share, 0.3 * value_at(pressure, strain), 1, "VPC");
  law_of(material).tension_pressure_share = 0;
  law_of(material).tension_stress = 0.25;
  off.compare(pulled(material, false, 0).first, 0.25, 1, "TSC");
  law_of(material).tension_stress_share = 0.5;
  off.compare(pulled(material, false, 0).first, 0.5 * uniaxial.ordinate[0], 1, "VTSC");
  // Of both the lower one.
  law_of(material).tension_pressure = 0.01;
  off.compare(pulled(material, true, 0).first, 0.01, 1, "PC below VTSC");
  law_of(material).tension_pressure = 10;
  off.compare(pulled(material, false, 0).first, 0.5 * uniaxial.ordinate[0], 1, "VTSC below PC");
}

/// Whatever the strain, the stress is on the ellipse or within, and along the elastic one.
TEST_P(BilkhuDubois, StressesReturnStraightToTheEllipse) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  test::Largest off("Bilkhu-Dubois foam, random strains: value of the ellipse",
                    "ellipse through three points", 1e-13);
  test::Largest along("Bilkhu-Dubois foam, random strains: stress off the direction of the elastic one [MPa]",
                      "elasticity", 1e-13);
  int yielding = 0;
  for (int i = 0; i < 400; ++i) {
    Six strain;
    const double size = 0.06 * std::exp2(6 * std::min(0.0, uniform(generator)));
    for (double& component : strain) component = size * uniform(generator);
    SolidDriver<double> point(foam(0.2), GetParam());
    point.apply(strain);
    const Six s = point.stress();
    const double two_shear = modulus / 1.2;
    const double volume = (strain[0] + strain[1] + strain[2]) * 0.2 * modulus / (1.2 * 0.6);
    Six elastic;
    for (int k = 0; k < 6; ++k)
      elastic[k] = k < 3 ? two_shear * strain[k] + volume : 0.5 * two_shear * strain[k];
    const double crush = std::max(0.0, -std::log(1 + point.item("volume_change")));
    const double compression = value_at(pressure, crush);
    const double strength = value_at(uniaxial, crush);
    double squares = 0;
    double product = 0;
    for (int k = 0; k < 6; ++k) {
      squares += elastic[k] * elastic[k];
      product += elastic[k] * s[k];
    }
    const double factor = product / squares;
    for (int k = 0; k < 6; ++k) along.compare(s[k], factor * elastic[k]);
    if (ellipse(elastic, compression, strength, tension) > 0) {
      ++yielding;
      EXPECT_LT(factor, 1);
      off.compare(ellipse(s, compression, strength, tension), 0);
    } else {
      EXPECT_NEAR(factor, 1, 1e-14);
    }
  }
  EXPECT_GT(yielding, 200);
  EXPECT_LT(yielding, 400);
}

TEST_P(BilkhuDubois, UnloadsAlongTheModulus) {
  MotionDriver<double> point(foam(), GetParam());
  point.move_in_steps(stretch(1, 1, 0.6), 400);
  const double crushed = value_at(uniaxial, -std::log(0.6));
  test::Largest off("Bilkhu-Dubois foam, unloaded from 40 %: stress, error [MPa]", "closed form", 1e-12);
  off.compare(point.stress()[2], -crushed);
  double length = 0.6;
  double expected = -crushed;
  for (int i = 0; i < 40; ++i) {
    const double next = length * 1.0005;
    expected += modulus * 2 * (next - length) / (next + length);
    point.move_to(stretch(1, 1, next));
    length = next;
    off.compare(point.stress()[2], expected);
  }
  EXPECT_LT(expected, -0.1);
}

TEST_P(BilkhuDubois, RatesScaleBothCurves) {
  auto material = foam();
  law_of(material).rate_factor = {{0, 10, 100}, {1, 1.2, 1.8}};
  test::Largest off("Bilkhu-Dubois foam, volumetric rate: yield stress, error [MPa]", "curve times factor",
                    1e-12);
  for (const double rate : {0.0, 5.0, 10.0, 55.0, 100.0, 700.0}) {
    MotionDriver<double> point(material, GetParam());
    double volume = 1;
    for (int i = 0; i < 50; ++i) {
      const double next = volume - 0.004;
      const double strain = 2 * (volume - next) / (volume + next);
      point.move_to(stretch(1, next, 1), rate > 0 ? strain / rate : 1e9);
      volume = next;
    }
    const double factor = rate < 10 ? 1 + 0.02 * rate : std::min(1.2 + (rate - 10) / 150, 1.8);
    off.compare(point.stress()[1], -factor * value_at(uniaxial, -std::log(volume)), 1, std::to_string(rate));
  }
}

/// Round any closed path of the deformation the foam takes up work.
TEST_P(BilkhuDubois, ClosedPathsTakeUpWork) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  double least = 1e300;
  for (int cycle = 0; cycle < 20; ++cycle) {
    auto material = foam(cycle % 2 == 0 ? 0 : 0.25);
    if (cycle % 3 == 0) law_of(material).tension_stress = 0.3;
    MotionDriver<double> point(material, GetParam());
    const double size = cycle < 10 ? 0.01 : 0.25;
    for (int leg = 0; leg < 3; ++leg) {
      Matrix to = unit;
      for (auto& row : to)
        for (double& value : row) value += size * uniform(generator);
      point.move_in_steps(to, 400);
    }
    point.move_in_steps(unit, 400);
    // Back at the start strains are zero; the elastic energy that is left is no more than what went in.
    least = std::min(least, point.work());
  }
  test::verified("Bilkhu-Dubois foam, closed paths of the deformation: least work [mJ/mm^3] is above zero",
                 "second law")
      .below(-least, 1e-12);
}

TEST_P(BilkhuDubois, ATurnedObserverSeesTheTurnedStress) {
  const Matrix turn = turn_about({2.0 / 7, -3.0 / 7, 6.0 / 7}, 1.1);
  SolidDriver<double> one(foam(0.2), GetParam());
  SolidDriver<double> other(foam(0.2), GetParam());
  test::Largest off("Bilkhu-Dubois foam, seen by a turned observer: stress, error [MPa]", "invariance",
                    1e-13);
  for (int i = 0; i < 60; ++i) {
    const Six strain{-0.005 * std::cos(0.3 * i), -0.004, 0.001, 0.004 * std::sin(0.2 * i), 0.003, -0.002};
    one.apply(strain);
    other.apply(rotated(strain, turn, 0.5));
    off.add(largest_difference(other.stress(), rotated(one.stress(), turn)), std::to_string(i));
  }
}

/// Strains of the middle of the step are turned on to its end, as the stress is: exact.
TEST_P(BilkhuDubois, CrushTurnsWithTheBody) {
  const std::array<double, 3> axis{0.6, 0, 0.8};
  const Matrix q = rotation(axis, 2);
  const double strength = value_at(uniaxial, -std::log(0.6));
  const Six expected = six_of(times(q, times(stretch(0, -strength, 0), transposed(q))));
  MotionDriver<double> point(foam(), GetParam());
  constexpr int steps = 1000;
  for (int i = 1; i <= steps; ++i)
    point.move_to(times(rotation(axis, 2.0 * i / steps), stretch(1, 1 - 0.4 * i / steps, 1)));
  test::verified("Bilkhu-Dubois foam crushed while it turns by 2 rad: stress, error [MPa]",
                 "crushed at rest, turned")
      .below(largest_difference(point.stress(), expected), 1e-10);
}

TEST_P(BilkhuDubois, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(foam(0.1), GetParam());
  MotionDriver<double> exact(foam(0.1), GetParam());
  for (int i = 1; i <= 20000; ++i) {
    const Matrix f{{{1 - 3e-5 * i, 1e-5 * i, 0}, {0, 1 + 2e-6 * i, 0}, {1e-5 * i, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  test::verified("Bilkhu-Dubois foam, 20000 steps in single precision: stress, error [MPa]",
                 "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()), 5e-5);
}

TEST(BilkhuDuboisConstants, AreChecked) {
  auto material = foam();
  EXPECT_NO_THROW(solid_material_constants(material));
  law_of(material).pressure = {{0, 0.5}, {0.19, 3}};
  EXPECT_THROW(solid_material_constants(material), Error) << "a third of 0.6 is above 0.19";
  material = foam();
  law_of(material).pressure = {{0, 0.5}, {1, 1}};
  EXPECT_THROW(solid_material_constants(material), Error) << "the uniaxial curve rises above it at last";
  material = foam();
  law_of(material).uniaxial = {{0.1, 0.5}, {1, 1}};
  EXPECT_THROW(solid_material_constants(material), Error);
  material = foam();
  law_of(material).uniaxial.ordinate[1] = 0;
  EXPECT_THROW(solid_material_constants(material), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::bilkhu_dubois_foam_test
