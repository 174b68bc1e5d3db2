// SPDX-License-Identifier: BSD-3-Clause
// Crushable foam along given paths.
#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::crushable_foam_test {
namespace {

constexpr double modulus = 20;  // MPa
constexpr double tension = 0.15;
const std::vector<double> crush{0, 0.1, 0.5, 0.7};
const std::vector<double> stress{0.4, 0.5, 0.8, 2.5};

model::Material foam() {
  model::Material material;
  material.id = 63;
  material.density = 6e-11;
  material.law = model::CrushableFoam{modulus, 0, crush, stress, tension, 0.1};
  return material;
}
/// The curve, its last slope beyond.
double yield_at(double gamma) {
  std::size_t k = 0;
  while (k + 2 < crush.size() && gamma > crush[k + 1]) ++k;
  return stress[k] + (gamma - crush[k]) * (stress[k + 1] - stress[k]) / (crush[k + 1] - crush[k]);
}
Matrix stretch(double x, double y, double z) {
  return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}

class Foam : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Foam, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Along one axis no lateral stress arises, along all three each carries the yield stress.
TEST_P(Foam, CrushFollowsTheCurve) {
  test::Points exact;
  test::Points found;
  for (const bool hydrostatic : {false, true}) {
    MotionDriver<double> point(foam(), GetParam());
    const std::string crushed =
        std::string("crushable foam, crushed along ") + (hydrostatic ? "three axes" : "one axis");
    test::Largest off(crushed + ": stress off the given curve [MPa]", "given curve", 1e-12);
    test::Largest across(crushed + ": lateral stress, error [MPa]", "given curve", 1e-12);
    test::Largest volumes(crushed + ": volume change, error", "prescribed motion", 1e-13);
    for (int i = 1; i <= 160; ++i) {
      const double volume = 1 - 0.005 * i;
      point.move_to(hydrostatic ? volumetric(volume) : stretch(1, volume, 1));
      if (i < 20) continue;  // elastic still, at most
      const Six s = point.stress();
      const double expected = -yield_at(1 - volume);
      off.compare(s[1], expected);
      across.compare(s[0], hydrostatic ? expected : 0);
      across.compare(s[2], hydrostatic ? expected : 0);
      volumes.compare(point.item("volume_change"), volume - 1);
      if (!hydrostatic) exact.push_back({1 - volume, -expected});
      if (!hydrostatic && i % 4 == 0) found.push_back({1 - volume, -s[1]});
    }
  }
  if (GetParam() == Isa::Scalar)
    test::drawn("Crushable foam along one axis", "volumetric strain", "stress [MPa]")
        .accepted("given curve", exact)
        .found("one point of material", found)
        .note();
}

TEST_P(Foam, UnloadsElasticallyToTheTensileStress) {
  MotionDriver<double> point(foam(), GetParam());
  point.move_in_steps(stretch(1, 1, 0.6), 400);
  const double crushed = yield_at(0.4);
  EXPECT_NEAR(point.stress()[2], -crushed, 1e-12);
  double length = 0.6;
  double expected = -crushed;
  test::Largest off("crushable foam, unloaded from 40 % to the cut-off in tension: stress, error [MPa]",
                    "closed form", 1e-12);
  for (int i = 0; i < 100; ++i) {
    const double next = length * 1.0005;
    expected = std::min(expected + modulus * 2 * (next - length) / (next + length), tension);
    point.move_to(stretch(1, 1, next));
    length = next;
    off.compare(point.stress()[2], expected);
  }
  EXPECT_EQ(expected, tension);
}

/// Principal stresses are bounded in whatever axes they come.
TEST_P(Foam, BoundsArePrincipalStresses) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  test::Largest off("crushable foam, random strains in random axes: principal stresses, error [MPa]",
                    "bounds of the principal stresses, by tensor algebra", 1e-14);
  for (int i = 0; i < 200; ++i) {
    const std::array<double, 3> value{0.04 * uniform(generator), 0.04 * uniform(generator),
                                      i % 10 == 0 ? 0.03 : 0.04 * uniform(generator)};
    std::array<double, 3> axis{uniform(generator), uniform(generator), uniform(generator)};
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    for (double& component : axis) component /= length;
    const Matrix q = rotation(axis, 3 * uniform(generator));
    const Six strain = six_of(times(q, times(stretch(value[0], value[1], value[2]), transposed(q))));
    SolidDriver<double> point(foam(), GetParam());
    point.apply({strain[0], strain[1], strain[2], 2 * strain[3], 2 * strain[4], 2 * strain[5]});
    const double gamma = -point.item("volume_change");
    const double least = gamma > 0 ? -yield_at(gamma) : -stress.front();
    std::array<double, 3> bounded{};
    for (int k = 0; k < 3; ++k) bounded[k] = std::clamp(modulus * value[k], least, tension);
    const Six expected = six_of(times(q, times(stretch(bounded[0], bounded[1], bounded[2]), transposed(q))));
    off.add(largest_difference(point.stress(), expected), std::to_string(i));
  }
}

/// Strains of the middle of the step are turned on to its end, as the stress is: exact.
TEST_P(Foam, CrushTurnsWithTheBody) {
  const std::array<double, 3> axis{0.6, 0, 0.8};
  const Matrix q = rotation(axis, 2);
  const Six expected = six_of(times(q, times(stretch(0, -yield_at(0.4), 0), transposed(q))));
  MotionDriver<double> point(foam(), GetParam());
  constexpr int steps = 1000;
  for (int i = 1; i <= steps; ++i)
    point.move_to(times(rotation(axis, 2.0 * i / steps), stretch(1, 1 - 0.4 * i / steps, 1)));
  EXPECT_NEAR(point.item("volume_change"), -0.4, 1e-13);
  test::verified("crushable foam crushed while it turns by 2 rad: stress, error [MPa]",
                 "crushed at rest, turned")
      .below(largest_difference(point.stress(), expected), 1e-10);
}

TEST_P(Foam, FloatAgreesWithDouble) {
  MotionDriver<float> coarse(foam(), GetParam());
  MotionDriver<double> exact(foam(), GetParam());
  for (int i = 1; i <= 20000; ++i) {
    const Matrix f{{{1 - 3e-5 * i, 1e-5 * i, 0}, {0, 1 + 2e-6 * i, 0}, {1e-5 * i, 0, 1}}};
    coarse.move_to(f);
    exact.move_to(f);
  }
  test::verified("crushable foam, 20000 steps in single precision: stress, error [MPa]", "double precision")
      .below(largest_difference(coarse.stress(), exact.stress()), 2e-5);
  EXPECT_NEAR(coarse.item("volume_change"), exact.item("volume_change"), 1e-6);
}

TEST(FoamConstants, AreChecked) {
  auto material = foam();
  auto& law = std::get<model::CrushableFoam>(material.law);
  law.crush = {0, 0.5, 0.5};
  law.yield_stress = {1, 2, 3};
  EXPECT_THROW(solid_material_constants(material), Error);
  law.crush = {};
  law.yield_stress = {};
  EXPECT_THROW(solid_material_constants(material), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::crushable_foam_test
