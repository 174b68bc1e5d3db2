// SPDX-License-Identifier: BSD-3-Clause
//
// A rigid wall of mass M strikes elastic bars, rigid blocks and balls. Exact for a bar of mass m, section A
// and impedance rho c (St Venant; S.P. Timoshenko, J.N. Goodier, Theory of Elasticity, 3rd ed., article 169):
// until the wave is back at 2 L / c the wall's velocity is V exp(-rho c A t / M). A free bar then leaves; a
// bar that is held pushes the wall back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/drawn.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/rigid.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::moving_mass_wall_test {
namespace {

using math::Vec3;

constexpr double length = 100.0;
constexpr double width = 2.0;
constexpr double thickness = 1.0;
constexpr double young = 210.0;
constexpr double density = 7.85e-6;
constexpr double speed = 0.01;
constexpr double bar_mass = density * length * width * thickness;

double wave_speed() {
  return std::sqrt(young / density);
}

/// A bar without lateral contraction along x at rest, and a wall at x = 0 that comes with `speed`.
model::Model struck_bar(Index elements, double mass_ratio) {
  model::Model model =
      test::one_part({.id = 1, .title = "bar", .density = density, .law = model::Elastic{young, 0.0}},
                     test::shell_section(thickness, 2));
  test::add_grid(model, 0, elements, 1, [](double u, double v) {
    return test::Point{u * length, v * width, 0};
  });
  model::RigidWall wall;
  wall.id = 1;
  wall.normal = {1, 0, 0};
  wall.mass = mass_ratio * bar_mass;
  wall.initial_velocity = speed;
  for (Index i = 0; i < model.nodes.count(); ++i) wall.nodes.push_back(i);
  model.rigid_walls.push_back(wall);
  return model;
}

void hold_far_end(model::Model& model, Index elements) {
  for (Index row = 0; row < 2; ++row)
    model.fixed_nodes.push_back(
        {.node = row * (elements + 1) + elements, .translation = {true, true, true}, .rotation = {}});
}

/// Of all nodes, bodies and walls.
Vec3 whole_momentum(const domain::Domain& domain) {
  Vec3 sum;
  for (Index i = 0; i < domain.nodes.count(); ++i)
    if (domain.nodes.is_free(i)) sum += domain.nodes.mass[i] * domain.nodes.velocity[i];
  for (const domain::RigidBody& body : domain.rigid_bodies) sum += body.mass * body.velocity;
  for (const domain::WallReport& wall : domain.walls) sum += wall.mass * wall.velocity;
  return sum;
}

TEST(MassOnBar, WallSlowsDownByTheImpedanceOfTheBar) {
  for (const double ratio : {0.5, 1.0, 4.0}) {
    model::Model model = struck_bar(400, ratio);
    hold_far_end(model, 400);
    const double there_and_back = 2 * length / wave_speed();
    model.control.end_time = 0.99 * there_and_back;
    timeloop::Simulation simulation(model, test::execution());
    double worst = 0;
    test::Points accepted;
    test::Points found;
    test::run(simulation, [&](const domain::Domain& domain) {
      // Velocities are half a step ahead.
      const double time = domain.clock.time + 0.5 * simulation.next_step();
      if (domain.clock.cycle == 0) return;
      const double exact = speed * std::exp(-2 / ratio * time / there_and_back);
      worst = test::larger_of(worst, std::fabs(domain.walls[0].velocity.x - exact) / speed);
      accepted.push_back({time / there_and_back, exact / speed});
      found.push_back({time / there_and_back, domain.walls[0].velocity.x / speed});
    });
    std::printf("mass ratio %.1f: velocity off by %.2e\n", ratio, worst);
    test::verified("wall of " + test::figure(ratio) +
                       " bar masses onto a bar: error of its velocity over the initial one",
                   "St Venant, exact")
        .below(worst, 1e-3);
    if (ratio != 1) continue;
    test::drawn("Wall with the mass of the bar that it strikes", "time, over that of the wave there and back",
                "velocity of the wall, over the initial one")
        .accepted("St Venant", accepted)
        .found("400 elements", found)
        .note();
  }
}

TEST(MassOnBar, AFreeBarLeavesWhenItsWaveIsBack) {
  const double ratio = 2;
  model::Model model = struck_bar(400, ratio);
  const double there_and_back = 2 * length / wave_speed();
  model.control.end_time = 3 * there_and_back;
  timeloop::Simulation simulation(model, test::execution());
  double last_touch = 0;
  double mismatch = 0;
  double imbalance = 0;
  const Vec3 before = {ratio * bar_mass * speed, 0, 0};
  test::run(simulation, [&](const domain::Domain& domain) {
    const double force = density * wave_speed() * speed * width * thickness;
    if (domain.walls[0].normal_force > 0.1 * force) last_touch = domain.clock.time;
    mismatch = test::larger_of(mismatch, norm(whole_momentum(domain) - before) / norm(before));
    imbalance =
        test::larger_of(imbalance, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  const domain::Domain& domain = simulation.domain();
  const domain::WallReport& wall = domain.walls[0];
  const double exact = speed * std::exp(-2 / ratio);
  std::printf("velocity %.5f of the exact one, contact %.4f, momentum %.1e, imbalance %.1e, taken %.1e\n",
              wall.velocity.x / exact, last_touch / there_and_back, mismatch, imbalance,
              domain.energy.rigidwall / domain.energy.initial_total);
  test::verified("wall of two bar masses onto a free bar: velocity after, over exact", "St Venant, exact")
      .near(wall.velocity.x / exact, 1, 0.01);
  test::verified("wall of two bar masses onto a free bar: end of contact over exact", "St Venant, exact")
      .near(last_touch / there_and_back, 1, 0.02);
  test::verified("wall of two bar masses onto a free bar: momentum", "conservation").below(mismatch, 3e-14);
  EXPECT_LT(imbalance, 5e-9);
  EXPECT_NEAR(domain.energy.initial_total, 0.5 * ratio * bar_mass * speed * speed, 1e-18);
  EXPECT_GT(domain.energy.rigidwall, 0);
  EXPECT_LT(domain.energy.rigidwall, 0.01 * domain.energy.initial_total);
  EXPECT_EQ(wall.force.x, 0);
}

TEST(MassOnBar, AHeldBarPushesTheWallBack) {
  model::Model model = struck_bar(400, 1);
  hold_far_end(model, 400);
  const double there_and_back = 2 * length / wave_speed();
  model.control.end_time = 1.95 * there_and_back;  // a third wave comes to the end of the bar at 2
  timeloop::Simulation simulation(model, test::execution());
  double last_touch = 0;
  double imbalance = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    if (domain.walls[0].normal_force > 0.02 * density * wave_speed() * speed * width * thickness)
      last_touch = domain.clock.time;
    imbalance =
        test::larger_of(imbalance, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  // Of the second wave: contact ends at 2 L / c (1 + (2 + exp(-2)) / 4), with -2 V exp(-1 - exp(-2) / 2).
  const double end = there_and_back * (1 + (2 + std::exp(-2.0)) / 4);
  const double exact = -2 * speed * std::exp(-1 - 0.5 * std::exp(-2.0));
  const domain::WallReport& wall = simulation.domain().walls[0];
  std::printf("rebound %.5f of the exact one, contact %.4f, imbalance %.1e\n", wall.velocity.x / exact,
              last_touch / end, imbalance);
  test::verified("wall onto a bar that is held: velocity of the rebound over exact", "St Venant, exact")
      .near(wall.velocity.x / exact, 1, 1e-4);
  test::verified("wall onto a bar that is held: end of contact over exact", "St Venant, exact")
      .near(last_touch / end, 1, 0.02);
  EXPECT_LT(imbalance, 2e-8);
}

TEST(MassOnBar, OnlyRelativeMotionCounts) {
  model::Model struck = struck_bar(50, 2);
  model::Model striking = struck_bar(50, 2);
  striking.rigid_walls[0].initial_velocity = 0;
  for (Index i = 0; i < striking.nodes.count(); ++i)
    striking.initial_velocities.push_back({.node = i, .velocity = {-speed, 0, 0}});
  struck.control.end_time = striking.control.end_time = 4 * length / wave_speed();
  timeloop::Simulation one(struck, test::execution());
  timeloop::Simulation other(striking, test::execution());
  test::run(one);
  test::run(other);
  EXPECT_NEAR(one.domain().walls[0].velocity.x - speed, other.domain().walls[0].velocity.x, 1e-11 * speed);
  EXPECT_NEAR(one.domain().energy.rigidwall, other.domain().energy.rigidwall,
              1e-9 * one.domain().energy.initial_total);
}

/// A wall that nothing can slow down is one with a curve.
TEST(MassOnBar, AHugeMassMovesAsPrescribed) {
  model::Model heavy = struck_bar(50, 1e30);
  model::Model prescribed = struck_bar(50, 0);
  prescribed.curves.push_back({.id = 1, .abscissa = {0, 1}, .ordinate = {speed, speed}});
  prescribed.rigid_walls[0].motion = {.curve = 0, .is_displacement = false, .direction = {1, 0, 0}};
  for (model::Model* model : {&heavy, &prescribed}) {
    model->rigid_walls[0].friction = 0.2;
    hold_far_end(*model, 50);
    model->control.end_time = 3 * length / wave_speed();
  }
  timeloop::Simulation one(heavy, test::execution());
  timeloop::Simulation other(prescribed, test::execution());
  test::run(one);
  test::run(other);
  double worst = 0;
  for (Index i = 0; i < one.domain().nodes.count(); ++i)
    worst = test::larger_of(worst, norm(one.domain().nodes.velocity[i] - other.domain().nodes.velocity[i]));
  std::printf("velocities differ by %.1e\n", worst / speed);
  EXPECT_LT(worst, 2e-13 * speed);
  EXPECT_NEAR(one.domain().walls[0].impulse.x / other.domain().walls[0].impulse.x, 1, 1e-11);
  EXPECT_NEAR(one.domain().walls[0].displacement.x, other.domain().walls[0].displacement.x, 1e-13);
}

/// A ball above a wall, both free.
model::Model ball_and_wall(bool rigid) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 6, 6, 6, [](double u, double v, double w) {
    const test::Point cube = {2 * u - 1, 2 * v - 1, 2 * w - 1};
    const double largest = std::max({std::fabs(cube[0]), std::fabs(cube[1]), std::fabs(cube[2])});
    const double distance = std::hypot(cube[0], cube[1], cube[2]);
    const double scale = distance > 0 ? 5 * (1 + largest / distance) : 1;
    return test::Point{scale * cube[0], scale * cube[1], scale * cube[2]};
  });
  if (rigid) test::make_rigid(model, 0);
  model::RigidWall wall;
  wall.id = 1;
  wall.shape = model::WallShape::Flat;
  wall.normal = {0.6, 0, 0.8};
  wall.edge = {0.8, 0, -0.6};
  wall.lengths = {16, 16, 0};
  wall.point = {-14, -8, -5};
  wall.mass = 0.02;
  wall.initial_velocity = 15;
  wall.friction = 0.2;
  for (Index i = 0; i < model.nodes.count(); ++i) {
    wall.nodes.push_back(i);
    model.initial_velocities.push_back({.node = i, .velocity = {1, 0.5, -2}});
  }
  model.rigid_walls.push_back(wall);
  model.control.end_time = 0.4;
  return model;
}

TEST(MassOnBall, MomentumAndEnergyAreKept) {
  for (const bool rigid : {false, true}) {
    const model::Model model = ball_and_wall(rigid);
    timeloop::Simulation simulation(model, test::execution());
    const Vec3 normal = {0.6, 0, 0.8};
    Vec3 before;
    double mismatch = 0;
    double imbalance = 0;
    test::run(simulation, [&](const domain::Domain& domain) {
      const Vec3 now = whole_momentum(domain);
      if (domain.clock.cycle == 0) before = now;
      const Vec3 impulse = domain.walls[0].impulse;
      // What friction gives the wall along itself is the guide's.
      const Vec3 change = now - before + (impulse - dot(impulse, normal) * normal);
      mismatch = test::larger_of(mismatch, norm(change) / norm(before));
      imbalance =
          test::larger_of(imbalance, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
    });
    const domain::Domain& domain = simulation.domain();
    std::printf("%s ball: momentum %.1e, imbalance %.1e, wall's velocity %.4f, taken %.4f\n",
                rigid ? "rigid" : "elastic", mismatch, imbalance, norm(domain.walls[0].velocity),
                domain.energy.rigidwall / domain.energy.initial_total);
    EXPECT_LT(mismatch, 2e-14);
    EXPECT_LT(imbalance, rigid ? 1e-12 : 1e-3);
    EXPECT_LT(norm(domain.walls[0].velocity), 10) << "it has hit the ball";
    EXPECT_GT(domain.energy.rigidwall, 0);
  }
}

TEST(MassOnBall, SameBitsForAnyNumberOfThreads) {
  for (const bool rigid : {false, true})
    for (const Precision precision : {Precision::Double, Precision::Mixed}) {
      const model::Model model = ball_and_wall(rigid);
      const auto hash = [&](int threads) {
        timeloop::Simulation simulation(model, {precision, default_isa(), threads});
        test::run(simulation);
        EXPECT_GT(simulation.domain().walls[0].normal_impulse, 0);
        return simulation.state_hash();
      };
      const std::uint64_t one = hash(1);
      for (const int threads : {2, 3}) EXPECT_EQ(hash(threads), one);
    }
}

}  // namespace
}  // namespace crumple::moving_mass_wall_test
