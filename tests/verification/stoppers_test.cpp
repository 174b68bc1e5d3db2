// SPDX-License-Identifier: BSD-3-Clause
//
// *CONSTRAINED_RIGID_BODY_STOPPERS. A rigid block runs under a constant force into a bound: until then it has
// the motion of a free body, from then on it is where the bound is. Exact: rigid body mechanics.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.hpp"
#include "support/conservation.hpp"
#include "support/largest.hpp"
#include "support/rigid.hpp"
#include "support/shapes.hpp"
#include "support/verified.hpp"

namespace crumple::stoppers_test {
namespace {

constexpr double mass = 10.0 * 10.0 * 10.0 * 7.85e-6;
constexpr double acceleration = 8;  // mm/ms^2

model::RigidBodyLoad push(const std::array<double, 3>& force) {
  model::RigidBodyLoad load;
  load.body = 0;
  load.force = force;
  load.curve = 0;
  return load;
}

/// mm, ms, kg: a cube of 10 with its centre at (5, 5, 5), pushed along x.
model::Model pushed_block() {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 2, 2, 2, [](double u, double v, double w) {
    return test::Point{10 * u, 10 * v, 10 * w};
  });
  test::make_rigid(model, 0);
  test::add_constant_curve(model, 1.0);
  model.rigid_body_loads.push_back(push({acceleration * mass, 0, 0}));
  model.control.end_time = 2;
  return model;
}

/// Of the block, along a direction; without bounds so far.
model::RigidBodyStopper along(const std::array<double, 3>& direction) {
  model::RigidBodyStopper stopper;
  stopper.body = 0;
  stopper.direction = direction;
  return stopper;
}

/// Bound along x by a curve over time, of the displacement.
void stop(model::Model& model, const model::Curve& curve) {
  model.curves.push_back(curve);
  model::RigidBodyStopper stopper = along({1, 0, 0});
  stopper.largest = {static_cast<Index>(model.curves.size()) - 1, true};
  model.rigid_body_stoppers.push_back(stopper);
}

double displacement(const domain::Domain& domain) {
  return domain.rigid_bodies[0].centre.x - 5;
}

TEST(Stoppers, BodyStopsAtItsBoundAndStays) {
  model::Model model = pushed_block();
  stop(model, {2, {0, 1e6}, {4, 4}});
  timeloop::Simulation simulation(model, test::execution());
  test::Largest path("rigid block pushed against a stopper: displacement over the way to it, error",
                     "rigid body mechanics", 2e-3);
  test::run(simulation, [&](const domain::Domain& domain) {
    const double time = domain.clock.time;
    path.compare(displacement(domain), std::min(4.0, 0.5 * acceleration * time * time), 4,
                 "time " + std::to_string(time));
  });
  const domain::Domain& domain = simulation.domain();
  std::printf("displacement %.15g, work %.6g, imbalance %.1e\n", displacement(domain),
              domain.energy.external_work, domain.energy.imbalance());
  test::verified("rigid block pushed against a stopper: displacement at the end over the bound", "exact")
      .near(displacement(domain) / 4, 1, 1e-14);
  // The force has done what the stop has taken, but for the first half step of a force that begins at once.
  const double taken = acceleration * mass * 4;
  EXPECT_LT(std::fabs(domain.energy.external_work), 1e-7 * taken);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-7 * taken);
}

TEST(Stoppers, TakeTheKineticEnergyOfAFreeBody) {
  model::Model model = pushed_block();
  model.rigid_body_loads.clear();
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = {7, 2, 0}, .angular_velocity = {}});
  stop(model, {2, {0, 1e6}, {4, 4}});
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::Domain& domain = simulation.domain();
  EXPECT_NEAR(displacement(domain), 4, 1e-13);
  EXPECT_NEAR(domain.rigid_bodies[0].centre.y - 5, 2 * domain.clock.time, 1e-11);
  test::verified("rigid block that a stopper stops: work over its kinetic energy along the stopper", "exact")
      .near(domain.energy.external_work / (0.5 * mass * 49), -1, 1e-12);
  EXPECT_LT(std::fabs(domain.energy.imbalance()), 1e-13 * mass * 49);
}

TEST(Stoppers, BodyMovesWithAMovingBoundAndLeavesIt) {
  model::Model model = pushed_block();
  // Goes back at a speed of 3 from a time of 1.2 on.
  stop(model, {2, {0, 1.2, 2, 1e6}, {4, 4, 1.6, 1.6}});
  // Pulled back from 2 on.
  model.curves[0] = {1, {0, 2, 2.0001, 1e6}, {1, 1, -1, -1}};
  model.control.end_time = 2.5;
  timeloop::Simulation simulation(model, test::execution());
  test::Largest path("rigid block pushed against a stopper that moves: displacement over the bound, error",
                     "the bound's curve", 1e-12);
  test::run(simulation, [&](const domain::Domain& domain) {
    const double time = domain.clock.time;
    if (time > 1.1 && time < 2) path.compare(displacement(domain), model.curves[1].at(time), 4);
  });
  const double since = 0.5;
  const double exact = 1.6 - 3 * since - 0.5 * acceleration * since * since;
  test::verified("rigid block pulled off a stopper: displacement over exact", "rigid body mechanics")
      .near(displacement(simulation.domain()) / exact, 1, 0.005);
  EXPECT_LT(std::fabs(simulation.domain().energy.imbalance()), 1e-7 * acceleration * mass * 4);
}

TEST(Stoppers, SpeedIsBounded) {
  model::Model model = pushed_block();
  model.curves.push_back({2, {0, 1e6}, {5, 5}});
  model::RigidBodyStopper stopper = along({-1, 0, 0});
  stopper.speed_curve = 1;
  stopper.death_time = 1.5;
  model.rigid_body_stoppers.push_back(stopper);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const double until = 5 / acceleration;
  const double exact =
      0.5 * acceleration * until * until + 5 * (1.5 - until) + 5 * 0.5 + 0.5 * acceleration * 0.25;
  test::verified("rigid block with a largest speed for some time: displacement over exact",
                 "rigid body mechanics")
      .near(displacement(simulation.domain()) / exact, 1, 0.005);
}

/// A stopper that begins to act when the body is beyond its bound holds it where it is, and lets it go back.
TEST(Stoppers, BodyBeyondIsNotThrownBack) {
  model::Model model = pushed_block();
  stop(model, {2, {0, 1e6}, {4, 4}});
  model.rigid_body_stoppers[0].birth_time = 1.5;
  model.curves[0] = {1, {0, 2, 2.0001, 1e6}, {1, 1, -1, -1}};
  model.control.end_time = 2.5;
  timeloop::Simulation simulation(model, test::execution());
  double fastest = 0;
  double stayed = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const double time = domain.clock.time;
    fastest = std::max(fastest, std::fabs(domain.rigid_bodies[0].velocity.x));
    if (time < 1.9) stayed = displacement(domain);
  });
  const double birth = 0.5 * acceleration * 1.5 * 1.5;
  test::verified("rigid block beyond a stopper that begins to act: displacement it stays at over exact",
                 "rigid body mechanics")
      .near(stayed / birth, 1, 0.005);
  test::verified("rigid block beyond a stopper that begins to act: largest speed over exact",
                 "rigid body mechanics")
      .near(fastest / (acceleration * 1.5), 1, 0.005);
  test::verified("rigid block beyond a stopper, pulled back: displacement over exact", "rigid body mechanics")
      .near(displacement(simulation.domain()) / (birth - 0.5 * acceleration * 0.25), 1, 0.005);
}

TEST(Stoppers, FixedAxesStayFixed) {
  model::Model model = pushed_block();
  model.rigid_bodies[0].fixed_translation = {true, false, false};
  stop(model, {2, {0, 2, 1e6}, {1, -3, -3}});
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_EQ(displacement(simulation.domain()), 0);
}

TEST(Stoppers, SayThatTheBodyStartsBeyond) {
  model::Model model = pushed_block();
  stop(model, {2, {0, 1e6}, {-1, -1}});
  try {
    const timeloop::Simulation simulation(model, test::execution());
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("beyond the largest (LCMAX), 4.0"), std::string::npos)
        << error.what();
  }
}

/// The coordinate itself, downwards and along y; the other directions stay free.
TEST(Stoppers, CoordinateAndSmallestBound) {
  model::Model model = pushed_block();
  model.rigid_body_loads.push_back(push({0, -acceleration * mass, 0}));
  model.curves.push_back({2, {0, 1e6}, {2, 2}});
  model::RigidBodyStopper stopper = along({0, 1, 0});
  stopper.smallest = {1, false};
  model.rigid_body_stoppers.push_back(stopper);
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  EXPECT_NEAR(simulation.domain().rigid_bodies[0].centre.y, 2, 1e-13);
  EXPECT_NEAR(displacement(simulation.domain()), 0.5 * acceleration * 4, 0.02);
}

}  // namespace
}  // namespace crumple::stoppers_test
