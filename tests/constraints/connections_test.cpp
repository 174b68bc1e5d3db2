// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "constraints/node_sets.hpp"
#include "constraints/rigid_bodies.hpp"
#include "constraints/rivets.hpp"
#include "constraints/spot_welds.hpp"
#include "support/verified.hpp"

namespace crumple::constraints::connections_test {
namespace {

using math::Vec3;

/// Share of a number that four last places are at least.
constexpr double last_places = 4.4e-16;

/// Two nodes of masses 2 and 3 at a distance of 5 along x; exact answers by hand.
class ConnectionsTest : public ::testing::Test {
 protected:
  ConnectionsTest() {
    domain::NodeFields& nodes = domain_.nodes;
    nodes.position.assign(2, Vec3{});
    nodes.position[1] = {5, 0, 0};
    nodes.velocity.assign(2, Vec3{});
    nodes.angular_velocity.assign(2, Vec3{});
    nodes.mass.assign(2, 2.0);
    nodes.mass[1] = 3;
    nodes.inertia.assign(2, 0.5);
    nodes.fixed.assign(2, 0);
    nodes.force.resize(2);
    nodes.domain_node = {0, 1};
    nodes.double_records.resize(2);
  }
  Vec3 momentum() const {
    Vec3 sum;
    for (Index i = 0; i < 2; ++i) sum += domain_.nodes.mass[i] * domain_.nodes.velocity[i];
    return sum;
  }

  model::Model model_;
  domain::Domain domain_;
};

TEST_F(ConnectionsTest, ANodeSetSharesItsMomentumAlongItsDirections) {
  model_.constrained_node_sets.push_back({.nodes = {1, 0}, .direction = {true, false, true}});
  domain_.nodes.velocity[0] = {10, 1, 0};
  domain_.nodes.velocity[1] = {0, 2, 5};
  const NodeSets sets(model_, domain_);
  for (Index i = 0; i < 2; ++i) {
    test::verified("node set of masses 2 and 3: common velocity", "conservation of momentum")
        .within(domain_.nodes.velocity[i].x, 4, last_places);
    EXPECT_DOUBLE_EQ(domain_.nodes.velocity[i].y, 1.0 + i);
    EXPECT_DOUBLE_EQ(domain_.nodes.velocity[i].z, 3);
  }
}

TEST_F(ConnectionsTest, ANodeSetIsHeldByAFixedNodeAndEndsAtItsTime) {
  model_.constrained_node_sets.push_back(
      {.nodes = {0, 1}, .direction = {true, true, true}, .failure_time = 2});
  domain_.nodes.fixed[1] = domain::fixed_translation(1);
  const NodeSets sets(model_, domain_);
  domain_.nodes.velocity[0] = {5, 7, 0};
  sets.constrain(domain_);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].y, 0);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[1].x, 2);
  domain_.clock.time = 2;
  domain_.nodes.velocity[0] = {5, 7, 0};
  sets.constrain(domain_);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].x, 5);
}

TEST_F(ConnectionsTest, ARivetKeepsTheDistanceToRoundOffAndTheMomentum) {
  model_.rivets.push_back({.id = 1, .node = {0, 1}});
  const Rivets rivets(model_, domain_);
  domain_.nodes.velocity[0] = {-1, 4, 2};
  domain_.nodes.velocity[1] = {3, -5, 1};
  const Vec3 before = momentum();
  const double step = 0.2;
  rivets.constrain(domain_, step);
  const Vec3 line = (domain_.nodes.position[1] + step * domain_.nodes.velocity[1]) -
                    (domain_.nodes.position[0] + step * domain_.nodes.velocity[0]);
  test::verified("rivet: length at the end of a step", "length at first").near(norm(line), 5, 1e-14);
  test::verified("rivet: momentum, change", "conservation").below(norm(momentum() - before), 1e-14);
  EXPECT_DOUBLE_EQ(domain_.nodes.velocity[0].y, 4) << "impulses are along the line";
}

TEST_F(ConnectionsTest, ARivetPullsAtFixedNodesAlongFreeAxesOnly) {
  model_.rivets.push_back({.id = 1, .node = {0, 1}});
  domain_.nodes.fixed[0] = 7;
  const Rivets rivets(model_, domain_);
  domain_.nodes.velocity[1] = {3, 0, 0};
  rivets.constrain(domain_, 0.2);
  EXPECT_EQ(norm(domain_.nodes.velocity[0]), 0);
  EXPECT_NEAR(norm(domain_.nodes.velocity[1]), 0, 1e-14);
}

TEST_F(ConnectionsTest, ARivetNeedsALength) {
  model_.rivets.push_back({.id = 1, .node = {0, 1}});
  domain_.nodes.position[1] = domain_.nodes.position[0];
  EXPECT_THROW(Rivets(model_, domain_), Error);
}

class WeldTest : public ConnectionsTest {
 protected:
  void put_force(Index node, const Vec3& force) {
    for (int axis = 0; axis < 3; ++axis) domain_.nodes.force[node].force[axis] = force[axis];
  }
  model::SpotWeld weld_{.id = 9, .nodes = {0, 1}};
};

TEST_F(WeldTest, TensionAndShearAreWhatMovesBothNodesAsOne) {
  model_.spot_welds.push_back(weld_);
  const SpotWelds welds(model_, domain_);
  // Pulled apart along x by 10 each: the link carries all of it, and nothing moves.
  put_force(0, {-10, 0, 0});
  put_force(1, {10, 0, 0});
  welds.break_overloaded(domain_);
  test::verified("spot weld pulled by 10: axial force", "equilibrium")
      .near(domain_.welds[0].axial, 10, 1e-14);
  EXPECT_NEAR(domain_.welds[0].shear, 0, 1e-13);
  // A force of 10 along y on the second node. Centre at 3; inertia about z: 2 * 9 + 3 * 4 + 2 * 0.5 = 31,
  // acceleration 10 / 5 and turning 10 * 2 / 31: 3 (2 + 2 * 20 / 31) - 10.
  put_force(0, {0, 0, 0});
  put_force(1, {0, 10, 0});
  welds.break_overloaded(domain_);
  EXPECT_NEAR(domain_.welds[0].axial, 0, 1e-14);
  test::verified("spot weld pushed across at one end: shear force", "motion of a rigid body")
      .near(domain_.welds[0].shear, std::fabs(3 * (2 + 40.0 / 31) - 10), 1e-13);
}

TEST_F(WeldTest, ATurningWeldCarriesTheCentripetalForce) {
  domain_.nodes.velocity[0] = {0, -3 * 4.0, 0};
  domain_.nodes.velocity[1] = {0, 2 * 4.0, 0};
  domain_.nodes.angular_velocity[0] = domain_.nodes.angular_velocity[1] = {0, 0, 4};
  model_.spot_welds.push_back(weld_);
  const SpotWelds welds(model_, domain_);
  welds.break_overloaded(domain_);
  test::verified("spot weld that turns: axial force", "m r omega^2")
      .near(domain_.welds[0].axial, 3 * 2 * 16, 1e-12);
}

TEST_F(WeldTest, FailsWhereTheSumOfPowersReachesOne) {
  weld_.normal_strength = 10;
  weld_.shear_strength = 1e9;
  weld_.normal_exponent = 2;
  model_.spot_welds.push_back(weld_);
  const SpotWelds welds(model_, domain_);
  put_force(0, {9.99, 0, 0});
  put_force(1, {-9.99, 0, 0});
  welds.break_overloaded(domain_);
  EXPECT_FALSE(domain_.welds[0].broken) << "pressure breaks nothing";
  for (const double force : {9.99, 10.01}) {
    put_force(0, {-force, 0, 0});
    put_force(1, {force, 0, 0});
    domain_.clock.time = force;
    welds.break_overloaded(domain_);
  }
  EXPECT_TRUE(domain_.welds[0].broken);
  EXPECT_EQ(domain_.welds[0].failure_time, 10.01);
  EXPECT_FALSE(domain_.rigid_bodies[0].active);
  EXPECT_TRUE(domain_.nodes.is_free(0));
  EXPECT_TRUE(domain_.nodes.is_free(1));
}

TEST_F(WeldTest, FailsByShearAndNormalForceTogether) {
  // Equal nodes, so that a pair of forces across the line turns them about the middle.
  domain_.nodes.mass[1] = 2;
  domain_.nodes.inertia.assign(2, 1e-9);
  weld_.normal_strength = 10;
  weld_.shear_strength = 20;
  weld_.shear_exponent = 2;
  model_.spot_welds.push_back(weld_);
  const SpotWelds welds(model_, domain_);
  // Alone 0.7 of the one and, as (12/20)^2, 0.36 of the other: together 1.06. The moment of the pair is
  // balanced, so that the shear is the force.
  put_force(0, {-7, -12, 0});
  put_force(1, {7, 12, 0});
  domain_.nodes.force[0].moment[2] = -60;
  welds.break_overloaded(domain_);
  EXPECT_TRUE(domain_.welds[0].broken);
}

TEST_F(WeldTest, FailsAtItsTime) {
  weld_.failure_time = 3;
  model_.spot_welds.push_back(weld_);
  const SpotWelds welds(model_, domain_);
  domain_.clock.time = 2.9;
  welds.break_overloaded(domain_);
  EXPECT_FALSE(domain_.welds[0].broken);
  domain_.clock.time = 3;
  welds.break_overloaded(domain_);
  EXPECT_TRUE(domain_.welds[0].broken);
}

}  // namespace
}  // namespace crumple::constraints::connections_test
