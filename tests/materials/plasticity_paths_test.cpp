// SPDX-License-Identifier: BSD-3-Clause
// Plane-stress plasticity on paths whose answer is known in closed form.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "materials/point_driver.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::plasticity_paths_test {
namespace {

constexpr double tangent = 2100;

class EveryIsa : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, EveryIsa, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Proportional paths are exact however long the step: 2 % strain in one step or in 7.
TEST_P(EveryIsa, UniaxialTensionFollowsTheBilinearCurve) {
  const std::string tension = "plane stress, uniaxial tension to 2 %, three kinds of hardening: ";
  test::Largest stresses(tension + "stress, relative error", "bilinear curve", 1e-12);
  test::Largest across(tension + "lateral stress over the axial one", "uniaxial stress", 1e-12);
  test::Largest strains(tension + "plastic strain, error", "bilinear curve", 1e-14);
  for (const double beta : {0.0, 0.4, 1.0})
    for (const int steps : {1, 7}) {
      PointDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
      const double strain = 0.02;
      for (int i = 0; i < steps; ++i) point.apply_uniaxial(strain / steps, poissons_ratio);
      const double at_yield = initial_yield / youngs_modulus;
      const double expected = initial_yield + tangent * (strain - at_yield);
      stresses.compare(point.stress()[0], expected, expected,
                       "beta " + std::to_string(beta) + " steps " + std::to_string(steps));
      across.compare(point.stress()[1], 0, expected);
      strains.compare(point.item("plastic_strain"), strain - expected / youngs_modulus);
    }
}

TEST_P(EveryIsa, EquibiaxialTensionIsExact) {
  const std::string tension = "plane stress, equibiaxial tension to 1 %, three kinds of hardening: ";
  test::Largest stresses(tension + "stress, relative error", "closed form", 1e-13);
  test::Largest strains(tension + "plastic strain, error", "closed form", 1e-14);
  for (const double beta : {0.0, 0.4, 1.0})
    for (const int steps : {1, 7}) {
      PointDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
      const double strain = 0.01;
      for (int i = 0; i < steps; ++i) point.apply({strain / steps, strain / steps, 0, 0, 0});
      // q = sigma, each plastic strain is half the effective one: strain = s (1-nu)/E + (s - s0) / (2 H).
      const double h = plastic_modulus(tangent);
      const double compliance = (1 - poissons_ratio) / youngs_modulus;
      const double expected = (strain + initial_yield / (2 * h)) / (compliance + 1 / (2 * h));
      stresses.compare(point.stress()[0], expected, expected);
      stresses.compare(point.stress()[1], expected, expected);
      strains.compare(point.item("plastic_strain"), (expected - initial_yield) / h);
    }
}

TEST_P(EveryIsa, EachPureShearIsExact) {
  const std::string sheared = "plane stress, each pure shear to 2 %, three kinds of hardening: ";
  test::Largest stresses(sheared + "stress, relative error", "bilinear curve", 1e-13);
  test::Largest strains(sheared + "plastic strain, error", "bilinear curve", 1e-14);
  for (const double beta : {0.0, 0.4, 1.0})
    for (int shear = 2; shear < components; ++shear)
      for (const int steps : {1, 7}) {
        PointDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
        Five strain{};
        strain[shear] = 0.02 / steps;
        for (int i = 0; i < steps; ++i) point.apply(strain);
        // q = sqrt(3) tau, engineering plastic shear is sqrt(3) times the effective strain.
        const double h = plastic_modulus(tangent);
        const double expected = (0.02 + std::sqrt(3.0) * initial_yield / h) / (1 / shear_modulus + 3 / h);
        stresses.compare(point.stress()[shear], expected, expected);
        strains.compare(point.item("plastic_strain"), (std::sqrt(3.0) * expected - initial_yield) / h);
      }
}

/// Tension to 1 % and back: with kinematic hardening the elastic range stays 2 sigma_0 wide, with isotropic
/// hardening it grows (Bauschinger effect).
TEST_P(EveryIsa, ReversedLoadingYieldsWhereTheHardeningSays) {
  const std::string reversed = "plane stress, tension to 1 % and back, three kinds of hardening: ";
  test::Largest ends(reversed + "stress before the reversed yield, relative error",
                     "closed form, combined hardening", 1e-12);
  test::Largest flows(reversed + "stress beyond the reversed yield, relative error",
                      "closed form, combined hardening", 1e-12);
  for (const double beta : {0.0, 0.5, 1.0}) {
    PointDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
    for (int i = 0; i < 10; ++i) point.apply_uniaxial(0.001, poissons_ratio);
    const double peak = initial_yield + tangent * (0.01 - initial_yield / youngs_modulus);
    EXPECT_NEAR(point.stress()[0], peak, 1e-9 * peak);
    const double radius = initial_yield + beta * plastic_modulus(tangent) * (0.01 - peak / youngs_modulus);
    const double range = 2 * radius / youngs_modulus;
    point.apply_uniaxial(-0.999 * range, poissons_ratio);
    ends.compare(point.stress()[0], peak - 0.999 * 2 * radius, peak, "beta " + std::to_string(beta));
    point.apply_uniaxial(-0.001 * range - 0.004, poissons_ratio);
    flows.compare(point.stress()[0], peak - 2 * radius - tangent * 0.004, peak,
                  "beta " + std::to_string(beta));
  }
}

/// Twenty stress-strain loops with kinematic hardening close exactly.
TEST_P(EveryIsa, KinematicLoopsAreStable) {
  PointDriver<double> point(plastic_kinematic(tangent, 0), GetParam());
  for (int i = 0; i < 10; ++i) point.apply_uniaxial(0.0005, poissons_ratio);
  const double peak = point.stress()[0];
  test::Largest peaks("plane stress, twenty loops with kinematic hardening: peak stress, relative change",
                      "stable loop", 1e-12);
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (int i = 0; i < 20; ++i) point.apply_uniaxial(-0.0005, poissons_ratio);
    peaks.compare(point.stress()[0], -peak, peak);
    for (int i = 0; i < 20; ++i) point.apply_uniaxial(0.0005, poissons_ratio);
    peaks.compare(point.stress()[0], peak, peak);
  }
}

TEST_P(EveryIsa, CowperSymondsScalesTheYieldStress) {
  // Mild steel: C = 40.4 1/s, p = 5.
  test::Largest off("plane stress, mild steel at 0.1 to 3000 per s: yield stress in shear, relative error",
                    "Cowper and Symonds", 1e-12);
  for (const double rate : {0.1, 40.4, 3000.0}) {
    PointDriver<double> point(plastic_kinematic(0, 1, 40.4, 5), GetParam());
    const double step = 1e-6;
    const double shear = std::sqrt(3.0) * rate * step;  // effective rate of pure shear: gamma rate / sqrt(3)
    const double steps = 0.01 / shear;
    // In steady flow without hardening all strain is plastic.
    for (int i = 0; i < 400; ++i) point.apply({0, 0, 0.0005, 0, 0}, steps / 20 * step);
    const double expected = initial_yield * (1 + std::pow(rate / 40.4, 0.2)) / std::sqrt(3.0);
    off.compare(point.stress()[2], expected, expected, "rate " + std::to_string(rate));
  }
}

/// The table's stress at the plastic strain reached, for steps within a row and across several kinks, hard to
/// soft and soft to hard.
TEST_P(EveryIsa, TabulatedHardeningIsExactAcrossKinks) {
  const std::vector<double> strain{0, 0.002, 0.01, 0.011, 0.05, 0.2};
  const std::vector<double> stress{250, 300, 310, 380, 381, 420};
  const auto table = [&](double at) {
    std::size_t k = 0;
    while (k + 1 < strain.size() && at >= strain[k + 1]) ++k;
    if (k + 1 == strain.size()) return stress[k];
    return stress[k] + (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]) * (at - strain[k]);
  };
  const std::string kinks = "plane stress, hardening table with kinks, steps from 0.0004 to 0.3: ";
  test::Largest sums(kinks + "elastic and plastic strain less the total", "additive strains", 1e-12);
  test::Largest stresses(kinks + "stress over 250 MPa, error", "table", 1e-13);
  for (const double increment : {0.0004, 0.003, 0.02, 0.3}) {
    PointDriver<double> point(tabulated(strain, stress), GetParam());
    double total = 0;
    while (total < 0.4) {
      total += increment;
      point.apply({0, 0, increment, 0, 0});
      const double plastic = point.item("plastic_strain");
      const double tau = point.stress()[2];
      sums.compare(tau / shear_modulus + std::sqrt(3.0) * plastic, total);
      if (plastic > 0) stresses.compare(std::sqrt(3.0) * tau, table(plastic), initial_yield);
    }
  }
}

/// Plastic flow keeps the volume: with the elastic part taken away, zz = -(xx + yy).
TEST_P(EveryIsa, ThicknessStrainIsElasticPlusIncompressible) {
  PointDriver<double> point(plastic_kinematic(tangent, 0.4), GetParam());
  double sum = 0;
  double zz = 0;
  for (int i = 0; i < 20; ++i) {
    const Five strain{0.001, -0.0002, 0.0005, 0, 0.0001};
    point.apply(strain);
    sum += strain[0] + strain[1];
    zz += point.thickness_strain();
  }
  const Five s = point.stress();
  const double elastic_sum = (s[0] + s[1]) * (1 - poissons_ratio) / youngs_modulus;
  const double elastic_zz = -(s[0] + s[1]) * poissons_ratio / youngs_modulus;
  EXPECT_GT(point.item("plastic_strain"), 0.01);
  test::verified("plane stress, plastic flow: thickness strain", "elastic part, incompressible flow")
      .near(zz, elastic_zz - (sum - elastic_sum), 1e-14);
}

TEST(PlasticityInput, BadNumbersAreNamed) {
  auto bad = plastic_kinematic(tangent, 1.5);
  EXPECT_THROW(shell_material_constants(bad), Error);
  bad = plastic_kinematic(youngs_modulus, 0.5);
  EXPECT_THROW(shell_material_constants(bad), Error);
  bad = plastic_kinematic(tangent, 0.5);
  std::get<model::PlasticKinematic>(bad.law).failure_strain = -0.2;
  try {
    shell_material_constants(bad);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Material 1: the failure strain"), std::string::npos);
  }
  EXPECT_THROW(shell_material_constants(tabulated({0, 0.1, 0.1}, {200, 210, 220})), Error);
  EXPECT_THROW(shell_material_constants(tabulated({0.1, 0.2}, {200, 210})), Error);
  EXPECT_THROW(shell_material_constants(tabulated({0, 0.1}, {200, -1})), Error);
  EXPECT_THROW(shell_material_constants(tabulated({0, 0.0001}, {200, 100})), Error);
}

}  // namespace
}  // namespace crumple::materials::testing::plasticity_paths_test
