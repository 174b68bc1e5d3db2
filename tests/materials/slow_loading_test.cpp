// SPDX-License-Identifier: BSD-3-Clause
// A million small steps: what float keeps of them.
#include <gtest/gtest.h>

#include "materials/point_driver.hpp"
#include "support/verified.hpp"

namespace crumple::materials::testing::slow_loading_test {
namespace {

constexpr double tangent = 2100;
const double root3 = std::sqrt(3.0);

/// Pure shear, in which the answer is exact (see EachPureShearIsExact).
double exact_stress(double strain) {
  const double h = plastic_modulus(tangent);
  return (strain + root3 * initial_yield / h) / (1 / shear_modulus + 3 / h);
}
double exact_plastic(double strain) {
  return (strain - exact_stress(strain) / shear_modulus) / root3;
}

template <class Real>
PointDriver<Real> loaded(const model::Material& material, double strain, int steps) {
  PointDriver<Real> point(material, available_isas().back());
  for (int i = 0; i < steps; ++i) point.apply({0, 0, strain / steps, 0, 0}, 1e-6);
  return point;
}

constexpr int million = 1000000;

/// What rounding the stress, once as trial and once returned, can make of the plastic strain: a stress that
/// is rounded by d is an elastic strain d / G that turns plastic.
double bound_of_rounding(double stress, int steps) {
  const auto rounded = static_cast<float>(stress);
  const double last_place = static_cast<double>(std::nextafter(rounded, 1e9F)) - static_cast<double>(rounded);
  return steps * last_place / (root3 * shear_modulus);
}

TEST(SlowLoading, AMillionStepsGiveThePlasticStrain) {
  for (const double strain : {0.02, 0.2}) {
    const double bound = bound_of_rounding(exact_stress(strain), million);
    EXPECT_LT(bound, 3e-4);
    const auto line = plastic_kinematic(tangent, 1);
    const auto table = tabulated({0, 10}, {initial_yield, initial_yield + 10 * plastic_modulus(tangent)});
    const std::array<model::Material, 2> both{line, table};
    for (const model::Material& material : both) {
      const auto point = loaded<float>(material, strain, million);
      const std::string slow = std::string("plane stress, a million steps in single precision to ") +
                               (strain < 0.1 ? "2 %, " : "20 %, ") +
                               (&material == &both[0] ? "bilinear: " : "table: ");
      test::verified(slow + "plastic strain", "closed form; what rounding allows")
          .near(point.item("plastic_strain"), exact_plastic(strain), bound);
      // The stress is that of the yield surface at this strain.
      const double yield = initial_yield + plastic_modulus(tangent) * point.item("plastic_strain");
      test::verified(slow + "stress off the yield surface, over the stress", "bilinear curve")
          .below(std::fabs(root3 * point.stress()[2] - yield) / (root3 * exact_stress(strain)), 1e-6);
    }
  }
}

TEST(SlowLoading, StressWithoutFlowAndBackStressAreWithinAPercent) {
  const auto elastic = loaded<float>(plastic_kinematic(tangent, 1), 0.001, million);
  const std::string slow = "plane stress, a million steps in single precision, ";
  test::verified(slow + "elastic: stress over exact", "Hooke's law")
      .near(elastic.stress()[2] / (0.001 * shear_modulus), 1, 0.005);
  for (const double strain : {0.003, 0.02, 0.2}) {
    const auto kinematic = loaded<float>(plastic_kinematic(tangent, 0), strain, million);
    test::verified(slow + "kinematic hardening: stress over exact", "bilinear curve")
        .near(kinematic.stress()[2] / exact_stress(strain), 1, 0.01);
  }
}

/// Increments of a seventh of half a unit in the last place of the plastic strain.
TEST(SlowLoading, FlowDoesNotHalt) {
  for (const Isa isa : available_isas()) {
    PointDriver<float> point(plastic_kinematic(tangent, 1), isa);
    point.apply({0, 0, 0.3, 0, 0}, 1e-6);
    const double start = point.item("plastic_strain") + point.item("plastic_strain_rest");
    EXPECT_GT(start, 0.16);
    constexpr double increment = 2e-9;
    constexpr int steps = 200000;
    const auto small = static_cast<double>(static_cast<float>(increment));
    for (int i = 0; i < steps; ++i) point.apply({0, 0, small, 0, 0}, 1e-6);
    const double grown = point.item("plastic_strain") + point.item("plastic_strain_rest") - start;
    const double expected = exact_plastic(0.3 + small * steps) - exact_plastic(0.3);
    EXPECT_NEAR(grown, expected, bound_of_rounding(exact_stress(0.3), steps)) << isa_name(isa);
    EXPECT_GT(grown, 0.8 * expected) << isa_name(isa);
  }
}

TEST(SlowLoading, DoubleIsExact) {
  const auto point = loaded<double>(plastic_kinematic(tangent, 1), 0.2, million);
  const std::string slow = "plane stress, a million steps in double precision to 20 %: ";
  test::verified(slow + "plastic strain", "closed form")
      .near(point.item("plastic_strain"), exact_plastic(0.2), 1e-9);
  test::verified(slow + "stress [MPa]", "closed form").near(point.stress()[2], exact_stress(0.2), 1e-7);
}

}  // namespace
}  // namespace crumple::materials::testing::slow_loading_test
