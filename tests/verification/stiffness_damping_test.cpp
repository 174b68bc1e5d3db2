// SPDX-License-Identifier: BSD-3-Clause
//
// Damping in proportion to stiffness (*DAMPING_PART_STIFFNESS): free bars in one of their modes, which are
// oscillators of one degree of freedom each.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/conservation.hpp"
#include "support/larger.hpp"
#include "support/lines.hpp"
#include "support/verified.hpp"

namespace crumple::stiffness_damping_test {
namespace {

using math::Vec3;
using model::ShellFormulation;
using model::SolidFormulation;
using test::Point;

constexpr Index elements = 8;
constexpr double young = 100;
constexpr double density = 1e-2;
constexpr double wave_speed = 100;  ///< sqrt(E / rho), elements of unit size
constexpr double speed = 1e-4;

model::Material material() {
  return {.id = 1, .title = "m", .density = density, .law = model::Elastic{young, 0}};
}

/// A bar along x, of unit cross section and unit elements, which is free.
model::Model truss_bar() {
  model::BeamSection section;
  section.id = 1;
  section.formulation = model::BeamFormulation::Truss;
  section.area = 1;
  model::Model model = test::one_beam_part(material(), section);
  test::add_line(model, elements, {}, [](double u) { return Point{elements * u, 0, 0}; });
  return model;
}
model::Model beam_bar() {
  model::Model model = test::one_beam_part(material(), test::rectangle(1, 1, 0.14));
  test::add_line(model, elements, {0, 0, 1}, [](double u) { return Point{elements * u, 0, 0}; });
  return model;
}
model::Model shell_bar(ShellFormulation formulation) {
  model::Model model = test::one_part(material(), test::shell_section(1, 3, formulation));
  test::add_grid(model, 0, elements, 1, [](double u, double v) { return Point{elements * u, v, 0}; });
  if (formulation == ShellFormulation::Triangle) {
    std::vector<model::ShellElement> split;
    for (const model::ShellElement& s : model.shells)
      for (const std::array<Index, 4>& node :
           {std::array<Index, 4>{s.node[0], s.node[1], s.node[2], s.node[2]},
            std::array<Index, 4>{s.node[0], s.node[2], s.node[3], s.node[3]}})
        split.push_back({.id = static_cast<UserId>(split.size()) + 1, .part = 0, .node = node});
    model.shells = std::move(split);
  }
  return model;
}
model::Model solid_bar(SolidFormulation formulation) {
  model::Model model = test::one_solid_part(material());
  model.solid_sections[0].formulation = formulation;
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  test::add_box(model, 0, elements, 1, 1, [](double u, double v, double w) {
    return Point{elements * u, v, w};
  });
  if (model::is_tetrahedral(formulation)) test::split_into_tetrahedra(model);
  return model;
}

double shape(int mode, double x) {
  return std::cos(mode * std::numbers::pi * x / elements);
}

/// Of a row of point masses, those at its ends half of the others.
double frequency(int mode) {
  return 2 * wave_speed * std::sin(0.5 * mode * std::numbers::pi / elements);
}

/// Largest error of the velocity over that of the start, and of the energy over that of the start.
struct Errors {
  double velocity = 0;
  double energy = 0;
  double ratio = 0;  ///< damping of the mode, share of critical
};

/// Runs the bar in a mode for three periods, and compares the velocity of its first node with the
/// oscillator's. Where `share` is given, beta follows from the first step.
Errors decay(model::Model model, int mode, const model::StiffnessDamping& damping, double step_scale,
             Precision precision = Precision::Double) {
  model.parts[0].damping = damping;
  const double omega = frequency(mode);
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back(
        {.node = node, .velocity = {speed * shape(mode, model.nodes.position[node][0]), 0, 0}});
  model.control.step_scale = step_scale;
  model.control.end_time = 3 * 2 * std::numbers::pi / omega;
  domain::Execution execution = test::execution();
  execution.precision = precision;
  timeloop::Simulation simulation(model, execution);
  Errors found;
  double beta = damping.beta;
  const Index first = simulation.domain().nodes.domain_node[0];
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.cycle == 0) {
      const double x = damping.share;
      if (x > 0) beta = x * domain.clock.element_limit / (std::sqrt(1 + x * x) - x);
      found.ratio = 0.5 * beta * omega;
      return;
    }
    const double damped = omega * std::sqrt(1 - found.ratio * found.ratio);
    // The velocities are half a step ahead of the time.
    const double t = domain.clock.time + 0.5 * domain.clock.step;
    const double phase = damped * t;
    const double exact = speed * std::exp(-found.ratio * omega * t) *
                         (std::cos(phase) - found.ratio * omega / damped * std::sin(phase));
    found.velocity =
        test::larger_of(found.velocity, std::fabs(domain.nodes.velocity[first].x - exact) / speed);
    found.energy =
        test::larger_of(found.energy, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  const double left = std::exp(-2 * found.ratio * omega * simulation.domain().clock.time);
  EXPECT_GT(simulation.domain().energy.damping, 0.7 * (1 - left) * simulation.domain().energy.initial_total);
  return found;
}

struct Bar {
  std::string name;
  model::Model model;
};
std::vector<Bar> bars() {
  std::vector<Bar> found{{"trusses", truss_bar()}, {"beams", beam_bar()}};
  for (const auto& [name, formulation] : {std::pair{"shells 1", ShellFormulation::HughesLiu},
                                          std::pair{"shells 2", ShellFormulation::BelytschkoTsay},
                                          std::pair{"shells 6", ShellFormulation::HughesLiuSelectiveReduced},
                                          std::pair{"shells 10", ShellFormulation::BelytschkoWongChiang},
                                          std::pair{"shells 16", ShellFormulation::FullyIntegrated}})
    found.push_back({name, shell_bar(formulation)});
  for (const auto& [name, formulation] : {std::pair{"solids 1", SolidFormulation::OnePointHexahedron},
                                          std::pair{"solids 2", SolidFormulation::SelectiveHexahedron}})
    found.push_back({name, solid_bar(formulation)});
  return found;
}

TEST(StiffnessDamping, ModesDecayAsRayleighSays) {
  const double beta = 2 * 0.05 / frequency(2);
  for (const Bar& bar : bars()) {
    SCOPED_TRACE(bar.name);
    const Errors coarse = decay(bar.model, 2, {.beta = beta}, 0.02);
    const Errors fine = decay(bar.model, 2, {.beta = beta}, 0.01);
    test::verified(
        "bar of " + bar.name + ", beta = 0.1 / omega of mode 2: velocity, error over the first one", "exact")
        .below(fine.velocity, 1.5e-3);
    // The velocity is half a step late: an error of the first order.
    EXPECT_LT(fine.velocity, 0.6 * coarse.velocity);
    test::verified("bar of " + bar.name + ": imbalance over the energy of the start", "conservation")
        .below(fine.energy, 1e-7);
  }
}

TEST(StiffnessDamping, ShareOfCriticalHoldsAtTheHighestFrequency) {
  for (const Bar& bar : bars()) {
    SCOPED_TRACE(bar.name);
    for (const int mode : {1, static_cast<int>(elements)}) {
      const Errors found = decay(bar.model, mode, {.share = 0.1}, 0.01);
      EXPECT_LT(found.velocity, 5e-3) << mode;
      // Of the bar's highest mode it is the share itself, if the stable step is the exact one; less of
      // others.
      if (bar.name == "trusses")
        test::verified("bar of trusses: damping of mode " + std::to_string(mode) + ", share of critical",
                       "exact")
            .within(found.ratio, 0.1 * std::sin(0.5 * mode * std::numbers::pi / elements), 1e-6);
      EXPECT_LT(found.ratio, 0.1 * (1 + 1e-6));
    }
  }
}

TEST(StiffnessDamping, IsTheSameInMixedPrecision) {
  const double beta = 2 * 0.05 / frequency(2);
  for (const Bar& bar : bars()) {
    SCOPED_TRACE(bar.name);
    EXPECT_LT(decay(bar.model, 2, {.beta = beta}, 0.02, Precision::Mixed).velocity, 4e-3);
  }
}

// Triangles and tetrahedra have no mode of one row; with the dilatation of the nodes only shears are damped.
TEST(StiffnessDamping, OfAllElementsTakesEnergyAndKeepsMomentum) {
  std::vector<Bar> all = bars();
  all.push_back({"triangles", shell_bar(ShellFormulation::Triangle)});
  all.push_back({"tetrahedra", solid_bar(SolidFormulation::Tetrahedron)});
  all.push_back({"nodal pressure tetrahedra", solid_bar(SolidFormulation::NodalPressureTetrahedron)});
  for (Bar& bar : all) {
    SCOPED_TRACE(bar.name);
    bar.model.parts[0].damping = model::StiffnessDamping{.share = 0.2};
    bar.model.control.step_scale = 0.5;
    bar.model.control.end_time = 1;
    for (Index node = 0; node < bar.model.nodes.count(); ++node) {
      const Point& x = bar.model.nodes.position[node];
      bar.model.initial_velocities.push_back(
          {.node = node,
           .velocity = {1e-3 * shape(3, x[0]), 0.2e-3 * shape(2, x[0]) + 1e-3 * x[1] * shape(1, x[0]),
                        1e-4}});
    }
    timeloop::Simulation simulation(bar.model, test::execution());
    test::Conservation kept;
    double before = 0;
    test::run(simulation, [&](const domain::Domain& now) {
      kept.watch(now);
      // The mean of two steps may have the other sign where a rate has changed it.
      EXPECT_GE(now.energy.damping, before - 1e-2 * now.energy.initial_total);
      before = now.energy.damping;
    });
    EXPECT_LT(kept.momentum_drift, 1e-10);
    EXPECT_LT(kept.turning_drift, 1e-10);
    EXPECT_GT(before, 0.1 * simulation.domain().energy.initial_total);
    test::verified("damped bar of " + bar.name + ": imbalance over the energy of the start", "conservation")
        .below(kept.worst_imbalance, 1e-4);
  }
}

// A stable step without regard to the damping would let every one of these grow.
TEST(StiffnessDamping, StepIsStableHoweverStrongTheDamping) {
  for (Bar& bar : bars()) {
    SCOPED_TRACE(bar.name);
    for (const model::StiffnessDamping& damping :
         {model::StiffnessDamping{.share = 1}, model::StiffnessDamping{.share = 10},
          model::StiffnessDamping{.beta = 0.02}, model::StiffnessDamping{.beta = 1}}) {
      model::Model model = bar.model;
      model.parts[0].damping = damping;
      model.control.step_scale = 0.9;
      for (Index node = 0; node < model.nodes.count(); ++node)
        model.initial_velocities.push_back(
            {.node = node,
             .velocity = {speed * shape(static_cast<int>(elements), model.nodes.position[node][0]), 0, 0}});
      timeloop::Simulation simulation(model, test::execution());
      simulation.start();
      for (int cycle = 0; cycle < 3000; ++cycle) simulation.step();
      EXPECT_LT(simulation.domain().energy.kinetic, 0.1 * simulation.domain().energy.initial_total);
      EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()), simulation.domain().energy.initial_total);
    }
  }
}

// A rod that turns fast is strained by what its inertia stretches it by alone: that does not change, and
// nothing is damped.
TEST(StiffnessDamping, LeavesRigidMotionAlone) {
  for (Bar& bar : bars()) {
    SCOPED_TRACE(bar.name);
    const double spin = 0.1;  // the ends move with 0.4 % of the wave speed
    for (const bool damped : {false, true}) {
      model::Model model = bar.model;
      if (damped) model.parts[0].damping = model::StiffnessDamping{.share = 0.1};
      model.control.end_time = 2 * std::numbers::pi / spin / 4;
      for (Index node = 0; node < model.nodes.count(); ++node) {
        const Point& x = model.nodes.position[node];
        model.initial_velocities.push_back({.node = node,
                                            .velocity = {-spin * (x[1] - 0.5), spin * (x[0] - 4), 0},
                                            .angular_velocity = {0, 0, spin}});
      }
      timeloop::Simulation simulation(model, test::execution());
      test::Conservation kept;
      test::run(simulation, [&](const domain::Domain& now) { kept.watch(now); });
      const domain::EnergyLedger& energy = simulation.domain().energy;
      EXPECT_LT(kept.turning_drift, 1e-9);
      // What starts suddenly swings about the stretch of steady rotation: at most that energy can be taken.
      EXPECT_LT(energy.damping, 1e-4 * energy.initial_total);
      if (damped)
        EXPECT_GT(energy.damping, 0);
      else
        EXPECT_EQ(energy.damping, 0);
    }
  }
}

/// One beam that is free, its ends turning against each other.
Errors turning_beam(const Vec3& axis, double stiffness) {
  model::Model model = test::one_beam_part(material(), test::rectangle(1, 1, 0.14));
  test::add_line(model, 1, {0, 0, 1}, [](double u) { return Point{u, 0, 0}; });
  for (const Index node : {0, 1})
    model.initial_velocities.push_back(
        {.node = node,
         .velocity = {},
         .angular_velocity = {(node == 0 ? -1 : 1) * speed * axis.x, (node == 0 ? -1 : 1) * speed * axis.y,
                              (node == 0 ? -1 : 1) * speed * axis.z}});
  model.control.step_scale = 0.01;
  timeloop::Simulation measure(model, test::execution());
  const double inertia = measure.domain().nodes.inertia[0];
  const double omega = std::sqrt(2 * stiffness / inertia);
  const double ratio = 0.05;
  model.parts[0].damping = model::StiffnessDamping{.beta = 2 * ratio / omega};
  model.control.end_time = 3 * 2 * std::numbers::pi / omega;
  timeloop::Simulation simulation(model, test::execution());
  const double damped = omega * std::sqrt(1 - ratio * ratio);
  Errors found;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.clock.cycle == 0) return;
    const double t = domain.clock.time + 0.5 * domain.clock.step;
    const double exact = speed * std::exp(-ratio * omega * t) *
                         (std::cos(damped * t) - ratio * omega / damped * std::sin(damped * t));
    const Vec3 now = domain.nodes.angular_velocity[domain.nodes.domain_node[1]];
    found.velocity = test::larger_of(found.velocity, std::fabs(dot(now, axis) - exact) / speed);
    found.energy =
        test::larger_of(found.energy, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  return found;
}

TEST(StiffnessDamping, OfBeamsActsOnTorsionAndBending) {
  const double shear_modulus = young / 2;
  const Errors torsion = turning_beam({1, 0, 0}, shear_modulus * 0.14);
  const Errors bending = turning_beam({0, 1, 0}, young / 12);
  test::verified("twisted beam: angular velocity, error over the first one", "exact")
      .below(torsion.velocity, 2e-3);
  test::verified("bent beam: angular velocity, error over the first one", "exact")
      .below(bending.velocity, 2e-3);
  test::verified("twisted and bent beam: imbalance over the energy of the start", "conservation")
      .below(test::larger_of(torsion.energy, bending.energy), 1e-10);
}

}  // namespace
}  // namespace crumple::stiffness_damping_test
