// SPDX-License-Identifier: BSD-3-Clause
//
// The resistance of joints in whole runs, against exact motions.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "constraints/rigid_motion.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::joint_stiffness_test {
namespace {

using math::Vec3;

constexpr std::array<bool, 3> all{true, true, true};
constexpr double spin = 0.5;

/// A block beside a held one, free to turn about one of the axes x, y, z through its centre, or to slide
/// along it, and set in motion so. A stiffness between the two, whose systems have the global axes; kg, mm,
/// ms.
model::Model resisted(int axis, bool slides) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  for (const double x : {-40.0, 0.0}) {
    const auto part = static_cast<Index>(model.rigid_bodies.size());
    if (part > 0) model.parts.push_back({.id = 2, .title = "block", .solid_section = 0, .material = 0});
    test::add_box(model, part, 2, 2, 2, [&](double u, double v, double w) {
      return test::Point{x + 20 * (u - 0.5), 10 * (v - 0.5), 10 * (w - 0.5)};
    });
    model::RigidBody& body = test::make_rigid(model, part);
    body.fixed_translation = body.fixed_rotation = all;
  }
  model::RigidBody& block = model.rigid_bodies[1];
  (slides ? block.fixed_translation : block.fixed_rotation)[static_cast<std::size_t>(axis)] = false;
  Vec3 direction;
  direction[axis] = spin;
  for (const Index node : block.nodes) {
    const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
    const Vec3 v = slides ? direction : cross(direction, Vec3{x[0], x[1], x[2]});
    model.initial_velocities.push_back({.node = node, .velocity = {v.x, v.y, v.z}});
  }
  model::JointStiffness stiffness;
  stiffness.id = 1;
  stiffness.is_translational = slides;
  stiffness.body = {0, 1};
  for (auto& axes : stiffness.axes) axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  model.joint_stiffnesses.push_back(stiffness);
  return model;
}

model::JointResistance& resistance(model::Model& model, int axis) {
  return model.joint_stiffnesses[0].resistance[static_cast<std::size_t>(axis)];
}

/// What resists a change of the velocity that is free.
double inertia_of(const model::Model& model, int axis, bool slides) {
  const timeloop::Simulation trial(model, test::execution());
  const domain::RigidBody& body = trial.domain().rigid_bodies[1];
  return slides ? body.mass
                : constraints::inertia_tensor(body, body.turn).column[static_cast<std::size_t>(axis)][axis];
}

std::string name_of(int axis, bool slides) {
  return std::string(slides ? "translational" : "generalized") + " joint stiffness, axis " +
         std::to_string(axis + 1) + ": ";
}

class Resistance : public ::testing::TestWithParam<std::pair<int, bool>> {};

TEST_P(Resistance, OfALinearCurveIsThatOfAnOscillator) {
  const auto [axis, slides] = GetParam();
  model::Model model = resisted(axis, slides);
  const double frequency = 2;
  const double stiffness = frequency * frequency * inertia_of(model, axis, slides);
  model.curves.push_back({7, {-10, 10}, {-10 * stiffness, 10 * stiffness}});
  resistance(model, axis).curve = 0;
  model.control.end_time = 7.25 * std::numbers::pi / frequency;
  timeloop::Simulation simulation(model, test::execution());
  double imbalance = 0;
  double offset = 0;
  test::run(simulation, [&](const domain::Domain& now) {
    if (now.clock.cycle == 1) offset = now.energy.imbalance();
    if (now.clock.cycle > 0)
      imbalance = test::larger_of(imbalance, std::fabs(now.energy.imbalance() - offset));
  });
  const domain::Domain& domain = simulation.domain();
  const double exact = spin / frequency * std::sin(frequency * domain.clock.time);
  // Central differences: the relative error of the frequency is (omega dt)^2 / 24.
  const double turned = frequency * domain.clock.time;
  const double step = frequency * domain.clock.step;
  const double allowed = 2 * turned * step * step / 24 + 1e-6;
  test::verified(name_of(axis, slides) + "oscillation on a linear curve after 3.6 periods", "sine")
      .near(domain.joint_stiffnesses[0].position[static_cast<std::size_t>(axis)], exact, allowed);
  test::verified(name_of(axis, slides) + "change of the energy balance over the energy", "conservation")
      .below(imbalance / domain.energy.initial_total, 1e-11);
  // At 7.25 half periods half of the energy is stored.
  EXPECT_NEAR(domain.joint_stiffnesses[0].energy / domain.energy.initial_total, 0.5, 5e-3);
}

TEST_P(Resistance, OfAStopGivesTheEnergyBack) {
  const auto [axis, slides] = GetParam();
  model::Model model = resisted(axis, slides);
  const double inertia = inertia_of(model, axis, slides);
  const double frequency = 10;
  resistance(model, axis).stiffness = frequency * frequency * inertia;
  resistance(model, axis).positive_stop = 0.6;
  resistance(model, axis).negative_stop = -0.3;
  // To the stop, half a period there, and on beyond the beginning.
  const double there = 0.6 / spin;
  const double turned = std::numbers::pi / frequency;
  model.control.end_time = 2 * there + turned + 0.2 / spin;
  timeloop::Simulation simulation(model, test::execution());
  double furthest = 0;
  // Clang 14 lets no lambda have a part of a structured binding.
  const auto place = static_cast<std::size_t>(axis);
  test::run(simulation, [&](const domain::Domain& now) {
    furthest = test::larger_of(furthest, now.joint_stiffnesses[0].position[place]);
  });
  const domain::Domain& domain = simulation.domain();
  test::verified(name_of(axis, slides) + "furthest position at a stop", "energy")
      .near(furthest, 0.6 + spin / frequency, 1e-4);
  test::verified(name_of(axis, slides) + "velocity after a stop over that before", "energy")
      .near(domain.joint_stiffnesses[0].rate[static_cast<std::size_t>(axis)] / spin, -1, 1e-3);
  EXPECT_NEAR(domain.joint_stiffnesses[0].position[static_cast<std::size_t>(axis)],
              -spin * (domain.clock.time - 2 * there - turned), 1e-3);
  EXPECT_LT(std::fabs(domain.joint_stiffnesses[0].energy), 1e-3 * domain.energy.initial_total);
}

TEST_P(Resistance, OfFrictionStopsTheMotionEvenly) {
  const auto [axis, slides] = GetParam();
  model::Model model = resisted(axis, slides);
  const double inertia = inertia_of(model, axis, slides);
  const double limit = 0.1 * inertia;
  resistance(model, axis).friction = limit;
  resistance(model, axis).stiffness = 1e4 * inertia;  // gives way after 1e-5
  model.control.end_time = 4;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  const double time = domain.clock.time;
  // In the first half step nothing has moved yet, and there is no friction.
  const double late = 0.1 * 0.5 * domain.clock.step * time;
  const double found = domain.joint_stiffnesses[0].position[static_cast<std::size_t>(axis)];
  test::verified(name_of(axis, slides) + "position against friction", "uniform deceleration")
      .near(found, spin * time - 0.05 * time * time + late, 1e-5);
  test::verified(name_of(axis, slides) + "friction energy over moment times angle, or force times way",
                 "exact")
      .near(domain.joint_stiffnesses[0].friction_energy / limit /
                domain.joint_stiffnesses[0].position[static_cast<std::size_t>(axis)],
            1, 1e-3);
  EXPECT_EQ(domain.energy.friction, domain.joint_stiffnesses[0].friction_energy);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-3 * domain.energy.initial_total);
}

TEST_P(Resistance, OfDampingDecaysTheMotion) {
  const auto [axis, slides] = GetParam();
  model::Model model = resisted(axis, slides);
  const double rate = 0.5;
  const double damping = rate * inertia_of(model, axis, slides);
  model.curves.push_back({7, {-10, 10}, {-10 * damping, 10 * damping}});
  resistance(model, axis).damping_curve = 0;
  model.control.end_time = 4;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  // The velocity is that of half a step ago: the rate of decay is off by half a step's share.
  test::verified(name_of(axis, slides) + "velocity with viscous damping over exact", "exponential")
      .near(domain.joint_stiffnesses[0].rate[static_cast<std::size_t>(axis)] /
                (spin * std::exp(-rate * (domain.clock.time - 0.5 * domain.clock.step))),
            1, 2 * rate * domain.clock.step);
  EXPECT_NEAR(domain.energy.damping,
              domain.energy.initial_total * (1 - std::exp(-2 * rate * domain.clock.time)),
              2e-3 * domain.energy.initial_total);
}

INSTANTIATE_TEST_SUITE_P(Axes, Resistance,
                         ::testing::Values(std::pair{0, false}, std::pair{1, false}, std::pair{2, false},
                                           std::pair{0, true}, std::pair{1, true}, std::pair{2, true}));

TEST(JointStiffness, CountsMoreThanOneTurn) {
  for (const int axis : {0, 2}) {
    model::Model model = resisted(axis, false);
    model.control.end_time = 30;
    timeloop::Simulation simulation(model, test::execution());
    test::run(simulation);
    const domain::Domain& domain = simulation.domain();
    EXPECT_NEAR(domain.joint_stiffnesses[0].position[static_cast<std::size_t>(axis)],
                spin * domain.clock.time, 1e-9);
  }
}

TEST(JointStiffness, ShortensTheStepWhereItIsStiff) {
  model::Model model = resisted(2, false);
  const double inertia = inertia_of(model, 2, false);
  const timeloop::Simulation free(model, test::execution());
  model.control.end_time = 0.5;
  resistance(model, 2).stiffness = 1e8 * inertia;
  resistance(model, 2).positive_stop = 0.1;
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  EXPECT_LT(1e4 * domain.clock.step, 1.0);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 0.02 * domain.energy.initial_total);
  EXPECT_LT(domain.joint_stiffnesses[0].rate[2], 0) << "it comes back";
}

/// Two free blocks with all resistances at once and a turn about no axis of theirs.
TEST(JointStiffness, KeepsTheMomentaOfFreeBodies) {
  for (const bool slides : {false, true}) {
    model::Model model = resisted(1, slides);
    model.initial_velocities.clear();
    for (model::RigidBody& body : model.rigid_bodies)
      body.fixed_translation = body.fixed_rotation = {false, false, false};
    const Vec3 turning{0.3, -0.2, 0.25};
    for (const Index node : model.rigid_bodies[1].nodes) {
      const auto& x = model.nodes.position[static_cast<std::size_t>(node)];
      const Vec3 v = Vec3{0.3, 0.1, -0.2} + cross(turning, Vec3{x[0], x[1], x[2]});
      model.initial_velocities.push_back({.node = node, .velocity = {v.x, v.y, v.z}});
    }
    model.curves.push_back({7, {-10, 10}, {-10, 10}});
    model.curves.push_back({8, {-10, 10}, {-0.1, 0.1}});
    for (int axis = 0; axis < 3; ++axis) {
      resistance(model, axis).curve = 0;
      resistance(model, axis).damping_curve = 1;
      resistance(model, axis).stiffness = 0.2;
      resistance(model, axis).friction = 0.001;
      resistance(model, axis).positive_stop = slides ? 0.01 : 0.1;
    }
    model.control.end_time = 5;
    timeloop::Simulation simulation(model, test::execution());
    std::array<Vec3, 2> start{};
    double change = 0;
    double imbalance = 0;
    double offset = 0;
    test::run(simulation, [&](const domain::Domain& now) {
      std::array<Vec3, 2> sum{};
      for (const domain::RigidBody& body : now.rigid_bodies) {
        sum[0] += body.mass * body.velocity;
        sum[1] += cross(body.centre, body.mass * body.velocity) + body.angular_momentum;
      }
      if (now.clock.cycle == 0) start = sum;
      if (now.clock.cycle == 1) offset = now.energy.imbalance();
      for (std::size_t i = 0; i < 2; ++i)
        change = test::larger_of(change, norm(sum[i] - start[i]) / norm(start[i]));
      if (now.clock.cycle > 0)
        imbalance = test::larger_of(imbalance, std::fabs(now.energy.imbalance() - offset));
    });
    const domain::Domain& domain = simulation.domain();
    test::verified(name_of(1, slides) + "two free bodies: change of both momenta", "conservation")
        .below(change, 1e-12);
    test::verified(name_of(1, slides) + "two free bodies: change of the energy balance over the energy",
                   "conservation")
        .below(imbalance / domain.energy.initial_total, 1e-12);
    EXPECT_GT(domain.joint_stiffnesses[0].friction_energy, 0);
    EXPECT_GT(domain.energy.damping, 0);
  }
}

}  // namespace
}  // namespace crumple::joint_stiffness_test
