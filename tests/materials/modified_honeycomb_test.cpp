// SPDX-License-Identifier: BSD-3-Clause
// Honeycomb whose yield stresses follow the strain of each component.
#include <gtest/gtest.h>

#include <algorithm>

#include "materials/honeycomb_samples.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::modified_honeycomb_test {
namespace {

using namespace honeycomb_support;

model::Material modified(model::Honeycomb::Abscissa over) {
  model::Material material = honeycomb();
  auto& law = std::get<model::Honeycomb>(material.law);
  law.over = over;
  // So stiff that the curves alone decide.
  law.moduli = {60000, 60000, 60000, 25000, 25000, 25000};
  return material;
}
/// All three axes at once, each by its own share, on straight paths of the sides.
Matrix squeezed(double share) {
  return global(stretch({1 - 0.5 * share, 1 - 0.2 * share, 1 + 0.1 * share}));
}
const std::array<double, 3> last_sides{0.5, 0.8, 1.1};

class ModifiedComb : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, ModifiedComb, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

TEST_P(ModifiedComb, EachStressFollowsItsOwnStrain) {
  for (const bool nominal : {true, false}) {
    MotionDriver<double> point(
        modified(nominal ? model::Honeycomb::Abscissa::NominalStrain : model::Honeycomb::Abscissa::Strain),
        GetParam());
    for (int i = 1; i <= 2000; ++i) point.move_to(squeezed(i / 2000.0));
    const Six found = local(point.stress());
    test::Largest off(std::string("honeycomb by strain, squeezed and pulled along a, b and c: stress off the "
                                  "curve at the ") +
                          (nominal ? "nominal" : "logarithmic") + " strain [MPa]",
                      "given curves", nominal ? 1e-11 : 1e-6);
    for (int axis = 0; axis < 3; ++axis) {
      const double side = last_sides[axis];
      const double crushed = nominal ? 1 - side : -std::log(side);
      off.compare(found[axis], (side < 1 ? -1 : 1) * yield_at(axis, crushed));
    }
  }
}

/// Along one axis the nominal strain is the change of volume.
TEST_P(ModifiedComb, AlongOneAxisItIsTheOneByVolume) {
  test::Largest off("honeycomb crushed along a, b and c: stress by nominal strain less that by volume [MPa]",
                    "none", 1e-10);
  for (int axis = 0; axis < 3; ++axis) {
    MotionDriver<double> by_strain(modified(model::Honeycomb::Abscissa::NominalStrain), GetParam());
    MotionDriver<double> by_volume(modified(model::Honeycomb::Abscissa::Volume), GetParam());
    for (int i = 1; i <= 340; ++i) {
      // Crushed, released, and crushed behind V_f.
      const double share = i <= 200   ? 0.0025 * i
                           : i <= 220 ? 0.5 - 0.002 * (i - 200)
                                      : 0.46 + 0.0025 * (i - 220);
      by_strain.move_to(along(axis, 1 - share));
      by_volume.move_to(along(axis, 1 - share));
      off.add(largest_difference(by_strain.stress(), by_volume.stress()));
    }
  }
}

TEST_P(ModifiedComb, ShearFollowsTheSizeOfItsStrain) {
  test::Largest off(
      "honeycomb by strain, sheared by 0.5 in each plane, to and fro: stress off the curve [MPa]",
      "given curves", 1e-6);
  for (int c = 3; c < 6; ++c)
    for (const double sign : {1.0, -1.0}) {
      MotionDriver<double> point(modified(model::Honeycomb::Abscissa::Strain), GetParam());
      const auto shear_by = [&](double from, double to) {
        for (int i = 1; i <= 500; ++i)
          point.move_to(global(sheared(c, sign * (from + (to - from) * i / 500))));
      };
      shear_by(0, 0.5);
      off.compare(local(point.stress())[c], sign * yield_at(c, 0.5));
      shear_by(0.5, 0.3);
      off.compare(local(point.stress())[c], -sign * yield_at(c, 0.3));
    }
}

TEST_P(ModifiedComb, EachComponentHasItsOwnRates) {
  model::Material material = modified(model::Honeycomb::Abscissa::NominalStrain);
  auto& law = std::get<model::Honeycomb>(material.law);
  law.own_rates[0] = {{10, 100}, {1, 2}};
  law.own_rates[1] = {{5, 50}, {1.5, 3}};
  MotionDriver<double> point(material, GetParam());
  // 55 / s along a, a fifth of that along b, none along c.
  const auto sides = [](double strain) {
    return global(stretch({std::exp(-strain), std::exp(-0.2 * strain), 1}));
  };
  for (int i = 1; i <= 400; ++i) {
    const double along_a = 2 * std::tanh(0.5 * 0.001);
    point.move_to(sides(0.001 * i), along_a / 55);
  }
  const Six found = local(point.stress());
  const double second = 2 * std::tanh(0.5 * 0.0002) / (2 * std::tanh(0.5 * 0.001)) * 55;
  const double factor_b = 1.5 + 1.5 * (second - 5) / 45;
  EXPECT_NEAR(found[0] / -yield_at(0, 1 - std::exp(-0.4)), 1.5, 1e-11);
  EXPECT_NEAR(found[1] / -yield_at(1, 1 - std::exp(-0.08)), factor_b, 1e-11);
}

TEST_P(ModifiedComb, FailsByTheNominalStrain) {
  model::Material material = modified(model::Honeycomb::Abscissa::NominalStrain);
  std::get<model::Honeycomb>(material.law).failure_tension = 0.2;
  MotionDriver<double> point(material, GetParam());
  for (int i = 1; i <= 60; ++i) {
    const double strain = 0.0041 * i;
    point.move_to(along(1, 1 + strain));
    EXPECT_EQ(point.intact(), strain < 0.2) << strain;
  }
}

/// Steps of 2.5e-6, of which single precision alone would lose a fiftieth.
TEST_P(ModifiedComb, SmallIncrementsStayInFloat) {
  MotionDriver<float> point(modified(model::Honeycomb::Abscissa::NominalStrain), GetParam());
  constexpr int steps = 200000;
  for (int i = 1; i <= steps; ++i) point.move_to(along(0, 1 - 0.5 * i / steps));
  test::verified("honeycomb by strain in single precision, 200000 steps to one half: stress, error [MPa]",
                 "given curve")
      .below(std::fabs(local(point.stress())[0] + yield_at(0, 0.5)), 1e-4);
}

}  // namespace
}  // namespace crumple::materials::testing::modified_honeycomb_test
