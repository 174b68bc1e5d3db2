// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rigid_wall.hpp"
#include "support/verified.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace crumple::constraints::rigid_wall_test {
namespace {

using math::Vec3;

/// Share of a number that four last places are at least.
constexpr double last_places = 4.4e-16;

/// One free node of mass 2 in front of a wall; exact answers by hand.
class RigidWallTest : public ::testing::Test {
 protected:
  RigidWallTest() {
    domain_.nodes.position.resize(1);
    domain_.nodes.velocity.resize(1);
    domain_.nodes.mass.assign(1, 2.0);
    domain_.nodes.fixed.assign(1, 0);
    domain_.nodes.domain_node = {0};
    domain_.walls.resize(1);
  }

  static model::RigidWall wall_at_five() {
    model::RigidWall wall;
    wall.nodes = {0};
    wall.point = {0, 0, 5};
    wall.normal = {0, 0, 1};
    return wall;
  }

  void stop(double friction, double interval, double next_step) {
    model::RigidWall wall = wall_at_five();
    wall.friction = friction;
    stop(wall, interval, next_step);
  }

  void stop(const model::RigidWall& wall, double interval, double next_step) {
    const AlignedArray<Vec3> previous = domain_.nodes.velocity;
    double fastest = std::numeric_limits<double>::infinity();
    RigidWall(model_, wall, domain_, 0).stop_nodes(domain_, {previous, interval, next_step, fastest});
  }

  model::Model model_;
  domain::Domain domain_;
};

TEST_F(RigidWallTest, LeavesANodeAloneThatDoesNotReachThePlane) {
  domain_.nodes.position[0] = {1, 2, 6};
  domain_.nodes.velocity[0] = {3, 0, -4};
  stop(1.0, 0.1, 0.2);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 3);
  EXPECT_EQ(domain_.nodes.velocity[0].z, -4);
  EXPECT_EQ(domain_.walls[0].impulse.z, 0);
}

TEST_F(RigidWallTest, LetsANodeArriveExactlyAtThePlane) {
  domain_.nodes.position[0] = {0, 0, 5.5};
  domain_.nodes.velocity[0] = {0, 0, -4};
  stop(0.0, 0.25, 0.5);
  const std::string arrives = "node arrives at a rigid wall: ";
  test::verified(arrives + "velocity that ends on the plane", "geometry")
      .within(domain_.nodes.velocity[0].z, -1.0, last_places);
  test::verified(arrives + "impulse of the wall", "change of momentum")
      .within(domain_.walls[0].impulse.z, -6.0, last_places);
  EXPECT_DOUBLE_EQ(domain_.walls[0].normal_force, 24.0);
  test::verified(arrives + "energy of the wall", "kinetic energy lost")
      .within(domain_.walls[0].energy + domain_.walls[0].deferred, 0.5 * 2 * (16 - 1), last_places);
}

TEST_F(RigidWallTest, FrictionTakesMuTimesTheNormalImpulseAndNoMore) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {3, 4, -2};
  stop(0.5, 0.1, 0.1);
  // Slip 5, normal change 2: the slip falls by 0.5 * 2 along its own direction.
  test::verified("node slides on a rigid wall, friction 0.5: velocity along", "Coulomb")
      .within(domain_.nodes.velocity[0].x, 3 * 0.8, last_places);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].y, 4 * 0.8);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].z, 0);
}

TEST_F(RigidWallTest, FrictionNeverReversesTheSlip) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {0.3, 0.4, -2};
  stop(0.5, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
  EXPECT_EQ(domain_.nodes.velocity[0].y, 0);
}

TEST_F(RigidWallTest, AFrictionOfOneSticks) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {300, 0, -0.001};
  stop(1.0, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
}

TEST_F(RigidWallTest, ANodeThatStartsBehindIsHeldAndNotThrownOut) {
  domain_.nodes.position[0] = {0, 0, 4};
  domain_.nodes.velocity[0] = {0, 0, -7};
  stop(0.0, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].z, 0);
}

TEST_F(RigidWallTest, ANodeMayLeaveThePlane) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {1, 0, 2};
  stop(1.0, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 1);
  EXPECT_EQ(domain_.nodes.velocity[0].z, 2);
}

TEST_F(RigidWallTest, AFixedDegreeOfFreedomStaysFixedAndTheOthersMakeUpForIt) {
  // The normal lies halfway between x, which is fixed, and z.
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {0, 1, -2};
  domain_.nodes.fixed[0] = domain::fixed_translation(0);
  model::RigidWall wall = wall_at_five();
  wall.normal = {std::sqrt(0.5), 0, std::sqrt(0.5)};
  stop(wall, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
  EXPECT_EQ(domain_.nodes.velocity[0].y, 1);
  EXPECT_NEAR(domain_.nodes.velocity[0].z, 0, 1e-15);
}

/// Only the direction is left to the node.
domain::LocalHold line_along(const Vec3& direction) {
  domain::LocalHold hold;
  hold.held = 2;
  for (int axis = 0; axis < 3; ++axis)
    hold.free.column[static_cast<std::size_t>(axis)] = direction[axis] * direction;
  return hold;
}

TEST_F(RigidWallTest, ASupportAlongAnObliqueAxisStaysOne) {
  domain_.nodes.local_hold = {0};
  domain_.nodes.local_holds = {line_along({std::sqrt(0.5), 0, std::sqrt(0.5)})};
  domain_.nodes.position[0] = {0, 0, 5.5};
  domain_.nodes.velocity[0] = {-4, 0, -4};
  stop(0.0, 0.25, 0.5);
  const std::string arrives = "node held across 45 degrees arrives at a rigid wall: ";
  test::verified(arrives + "velocity along the wall", "the direction that is free")
      .near(domain_.nodes.velocity[0].x, -1, 1e-14);
  EXPECT_NEAR(domain_.nodes.velocity[0].z, -1, 1e-14);
  test::verified(arrives + "impulse of the wall", "change of momentum")
      .near(domain_.walls[0].impulse.z, -6.0, 1e-14);
  test::verified(arrives + "energy of the wall", "kinetic energy lost")
      .near(domain_.walls[0].energy + domain_.walls[0].deferred, 0.5 * 2 * (32 - 2), 1e-13);
}

TEST_F(RigidWallTest, AWallWithMassLosesWhatAnObliqueSupportTakes) {
  domain_.nodes.local_hold = {0};
  domain_.nodes.local_holds = {line_along({std::sqrt(0.5), 0, std::sqrt(0.5)})};
  domain_.nodes.position[0] = {0, 0, 5};
  model::RigidWall wall = wall_at_five();
  wall.mass = 4;
  wall.initial_velocity = 3;
  stop(wall, 0.1, 0.1);
  // The node resists with its mass over the cosine squared: 4 * 3 = (4 + 2 / 0.5) v.
  EXPECT_NEAR(domain_.walls[0].velocity.z, 1.5, 1e-14);
  EXPECT_NEAR(domain_.nodes.velocity[0].z, 1.5, 1e-14);
  EXPECT_NEAR(domain_.nodes.velocity[0].x, 1.5, 1e-14);
}

TEST_F(RigidWallTest, ABoxOfTimeLimitsTheWall) {
  model::RigidWall wall = wall_at_five();
  wall.birth_time = 1;
  wall.death_time = 2;
  for (const double time : {0.5, 2.5}) {
    domain_.clock.time = time;
    domain_.nodes.position[0] = {0, 0, 5};
    domain_.nodes.velocity[0] = {0, 0, -1};
    stop(wall, 0.1, 0.1);
    EXPECT_EQ(domain_.nodes.velocity[0].z, -1) << time;
  }
  domain_.clock.time = 1.5;
  stop(wall, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].z, 0);
}

TEST_F(RigidWallTest, AMovingWallPushesWithItsVelocityAndItsWorkIsExternal) {
  model_.curves.push_back({.id = 1, .abscissa = {0, 1}, .ordinate = {3, 3}});
  model::RigidWall wall = wall_at_five();
  wall.motion = {.curve = 0, .is_displacement = false, .direction = {0, 0, 1}};
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {0, 0, 0};
  stop(wall, 0.1, 0.1);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].z, 3);
  EXPECT_DOUBLE_EQ(domain_.walls[0].displacement.z, 0.3);
  EXPECT_DOUBLE_EQ(domain_.walls[0].impulse.z, -6);
  const domain::WallReport& report = domain_.walls[0];
  const double work = domain_.energy.external_work + report.deferred_work;
  test::verified("node pushed by a moving wall: external work", "impulse times velocity")
      .within(work, 6 * 3, last_places);
  test::verified("node pushed by a moving wall: work less the wall's energy", "kinetic energy gained")
      .within(work - report.energy - report.deferred, 0.5 * 2 * 9, last_places);
}

TEST_F(RigidWallTest, ADisplacementCurvePlacesTheWall) {
  model_.curves.push_back({.id = 1, .abscissa = {0, 1}, .ordinate = {-2, 8}});
  model::RigidWall wall = wall_at_five();
  wall.motion = {.curve = 0, .is_displacement = true, .direction = {0, 0, 1}};
  // The plane is at 3 and comes to 4 within the step.
  domain_.nodes.position[0] = {0, 0, 3.5};
  domain_.nodes.velocity[0] = {0, 0, 0};
  stop(wall, 0.1, 0.1);
  test::verified("node before a wall moved by a curve: velocity that ends on the plane", "geometry")
      .near(domain_.nodes.velocity[0].z, 5, 1e-13);
}

}  // namespace
}  // namespace crumple::constraints::rigid_wall_test
