// SPDX-License-Identifier: BSD-3-Clause
//
// Waves that leave a bar of solids through a non-reflecting boundary (*BOUNDARY_NON_REFLECTING). A boundary
// that resists motion by rho c has the impedance of the bar, so that a plane wave of normal incidence meets
// no change there (J. Lysmer, R.L. Kuhlemeyer, J. Eng. Mech. Div. ASCE 95 (1969) 859-877).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "model/solid_faces.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/ties.hpp"
#include "support/verified.hpp"

namespace crumple::non_reflecting_test {
namespace {

using math::Vec3;

constexpr double length = 100;
constexpr double young = 210;
constexpr double density = 7.85e-6;
constexpr double velocity = 0.01;
constexpr Index along = 100;

enum class Wave { Dilatational, Shear };

double speed(Wave wave, double poisson) {
  const double shear = young / (2 * (1 + poisson));
  const double modulus = wave == Wave::Shear ? shear : 2 * shear * (1 - poisson) / (1 - 2 * poisson);
  return std::sqrt(modulus / density);
}

/// The four nodes of an end, in the order of a segment.
std::array<Index, 4> end_of_bar(Index end) {
  const auto node = [&](Index j, Index k) { return end * along + (along + 1) * (j + 2 * k); };
  return {node(0, 0), node(1, 0), node(1, 1), node(0, 1)};
}

/// A bar along x with boundaries at these ends, as far as they act.
model::Model bar(double poisson, const std::vector<Index>& ends, bool normal = true, bool tangential = true) {
  model::Model model = test::one_solid_part(
      {.id = 1, .title = "bar", .density = density, .law = model::Elastic{young, poisson}});
  test::add_box(model, 0, along, 1, 1, [](double u, double v, double w) {
    return test::Point{length * u, v, w};
  });
  model.control.bulk_quadratic = model.control.bulk_linear = 0;  // what it takes stays in the bar as heat
  for (const Index end : ends)
    model.viscous_segments.push_back(
        {.node = end_of_bar(end), .solid = end * (along - 1), .normal = normal, .tangential = tangential});
  return model;
}

/// Nodes move along one axis alone, at first in the middle of the bar: half of the pulse goes each way.
void give_pulse(model::Model& model, Wave wave) {
  const std::size_t axis = wave == Wave::Dilatational ? 0 : 1;
  std::array<bool, 3> held{true, true, true};
  held[axis] = false;
  for (Index node = 0; node < model.nodes.count(); ++node) {
    model.fixed_nodes.push_back({.node = node, .translation = held});
    const double place = (model.nodes.position[node][0] - 0.5 * length) / (0.15 * length);
    if (std::fabs(place) >= 1) continue;
    std::array<double, 3> start{};
    start[axis] = velocity * std::pow(std::cos(0.5 * std::numbers::pi * place), 2);
    model.initial_velocities.push_back({.node = node, .velocity = start});
  }
}

struct Left {
  double energy = 0;     ///< kinetic and internal at the end over that of the start
  double imbalance = 0;  ///< largest, over the initial energy
  double damped = 0;     ///< over the initial energy
};

Left run_to_end(const model::Model& model, Precision precision = Precision::Double, int threads = 1) {
  timeloop::Simulation simulation(model, {precision, default_isa(), threads});
  Left left;
  test::run(simulation, [&](const domain::Domain& now) {
    left.imbalance =
        test::larger_of(left.imbalance, std::fabs(now.energy.imbalance()) / now.energy.initial_total);
  });
  const domain::EnergyLedger& energy = simulation.domain().energy;
  left.energy = (energy.kinetic + energy.internal + energy.hourglass) / energy.initial_total;
  left.damped = energy.damping / energy.initial_total;
  return left;
}

/// When both halves of the pulse would be in the middle again.
Left pulse_through_ends(Wave wave, bool normal, bool tangential, Precision precision = Precision::Double) {
  constexpr double poisson = 0.3;
  model::Model model = bar(poisson, {0, 1}, normal, tangential);
  give_pulse(model, wave);
  model.control.end_time = length / speed(wave, poisson);
  return run_to_end(model, precision);
}

TEST(NonReflecting, PulsesLeaveThroughTheEnds) {
  for (const Precision precision : {Precision::Double, Precision::Mixed})
    for (const Wave wave : {Wave::Dilatational, Wave::Shear}) {
      const Left left = pulse_through_ends(wave, true, true, precision);
      const std::string what = std::string("pulse of ") +
                               (wave == Wave::Shear ? "shear" : "longitudinal strain") +
                               " that leaves a bar of solids through both ends, " +
                               (precision == Precision::Double ? "double" : "mixed");
      std::printf("%s: energy left %.2e, imbalance %.1e, damped %.4f\n", what.c_str(), left.energy,
                  left.imbalance, left.damped);
      test::verified(what + ": energy that stays over that of the pulse",
                     "Lysmer and Kuhlemeyer, no reflection")
          .below(left.energy, 1e-5);
      test::verified(what + ": energy error over the initial energy", "conservation")
          .below(left.imbalance, 1e-7);
    }
}

TEST(NonReflecting, EndsThatAreTurnedOffReflect) {
  EXPECT_LT(pulse_through_ends(Wave::Dilatational, true, false).energy, 1e-2);
  EXPECT_LT(pulse_through_ends(Wave::Shear, false, true).energy, 1e-2);
  EXPECT_GT(pulse_through_ends(Wave::Dilatational, false, true).energy, 0.95);
  EXPECT_GT(pulse_through_ends(Wave::Shear, true, false).energy, 0.95);
}

/// Behind the front that runs from the boundary a bar that flies has half its velocity, behind the one that
/// comes back from the free end none: momentum and energy are gone after 2 L / c.
TEST(NonReflecting, AFlyingBarIsStoppedByOneEnd) {
  model::Model model = bar(0, {1});
  const double c = speed(Wave::Dilatational, 0);
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {velocity, 0, 0}});
  model.control.end_time = 2.4 * length / c;
  timeloop::Simulation simulation(model, test::execution());
  const double whole = density * length * velocity;
  double worst = 0;
  double imbalance = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    const double reached = std::min(1.0, 0.5 * (now.clock.time + 0.5 * simulation.next_step()) * c / length);
    worst = test::larger_of(worst, std::fabs(test::momentum(now).x / whole - (1 - reached)));
    imbalance = test::larger_of(imbalance, std::fabs(now.energy.imbalance()) / now.energy.initial_total);
  });
  const domain::EnergyLedger& energy = simulation.domain().energy;
  std::printf("flying bar: momentum %.2e, imbalance %.1e, damped %.5f\n", worst, imbalance,
              energy.damping / energy.initial_total);
  test::verified("flying bar stopped by a non-reflecting end: momentum over the initial one",
                 "wave equation, exact")
      .below(worst, 0.01);
  test::verified("flying bar stopped by a non-reflecting end: damped energy over the initial one",
                 "wave equation, exact")
      .near(energy.damping / energy.initial_total, 1, 0.01);
  test::verified("flying bar stopped by a non-reflecting end: energy error over the initial energy",
                 "conservation")
      .below(imbalance, 1e-6);
}

/// Turned in space, without supports: the boundary follows the normals of its segments.
TEST(NonReflecting, TheDirectionOfTheBarMakesNoDifference) {
  std::vector<double> energy;
  for (const bool turned : {false, true}) {
    model::Model model = bar(0, {0, 1});
    const Vec3 e1{0.48, 0.64, 0.6};
    const Vec3 e2{-0.8, 0.6, 0};
    const Vec3 e3 = cross(e1, e2);
    for (Index node = 0; node < model.nodes.count(); ++node) {
      std::array<double, 3>& x = model.nodes.position[node];
      const double place = (x[0] - 0.5 * length) / (0.15 * length);
      const double size = std::fabs(place) < 1 ? std::pow(std::cos(0.5 * std::numbers::pi * place), 2) : 0;
      const Vec3 v = velocity * size * (turned ? e1 : Vec3{1, 0, 0});
      if (size > 0) model.initial_velocities.push_back({.node = node, .velocity = {v.x, v.y, v.z}});
      const Vec3 moved = x[0] * e1 + x[1] * e2 + x[2] * e3;
      if (turned) x = {moved.x, moved.y, moved.z};
    }
    model.control.end_time = 0.6 * length / speed(Wave::Dilatational, 0);
    energy.push_back(run_to_end(model).energy);
  }
  EXPECT_LT(energy[0], 0.9);
  EXPECT_NEAR(energy[0], energy[1], 1e-6);
}

/// A single cube whose nodes have three dashpots each: far more than an explicit force would stand, c dt / m
/// being above 2. The motion dies away, and the step is that without a boundary.
TEST(NonReflecting, TakesEnergyHoweverStiffItIs) {
  const auto cube = [](bool boundary) {
    model::Model model = test::one_solid_part(test::elastic_steel());
    test::add_box(model, 0, 1, 1, 1, [](double u, double v, double w) { return test::Point{u, v, w}; });
    for (Index node = 0; node < model.nodes.count(); ++node)
      model.initial_velocities.push_back(
          {.node = node, .velocity = {0.1 * (node % 3), 0.1 * (node % 2), -0.05 * (node % 5)}});
    constexpr std::array<std::array<Index, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    if (boundary)
      for (const auto& face : faces) model.viscous_segments.push_back({.node = face, .solid = 0});
    model.control.end_time = 0.01;
    model.control.step_scale = 0.9;
    return model;
  };
  const model::Model free_model = cube(false);
  timeloop::Simulation free_cube(free_model, test::execution());
  free_cube.start();
  const model::Model model = cube(true);
  timeloop::Simulation simulation(model, test::execution());
  double first = 0;
  double last = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    last = 0;
    for (Index node = 0; node < now.nodes.count(); ++node)
      last = test::larger_of(last, norm(now.nodes.velocity[node]));
    if (now.clock.cycle == 0) {
      first = last;
      EXPECT_EQ(simulation.next_step(), free_cube.next_step());
    }
    EXPECT_LE(last, first);
    EXPECT_LT(std::fabs(now.energy.imbalance()), 1e-6 * now.energy.initial_total);
  });
  EXPECT_LT(last, 1e-6 * first);
}

/// No static force: a bar that is pulled with a constant force at one end moves away, in the end with the
/// velocity at which the dashpots carry the force.
TEST(NonReflecting, GivesWayToAStaticLoadAtAConstantVelocity) {
  model::Model model = bar(0, {1});
  const double force = 1e-3;
  for (const Index node : end_of_bar(0))
    model.nodal_loads.push_back({.node = node, .force = {0.25 * force, 0, 0}});
  const double impedance = density * speed(Wave::Dilatational, 0);
  model.control.end_time = 2.4 * length / speed(Wave::Dilatational, 0);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double found = test::momentum(domain).x / (density * length);
  test::verified("bar under a constant force, with a non-reflecting end: velocity over that of the dashpots",
                 "wave equation, exact")
      .near(found * impedance / force, 1, 0.02);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3 * domain.energy.external_work);
}

/// Nodes that a rigid body moves have no dashpots: the bar keeps its momentum.
TEST(NonReflecting, DoesNotActOnNodesOfARigidBody) {
  model::Model model = bar(0, {1});
  model::RigidBody plate;
  plate.id = 7;
  const auto end = end_of_bar(1);
  plate.nodes.assign(end.begin(), end.end());
  std::sort(plate.nodes.begin(), plate.nodes.end());
  model.rigid_bodies.push_back(plate);
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {velocity, 0, 0}});
  model.control.end_time = length / speed(Wave::Dilatational, 0);
  const Left left = run_to_end(model);
  EXPECT_NEAR(left.energy, 1, 1e-9);
  EXPECT_EQ(left.damped, 0);
}

/// A node that follows a segment is not the boundary's to stop.
TEST(NonReflecting, RefusesTiedNodes) {
  model::Model model = test::two_blocks(1, 1, 1, model::TieMethod::Constraint);
  timeloop::Simulation simulation(model, test::execution());
  const domain::NodeFields& nodes = simulation.domain().nodes;
  for (std::size_t solid = 0; solid < model.solids.size(); ++solid)
    for (const std::array<Index, 4>& face : model::faces_of(model.solids[solid]))
      if (std::any_of(face.begin(), face.end(),
                      [&](Index node) { return nodes.is_tied(nodes.domain_node[node]); }))
        model.viscous_segments.push_back({.node = face, .solid = static_cast<Index>(solid)});
  ASSERT_FALSE(model.viscous_segments.empty());
  EXPECT_THROW(timeloop::Simulation(model, test::execution()), Error);
}

/// The boundary of a solid ends with it.
TEST(NonReflecting, EndsWithTheSolid) {
  model::Model model = bar(0, {1});
  model.materials[0].erosion.emplace();
  model.materials[0].erosion->time = 0.2 * length / speed(Wave::Dilatational, 0);
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.initial_velocities.push_back({.node = node, .velocity = {velocity, 0, 0}});
  model.control.end_time = 0.4 * length / speed(Wave::Dilatational, 0);
  timeloop::Simulation simulation(model, test::execution());
  double damped = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    if (now.clock.time < 0.55 * model.control.end_time) damped = now.energy.damping;
  });
  EXPECT_GT(damped, 0);
  EXPECT_NEAR(simulation.domain().energy.damping, damped, 1e-9 * damped);
}

}  // namespace
}  // namespace crumple::non_reflecting_test
