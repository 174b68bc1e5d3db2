// SPDX-License-Identifier: BSD-3-Clause
// What forces that follow from rates take in the half step of the start, and runs that go on without an
// element.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::start_test {
namespace {

using Form = model::SolidHourglassForm;

void damp_solids(model::Model& model, Form form) {
  model.control.hourglass.solid_form = form;
}

double energy_ratio_after(const model::Model& model, int steps) {
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  EXPECT_EQ(simulation.domain().energy.ratio(), 1) << "the start counts nothing before its time";
  for (int i = 0; i < steps; ++i) simulation.step();
  return simulation.domain().energy.ratio();
}

// A cube that is held at one end, and a force that is there from time zero on: what it does in the half step
// of the start is not 1/8 (f dt)^2 / m more than what the cube takes up.
TEST(Start, ALoadThatIsThereDoesTheWorkThatItsNodesTakeUp) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
  model.curves.push_back({1, {0, 1e6}, {1, 1}});
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const bool end = model.nodes.position[i][0] > 0.5;
    model.fixed_nodes.push_back({.node = i, .translation = {!end, true, true}});
    if (end) model.nodal_loads.push_back({.node = i, .force = {0.01, 0, 0}, .moment = {}, .curve = 0});
  }
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  for (int i = 0; i < 40; ++i) {
    simulation.step();
    const domain::EnergyLedger& energy = simulation.domain().energy;
    test::verified("bar under a force from the start on: imbalance over its work", "balance")
        .below(std::fabs(energy.imbalance()), 2e-3 * std::fabs(energy.external_work) + 1e-16);
  }
}

// A strip in tension that is held at one end springs back. What its stress does in the half step of the start
// is no error of the balance: a strip of four elements was wrong by a hundredth of its kinetic energy for
// good.
TEST(Start, AnInitialStressThatNothingBalancesKeepsTheEnergy) {
  model::Model model =
      test::one_part(test::elastic_steel(), test::shell_section(0.5, 1, model::ShellFormulation::Membrane));
  test::add_grid(model, 0, 4, 1, [](double u, double v) { return test::Point{4 * u, v, 0}; });
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.fixed_nodes.push_back({.node = i, .translation = {model.nodes.position[i][0] < 0.5, true, true}});
  for (std::size_t i = 0; i < model.shells.size(); ++i) {
    model::InitialPointStress point;
    point.stress[0] = 0.1;
    model.shell_stresses.push_back({.element = static_cast<Index>(i), .planes = 1, .points = {point}});
  }
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  double moving = 0;
  double imbalance = 0;
  for (int i = 0; i < 40; ++i) {
    simulation.step();
    const domain::EnergyLedger& energy = simulation.domain().energy;
    moving = std::fmax(moving, energy.kinetic);
    imbalance = std::fmax(imbalance, std::fabs(energy.imbalance()));
  }
  test::verified("strip that springs back from an initial stress: imbalance over its kinetic energy",
                 "balance")
      .below(imbalance / moving, 2e-3);
}

/// Each node of a cube moves along x by the product of two or three of its coordinates.
TEST(Start, AnHourglassModeOfASolidKeepsItsEnergyInTheLedger) {
  for (const Form form : {Form::StandardViscous, Form::FlanaganBelytschkoViscous, Form::ExactVolumeViscous})
    for (const bool third : {false, true}) {
      model::Model model = test::one_solid_part(test::elastic_steel());
      damp_solids(model, form);
      test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
      for (Index i = 0; i < model.nodes.count(); ++i) {
        const auto& x = model.nodes.position[i];
        const double mode = (2 * x[0] - 1) * (2 * x[1] - 1) * (third ? 2 * x[2] - 1 : 1);
        model.initial_velocities.push_back(
            {.node = i, .velocity = {0.01 * mode, 0, 0}, .angular_velocity = {}});
      }
      test::verified("viscous hourglass control of a cube: energy ratio - 1 after the start", "balance")
          .below(std::fabs(energy_ratio_after(model, 30) - 1), 2e-3);
    }
}

/// Bulk viscosity acts in the first half step, too.
TEST(Start, RandomVelocitiesKeepTheirEnergyInTheLedger) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  model::Model model = test::one_solid_part(test::elastic_steel());
  damp_solids(model, Form::FlanaganBelytschkoViscous);
  test::add_box(model, 0, 3, 3, 3, [](double u, double v, double w) {
    return test::Point{3 * u + 0.2 * v, 3 * v + 0.1 * w * w, 3 * w};
  });
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back(
        {.node = i,
         .velocity = {0.01 * share(random), 0.01 * share(random), 0.01 * share(random)},
         .angular_velocity = {}});
  test::verified("27 hexahedra with random velocities: energy ratio - 1 after the start", "balance")
      .below(std::fabs(energy_ratio_after(model, 100) - 1), 2e-3);
}

/// In the plane and with its nodes turning.
TEST(Start, AnHourglassModeOfAShellKeepsItsEnergyInTheLedger) {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(0.5, 2));
  test::add_grid(model, 0, 1, 1, [](double u, double v) { return test::Point{u, v, 0}; });
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    const double mode = (2 * x[0] - 1) * (2 * x[1] - 1);
    model.initial_velocities.push_back(
        {.node = i, .velocity = {0.01 * mode, 0, 0}, .angular_velocity = {0, 0.03 * mode, 0}});
  }
  test::verified("viscous hourglass control of a shell: energy ratio - 1 after the start", "balance")
      .below(std::fabs(energy_ratio_after(model, 30) - 1), 2e-3);
}

/// One shell that tears, with two dampings.
TEST(LastElement, MayErodeFromAModelWithDamping) {
  model::Model model = test::one_part(test::mild_steel(), test::shell_section(1, 2));
  std::get<model::PlasticKinematic>(model.materials[0].law).failure_strain = 0.05;
  test::add_grid(model, 0, 1, 1, [](double u, double v) { return test::Point{u, v, 0}; });
  model.mass_damping = model::MassDamping{.constant = 1};
  model::MassDamping of_part{.constant = 2};
  of_part.parts = {0};
  model.part_dampings.push_back(of_part);
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back(
        {.node = i, .velocity = {200 * model.nodes.position[i][0], 0, 0}, .angular_velocity = {}});
  model.control.end_time = 0.05;
  timeloop::Simulation simulation(model, test::execution());
  simulation.start();
  const double first = simulation.next_step();
  while (!simulation.finished() && simulation.domain().clock.cycle < 5000) {
    ASSERT_NO_THROW(simulation.step()) << "cycle " << simulation.domain().clock.cycle;
    if (simulation.domain().shells[0].eroded == 0) continue;
    EXPECT_GT(simulation.next_step(), 0.1 * first);
    EXPECT_LE(simulation.next_step(), 1.0001 * first);
  }
  EXPECT_EQ(simulation.domain().shells[0].eroded, 1);
  EXPECT_TRUE(simulation.finished());
  EXPECT_NEAR(simulation.domain().energy.ratio(), 1, 0.01);
}

}  // namespace
}  // namespace crumple::start_test
