// SPDX-License-Identifier: BSD-3-Clause
// What ends a run: energies that no sound run has, and no energy that a sound run may have.
#include "timeloop/guards.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace crumple::timeloop::guards_test {
namespace {

/// One node of unit mass at x = 1, past the first step.
domain::Domain sample() {
  domain::Domain domain;
  domain.nodes.position.assign(1, {1, 0, 0});
  domain.nodes.velocity.assign(1, {});
  domain.nodes.angular_velocity.assign(1, {});
  domain.nodes.mass.assign(1, 1.0);
  domain.nodes.model_node = {0};
  domain.clock.cycle = 1;
  domain.clock.step = 1e-6;
  return domain;
}

model::Model one_node(double step_scale) {
  model::Model model;
  model.nodes.id = {7};
  model.nodes.position = {{1, 0, 0}};
  model.control.step_scale = step_scale;
  return model;
}

TEST(Guards, RoundOffOfAModelAtRestIsNoGrowth) {
  domain::Domain domain = sample();
  domain.energy.kinetic = 0.5 * 1e-20;  // a unit in the last place of x per step
  EXPECT_NO_THROW(guard_kinetic_energy(one_node(0.9), domain, 0));
  domain.energy.kinetic = -0.5 * 1e-20;
  EXPECT_NO_THROW(guard_kinetic_energy(one_node(0.9), domain, 0));
  domain.energy.kinetic = 1e-9;
  EXPECT_THROW(guard_kinetic_energy(one_node(0.9), domain, 0), NumericalError);
}

// What springs back has nothing but what its stresses hold.
TEST(Guards, StressesOfTheStartMayBecomeMotion) {
  domain::Domain domain = sample();
  model::Model model = one_node(0.9);
  model.materials.resize(1);
  model.materials[0].density = 2;
  model.materials[0].law = model::Elastic{100, 0.25};
  model.parts.resize(1);
  model.parts[0].material = 0;
  model.solids.resize(1);
  model.solids[0].part = 0;
  model.solid_stresses.resize(1);
  model.solid_stresses[0].element = 0;
  model.solid_stresses[0].points.resize(1);
  model.solid_stresses[0].points[0].stress = {4, 0, 0, 0, 0, 0};
  const double stored = 0.5 * 1.25 * 16 / 100 * 0.5;  // (1 + nu) s^2 / (2 E) times the volume
  domain.energy.kinetic = 99 * stored;
  EXPECT_NO_THROW(guard_kinetic_energy(model, domain, initial_stress_energy(model, domain)));
  domain.energy.kinetic = 101 * stored;
  EXPECT_THROW(guard_kinetic_energy(model, domain, initial_stress_energy(model, domain)), NumericalError);
}

TEST(Guards, GrowthIsJudgedByWhatWasSupplied) {
  domain::Domain domain = sample();
  domain.energy.external_work = -2;
  domain.energy.initial_total = 1;
  domain.energy.kinetic = 299;
  EXPECT_NO_THROW(guard_kinetic_energy(one_node(0.9), domain, 0));
  domain.energy.kinetic = 301;
  EXPECT_THROW(guard_kinetic_energy(one_node(0.9), domain, 0), NumericalError);
  domain.energy.internal = 2;
  EXPECT_NO_THROW(guard_kinetic_energy(one_node(0.9), domain, 0));
  domain.energy.kinetic = std::nan("");
  EXPECT_THROW(guard_kinetic_energy(one_node(0.9), domain, 0), NumericalError);
}

/// The lowest kinetic energy of a free oscillator over its energy, with the step s 2 / omega.
double lowest_of_oscillator(double s) {
  const double step = 2 * s;  // omega = 1, mass = 1
  double x = 0;
  double v = 1;  // of n - 1/2
  double least = 1;
  const double first = 0.5 * v * (v - step * x) + 0.5 * x * x;
  for (int n = 0; n < 10000; ++n) {
    x += step * v;
    const double next = v - step * x;
    least = std::fmin(least, 0.5 * v * next);
    v = next;
  }
  return least / first;
}

TEST(Guards, AStableOscillatorMayHaveNegativeKineticEnergyAnUnstableRunMayNot) {
  for (const double s : {0.6, 0.9, 0.96, 0.98}) {
    domain::Domain domain = sample();
    domain.energy.initial_total = 1;
    domain.energy.kinetic = lowest_of_oscillator(s);
    EXPECT_LT(domain.energy.kinetic, 0);
    EXPECT_NO_THROW(guard_kinetic_energy(one_node(s), domain, 0)) << s;
    // Elements alone may be nearer to their limit than the others.
    domain.energy.kinetic = 3 * lowest_of_oscillator(std::fmin(1.07 * s, 0.995));
    EXPECT_NO_THROW(guard_kinetic_energy(one_node(s), domain, 0)) << "nothing is strained";
    domain.energy.internal = 1 - domain.energy.kinetic;
    EXPECT_THROW(guard_kinetic_energy(one_node(s), domain, 0), NumericalError) << s;
  }
}

TEST(Guards, AContactThatMakesEnergyIsNamed) {
  domain::Domain domain = sample();
  domain.contacts.push_back({.id = 3, .worst_node = 11, .energy = -4.99});
  domain.energy.initial_total = 50;
  domain.energy.internal = 10;
  EXPECT_NO_THROW(guard_contact_energy(domain));
  domain.contacts[0].energy = -5.01;
  domain.contacts[0].withheld = {.count = 1, .largest = 5, .cycle = 4, .node = 12, .segment = 13};
  try {
    guard_contact_energy(domain);
    FAIL() << "not stopped";
  } catch (const NumericalError& error) {
    const std::string text = error.what();
    for (const char* const part : {"Contact 3", "node so far is 11", "node 12 on segment 13 in cycle 4",
                                   "cycle 1", "--allow-negative-contact-energy"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  domain.energy.initial_total = 102;  // early in an impact, little has been absorbed
  EXPECT_NO_THROW(guard_contact_energy(domain));
}

}  // namespace
}  // namespace crumple::timeloop::guards_test
