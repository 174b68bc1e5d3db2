// SPDX-License-Identifier: BSD-3-Clause
//
// Static answers by dynamic relaxation, against closed forms, and the runs that begin with them: they stay at
// rest under the same load, and keep the energy of what was stored when they move.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"
#include "timeloop/dynamic_relaxation.hpp"

namespace crumple::dynamic_relaxation_test {
namespace {

constexpr double young = 210.0;
constexpr double density = 7.85e-6;

// mm, ms, kg. A strip of shells under its own weight, ten times of that: a tenth of its thickness.
constexpr double length = 60.0;
constexpr double thickness = 2.0;
constexpr double gravity = 9.81e-2;
constexpr double bending = young * thickness * thickness / (12 * density);  // E I / (rho A)

/// Of an Euler-Bernoulli beam (S. Timoshenko, Strength of Materials I, 1955, article 41).
double static_deflection() {
  return gravity * std::pow(length, 4) / (8 * bending);
}

double period() {
  constexpr double lambda = 1.875104068711961;
  return 2 * std::numbers::pi * length * length / (lambda * lambda * std::sqrt(bending));
}

model::Model strip() {
  model::Model model =
      test::one_part({.id = 1, .title = "strip", .density = density, .law = model::Elastic{young, 0.0}},
                     test::shell_section(thickness, 2));
  constexpr Index columns = 12;
  test::add_grid(model, 0, columns, 1, [](double u, double v) { return test::Point{u * length, 5 * v, 0}; });
  for (Index j = 0; j < 2; ++j)
    model.fixed_nodes.push_back(
        {.node = j * (columns + 1), .translation = {true, true, true}, .rotation = {true, true, true}});
  model.curves.push_back({1, {0, 1e6}, {gravity, gravity}});
  model.body_loads.push_back({2, 0, 1.0});
  model.relaxation.emplace();
  model.relaxation->body_loads = model.body_loads;
  model.relaxation->settings.tolerance = 1e-8;
  model.control.end_time = period();
  return model;
}

double tip(const domain::Domain& domain) {
  return -test::displacement(domain, 12).z;
}

// The dynamic answer to a load that is there at once swings to twice the static one.
TEST(DynamicRelaxation, AStripUnderItsWeightComesToRestAtItsDeflection) {
  const model::Model model = strip();
  timeloop::Simulation simulation(model, test::execution());
  timeloop::begin_relaxed(simulation);
  test::verified("strip of shells under its weight: deflection after dynamic relaxation", "beam theory")
      .within(tip(simulation.domain()), static_deflection(), 0.01);
  const double rest = tip(simulation.domain());
  double farthest = 0;
  double fastest = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    farthest = std::max(farthest, std::fabs(tip(domain) - rest));
    fastest = std::max(fastest, std::fabs(domain.energy.kinetic));
  });
  EXPECT_GT(simulation.domain().clock.cycle, 1000);
  test::verified("the same, a period later under the same load: motion of the tip over the deflection",
                 "statics")
      .below(farthest / rest, 0.01);
  EXPECT_LT(fastest, 1e-4 * simulation.domain().energy.internal);
}

// Without the relaxation it is this, so that the two cases above can fail.
TEST(DynamicRelaxation, WithoutItTheStripSwingsToTwiceTheDeflection) {
  const model::Model model = strip();
  timeloop::Simulation simulation(model, test::execution());
  double farthest = 0;
  test::run(simulation, [&](const domain::Domain& domain) { farthest = std::max(farthest, tip(domain)); });
  EXPECT_NEAR(farthest, 2 * static_deflection(), 0.1 * static_deflection());
}

// Velocities are there once the run begins, and only then.
TEST(DynamicRelaxation, InitialVelocitiesBeginWithTheRun) {
  model::Model model = strip();
  const double still = [&] {
    timeloop::Simulation simulation(model, test::execution());
    timeloop::begin_relaxed(simulation);
    return tip(simulation.domain());
  }();
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {0, 0, 0.1}});
  timeloop::Simulation simulation(model, test::execution());
  timeloop::begin_relaxed(simulation);
  simulation.start();
  EXPECT_EQ(tip(simulation.domain()), still);
  double mass = 0;
  const domain::NodeFields& nodes = simulation.domain().nodes;
  for (Index i = 0; i < nodes.count(); ++i)
    if (nodes.fixed[i] == 0) mass += nodes.mass[i];
  EXPECT_NEAR(simulation.domain().energy.kinetic, 0.5 * mass * 0.01, 1e-12 * mass);
}

/// The ledger of a relaxation, at its end.
struct Balance {
  double imbalance = 0;
  double damping = 0;
  double work = 0;
  long cycles = 0;
  double error = 0;
};

Balance relaxed_balance(const model::Model& model) {
  timeloop::DynamicRelaxation relaxation(model, test::execution());
  relaxation.start();
  while (!relaxation.finished()) relaxation.step();
  const domain::Domain& domain = relaxation.simulation().domain();
  return {domain.energy.imbalance(), domain.energy.damping, domain.energy.external_work, domain.clock.cycle,
          domain.energy.error()};
}

// Of the work of a load that is there at once, half is stored and half has to go.
TEST(DynamicRelaxation, WhatItTakesIsInTheBalance) {
  const Balance balance = relaxed_balance(strip());
  EXPECT_NEAR(balance.damping, 0.5 * balance.work, 0.01 * balance.work);
  test::verified("dynamic relaxation of a strip: imbalance over the work of its weight", "balance")
      .below(std::fabs(balance.imbalance) / balance.work, 1e-3);
}

// A factor that is far too small for this strip creeps; the automatic one finds the critical one.
TEST(DynamicRelaxation, TheAutomaticFactorIsFoundFromTooMuchAndTooLittleDamping) {
  model::Model model = strip();
  const double frequency = 2 * std::numbers::pi / period();
  for (const double factor : {0.97, 0.9999}) {
    model.relaxation->settings.factor = factor;
    model.relaxation->settings.automatic = true;
    timeloop::DynamicRelaxation relaxation(model, test::execution());
    relaxation.start();
    while (!relaxation.finished() && relaxation.simulation().domain().clock.cycle < 30000) relaxation.step();
    const domain::Domain& domain = relaxation.simulation().domain();
    EXPECT_TRUE(relaxation.converged()) << factor;
    EXPECT_LT(domain.clock.cycle, 15000) << factor;
    EXPECT_NEAR(tip(domain), static_deflection(), 0.01 * static_deflection()) << factor;
    const double critical = 1 - 2 * frequency * domain.clock.step;
    EXPECT_LT(1 - relaxation.factor(), 20 * (1 - critical)) << factor;
  }
}

/// A bar of 8 cubes that is pulled at its end; both phases know the force.
model::Model bar(double force) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 8, 1, 1, [](double u, double v, double w) { return test::Point{8 * u, v, w}; });
  model.curves.push_back({1, {0, 1e6}, {1, 1}});
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    model.fixed_nodes.push_back({.node = i, .translation = {x[0] < 0.5, x[1] < 0.5, x[2] < 0.5}});
    if (x[0] > 7.5) model.nodal_loads.push_back({.node = i, .force = {force / 4, 0, 0}, .curve = 0});
  }
  model.relaxation.emplace();
  model.relaxation->nodal_loads = model.nodal_loads;
  model.relaxation->settings.factor = 0.95;
  model.relaxation->settings.tolerance = 1e-12;
  model.control.end_time = 0.02;
  return model;
}

double stress_along(const domain::Domain& domain, Index place) {
  const domain::SolidBlock& block = domain.solids.front();
  return block.state(place, block.find("stress")->first);
}

TEST(DynamicRelaxation, ABarInTensionHasTheStressOfItsForce) {
  const double force = 0.1;
  const model::Model model = bar(force);
  timeloop::Simulation simulation(model, test::execution());
  timeloop::begin_relaxed(simulation);
  test::run(simulation);
  for (Index i = 0; i < 8; ++i)
    test::verified("bar of solids in tension after dynamic relaxation: stress", "F / A")
        .within(stress_along(simulation.domain(), i), force, 0.002);
}

// Let go, it swings with all the energy that the force has stored, and none is lost or won.
TEST(DynamicRelaxation, ABarThatIsReleasedKeepsTheEnergyThatIsStored) {
  model::Model model = bar(0.1);
  model.nodal_loads.clear();
  timeloop::Simulation simulation(model, test::execution());
  timeloop::begin_relaxed(simulation);
  double most = 0;
  double stored = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.cycle == 0) stored = domain.energy.internal;
    most = std::max(most, domain.energy.kinetic);
  });
  EXPECT_NEAR(stored, 0.5 * 0.1 * 0.1 * 8 / young, 0.01 * stored);
  EXPECT_GT(most, 0.9 * stored);
  test::verified("bar released from a relaxed tension: imbalance over the energy stored", "balance")
      .below(std::fabs(simulation.domain().energy.imbalance()) / stored, 5e-3);
}

std::uint64_t hash_after(const model::Model& model, int threads, Precision precision) {
  domain::Execution execution = test::execution();
  execution.threads = threads;
  execution.precision = precision;
  timeloop::Simulation simulation(model, execution);
  timeloop::begin_relaxed(simulation);
  simulation.start();
  for (int i = 0; i < 50; ++i) simulation.step();
  EXPECT_NEAR(tip(simulation.domain()), static_deflection(), 0.011 * static_deflection());
  return simulation.state_hash();
}

TEST(DynamicRelaxation, AnyNumberOfThreadsGivesTheSameBits) {
  const model::Model model = strip();
  for (const Precision precision : {Precision::Double, Precision::Mixed}) {
    const std::uint64_t one = hash_after(model, 1, precision);
    EXPECT_EQ(hash_after(model, 2, precision), one);
    EXPECT_EQ(hash_after(model, 3, precision), one);
  }
}

TEST(DynamicRelaxation, ItsEndTimeEndsItWhereItIs) {
  model::Model model = strip();
  model.relaxation->settings.end_time = 0.25 * period();
  timeloop::DynamicRelaxation relaxation(model, test::execution());
  relaxation.start();
  while (!relaxation.finished()) relaxation.step();
  EXPECT_FALSE(relaxation.converged());
  EXPECT_NEAR(relaxation.simulation().domain().clock.time, 0.25 * period(), 0.01 * period());
}

TEST(DynamicRelaxation, NothingToDoIsDoneAtTheFirstCheck) {
  model::Model model = strip();
  model.relaxation->body_loads.clear();
  const Balance balance = relaxed_balance(model);
  EXPECT_EQ(balance.cycles, 250);
}

}  // namespace
}  // namespace crumple::dynamic_relaxation_test
