// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ISOTROPIC_ELASTIC_FAILURE: failure by plastic strain and by tension, and what is left behind it.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "materials/motion_driver.hpp"
#include "support/drawn.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::failing_solid_test {
namespace {

constexpr double shear = 80000;
constexpr double bulk = 170000;
constexpr double yield = 250;
constexpr double hardening = 1000;

model::FailingSolid steel() {
  model::FailingSolid law;
  law.youngs_modulus = 9 * bulk * shear / (3 * bulk + shear);
  law.poissons_ratio = (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear));
  law.yield_stress = yield;
  law.hardening = hardening;
  return law;
}
model::Material material(const model::FailingSolid& law) {
  model::Material found;
  found.id = 13;
  found.density = 7.85e-9;
  found.law = law;
  return found;
}
/// The law that is the same up to failure.
model::Material without_failure() {
  model::PlasticKinematic law;
  law.youngs_modulus = steel().youngs_modulus;
  law.poissons_ratio = steel().poissons_ratio;
  law.yield_stress = yield;
  law.tangent_modulus = law.youngs_modulus * hardening / (law.youngs_modulus + hardening);
  law.isotropic_fraction = 1;
  model::Material found = material(steel());
  found.law = law;
  return found;
}
Matrix path(int i) {
  return {{{1 + 4e-4 * i, 6e-4 * i, 0}, {0, 1 - 2e-4 * i, 1e-4 * i}, {0, 0, 1 - 1e-4 * i}}};
}
Matrix sheared(double gamma) {
  Matrix f = unit;
  f[0][1] = gamma;
  return f;
}
class Failing : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Failing, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

template <class Real>
void expect_same(Isa isa, const model::FailingSolid& law, test::Largest& off) {
  MotionDriver<Real> point(material(law), isa);
  MotionDriver<Real> other(without_failure(), isa);
  for (int i = 1; i <= 100; ++i) {
    point.move_to(path(i));
    other.move_to(path(i));
    off.add(largest_difference(point.stress(), other.stress()) / yield);
    off.compare(point.item("plastic_strain"), other.item("plastic_strain"));
  }
  EXPECT_GT(point.item("plastic_strain"), 0.03);
  EXPECT_EQ(point.item("failed"), 0);
}

TEST_P(Failing, IsTheLawOfIsotropicHardeningUntilItFails) {
  test::Largest off("failing solid, intact: stress and plastic strain, difference",
                    "the law of isotropic hardening", 1e-12);
  test::Largest singles("failing solid, intact, in single precision: the same", "the same", 1e-5);
  expect_same<double>(GetParam(), steel(), off);
  expect_same<float>(GetParam(), steel(), singles);
  model::FailingSolid law = steel();
  law.failure_strain = 1;
  law.failure_pressure = -1e5;
  law.keeps_failed = true;
  expect_same<double>(GetParam(), law, off);
  law.keeps_failed = false;
  expect_same<double>(GetParam(), law, off);
}

TEST_P(Failing, GoesAtAPlasticStrain) {
  model::FailingSolid law = steel();
  law.failure_strain = 0.02;
  ASSERT_TRUE(solid_can_fail(material(law)));
  MotionDriver<double> point(material(law), GetParam());
  int i = 0;
  do {
    EXPECT_LT(point.item("plastic_strain"), 0.02);
    point.move_to(sheared(5e-4 * ++i));
  } while (point.intact() && i < 300);
  EXPECT_GE(point.item("plastic_strain"), 0.02);
  EXPECT_LT(point.item("plastic_strain"), 0.0205);
  EXPECT_FALSE(point.intact());
  EXPECT_EQ(largest_difference(point.stress(), Six{}), 0);
  const double strain = point.item("plastic_strain");
  point.move_in_steps(sheared(0.3), 20);
  EXPECT_EQ(point.item("plastic_strain"), strain);
  EXPECT_EQ(largest_difference(point.stress(), Six{}), 0);
}

/// The mean stress of a volume that grows is bulk ln V, whatever the flow.
TEST_P(Failing, GoesAtATension) {
  model::FailingSolid law = steel();
  law.failure_pressure = -1000;
  ASSERT_TRUE(solid_can_fail(material(law)));
  for (const double beyond : {-1e-6, 1e-6}) {
    MotionDriver<double> point(material(law), GetParam());
    point.move_in_steps(volumetric(std::exp(1000 / bulk + beyond)), 100);
    EXPECT_EQ(point.intact(), beyond < 0);
    EXPECT_NEAR(point.pressure(), beyond < 0 ? -1000 : 0, 0.3);
  }
  // Pressure of the same size does nothing.
  MotionDriver<double> pressed(material(law), GetParam());
  pressed.move_in_steps(volumetric(0.98), 50);
  EXPECT_TRUE(pressed.intact());
  EXPECT_GT(pressed.pressure(), 3000);
}

template <class Real>
void expect_fluid(Isa isa, bool by_strain, double tolerance) {
  model::FailingSolid law = steel();
  law.keeps_failed = true;
  (by_strain ? law.failure_strain : law.failure_pressure) = by_strain ? 0.01 : -500;
  EXPECT_FALSE(solid_can_fail(material(law)));
  MotionDriver<Real> point(material(law), isa);
  const Matrix end = by_strain ? sheared(0.05) : volumetric(1.01);
  point.move_in_steps(end, 100);
  EXPECT_EQ(point.item("failed"), 1);
  EXPECT_EQ(equivalent(point.stress()), 0);
  EXPECT_NEAR(point.pressure(), 0, tolerance);
  const double strain = point.item("plastic_strain");
  // It bears pressure from there on, but neither shear nor tension.
  const double volume = determinant(point.at());
  point.move_in_steps(times(sheared(0.1), times(volumetric(0.98), point.at())), 200);
  EXPECT_NEAR(point.pressure(), -bulk * std::log(0.98), 1e-4 * bulk * 0.02 + tolerance);
  EXPECT_EQ(equivalent(point.stress()), 0);
  EXPECT_EQ(point.item("plastic_strain"), strain);
  point.move_in_steps(volumetric(1.05 * volume), 100);
  EXPECT_EQ(point.pressure(), 0);
  EXPECT_EQ(equivalent(point.stress()), 0);
}

TEST_P(Failing, StaysAsAFluidWhereItIsKept) {
  for (const bool by_strain : {false, true}) {
    expect_fluid<double>(GetParam(), by_strain, 1e-9);
    expect_fluid<float>(GetParam(), by_strain, 0.5);
  }
}

TEST(FailingSolid, RefusesWhatHasNoSense) {
  const auto refused = [](const model::FailingSolid& law) {
    EXPECT_THROW(solid_material_constants(material(law), nullptr), Error);
  };
  EXPECT_NO_THROW(solid_material_constants(material(steel()), nullptr));
  EXPECT_FALSE(solid_can_fail(material(steel())));
  model::FailingSolid law = steel();
  law.yield_stress = 0;
  refused(law);
  law = steel();
  law.hardening = -1;
  refused(law);
  law = steel();
  law.failure_pressure = 1;
  refused(law);
  law = steel();
  law.failure_strain = -1;
  refused(law);
}

}  // namespace
}  // namespace crumple::materials::testing::failing_solid_test
