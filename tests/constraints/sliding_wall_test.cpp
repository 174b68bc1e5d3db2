// SPDX-License-Identifier: BSD-3-Clause
//
// Rigid walls with mass against lumped nodes and rigid bodies; exact answers by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "constraints/rigid_bodies.hpp"
#include "constraints/rigid_motion.hpp"
#include "constraints/rigid_wall.hpp"
#include "support/verified.hpp"

namespace crumple::constraints::sliding_wall_test {
namespace {

using math::Vec3;

constexpr double step = 0.1;
/// Share of a number that four last places are at least.
constexpr double last_places = 4.4e-16;

/// Free nodes of mass 2 above a wall of mass 6 at z = 5, which comes towards them.
class SlidingWallTest : public ::testing::Test {
 protected:
  SlidingWallTest() {
    wall_.point = {0, 0, 5};
    wall_.normal = {0, 0, 1};
    wall_.mass = 6;
    wall_.initial_velocity = 4;
    domain_.walls.resize(1);
  }

  void add_node(const Vec3& position, const Vec3& velocity, double mass = 2) {
    domain::NodeFields& nodes = domain_.nodes;
    const Index node = nodes.count();
    nodes.position.push_back(position);
    nodes.velocity.push_back(velocity);
    nodes.angular_velocity.push_back(Vec3{});
    nodes.inertia.push_back(0);
    nodes.mass.push_back(mass);
    nodes.fixed.push_back(0);
    nodes.domain_node.push_back(node);
    nodes.double_records.emplace_back();
    if (!domain_.body_of_node.empty()) domain_.body_of_node.push_back(no_index);
    wall_.nodes.push_back(node);
  }

  void stop() {
    previous_ = domain_.nodes.velocity;
    RigidWall wall(model_, wall_, domain_, 0);
    initial_ = momentum();
    initial_energy_ = energy();
    for (domain::RigidBody& body : domain_.rigid_bodies) {
      body.previous_velocity = body.velocity;
      body.previous_spin = body.spin;
    }
    double fastest = std::numeric_limits<double>::infinity();
    wall.stop_nodes(domain_, {previous_, step, step, fastest});
  }

  const domain::WallReport& report() const { return domain_.walls[0]; }
  double speed() const { return dot(report().velocity, normalised(normal())); }
  Vec3 normal() const { return {wall_.normal[0], wall_.normal[1], wall_.normal[2]}; }

  /// Of nodes, bodies and wall.
  Vec3 momentum() const {
    Vec3 sum = wall_.mass * report().velocity;
    for (Index i = 0; i < domain_.nodes.count(); ++i)
      if (domain_.nodes.is_free(i)) sum += domain_.nodes.mass[i] * domain_.nodes.velocity[i];
    for (const domain::RigidBody& body : domain_.rigid_bodies) sum += body.mass * body.velocity;
    return sum;
  }
  double energy() const {
    double sum = 0.5 * wall_.mass * dot(report().velocity, report().velocity);
    for (Index i = 0; i < domain_.nodes.count(); ++i)
      if (domain_.nodes.is_free(i))
        sum += 0.5 * domain_.nodes.mass[i] * dot(domain_.nodes.velocity[i], domain_.nodes.velocity[i]);
    for (const domain::RigidBody& body : domain_.rigid_bodies)
      sum += 0.5 * (body.mass * dot(body.velocity, body.velocity) + dot(body.angular_momentum, body.spin));
    return sum;
  }
  void expect_energy_is_booked(double tolerance = 1e-14) const {
    EXPECT_NEAR(report().energy + report().deferred, initial_energy_ - energy(), tolerance * initial_energy_);
    EXPECT_GE(report().energy + report().deferred, 0) << "an impact is plastic";
    EXPECT_EQ(domain_.energy.external_work + report().deferred_work, 0);
  }

  /// Four nodes of mass 2 in a square of side 2 in the plane z = 5 around (x, 0) as a rigid body.
  void add_square(double x, const Vec3& velocity) {
    std::vector<Index> nodes;
    for (const double dx : {-1.0, 1.0})
      for (const double dy : {-1.0, 1.0}) {
        nodes.push_back(domain_.nodes.count());
        add_node({x + dx, dy, 5}, velocity);
      }
    add_body(domain_, body_of_nodes(domain_, 1, nodes));
  }

  model::Model model_;
  model::RigidWall wall_;
  domain::Domain domain_;
  AlignedArray<Vec3> previous_;
  Vec3 initial_;
  double initial_energy_ = 0;
};

TEST_F(SlidingWallTest, FliesOnWithNothingInItsWay) {
  add_node({0, 0, 6}, {3, 0, 0});
  stop();
  EXPECT_DOUBLE_EQ(report().displacement.z, step * 4);
  EXPECT_EQ(report().displacement_now.z, 0);
  EXPECT_EQ(report().velocity.z, 4);
  EXPECT_DOUBLE_EQ(report().kinetic_energy, 0.5 * 6 * 16);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 3);
  EXPECT_EQ(report().impulse.z, 0);
}

TEST_F(SlidingWallTest, SharesItsMomentumWithNodesAtRest) {
  for (const double x : {0.0, 1.0, 2.0}) add_node({x, 0, 5}, {0, 0, 0});
  stop();
  test::verified("wall of mass 6 at speed 4 meets three nodes of mass 2: common velocity",
                 "conservation of momentum")
      .within(speed(), 2, last_places);
  for (const Vec3& velocity : domain_.nodes.velocity) EXPECT_DOUBLE_EQ(velocity.z, 2);
  EXPECT_DOUBLE_EQ(report().displacement.z, step * 2);
  EXPECT_DOUBLE_EQ(report().impulse.z, -12);
  EXPECT_DOUBLE_EQ(report().normal_force, 12 / step);
  test::verified("wall of mass 6 at speed 4 meets three nodes of mass 2: energy of the wall",
                 "kinetic energy lost")
      .within(report().energy + report().deferred, 48 - 24, last_places);
  EXPECT_DOUBLE_EQ(report().kinetic_energy, 0.5 * 6 * 4 * 2) << "in product form";
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, ANodeThatWouldLeaveIsNotPulled) {
  add_node({0, 0, 5}, {0, 0, -4}, 6);
  add_node({0, 0, 5}, {0, 0, 3});
  stop();
  EXPECT_DOUBLE_EQ(speed(), 0) << "of the first node and the wall";
  EXPECT_EQ(domain_.nodes.velocity[1].z, 3) << "slower than the wall was, faster than it is";
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, ANodeArrivesExactlyAtTheMovingPlane) {
  add_node({0, 0, 5.3}, {0, 0, -1});
  stop();
  const double plane = 5 + report().displacement.z;
  test::verified("node and wall with mass, on their way: distance of the node from the plane", "none")
      .near(domain_.nodes.position[0].z + step * domain_.nodes.velocity[0].z - plane, 0, 1e-15);
  EXPECT_DOUBLE_EQ(momentum().z, initial_.z);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, FrictionIsRelativeToTheWallAndActsAcross) {
  wall_.friction = 0.25;
  add_node({0, 0, 5}, {3, 4, 0}, 6);
  stop();
  // Normal change 2: the slip of 5 falls by 0.25 * 2.
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].z, 2);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].x, 3 * 0.9);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].y, 4 * 0.9);
  EXPECT_EQ(report().velocity.x, 0) << "its guide holds it";
  EXPECT_NEAR(report().impulse.x, 6 * 3 * 0.1, 1e-14);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, ARectanglePassesBesideNodes) {
  wall_.shape = model::WallShape::Flat;
  wall_.edge = {1, 0, 0};
  wall_.lengths = {2, 3, 0};
  add_node({1, 1, 5.1}, {0, 0, 0});
  add_node({2.5, 1, 5.1}, {0, 0, 0});
  add_node({1, -0.5, 5.1}, {0, 0, 0});
  stop();
  EXPECT_GT(domain_.nodes.velocity[0].z, 0);
  EXPECT_EQ(domain_.nodes.velocity[1].z, 0);
  EXPECT_EQ(domain_.nodes.velocity[2].z, 0);
  EXPECT_DOUBLE_EQ(momentum().z, initial_.z);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, ARectangleThatSlowsDownMeetsWhatComesOverItsEdge) {
  // At the wall's first velocity the second node is met before it is over the edge at x = 0.
  wall_.shape = model::WallShape::Flat;
  wall_.edge = {1, 0, 0};
  wall_.lengths = {2, 2, 0};
  wall_.initial_velocity = 10;
  add_node({1, 1, 5}, {0, 0, -10}, 6);
  add_node({-0.02, 1, 5.05}, {1, 0, -1});
  stop();
  EXPECT_GE(domain_.nodes.position[1].z + step * domain_.nodes.velocity[1].z,
            5 + report().displacement.z - 1e-15);
  EXPECT_NEAR(momentum().z, initial_.z, 1e-13) << "60 and -60 and a little";
  EXPECT_LT(speed(), 0);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, AFixedNodeStopsIt) {
  add_node({0, 0, 5}, {0, 0, 0});
  add_node({1, 0, 5}, {0, 0, 0});
  domain_.nodes.fixed[0] = domain::fixed_translation(2);
  stop();
  EXPECT_EQ(speed(), 0);
  EXPECT_EQ(domain_.nodes.velocity[0].z, 0);
  EXPECT_EQ(domain_.nodes.velocity[1].z, 0);
  EXPECT_DOUBLE_EQ(report().impulse.z, -24);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, AFixedNodeFartherAwayLetsItCome) {
  add_node({0, 0, 5.1}, {0, 0, 0});
  domain_.nodes.fixed[0] = 7;
  stop();
  EXPECT_NEAR(speed(), 1, 1e-14) << "0.1 in a step of 0.1";
}

TEST_F(SlidingWallTest, WhatIsFixedAcrossMakesANodeHeavier) {
  // A node on rails along z, the normal halfway between x and z: pushed along the normal it resists with
  // twice its mass, half of the push goes into the rails.
  const double half = std::sqrt(0.5);
  wall_.normal = {half, 0, half};
  wall_.mass = 4;
  add_node({0, 0, 5}, {0, 0, 0});
  domain_.nodes.fixed[0] = domain::fixed_translation(0);
  stop();
  EXPECT_DOUBLE_EQ(speed(), 2) << "4 * 4 / (4 + 4)";
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
  EXPECT_NEAR(domain_.nodes.velocity[0].z * half, 2, 1e-14) << "it stays on the plane";
  EXPECT_NEAR(norm(report().impulse + 8 * normal()), 0, 1e-14) << "a wall without friction pushes straight";
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, MomentumAndEnergyOfManyNodesAddUp) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  wall_.normal = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  wall_.friction = 0.3;
  for (int i = 0; i < 300; ++i) {
    const Vec3 across = cross(normal(), Vec3{unit(random), unit(random), unit(random)});
    const double gap = 0.2 + 0.2 * unit(random);
    add_node(Vec3{0, 0, 5} + across + gap * normal(), {unit(random), unit(random), unit(random)},
             0.1 + 0.05 * unit(random));
  }
  stop();
  EXPECT_LT(speed(), 3.9);
  const std::string many = "wall with mass and friction meets 300 nodes: ";
  test::verified(many + "momentum along, change over that at first", "conservation")
      .below(std::fabs(dot(momentum() - initial_, normal())) / norm(initial_), 1e-14);
  test::verified(many + "momentum across, change less the guide's impulse", "conservation")
      .below(norm(momentum() - initial_ + (report().impulse - dot(report().impulse, normal()) * normal())) /
                 norm(initial_),
             1e-14);
  const double plane = 10.0 / 3 + dot(report().displacement, normal());
  for (Index i = 0; i < domain_.nodes.count(); ++i)
    EXPECT_GT(dot(domain_.nodes.position[i] + step * domain_.nodes.velocity[i], normal()), plane - 1e-14);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, PushesABodyThroughItsCentre) {
  add_square(0, {0, 0, 0});
  stop();
  test::verified("wall with mass pushes a rigid body through its centre: common velocity",
                 "conservation of momentum")
      .near(speed(), 24.0 / 14, 3e-11);
  EXPECT_NEAR(domain_.rigid_bodies[0].velocity.z, 24.0 / 14, 1e-9);
  EXPECT_NEAR(momentum().z, initial_.z, 1e-14 * initial_.z);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, AMoteIsPushedByABody) {
  wall_.mass = 1e-9;
  add_square(0, {0, 0, -1});
  stop();
  EXPECT_NEAR(speed(), -1, 3e-6) << "what rounds at the body moves the mote";
  EXPECT_NEAR(momentum().z, initial_.z, 1e-14 * -initial_.z);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, TurnsABodyThatItHitsBesideItsCentre) {
  // Only the two nodes at x = 1 are over the rectangle. Mass 8, inertia about y 4 * 2 * 1 = 8: there the body
  // resists with 1 / (1/8 + 1/8) = 4.
  wall_.shape = model::WallShape::Flat;
  wall_.point = {0.5, -3, 5};
  wall_.edge = {1, 0, 0};
  wall_.lengths = {6, 6, 0};
  add_square(0, {0, 0, 0});
  stop();
  const domain::RigidBody& body = domain_.rigid_bodies[0];
  const std::string beside = "wall with mass hits a rigid body beside its centre: ";
  test::verified(beside + "velocity of the wall", "effective mass").near(speed(), 24.0 / 10, 3e-11);
  test::verified(beside + "velocity of the body", "effective mass")
      .near(body.velocity.z, 24.0 / 10 / 2, 1e-9);
  test::verified(beside + "spin of the body", "effective mass").near(body.spin.y, -24.0 / 10 / 2, 1e-9);
  EXPECT_NEAR(momentum().z, initial_.z, 1e-14 * initial_.z);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, PushesBodiesAndNodesTogether) {
  add_square(0, {0, 0, 0});
  add_square(5, {0, 0, -1});
  add_node({9, 0, 5}, {0, 0, 0.5});
  add_node({9, 0, 5.05}, {0, 0, 0.5});
  add_node({9, 0, 5}, {0, 0, 3});
  stop();
  // The node farther off may come by 0.5 in the step: a limit of 1 for the wall.
  const double common = (6 * 4 - 8 + 2 * 0.5) / (6 + 8 + 8 + 2);
  ASSERT_LT(common, 1);
  test::verified("wall with mass pushes two bodies and two nodes: common velocity",
                 "conservation of momentum")
      .near(speed(), common, 3e-11);
  EXPECT_NEAR(domain_.rigid_bodies[0].velocity.z, common, 1e-9);
  EXPECT_NEAR(domain_.rigid_bodies[1].velocity.z, common, 1e-9);
  EXPECT_NEAR(momentum().z, initial_.z, 1e-14 * initial_.z);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, AHeldBodyStopsItAndFeelsThePush) {
  add_square(0, {0, 0, 0});
  add_node({9, 0, 5}, {0, 0, 0});
  domain::RigidBody& body = domain_.rigid_bodies[0];
  body.held_translation = body.held_rotation = {true, true, true};
  body.impulse = Vec3{};
  stop();
  EXPECT_EQ(speed(), 0);
  EXPECT_EQ(body.velocity.z, 0);
  EXPECT_DOUBLE_EQ(body.impulse.z, 24);
  EXPECT_DOUBLE_EQ(report().impulse.z, -24);
  expect_energy_is_booked();
}

TEST_F(SlidingWallTest, ABodyThatIsPulledAtItPushesItAway) {
  add_square(0, {0, 0, -3});
  domain::RigidBody& body = domain_.rigid_bodies[0];
  body.held_translation = body.held_rotation = {true, true, true};
  stop();
  EXPECT_EQ(speed(), -3);
  EXPECT_EQ(body.velocity.z, -3) << "its motion is prescribed";
  EXPECT_DOUBLE_EQ(body.impulse.z, 6 * 7);
  // The wall loses 4^2 - 3^2, the push does work on the body: its motion gives that.
  EXPECT_DOUBLE_EQ(report().energy + report().deferred, 0.5 * 6 * (16 - 9) + 6 * 7 * 3);
}

TEST_F(SlidingWallTest, ABoxOfTimeLetsItPass) {
  wall_.birth_time = 1;
  add_node({0, 0, 5}, {0, 0, 0});
  stop();
  EXPECT_EQ(domain_.nodes.velocity[0].z, 0);
  EXPECT_DOUBLE_EQ(report().displacement.z, step * 4);
}

TEST_F(SlidingWallTest, TheStateHasItsVelocity) {
  add_node({0, 0, 5}, {0, 0, 0});
  const RigidWall wall(model_, wall_, domain_, 0);
  const auto hash = [&] {
    domain::StateList list;
    domain_.declare(list);
    return list.hash();
  };
  const std::uint64_t before = hash();
  domain_.walls[0].velocity.z += 1;
  EXPECT_NE(hash(), before);
}

}  // namespace
}  // namespace crumple::constraints::sliding_wall_test
