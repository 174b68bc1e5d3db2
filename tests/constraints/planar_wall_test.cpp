// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/planar_wall.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crumple::constraints {
namespace {

using math::Vec3;

/// One free node of mass 2 in front of a wall; exact answers by hand.
class PlanarWallTest : public ::testing::Test {
 protected:
  PlanarWallTest() {
    domain_.nodes.position.resize(1);
    domain_.nodes.velocity.resize(1);
    domain_.nodes.mass.assign(1, 2.0);
    domain_.nodes.domain_node = {0};
    domain_.walls.resize(1);
  }

  void stop(double friction, double interval, double next_step) {
    model::RigidWall wall;
    wall.nodes = {0};
    wall.point = {0, 0, 5};
    wall.normal = {0, 0, 1};
    wall.friction = friction;
    const AlignedArray<Vec3> previous = domain_.nodes.velocity;
    PlanarWall(wall, domain_, 0).stop_nodes(domain_, previous, interval, next_step);
  }

  domain::Domain domain_;
};

TEST_F(PlanarWallTest, LeavesANodeAloneThatDoesNotReachThePlane) {
  domain_.nodes.position[0] = {1, 2, 6};
  domain_.nodes.velocity[0] = {3, 0, -4};
  stop(1.0, 0.1, 0.2);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 3);
  EXPECT_EQ(domain_.nodes.velocity[0].z, -4);
  EXPECT_EQ(domain_.walls[0].impulse.z, 0);
}

TEST_F(PlanarWallTest, LetsANodeArriveExactlyAtThePlane) {
  domain_.nodes.position[0] = {0, 0, 5.5};
  domain_.nodes.velocity[0] = {0, 0, -4};
  stop(0.0, 0.25, 0.5);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].z, -1.0);
  EXPECT_DOUBLE_EQ(domain_.walls[0].impulse.z, -6.0) << "on the wall: minus the change of momentum";
  EXPECT_DOUBLE_EQ(domain_.walls[0].normal_force, 24.0);
  EXPECT_DOUBLE_EQ(domain_.walls[0].energy + domain_.walls[0].deferred, 0.5 * 2 * (16 - 1))
      << "the kinetic energy lost";
}

TEST_F(PlanarWallTest, FrictionTakesMuTimesTheNormalImpulseAndNoMore) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {3, 4, -2};
  stop(0.5, 0.1, 0.1);
  // Slip 5, normal change 2: the slip falls by 0.5 * 2 along its own direction.
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].x, 3 * 0.8);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].y, 4 * 0.8);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].z, 0);
}

TEST_F(PlanarWallTest, FrictionNeverReversesTheSlip) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {0.3, 0.4, -2};
  stop(0.5, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
  EXPECT_EQ(domain_.nodes.velocity[0].y, 0);
}

TEST_F(PlanarWallTest, AFrictionOfOneSticks) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {300, 0, -0.001};
  stop(1.0, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 0);
}

TEST_F(PlanarWallTest, ANodeThatStartsBehindIsHeldAndNotThrownOut) {
  domain_.nodes.position[0] = {0, 0, 4};
  domain_.nodes.velocity[0] = {0, 0, -7};
  stop(0.0, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].z, 0);
}

TEST_F(PlanarWallTest, ANodeMayLeaveThePlane) {
  domain_.nodes.position[0] = {0, 0, 5};
  domain_.nodes.velocity[0] = {1, 0, 2};
  stop(1.0, 0.1, 0.1);
  EXPECT_EQ(domain_.nodes.velocity[0].x, 1);
  EXPECT_EQ(domain_.nodes.velocity[0].z, 2);
}

}  // namespace
}  // namespace crumple::constraints
