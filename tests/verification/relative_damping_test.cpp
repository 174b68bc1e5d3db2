// SPDX-License-Identifier: BSD-3-Clause
//
// Damping against a rigid body (*DAMPING_RELATIVE).

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/conservation.hpp"
#include "support/larger.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::relative_damping_test {
namespace {

using math::Vec3;

constexpr double frequency = 0.5;
constexpr double share = 0.1;
constexpr double rate = 4 * std::numbers::pi * share * frequency;

/// Two boxes apart from each other: the first one rigid, the second one elastic; nothing but damping joins
/// them.
model::Model two_boxes() {
  model::Model model = test::one_solid_part(test::elastic_steel());
  model.parts.push_back(model.parts[0]);
  model.parts[1].id = 2;
  for (const Index part : {0, 1})
    test::add_box(model, part, 2, 2, 2, [&](double u, double v, double w) {
      return test::Point{20 * u + 40 * part - 10, 10 * v - 5, 10 * w - 5};
    });
  test::make_rigid(model, 0);
  model::RelativeDamping damping;
  damping.body = 0;
  damping.frequency = frequency;
  damping.share = share;
  damping.parts = {1};
  model.relative_dampings.push_back(damping);
  model.control.end_time = 1;
  return model;
}

void set_velocity(model::Model& model, Index part, const Vec3& velocity, double spin = 0) {
  for (const Index node : test::nodes_of_part(model, part)) {
    const auto& x = model.nodes.position[node];
    model.initial_velocities.push_back(
        {.node = node, .velocity = {velocity.x - spin * x[1], velocity.y + spin * x[0], velocity.z}});
  }
}

/// Mean velocity of the elastic box, weighed by mass.
Vec3 velocity_of_second(const domain::Domain& domain) {
  Vec3 sum;
  double mass = 0;
  for (Index node = 0; node < domain.nodes.count(); ++node) {
    if (!domain.nodes.is_free(node)) continue;
    sum += domain.nodes.mass[node] * domain.nodes.velocity[node];
    mass += domain.nodes.mass[node];
  }
  return (1 / mass) * sum;
}

TEST(RelativeDamping, DistanceOfVelocitiesDecaysAndMomentumStays) {
  model::Model model = two_boxes();
  // Along the line of the centres: nothing turns. Both boxes have the same mass.
  set_velocity(model, 0, {1, 0, 0});
  set_velocity(model, 1, {2, 0, 0});
  timeloop::Simulation simulation(model, test::execution());
  test::Conservation kept;
  double error = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    kept.watch(domain);
    if (domain.clock.cycle == 0) return;
    const double t = domain.clock.time + 0.5 * domain.clock.step;
    const double apart = velocity_of_second(domain).x - domain.rigid_bodies[0].velocity.x;
    error = test::larger_of(error, std::fabs(apart - std::exp(-2 * rate * t)));
  });
  test::verified("damping against a body: relative velocity, error", "exact").below(error, 5e-4);
  test::verified("damping against a body: momentum, drift", "conservation").below(kept.momentum_drift, 1e-10);
  test::verified("damping against a body: moment of momentum, drift", "conservation")
      .below(kept.turning_drift, 1e-8);
  test::verified("damping against a body: imbalance over the energy of the start", "conservation")
      .below(kept.worst_imbalance, 1e-6);
  const double lost = 0.25 * simulation.domain().rigid_bodies[0].mass * (1 - std::exp(-4 * rate));
  EXPECT_NEAR(simulation.domain().energy.damping, lost, 0.02 * lost);
}

TEST(RelativeDamping, LeavesWhatMovesWithTheBodyAlone) {
  model::Model model = two_boxes();
  for (const Index part : {0, 1}) set_velocity(model, part, {3, -1, 2}, 0);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_NEAR(norm(velocity_of_second(simulation.domain()) - Vec3{3, -1, 2}), 0, 1e-9);
  EXPECT_LT(simulation.domain().energy.damping, 1e-12 * simulation.domain().energy.initial_total);
}

TEST(RelativeDamping, AwayFromTheLineOfCentresTurnsTheBody) {
  model::Model model = two_boxes();
  set_velocity(model, 0, {0, 0, 0});
  set_velocity(model, 1, {0, 1, 0});
  timeloop::Simulation simulation(model, test::execution());
  test::Conservation kept;
  test::run(simulation, [&](const domain::Domain& domain) { kept.watch(domain); });
  EXPECT_GT(simulation.domain().rigid_bodies[0].angular_velocity.z, 1e-3);
  test::verified("damping against a body that turns: momentum, drift", "conservation")
      .below(kept.momentum_drift, 1e-10);
  test::verified("damping against a body that turns: imbalance over the energy of the start", "conservation")
      .below(kept.worst_imbalance, 1e-5);
}

// The limit is that of the pair: a light body is thrown to and fro by less than the nodes' own limit.
TEST(RelativeDamping, StepIsStableHoweverStrongTheDamping) {
  for (const double strength : {10.0, 1e3, 1e5}) {
    model::Model model = two_boxes();
    model.relative_dampings[0].share = strength;
    model.materials[1].density *= 1e-2;
    set_velocity(model, 0, {1, 0, 0});
    set_velocity(model, 1, {2, 1, 0});
    timeloop::Simulation simulation(model, test::execution());
    simulation.start();
    for (int cycle = 0; cycle < 3000; ++cycle) simulation.step();
    EXPECT_LT(simulation.domain().energy.kinetic, 1.1 * simulation.domain().energy.initial_total) << strength;
  }
}

}  // namespace
}  // namespace crumple::relative_damping_test
