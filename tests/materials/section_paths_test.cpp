// SPDX-License-Identifier: BSD-3-Clause
//
// The laws at the points of beams' cross sections against the rate equations of J2 plasticity with zero
// stress across, integrated in small explicit steps, and against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "materials/section_driver.hpp"
#include "support/verified.hpp"

namespace crumple::materials::section_paths_test {
namespace {

using Point = testing::SectionPoint;

model::Material kinematic(double beta) {
  return {.id = 1,
          .title = "m",
          .density = 1,
          .law = model::PlasticKinematic{.youngs_modulus = 200,
                                         .poissons_ratio = 0.3,
                                         .yield_stress = 0.3,
                                         .tangent_modulus = 10,
                                         .isotropic_fraction = beta}};
}

/// J2 with linear hardening by small explicit steps of the full tensor, whose lateral strains keep the
/// lateral stresses zero: the deviator of stress and back stress, and the uniaxial condition, written out.
class RateEquations {
 public:
  RateEquations(double beta) {
    const double modulus = 200 * 10 / 190.0;
    isotropic_ = beta * modulus;
    kinematic_ = (1 - beta) * modulus;
  }
  void advance(double axial, double along_s, double along_t) {
    const double shear = 200 / 2.6;
    const double trial[3] = {s_[0] + 200 * axial, s_[1] + shear * along_s, s_[2] + shear * along_t};
    const double x[3] = {s_[0] - b_[0], s_[1] - b_[1], s_[2] - b_[2]};
    const double size = std::sqrt(x[0] * x[0] + 3 * (x[1] * x[1] + x[2] * x[2]));
    const double y[3] = {trial[0] - b_[0], trial[1] - b_[1], trial[2] - b_[2]};
    const double next = std::sqrt(y[0] * y[0] + 3 * (y[1] * y[1] + y[2] * y[2]));
    const double limit = 0.3 + isotropic_ * p_;
    for (int i = 0; i < 3; ++i) s_[i] = trial[i];
    if (next <= limit || size == 0) return;
    // Normal of the yield function in stress; the plastic strains across do no work.
    const double n[3] = {y[0] / next, 3 * y[1] / next, 3 * y[2] / next};
    const double back[3] = {kinematic_ * y[0] / next, kinematic_ * y[1] / next, kinematic_ * y[2] / next};
    const double stiffness = 200 * n[0] * n[0] + shear * (n[1] * n[1] + n[2] * n[2]) + isotropic_ +
                             n[0] * back[0] + n[1] * back[1] + n[2] * back[2];
    const double flow = (next - limit) / stiffness;
    s_[0] -= 200 * flow * n[0];
    for (int i = 1; i < 3; ++i) s_[i] -= shear * flow * n[i];
    for (int i = 0; i < 3; ++i) b_[i] += flow * back[i];
    p_ += flow;
  }
  double stress(int i) const { return s_[i]; }
  double plastic_strain() const { return p_; }

 private:
  double s_[3] = {};
  double b_[3] = {};
  double p_ = 0;
  double isotropic_ = 0;
  double kinematic_ = 0;
};

TEST(SectionPaths, FollowTheRateEquations) {
  for (const double beta : {0.0, 0.5, 1.0}) {
    Point point(kinematic(beta));
    RateEquations rates(beta);
    const double path[][3] = {{0.004, 0, 0}, {0, 0.006, 0.002}, {-0.008, 0.001, -0.004}, {0.002, -0.012, 0}};
    for (const auto& leg : path) {
      constexpr int steps = 2000;
      for (int i = 0; i < steps; ++i) point.advance(leg[0] / steps, leg[1] / steps, leg[2] / steps, 1.0);
      constexpr int fine = 200000;
      for (int i = 0; i < fine; ++i) rates.advance(leg[0] / fine, leg[1] / fine, leg[2] / fine);
    }
    double worst = std::fabs(point.plastic_strain() / rates.plastic_strain() - 1);
    for (int i = 0; i < 3; ++i) worst = std::max(worst, std::fabs(point.stress(i) - rates.stress(i)) / 0.3);
    test::verified("points of beams against the rate equations of J2, error", "explicit integration")
        .below(worst, 2e-3);
  }
}

TEST(SectionPaths, PureShearYieldsAtOneOverRootThree) {
  Point point(kinematic(1.0));
  for (int i = 0; i < 1000; ++i) point.advance(0, 1e-5, 0, 1.0);
  // tau = tau_y + H_t (gamma - tau_y / G) with the slope G H / (3 G + H).
  const double shear = 200 / 2.6;
  const double hardening = 2000 / 190.0;
  const double yields = 0.3 / std::sqrt(3.0);
  const double expected = yields + shear * hardening / (3 * shear + hardening) * (0.01 - yields / shear);
  EXPECT_NEAR(point.stress(1), expected, 1e-10);
  EXPECT_EQ(point.stress(0), 0);
}

/// Uniaxial stress at the plastic strain that the law says, at one rate.
void check_uniaxial(const model::ConstitutiveLaw& law, double rate,
                    const std::function<double(double)>& yield, double tolerance) {
  Point point({.id = 1, .title = "m", .density = 1, .law = law});
  for (int i = 0; i < 5000; ++i) point.advance(2e-5, 0, 0, 2e-5 / rate);
  EXPECT_GT(point.plastic_strain(), 0.05);
  EXPECT_NEAR(point.stress(0) / yield(point.plastic_strain()), 1, tolerance);
}

TEST(SectionPaths, FollowCurvesPowersAndRates) {
  model::PiecewiseLinearPlasticity table;
  table.youngs_modulus = 200;
  table.poissons_ratio = 0.3;
  table.plastic_strain = {0, 0.02, 0.08, 0.2};
  table.yield_stress = {0.2, 0.3, 0.36, 0.38};
  const auto curve = [](double p) { return p < 0.08 ? 0.3 + (p - 0.02) : 0.36 + (p - 0.08) / 6; };
  check_uniaxial(table, 1, curve, 1e-12);
  table.cowper_symonds_rate = 40;
  table.cowper_symonds_exponent = 5;
  // The plastic strain rate is a little less than the total one.
  for (const bool viscoplastic : {false, true}) {
    table.viscoplastic = viscoplastic;
    check_uniaxial(
        table, 400, [&](double p) { return curve(p) * (1 + std::pow(10, 0.2)); }, 5e-3);
  }
  model::PowerLawPlasticity power;
  power.youngs_modulus = 200;
  power.poissons_ratio = 0.3;
  power.strength = 0.6;
  power.exponent = 0.2;
  power.yield_strain = std::pow(0.6 / 200, 1 / 0.8);
  check_uniaxial(
      power, 1, [&](double p) { return 0.6 * std::pow(p + power.yield_strain, 0.2); }, 1e-12);
  model::JohnsonCook rated;
  rated.youngs_modulus = 200;
  rated.poissons_ratio = 0.3;
  rated.yield_stress = 0.2;
  rated.hardening = 0.4;
  rated.exponent = 0.5;
  rated.rate_coefficient = 0.02;
  rated.reference_rate = 1;
  rated.simplified = true;
  check_uniaxial(
      rated, 100, [](double p) { return (0.2 + 0.4 * std::sqrt(p)) * (1 + 0.02 * std::log(100.0)); }, 5e-4);
}

TEST(SectionPaths, PointsFailAtTheirPlasticStrain) {
  auto material = kinematic(1.0);
  std::get<model::PlasticKinematic>(material.law).failure_strain = 0.01;
  Point point(material);
  double last = 0;
  for (int i = 0; i < 1000 && point.intact() != 0; ++i) {
    last = point.plastic_strain();
    point.advance(2e-5, 0, 0, 1.0);
  }
  EXPECT_LT(last, 0.01);
  EXPECT_GE(point.plastic_strain(), 0.01);
  EXPECT_EQ(point.stress(0), 0);
  point.advance(0.1, 0, 0, 1.0);
  EXPECT_EQ(point.stress(0), 0);
}

TEST(SectionPaths, LawsThatBeamsCannotHaveAreNotFound) {
  EXPECT_EQ(section_material_kind(model::BlatzKo{}), -1);
  EXPECT_EQ(section_material_kind(model::JohnsonCook{}), -1);
  model::PiecewiseLinearPlasticity limited;
  limited.failure_thinning = 0.1;
  EXPECT_EQ(section_material_kind(limited), -1);
}

}  // namespace
}  // namespace crumple::materials::section_paths_test
