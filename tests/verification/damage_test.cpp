// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_DAMAGE_GISSMO and *MAT_PLASTICITY_WITH_DAMAGE: a bar of solids is pulled apart in its middle,
// where the stress fades before elements go: energy and momentum are kept.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::damage_test {
namespace {

constexpr double size = 2.0;
constexpr double speed = 40.0;  // mm/ms each way
constexpr Index length = 12;    // elements

model::Material with_gissmo() {
  model::Material middle = test::mild_steel();
  middle.damage = model::GissmoDamage{.exponent = 2,
                                      .failure_strain = model::constant_family(0.06),
                                      .critical_strain = model::constant_family(0.03),
                                      .fading_exponent = model::constant_family(1.5),
                                      .size_factor = {}};
  return middle;
}

model::Material with_fading_law() {
  model::Material middle = test::mild_steel();
  model::PiecewiseLinearPlasticity law;
  law.youngs_modulus = 207;
  law.poissons_ratio = 0.3;
  law.plastic_strain = {0, 10};
  law.yield_stress = {0.25, 2.5};
  law.damage_strain = {0, 0.03, 0.06};
  law.damage = {0, 0, 1};
  law.failure_strain = 0.06;
  middle.law = law;
  return middle;
}

model::Model bar(model::SolidFormulation formulation, model::Material middle) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.solid_sections[0].formulation = formulation;
  middle.id = 2;
  model.materials.push_back(std::move(middle));
  model.parts.push_back({.id = 2, .title = "middle", .solid_section = 0, .material = 1});
  test::add_box(model, 0, length, 2, 2, [](double u, double v, double w) {
    return test::Point{(u - 0.5) * length * size, 2 * v * size, 2 * w * size};
  });
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    const auto column = static_cast<Index>(e) % length;
    if (column == length / 2 - 1 || column == length / 2) model.solids[e].part = 1;
  }
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const double x = model.nodes.position[i][0];
    const double v = speed * (x > 1e-9 ? 1 : x < -1e-9 ? -1 : 0);
    model.initial_velocities.push_back({.node = i, .velocity = {v, 0, 0}, .angular_velocity = {}});
  }
  // Smaller than the rest and out of reach: a constant step.
  model.parts.push_back({.id = 3, .title = "clock", .solid_section = 0, .material = 0});
  test::add_box(model, 2, 1, 1, 1, [](double u, double v, double w) {
    return test::Point{1000 + 0.5 * size * u, 0.5 * size * v, 0.5 * size * w};
  });
  model.control.end_time = 0.06;
  // The work of solids is exact to the second order of the step: at 0.3 the balance is
  // 1.6e-6, and 1.3e-6 without damage, when the points fail at the same strain.
  model.control.step_scale = 0.15;
  return model;
}

class DamagedBar : public ::testing::TestWithParam<model::SolidFormulation> {};

TEST_P(DamagedBar, KeepsEnergyAndMomentum) {
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const model::Model model = bar(GetParam(), with_gissmo());
    timeloop::Simulation simulation(model, {precision, default_isa(), 1});
    const domain::Domain& domain = simulation.domain();
    double worst = 0;
    double worst_momentum = 0;
    double faded = 0;
    test::run(simulation, [&](const domain::Domain& now) {
      worst = test::larger_of(worst, std::fabs(now.energy.imbalance()) / now.energy.initial_total);
      worst_momentum = test::larger_of(worst_momentum, norm(test::momentum(now)));
      const domain::SolidBlock& middle = now.solids[1];
      const double damage = middle.state(0, middle.find("gissmo_damage")->first);
      if (damage > 0.25 && damage < 1) faded = test::larger_of(faded, damage);
    });
    EXPECT_EQ(domain.solids[1].eroded, 8);
    EXPECT_GT(faded, 0.5) << "it does not fail at once";
    EXPECT_GT(domain.energy.eroded, 0.25 * 0.03 * 8 * size * size * size);
    const bool exact = precision == Precision::Double;
    EXPECT_LT(worst_momentum, (exact ? 1e-11 : 1e-5) * domain.energy.initial_total / speed);
    test::verified(
        std::string("bar torn apart by damage, ") +
            (GetParam() == model::SolidFormulation::OnePointHexahedron ? "ELFORM 1, " : "ELFORM 2, ") +
            (exact ? "double" : "mixed") + ": energy over the initial one",
        "conservation")
        .below(worst, 1e-6);
  }
}

TEST_P(DamagedBar, OfTheLawKeepsEnergyAndMomentum) {
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const model::Model model = bar(GetParam(), with_fading_law());
    timeloop::Simulation simulation(model, {precision, default_isa(), 1});
    const domain::Domain& domain = simulation.domain();
    double worst = 0;
    double worst_momentum = 0;
    int fading = 0;
    test::run(simulation, [&](const domain::Domain& now) {
      worst = test::larger_of(worst, std::fabs(now.energy.imbalance()) / now.energy.initial_total);
      worst_momentum = test::larger_of(worst_momentum, norm(test::momentum(now)));
      const domain::SolidBlock& middle = now.solids[1];
      const double plastic = middle.state(0, middle.find("plastic_strain")->first);
      fading += plastic > 0.035 && plastic < 0.055 ? 1 : 0;
    });
    EXPECT_EQ(domain.solids[1].eroded, 8);
    EXPECT_GT(fading, 5) << "it does not fail at once";
    // As much as the strains up to the rupture take at the yield stress that is left, 0.25 (0.03 + 0.015).
    EXPECT_GT(domain.energy.eroded, 0.25 * 0.04 * 8 * size * size * size);
    const bool exact = precision == Precision::Double;
    EXPECT_LT(worst_momentum, (exact ? 1e-11 : 1e-5) * domain.energy.initial_total / speed);
    test::verified(
        std::string("bar torn apart by the damage of its law, ") +
            (GetParam() == model::SolidFormulation::OnePointHexahedron ? "ELFORM 1, " : "ELFORM 2, ") +
            (exact ? "double" : "mixed") + ": energy over the initial one",
        "conservation")
        .below(worst, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, DamagedBar,
                         ::testing::Values(model::SolidFormulation::OnePointHexahedron,
                                           model::SolidFormulation::SelectiveHexahedron),
                         [](const auto& test) {
                           return test.param == model::SolidFormulation::OnePointHexahedron ? "OnePoint"
                                                                                            : "Selective";
                         });

}  // namespace
}  // namespace crumple::damage_test
