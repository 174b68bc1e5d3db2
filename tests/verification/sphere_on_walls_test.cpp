// SPDX-License-Identifier: BSD-3-Clause
//
// An elastic ball (a cube drawn round) meets rigid walls of every shape. Exact are: no node inside a wall,
// the wall's impulse equal to the change of momentum, the energy balance with what the wall's perfectly
// plastic impact takes, friction that takes its coefficient times the normal impulse, and that only relative
// motion counts.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "constraints/wall_shapes.hpp"
#include "support/larger.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"
#include "support/verified.hpp"

namespace crumple::sphere_on_walls_test {
namespace {

using math::Vec3;
using model::WallShape;

constexpr double radius = 10.0;
constexpr double speed = 20.0;

/// A cube of hexahedra drawn half of the way onto the ball around it, so that no element at its edges
/// becomes flat; it touches the ball in the middles of its faces.
test::Point ball(double u, double v, double w) {
  const test::Point cube = {2 * u - 1, 2 * v - 1, 2 * w - 1};
  const double largest = std::max({std::fabs(cube[0]), std::fabs(cube[1]), std::fabs(cube[2])});
  const double distance = std::hypot(cube[0], cube[1], cube[2]);
  const double scale = distance > 0 ? 0.5 * (1 + largest / distance) : 1;
  return {radius * scale * cube[0], radius * scale * cube[1], radius * scale * cube[2]};
}

/// The ball above a wall whose highest place is at z = -radius - 0.1.
model::Model ball_above(WallShape shape, double friction = 0) {
  model::Model model = test::one_solid_part(test::elastic_steel());
  test::add_box(model, 0, 8, 8, 8, ball);
  model.control.end_time = 0.08;
  model::RigidWall wall;
  wall.id = 1;
  wall.shape = shape;
  wall.friction = friction;
  wall.normal = {0, 0, 1};
  const double top = -radius - 0.1;
  wall.point = {0, 0, top};
  for (Index i = 0; i < model.nodes.count(); ++i) wall.nodes.push_back(i);
  if (shape == WallShape::Flat || shape == WallShape::Prism) {
    wall.edge = {1, 0, 0};
    wall.lengths = {14, 12, 5};
    wall.point = {-7, -6, top};
  } else if (shape == WallShape::Cylinder) {
    wall.normal = {0, 1, 0};
    wall.radius = 4;
    wall.lengths = {30, 0, 0};
    wall.point = {0, -15, top - wall.radius};
  } else if (shape == WallShape::Sphere) {
    wall.radius = 6;
    wall.point = {0, 0, top - wall.radius};
  }
  model.rigid_walls.push_back(wall);
  return model;
}

void give_velocity(model::Model& model, const test::Point& velocity) {
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i, .velocity = velocity, .angular_velocity = {}});
}

/// How far the deepest node is in the wall at rest [length].
double deepest(const constraints::WallSurface& surface, const domain::Domain& domain) {
  double depth = 0;
  for (const Vec3& x : domain.nodes.position)
    depth = test::larger_of(depth, std::visit(
                                       [&](const auto& shape) {
                                         if constexpr (requires { shape.gap(x); })
                                           return -shape.gap(x).gap;
                                         else
                                           // A rectangle is as good as the plane under this ball.
                                           return -(x.z + radius + 0.1);
                                       },
                                       surface));
  return depth;
}

class BallOnWall : public ::testing::TestWithParam<WallShape> {};

TEST_P(BallOnWall, ReboundsWithoutPenetrationLossOfMomentumOrOfEnergy) {
  model::Model model = ball_above(GetParam());
  give_velocity(model, {0, 0, -speed});
  const constraints::WallSurface surface = constraints::wall_surface(model.rigid_walls[0]);
  timeloop::Simulation simulation(model, test::execution());
  Vec3 before;
  double depth = 0;
  double mismatch = 0;
  double imbalance = 0;
  test::run(simulation, [&](const domain::Domain& domain) {
    const Vec3 now = test::momentum(domain);
    if (domain.clock.cycle == 0) before = now;
    depth = test::larger_of(depth, deepest(surface, domain));
    mismatch = test::larger_of(mismatch, norm(now - before + domain.walls[0].impulse) / norm(before));
    imbalance =
        test::larger_of(imbalance, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  });
  const domain::Domain& domain = simulation.domain();
  const domain::WallReport& wall = domain.walls[0];
  const Vec3 after = test::momentum(domain);
  RecordProperty("rebound", std::to_string(after.z / -before.z));
  RecordProperty("taken", std::to_string(wall.energy / domain.energy.initial_total));
  test::verified("elastic ball on a wall: depth in the wall over the radius", "none")
      .below(depth / radius, 1e-12);
  test::verified("elastic ball on a wall: impulse less change of momentum", "conservation")
      .below(mismatch, 1e-11);
  // It falls with the step: 3.0e-4 here, below 2e-4 at half of it.
  test::verified("elastic ball on a wall: energy", "conservation").below(imbalance, 4e-4);
  EXPECT_GT(after.z, 0.2 * -before.z) << "it has rebounded";
  EXPECT_LT(std::hypot(after.x, after.y), 1e-9 * norm(before)) << "and straight up";
  EXPECT_GT(wall.energy, 0) << "impact of the nodes is plastic";
  EXPECT_LT(wall.energy, 0.02 * domain.energy.initial_total);
  EXPECT_EQ(wall.force.z, 0) << "it has left";
}

TEST_P(BallOnWall, OnlyRelativeMotionCounts) {
  model::Model struck = ball_above(GetParam(), 0.2);
  give_velocity(struck, {1, 0, -speed});
  model::Model striking = ball_above(GetParam(), 0.2);
  give_velocity(striking, {1, 0, 0});
  striking.curves.push_back({.id = 1, .abscissa = {0, 1}, .ordinate = {speed, speed}});
  striking.rigid_walls[0].motion = {.curve = 0, .is_displacement = false, .direction = {0, 0, 1}};
  timeloop::Simulation at_rest(struck, test::execution());
  timeloop::Simulation moving(striking, test::execution());
  test::run(at_rest);
  test::run(moving);
  const Vec3 difference = test::momentum(moving.domain()) - test::momentum(at_rest.domain());
  double mass = 0;
  for (const double m : at_rest.domain().nodes.mass) mass += m;
  EXPECT_NEAR(difference.z / (mass * speed), 1, 1e-9);
  EXPECT_NEAR(difference.x / (mass * speed), 0, 1e-9);
  const domain::EnergyLedger& energy = moving.domain().energy;
  EXPECT_GT(energy.external_work, 0);
  EXPECT_LT(std::fabs(energy.imbalance()), 2e-4 * energy.external_work);
  EXPECT_NEAR(energy.rigidwall, at_rest.domain().energy.rigidwall, 1e-6 * at_rest.domain().energy.rigidwall);
}

std::string name_of(const ::testing::TestParamInfo<WallShape>& info) {
  constexpr const char* names[] = {"Plane", "Flat", "Prism", "Cylinder", "Sphere"};
  return names[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Shapes, BallOnWall,
                         ::testing::Values(WallShape::Plane, WallShape::Flat, WallShape::Prism,
                                           WallShape::Cylinder, WallShape::Sphere),
                         name_of);

TEST(BallOnPlane, SlidingFrictionTakesItsCoefficientTimesTheNormalImpulse) {
  constexpr double friction = 0.1;
  model::Model model = ball_above(WallShape::Plane, friction);
  // Fast enough along the wall that no node ever sticks.
  give_velocity(model, {6 * speed, 0, -speed});
  timeloop::Simulation simulation(model, test::execution());
  test::run(simulation);
  const domain::WallReport& wall = simulation.domain().walls[0];
  test::verified("ball slides along a wall: tangential over normal impulse", "Coulomb")
      .within(wall.impulse.x / wall.normal_impulse, friction, 1e-3);
  EXPECT_NEAR(-wall.impulse.z, wall.normal_impulse, 1e-12 * wall.normal_impulse);
}

}  // namespace
}  // namespace crumple::sphere_on_walls_test
