// SPDX-License-Identifier: BSD-3-Clause
//
// Trusses: large motion against the energy of the logarithmic strain, plasticity and failure of a bar that
// carries a mass, waves in a row of them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::trusses_test {
namespace {

using test::Point;

model::BeamSection truss(double area) {
  model::BeamSection section;
  section.id = 1;
  section.formulation = model::BeamFormulation::Truss;
  section.area = area;
  return section;
}

model::Material material(const model::ConstitutiveLaw& law) {
  return {.id = 1, .title = "m", .density = 1e-6, .law = law};
}

/// Two trusses from (-4, 0) and (4, 0) to a mass at (0, 1), which falls with a given speed.
model::Model two_trusses(double speed) {
  model::Model model = test::one_beam_part(material(model::Elastic{100.0, 0.3}), truss(2.0));
  test::add_line(model, 2, {}, [](double u) { return Point{8 * u - 4, u == 0.5 ? 1.0 : 0.0, 0}; });
  for (const Index node : {0, 2})
    model.fixed_nodes.push_back({.node = node, .translation = {true, true, true}, .rotation = {}});
  model.lumped_masses.push_back({.id = 1, .node = 1, .mass = 1.0});
  model.initial_velocities.push_back({.node = 1, .velocity = {0, -speed, 0}});
  model.control.step_scale = 0.5;
  return model;
}

/// Energy of both trusses when the mass is at the height y: E A (l ln(l / L) - l + L) each.
double energy_at(double y) {
  const double whole = std::sqrt(17.0);
  const double length = std::sqrt(16 + y * y);
  return 2 * 200.0 * (length * std::log(length / whole) - length + whole);
}

TEST(Trusses, SnapThroughWhereTheirEnergyLetsThem) {
  const double barrier = energy_at(0);
  const auto lowest = [](double speed) {
    model::Model model = two_trusses(speed);
    model.control.end_time = 5;
    timeloop::Simulation simulation(model, test::execution());
    double height = 1;
    double worst = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      const double y = domain.nodes.position[domain.nodes.domain_node[1]].y;
      height = std::min(height, y);
      worst = test::larger_of(worst, std::fabs(domain.energy.internal - energy_at(y)));
    });
    EXPECT_LT(worst, 1e-4 * energy_at(0));
    return height;
  };
  const double just = std::sqrt(2 * barrier);
  EXPECT_GT(lowest(0.99 * just), 0.0);
  // Through, and beyond the mirrored place of rest by as much as the energy that is left allows.
  const double height = lowest(1.01 * just);
  EXPECT_LT(height, -1.0);
  test::verified("two trusses snap through: energy at the turning point over the barrier", "exact")
      .near(energy_at(height) / barrier, 1.01 * 1.01, 2e-3);
}

/// A bar of length 10 along x, held at its first end, with a mass at the other that moves along it.
model::Model bar_with_mass(const model::ConstitutiveLaw& law, double speed) {
  model::Model model = test::one_beam_part(material(law), truss(2.0));
  test::add_line(model, 1, {}, [](double u) { return Point{10 * u, 0, 0}; });
  model.fixed_nodes.push_back({.node = 0, .translation = {true, true, true}, .rotation = {}});
  model.fixed_nodes.push_back({.node = 1, .translation = {false, true, true}, .rotation = {}});
  model.lumped_masses.push_back({.id = 1, .node = 1, .mass = 1.0});
  model.initial_velocities.push_back({.node = 1, .velocity = {speed, 0, 0}});
  model.control.step_scale = 0.9;
  return model;
}

/// Yields at half a percent of strain, perfectly plastic.
model::PlasticKinematic soft_metal() {
  return {.youngs_modulus = 100,
          .poissons_ratio = 0.3,
          .yield_stress = 0.5,
          .tangent_modulus = 0.0,
          .isotropic_fraction = 1.0};
}

TEST(Trusses, PlasticBarStopsTheMassWhereItsWorkIsDone) {
  model::PlasticKinematic law = soft_metal();
  law.tangent_modulus = 1.0;
  law.isotropic_fraction = 0.0;
  model::Model model = bar_with_mass(law, 0.5);
  model.control.end_time = 10;
  timeloop::Simulation simulation(model, test::execution());
  double longest = 10;
  double shortest_after = 1e9;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double x = domain.nodes.position[domain.nodes.domain_node[1]].x;
    if (x > longest) shortest_after = x;
    longest = test::larger_of(longest, x);
    shortest_after = std::min(shortest_after, x);
  });
  // Work over the length with the stress s(ln(l / L)), by small steps; it is the kinetic energy at the peak.
  double length = 10;
  double work = 0;
  const double yield_strain = 0.5 / 100;
  while (work < 0.125) {
    const double strain = std::log(length / 10);
    const double stress = strain < yield_strain ? 100 * strain : 0.5 + 1.0 * (strain - yield_strain);
    work += 2.0 * stress * 1e-6;
    length += 1e-6;
  }
  test::verified("plastic truss stops a mass: peak over exact", "exact, by its integral")
      .near((longest - 10) / (length - 10), 1, 1e-3);
  // Kinematic: unloading stays elastic over twice the yield stress, it swings about the plastic length.
  EXPECT_GT(shortest_after, longest - 2.1 * yield_strain * longest);
  EXPECT_LT(simulation.domain().energy.error(), 1e-3);
}

TEST(Trusses, RateRaisesTheYieldStress) {
  model::PlasticKinematic law = soft_metal();
  law.cowper_symonds_rate = 0.02;
  law.cowper_symonds_exponent = 2.0;
  model::Model model = bar_with_mass(law, 1.0);
  model.control.end_time = 0.3;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double rate = domain.nodes.velocity[domain.nodes.domain_node[1]].x /
                      domain.nodes.position[domain.nodes.domain_node[1]].x;
  const double stress = domain.beams[0].state(0, domain.beams[0].find("stress")->first);
  EXPECT_NEAR(stress, 0.5 * (1 + std::sqrt(rate / 0.02)), 2e-3 * stress);
}

TEST(Trusses, FailAndGiveTheirEnergyToTheEroded) {
  model::PlasticKinematic law = soft_metal();
  law.failure_strain = 0.01;
  model::Model model = bar_with_mass(law, 1.0);
  model.control.end_time = 2;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  EXPECT_EQ(domain.beams[0].eroded, 1);
  // Work up to failure: elastic up to 0.005, then to a plastic strain of 0.01.
  const double work = 2 * 10 * (0.5 * 0.5 * 0.005 + 0.5 * 0.01);
  EXPECT_NEAR(domain.energy.eroded, work, 0.03 * work);
  EXPECT_EQ(domain.energy.internal, 0);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3 * domain.energy.initial_total);
}

/// EFFEPS below zero of *MAT_ADD_EROSION is the failure of the law, bit by bit, the smaller of both counting.
TEST(Trusses, FailByACriterionOfPlasticStrain) {
  const auto run = [](double of_law, double criterion) {
    model::PlasticKinematic law = soft_metal();
    law.failure_strain = of_law;
    model::Model model = bar_with_mass(law, 1.0);
    if (criterion > 0) model.materials[0].erosion.emplace().effective_plastic_strain = criterion;
    model.control.end_time = 2;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    EXPECT_EQ(simulation.domain().beams[0].eroded, 1);
    return simulation.state_hash();
  };
  const auto expected = run(0.01, 0);
  EXPECT_EQ(run(0, 0.01), expected);
  EXPECT_EQ(run(0.02, 0.01), expected);
  EXPECT_EQ(run(0.01, 0.02), expected);
}

TEST(Trusses, WaveRunsThroughARowOfThem) {
  // A free bar whose first half moves: after the time L / c the other half moves.
  model::Model model = test::one_beam_part(
      {.id = 1, .title = "m", .density = 1.0, .law = model::Elastic{100.0, 0.3}}, truss(1.0));
  test::add_line(model, 100, {}, [](double u) { return Point{100 * u, 0, 0}; });
  for (Index node = 0; node < 50; ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {0.01, 0, 0}});
  model.initial_velocities.push_back({.node = 50, .velocity = {0.005, 0, 0}});
  model.control.end_time = 100.0 / 10.0;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  double first = 0;
  double second = 0;
  for (Index node = 0; node < 50; ++node) {
    first += domain.nodes.velocity[domain.nodes.domain_node[node]].x / 50;
    second += domain.nodes.velocity[domain.nodes.domain_node[node + 51]].x / 50;
  }
  test::verified("wave through a row of trusses: velocity left behind over the initial one",
                 "wave equation, exact")
      .near(first / 0.01, 0, 3e-2);
  EXPECT_NEAR(second, 0.01, 3e-4);
}

}  // namespace
}  // namespace crumple::trusses_test
