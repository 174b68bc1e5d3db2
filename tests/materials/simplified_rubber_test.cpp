// SPDX-License-Identifier: BSD-3-Clause
// Rubber and foam by the curve of their uniaxial test.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::simplified_rubber_test {
namespace {

constexpr double bulk = 2000;  // MPa
constexpr double lateral = 0.25;

/// Ogden's terms, whose uniaxial test is known: mu (l^(alpha - 1) - l^(-alpha m - 1)), m = 1/2 of rubber, nu
/// of foam, for which they are Hill's.
struct Term {
  double mu, alpha;
};
const std::vector<Term> terms{{0.8, 1.6}, {0.02, 5}, {-0.3, -2}};

double nominal(double stretch, double m) {
  double sum = 0;
  for (const Term& t : terms)
    sum += t.mu * (std::pow(stretch, t.alpha - 1) - std::pow(stretch, -t.alpha * m - 1));
  return sum;
}
/// The test in 801 points, from stretch 0.2 to 3.
model::Material material_of(bool is_foam) {
  model::Material material;
  material.id = 181;
  material.density = 1e-9;
  model::SimplifiedRubber law;
  law.is_foam = is_foam;
  law.bulk_modulus = bulk;
  for (int k = 0; k <= 800; ++k) {
    const double stretch = k <= 300 ? 0.2 + 0.8 * k / 300 : 1 + 2.0 * (k - 300) / 500;
    law.stretch.push_back(stretch);
    law.stress.push_back(k == 300 ? 0 : nominal(stretch, is_foam ? lateral : 0.5));
  }
  law.youngs_modulus = nominal(1.001, is_foam ? lateral : 0.5) / 0.001;
  law.poissons_ratio = is_foam ? lateral : 0.5 - law.youngs_modulus / (6 * bulk);
  material.law = law;
  return material;
}
/// Of a principal stretch, as rubber with incompressible and foam with volume J: sum mu (l^alpha - J^-(alpha
/// m))
double function(double stretch) {
  double sum = 0;
  for (const Term& t : terms) sum += t.mu * std::pow(stretch, t.alpha);
  return sum;
}
Matrix stretch(double x, double y, double z) {
  return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}

class Fitted : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Fitted, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

TEST_P(Fitted, UniaxialTestIsGivenBack) {
  test::Points exact;
  test::Points found;
  for (const bool is_foam : {false, true}) {
    MotionDriver<double> point(material_of(is_foam), GetParam());
    const std::string what = std::string("simplified ") + (is_foam ? "foam" : "rubber");
    test::Largest off(what + ", uniaxial test from 0.25 to 2.5: nominal stress, error over 1 MPa and itself",
                      "given curve", 2e-4);
    test::Largest across(what + ", uniaxial test: stress across [MPa]", "none", 2e-4);
    for (int i = 0; i <= 200; ++i) {
      const double l = i <= 75 ? 1 - 0.01 * i : 0.25 + 0.018 * (i - 75);
      const double side = std::pow(l, is_foam ? -lateral : -0.5);
      point.move_to(stretch(side, l, side));
      const Six s = point.stress();
      // Of rubber the pressure is any: that which leaves the sides free.
      const double stress = (s[1] - (is_foam ? 0 : s[0])) * side * side;
      const double expected = nominal(l, is_foam ? lateral : 0.5);
      off.compare(stress, expected, 1 + std::fabs(expected));
      if (is_foam)
        across.add(std::fabs(s[0]));
      else
        across.add(std::fabs(s[0] - s[2]));
      if (!is_foam && i >= 75) exact.push_back({l, expected});
      if (!is_foam && i >= 75 && i % 5 == 0) found.push_back({l, stress});
    }
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Simplified rubber, uniaxial test", "stretch", "nominal stress [MPa]")
        .accepted("given curve", exact)
        .found("one point of material", found)
        .note();
}

/// What the test has not seen: a sheet pulled both ways, a wide strip, and a foam squeezed from all sides.
TEST_P(Fitted, OtherStatesAreThoseOfTheOgdenAndHillLaws) {
  test::Largest sheet(
      "simplified rubber by a test of Ogden's, sheet pulled both ways: stress, relative error", "Ogden 1972",
      5e-4);
  test::Largest strip("simplified rubber by a test of Ogden's, wide strip: stress, relative error",
                      "Ogden 1972", 5e-4);
  for (const double l : {0.7, 0.9, 1.1, 1.3, 1.6}) {
    MotionDriver<double> both(material_of(false), GetParam());
    both.move_to(stretch(l, l, 1 / (l * l)));
    const double equal = function(l) - function(1 / (l * l));
    sheet.compare(both.stress()[0] - both.stress()[2], equal, equal);
    MotionDriver<double> wide(material_of(false), GetParam());
    wide.move_to(stretch(l, 1, 1 / l));
    const double plane = function(l) - function(1 / l);
    strip.compare(wide.stress()[0] - wide.stress()[2], plane, plane);
    const double held = function(1) - function(1 / l);
    strip.compare(wide.stress()[1] - wide.stress()[2], held, held);
  }
  test::Largest block(
      "simplified foam by a test of Hill's, squeezed along two and three axes: stress, error "
      "over itself and 0.1 MPa",
      "Hill's law", 5e-4);
  for (const double l : {0.6, 0.8, 0.95, 1.1})
    for (const double other : {l, 1.0}) {
      MotionDriver<double> point(material_of(true), GetParam());
      point.move_to(stretch(l, l, other));
      const double volume = l * l * other;
      const double common = function(std::pow(volume, -lateral / (1 - 2 * lateral)));
      const double first = (function(l) - common) / volume;
      const double last = (function(other) - common) / volume;
      block.compare(point.stress()[0], first, std::fabs(first) + 0.1);
      block.compare(point.stress()[2], last, std::fabs(last) + 0.1);
    }
}

TEST_P(Fitted, ClosedPathsTakeNoWork) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  test::Largest kept("simplified rubber and foam, random closed paths: work over the largest, size", "none",
                     2e-3);
  for (int i = 0; i < 10; ++i) {
    MotionDriver<double> point(material_of(i % 2 == 0), GetParam());
    double largest = 0;
    for (int leg = 0; leg <= 5; ++leg) {
      Matrix to = unit;
      if (leg < 5)
        for (auto& row : to)
          for (double& value : row) value += uniform(generator);
      point.move_in_steps(to, 300);
      largest = std::max(largest, std::fabs(point.work()));
    }
    kept.add(std::fabs(point.work()) / largest);
  }
}

TEST_P(Fitted, KnowsNoRotation) {
  const Matrix stretched{{{1.1, 0.2, 0}, {0, 0.7, 0.1}, {0.05, 0, 1.2}}};
  const std::array<double, 3> axis{2.0 / 3, -1.0 / 3, 2.0 / 3};
  for (const bool is_foam : {false, true}) {
    MotionDriver<double> point(material_of(is_foam), GetParam());
    for (int i = 1; i <= 600; ++i) point.move_to(rotation(axis, 0.1047197551196598 * i));
    test::verified("simplified rubber or foam, ten turns without strain: stress [MPa]", "none")
        .below(largest_difference(point.stress(), {}), 1e-9);
    point.move_in_steps(stretched, 3);
    const Matrix before = matrix_of(point.stress());
    for (int i = 1; i <= 25; ++i) point.move_to(times(rotation(axis, 0.1 * i), stretched));
    const Matrix q = rotation(axis, 2.5);
    const Six carried = six_of(times(q, times(before, transposed(q))));
    test::verified("simplified rubber or foam, strained, then turned: stress, error [MPa]", "turned stress")
        .below(largest_difference(point.stress(), carried), 1e-9);
  }
}

/// In random directions of motion and propagation along the axes, by differences.
TEST_P(Fitted, WaveSpeedBoundsTheTangent) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(0.4, 1.6);
  for (int i = 0; i < 60; ++i) {
    const bool is_foam = i % 2 == 0;
    double side[3] = {uniform(generator), uniform(generator), uniform(generator)};
    if (!is_foam) side[2] = 1 / (side[0] * side[1]);
    const Matrix f = stretch(side[0], side[1], side[2]);
    MotionDriver<double> point(material_of(is_foam), GetParam());
    point.move_to(f);
    const double density = 1e-9 / determinant(f);
    for (int k = 0; k < 3; ++k) {
      constexpr double h = 1e-5;
      MotionDriver<double> moved(material_of(is_foam), GetParam());
      moved.move_to(f);
      Matrix more = f;
      more[k][k] *= 1 + h;
      moved.move_to(more);
      const double slope = (moved.stress()[k] - point.stress()[k]) / h;
      EXPECT_GT(density * point.wave_speed() * point.wave_speed(), 0.99 * slope) << is_foam << " " << k;
    }
  }
}

TEST_P(Fitted, FloatAgreesWithDouble) {
  for (const bool is_foam : {false, true}) {
    MotionDriver<float> coarse(material_of(is_foam), GetParam());
    MotionDriver<double> exact(material_of(is_foam), GetParam());
    for (int i = 1; i <= 20000; ++i) {
      const Matrix f{{{1 - 2e-5 * i, 1e-5 * i, 0}, {0, 1 + 2e-5 * i, 0}, {1e-5 * i, 0, 1}}};
      coarse.move_to(f);
      exact.move_to(f);
    }
    test::verified("simplified rubber or foam, 20000 steps in single precision: stress over the bulk modulus",
                   "double precision")
        .below(largest_difference(coarse.stress(), exact.stress()) / bulk, 3e-6);
  }
}

TEST(FittedConstants, AreChecked) {
  EXPECT_NO_THROW(solid_material_constants(material_of(true)));
  const auto refuses = [](bool is_foam, void (*change)(model::SimplifiedRubber&)) {
    auto material = material_of(is_foam);
    change(std::get<model::SimplifiedRubber>(material.law));
    EXPECT_THROW(solid_material_constants(material), Error);
  };
  refuses(true, [](model::SimplifiedRubber& law) { law.poissons_ratio = 0; });
  refuses(false, [](model::SimplifiedRubber& law) { law.bulk_modulus = 0; });
  refuses(true, [](model::SimplifiedRubber& law) { law.stretch[3] = law.stretch[4]; });
  refuses(true, [](model::SimplifiedRubber& law) { law.stretch.front() = 0; });
  refuses(true, [](model::SimplifiedRubber& law) { law.stress.pop_back(); });
}

}  // namespace
}  // namespace crumple::materials::testing::simplified_rubber_test
