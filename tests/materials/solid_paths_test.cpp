// SPDX-License-Identifier: BSD-3-Clause
// Laws of solids on paths whose answer is known in closed form.
#include <gtest/gtest.h>

#include "materials/solid_driver.hpp"
#include "support/largest.hpp"

namespace crumple::materials::testing::solid_paths_test {
namespace {

constexpr double tangent = 2100;
constexpr double bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio));
const double root3 = std::sqrt(3.0);

model::Material elastic() {
  model::Material material;
  material.id = 9;
  material.density = 7.85e-9;
  material.law = model::Elastic{youngs_modulus, poissons_ratio};
  return material;
}

class Solid : public ::testing::TestWithParam<Isa> {};
INSTANTIATE_TEST_SUITE_P(All, Solid, ::testing::ValuesIn(available_isas()),
                         [](const auto& isa) { return std::string(isa_name(isa.param)); });

/// Hooke's law by its inverse: strains of the stress that came out are those that went in.
TEST_P(Solid, ElasticStressesGiveBackTheirStrains) {
  SolidDriver<double> point(elastic(), GetParam());
  const Six strain{0.003, -0.001, 0.0005, 0.002, -0.0004, 0.0011};
  for (int i = 0; i < 4; ++i) point.apply(strain);
  const Six s = point.stress();
  test::Largest off("elastic solid: strains of its stresses, error", "Hooke's law, inverted", 1e-16);
  for (int c = 0; c < 3; ++c) {
    const double across = s[(c + 1) % 3] + s[(c + 2) % 3];
    off.compare((s[c] - poissons_ratio * across) / youngs_modulus, 4 * strain[c]);
    off.compare(s[c + 3] / shear_modulus, 4 * strain[c + 3]);
  }
}

/// Proportional paths are exact however long the step: 2 % strain in one step or in 7.
TEST_P(Solid, UniaxialTensionFollowsTheBilinearCurve) {
  const std::string tension = "solid, uniaxial tension to 2 %, three kinds of hardening: ";
  test::Largest stresses(tension + "stress, relative error", "bilinear curve", 1e-12);
  test::Largest across(tension + "lateral stress over the axial one", "uniaxial stress", 1e-12);
  test::Largest strains(tension + "plastic strain, error", "bilinear curve", 1e-14);
  for (const double beta : {0.0, 0.4, 1.0})
    for (const int steps : {1, 7}) {
      SolidDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
      const double strain = 0.02;
      for (int i = 0; i < steps; ++i) point.apply_uniaxial(strain / steps);
      const double expected = initial_yield + tangent * (strain - initial_yield / youngs_modulus);
      stresses.compare(point.stress()[0], expected, expected,
                       "beta " + std::to_string(beta) + " steps " + std::to_string(steps));
      across.compare(point.stress()[1], 0, expected);
      EXPECT_EQ(point.stress()[1], point.stress()[2]);
      strains.compare(point.item("plastic_strain"), strain - expected / youngs_modulus);
    }
}

/// Along each axis: q = 2 G e - 3 G p = sigma_0 + H p, and the pressure is elastic.
TEST_P(Solid, UniaxialStrainIsExact) {
  const std::string squeezed = "solid, uniaxial strain of 2 % both ways, three kinds of hardening: ";
  test::Largest stresses(squeezed + "stresses [MPa], error", "closed form", 1e-10);
  test::Largest strains(squeezed + "plastic strain, error", "closed form", 1e-14);
  for (const double beta : {0.0, 0.4, 1.0})
    for (const int steps : {1, 7})
      for (const double strain : {0.02, -0.02})
        for (int axis = 0; axis < 3; ++axis) {
          SolidDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
          Six increment{};
          increment[axis] = strain / steps;
          for (int i = 0; i < steps; ++i) point.apply(increment);
          const double h = plastic_modulus(tangent);
          const double p = (2 * shear_modulus * 0.02 - initial_yield) / (3 * shear_modulus + h);
          const double q = std::copysign(initial_yield + h * p, strain);
          stresses.compare(point.stress()[axis], bulk_modulus * strain + 2 * q / 3);
          stresses.compare(point.stress()[(axis + 1) % 3], bulk_modulus * strain - q / 3);
          stresses.compare(point.stress()[(axis + 2) % 3], bulk_modulus * strain - q / 3);
          strains.compare(point.item("plastic_strain"), p);
        }
}

TEST_P(Solid, EachPureShearIsExact) {
  const std::string sheared = "solid, each pure shear to 2 %, three kinds of hardening: ";
  test::Largest stresses(sheared + "stress, relative error", "bilinear curve", 1e-13);
  test::Largest strains(sheared + "plastic strain, error", "bilinear curve", 1e-14);
  for (const double beta : {0.0, 0.4, 1.0})
    for (int shear = 3; shear < solid_components; ++shear)
      for (const int steps : {1, 7}) {
        SolidDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
        Six strain{};
        strain[shear] = 0.02 / steps;
        for (int i = 0; i < steps; ++i) point.apply(strain);
        // q = sqrt(3) tau, engineering plastic shear is sqrt(3) times the effective strain.
        const double h = plastic_modulus(tangent);
        const double expected = (0.02 + root3 * initial_yield / h) / (1 / shear_modulus + 3 / h);
        stresses.compare(point.stress()[shear], expected, expected);
        strains.compare(point.item("plastic_strain"), (root3 * expected - initial_yield) / h);
      }
}

/// Tension to 1 % and back: with kinematic hardening the elastic range stays 2 sigma_0 wide, with isotropic
/// hardening it grows (Bauschinger effect).
TEST_P(Solid, ReversedLoadingYieldsWhereTheHardeningSays) {
  const std::string reversed = "solid, tension to 1 % and back, three kinds of hardening: ";
  test::Largest ends(reversed + "stress before the reversed yield, relative error",
                     "closed form, combined hardening", 1e-12);
  test::Largest flows(reversed + "stress beyond the reversed yield, relative error",
                      "closed form, combined hardening", 1e-12);
  for (const double beta : {0.0, 0.5, 1.0}) {
    SolidDriver<double> point(plastic_kinematic(tangent, beta), GetParam());
    for (int i = 0; i < 10; ++i) point.apply_uniaxial(0.001);
    const double peak = initial_yield + tangent * (0.01 - initial_yield / youngs_modulus);
    EXPECT_NEAR(point.stress()[0], peak, 1e-9 * peak);
    const double radius = initial_yield + beta * plastic_modulus(tangent) * (0.01 - peak / youngs_modulus);
    const double range = 2 * radius / youngs_modulus;
    point.apply_uniaxial(-0.999 * range);
    ends.compare(point.stress()[0], peak - 0.999 * 2 * radius, peak, "beta " + std::to_string(beta));
    point.apply_uniaxial(-0.001 * range - 0.004);
    flows.compare(point.stress()[0], peak - 2 * radius - tangent * 0.004, peak,
                  "beta " + std::to_string(beta));
  }
}

/// Twenty stress-strain loops with kinematic hardening close exactly, and each dissipates the same.
TEST_P(Solid, KinematicLoopsAreStable) {
  SolidDriver<double> point(plastic_kinematic(tangent, 0), GetParam());
  for (int i = 0; i < 10; ++i) point.apply_uniaxial(0.0005);
  const double peak = point.stress()[0];
  test::Largest peaks("solid, twenty loops with kinematic hardening: peak stress, relative change",
                      "stable loop", 1e-12);
  test::Largest widths("solid, twenty loops with kinematic hardening: width of the loop, error",
                       "bilinear curve", 1e-13);
  for (int cycle = 0; cycle < 20; ++cycle) {
    const double before = point.item("plastic_strain");
    for (int i = 0; i < 20; ++i) point.apply_uniaxial(-0.0005);
    peaks.compare(point.stress()[0], -peak, peak);
    for (int i = 0; i < 20; ++i) point.apply_uniaxial(0.0005);
    peaks.compare(point.stress()[0], peak, peak);
    // Twice the plastic part of the strain range: the loop's width.
    const double elastic_range = 2 * initial_yield / youngs_modulus;
    const double plastic_range = (0.01 - elastic_range) * (1 - tangent / youngs_modulus);
    widths.compare(point.item("plastic_strain") - before, 2 * plastic_range);
  }
}

/// A pressure of thousands of yield stresses, alone and over a stress on the yield surface.
template <class Real>
void expect_no_flow_under_pressure(const model::Material& material, Isa isa) {
  for (const double sign : {1.0, -1.0}) {
    SolidDriver<Real> point(material, isa);
    const double volume = static_cast<double>(static_cast<Real>(sign * 0.5));
    for (int i = 0; i < 10; ++i) point.apply({volume, volume, volume, 0, 0, 0});
    EXPECT_EQ(point.item("plastic_strain"), 0);
    const Six s = point.stress();
    test::verified(std::string("solid under pressure of thousands of yield stresses, ") +
                       (sizeof(Real) == 4 ? "single" : "double") +
                       " precision: stress over K times volume strain",
                   "elastic, no flow")
        .near(s[0] / (3 * bulk_modulus * 5 * sign), 1, sizeof(Real) == 4 ? 1e-6 : 1e-12);
    EXPECT_EQ(s[0], s[1]);
    EXPECT_EQ(s[0], s[2]);
    EXPECT_EQ(equivalent({s[3], s[4], s[5], 0, 0, 0}), 0);
  }
  // The same shear makes the same flow, with and without a pressure that came before it.
  SolidDriver<Real> pressed(material, isa);
  SolidDriver<Real> free(material, isa);
  for (SolidDriver<Real>* point : {&pressed, &free}) {
    point->apply({0, 0, 0, 0.3 * initial_yield / root3 / shear_modulus, 0, 0});
    if (point == &pressed) point->apply({-0.01, -0.01, -0.01, 0, 0, 0});
    EXPECT_EQ(point->item("plastic_strain"), 0);
    point->apply({0, 0, 0, 0.01, 0, 0});
  }
  EXPECT_GT(free.item("plastic_strain"), 0.001);
  EXPECT_EQ(pressed.item("plastic_strain"), free.item("plastic_strain"));
  EXPECT_EQ(pressed.stress()[3], free.stress()[3]);
}

TEST_P(Solid, PressureLeavesNoPlasticStrain) {
  for (const model::Material& material :
       {plastic_kinematic(tangent, 0.4), tabulated({0, 0.1}, {250, 400}), power_law()}) {
    expect_no_flow_under_pressure<double>(material, GetParam());
    expect_no_flow_under_pressure<float>(material, GetParam());
  }
}

TEST_P(Solid, CowperSymondsScalesTheYieldStress) {
  // Mild steel: C = 40.4 1/s, p = 5.
  test::Largest off("solid, mild steel at 0.1 to 3000 per s: yield stress in shear, relative error",
                    "Cowper and Symonds", 1e-12);
  for (const double rate : {0.1, 40.4, 3000.0}) {
    SolidDriver<double> point(plastic_kinematic(0, 1, 40.4, 5), GetParam());
    const double shear = 0.0005;
    // The effective rate of pure shear is the shear rate over sqrt(3).
    // In steady flow without hardening all strain is plastic.
    for (int i = 0; i < 400; ++i) point.apply({0, 0, 0, 0, shear, 0}, shear / root3 / rate);
    const double expected = initial_yield * (1 + std::pow(rate / 40.4, 0.2)) / root3;
    off.compare(point.stress()[4], expected, expected, "rate " + std::to_string(rate));
  }
}

/// The table's stress at the plastic strain reached, for steps within a row and across several kinks, hard to
/// soft and soft to hard.
TEST_P(Solid, TabulatedHardeningIsExactAcrossKinks) {
  const std::vector<double> strain{0, 0.002, 0.01, 0.011, 0.05, 0.2};
  const std::vector<double> stress{250, 300, 310, 380, 381, 420};
  const auto table = [&](double at) {
    std::size_t k = 0;
    while (k + 1 < strain.size() && at >= strain[k + 1]) ++k;
    if (k + 1 == strain.size()) return stress[k];
    return stress[k] + (stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]) * (at - strain[k]);
  };
  const std::string kinks = "solid, hardening table with kinks, steps from 0.0004 to 0.3: ";
  test::Largest sums(kinks + "elastic and plastic strain less the total", "additive strains", 1e-12);
  test::Largest stresses(kinks + "stress over 250 MPa, error", "table", 1e-13);
  for (const double increment : {0.0004, 0.003, 0.02, 0.3}) {
    SolidDriver<double> point(tabulated(strain, stress), GetParam());
    double total = 0;
    while (total < 0.4) {
      total += increment;
      point.apply({0, 0, 0, 0, 0, increment});
      const double plastic = point.item("plastic_strain");
      const double tau = point.stress()[5];
      sums.compare(tau / shear_modulus + root3 * plastic, total);
      if (plastic > 0) stresses.compare(root3 * tau, table(plastic), initial_yield);
    }
  }
}

/// k (e_y + p)^n under uniaxial tension, at the plastic strain that the axial strain leaves.
TEST_P(Solid, PowerLawIsExactInTension) {
  test::Largest stresses("solid, power law in tension to 5 %: stress, relative error", "closed form", 1e-12);
  test::Largest strains("solid, power law in tension to 5 %: plastic strain, error", "closed form", 1e-14);
  for (const int steps : {1, 9}) {
    SolidDriver<double> point(power_law(), GetParam());
    const double strain = 0.05;
    for (int i = 0; i < steps; ++i) point.apply_uniaxial(strain / steps);
    const double first = std::pow(youngs_modulus / 500, 1 / (0.22 - 1));
    double sigma = 300;
    for (int i = 0; i < 200; ++i) sigma = 500 * std::pow(first + strain - sigma / youngs_modulus, 0.22);
    stresses.compare(point.stress()[0], sigma, sigma);
    strains.compare(point.item("plastic_strain"), strain - sigma / youngs_modulus);
  }
}

}  // namespace
}  // namespace crumple::materials::testing::solid_paths_test
