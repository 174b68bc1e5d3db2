// SPDX-License-Identifier: BSD-3-Clause
// One body, exact answers by hand.
#include "constraints/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "constraints/body_impact.hpp"
#include "constraints/rigid_bodies.hpp"
#include "support/verified.hpp"

namespace crumple::constraints::rigid_motion_test {
namespace {

using math::Vec3;

/// Two masses of 2 at x = -3 and 3.
class Dumbbell : public ::testing::Test {
 protected:
  Dumbbell() {
    domain::NodeFields& nodes = domain_.nodes;
    nodes.position = {{-3, 0, 0}, {3, 0, 0}, {0, 9, 0}};
    nodes.velocity.resize(3);
    nodes.angular_velocity.resize(3);
    nodes.mass.assign(3, 2.0);
    nodes.inertia.assign(3, 0.0);
    nodes.fixed.assign(3, 0);
    nodes.double_records.resize(3);
    nodes.force.resize(3);
  }

  domain::RigidBody& add() {
    add_body(domain_, body_of_nodes(domain_, 7, {0, 1}));
    return domain_.rigid_bodies.back();
  }

  domain::Domain domain_;
};

TEST_F(Dumbbell, HasTheMomentaOfItsNodes) {
  domain_.nodes.velocity = {{0, 1, 0}, {4, 7, 0}, {}};
  const domain::RigidBody& body = add();
  EXPECT_EQ(body.mass, 4);
  const std::string made = "rigid body made of two moving masses: ";
  test::verified(made + "velocity, error", "conservation of momentum")
      .below(norm(body.velocity - Vec3{2, 4, 0}), 1e-15);
  test::verified(made + "moment of momentum, error", "conservation")
      .below(norm(body.angular_momentum - Vec3{0, 0, 36}), 1e-14);
  EXPECT_LT(norm(body.spin - Vec3{0, 0, 1}), 1e-15);
  // What stretched it is gone.
  EXPECT_LT(norm(domain_.nodes.velocity[0] - Vec3{2, 1, 0}), 1e-15);
  EXPECT_FALSE(domain_.nodes.is_free(0));
  EXPECT_TRUE(domain_.nodes.is_free(2));
  EXPECT_EQ(domain_.body_of_node[1], 0);
}

TEST_F(Dumbbell, DoesNotTurnAboutItsLine) {
  domain::RigidBody& body = add();
  body.angular_momentum = {5, 0, 0};
  EXPECT_EQ(norm(spin_of(body, body.turn, body.angular_momentum)), 0);
}

TEST_F(Dumbbell, TurnsByTheForcesOnItsNodes) {
  const domain::RigidBody& body = add();
  domain_.nodes.force[1].force[2] = 12;
  const model::Model model;
  const RigidBodies bodies(model, domain_);
  bodies.kick(domain_, 0.5);
  const std::string kicked = "rigid dumbbell kicked at one end: ";
  test::verified(kicked + "velocity, error", "closed form")
      .below(norm(body.velocity - Vec3{0, 0, 1.5}), 1e-15);
  test::verified(kicked + "spin, error", "closed form").below(norm(body.spin - Vec3{0, -0.5, 0}), 1e-15);
  bodies.carry_nodes(domain_, 0.5, 0.5);
  domain_.clock.step = 0.5;
  bodies.place_nodes(domain_);
  test::verified(kicked + "distance of its ends", "rigid")
      .near(norm(domain_.nodes.position[1] - domain_.nodes.position[0]), 6, 1e-15);
  EXPECT_NEAR(body.centre.z, 0.75, 1e-15);
}

// The clock needs it: what the nodes' velocities do not tell of their way.
TEST_F(Dumbbell, TellsHowFarItMovedNodesToTheirPlaces) {
  add();
  const model::Model model;
  const RigidBodies bodies(model, domain_);
  bodies.kick(domain_, 0.5);
  bodies.carry_nodes(domain_, 0.5, 0.5);
  domain_.clock.step = 0.5;
  EXPECT_EQ(bodies.place_nodes(domain_), 0);
  for (const std::size_t far : {0U, 1U}) {
    domain_.nodes.position[far] += Vec3{0.3, -0.4, 1.2};
    domain_.nodes.position[1 - far] += Vec3{0, 0.25, 0};
    domain_.nodes.position[2] += Vec3{7, 0, 0};  // not of the body
    EXPECT_NEAR(bodies.place_nodes(domain_), 1.3, 1e-15);
    EXPECT_EQ(norm(domain_.nodes.position[0] - Vec3{-3, 0, 0}), 0);
    EXPECT_EQ(norm(domain_.nodes.position[1] - Vec3{3, 0, 0}), 0);
  }
}

TEST_F(Dumbbell, ImpactOfOneEndIsThatOfItsEffectiveMass) {
  domain_.nodes.velocity = {{0, 0, -3}, {0, 0, -3}, {}};
  domain::RigidBody& body = add();
  std::vector<BodyTouch> touches = {{1, {3, 0, 0}, {0, 0, 1}, 0, {}}};
  stop_body(body, {}, touches);
  // 1 / (1 / M + r^2 / J) = 1 / (1/4 + 9/36) = 2: the other mass does not feel it.
  test::verified("rigid dumbbell strikes with one end: impulse", "effective mass")
      .near(touches[0].impulse.z, 6, 1e-12);
  test::verified("rigid dumbbell strikes with one end: velocity of the other", "centre of percussion")
      .near(velocity_at(body, {-3, 0, 0}).z, -3, 1e-12);
  EXPECT_NEAR(velocity_at(body, {3, 0, 0}).z, 0, 1e-12);
}

TEST_F(Dumbbell, BothEndsStopIt) {
  domain_.nodes.velocity = {{0, 0, -3}, {0, 0, -5}, {}};
  domain::RigidBody& body = add();
  std::vector<BodyTouch> touches = {{0, {-3, 0, 0}, {0, 0, 1}, 0, {}}, {1, {3, 0, 0}, {0, 0, 1}, -1, {}}};
  stop_body(body, {}, touches);
  test::verified("rigid dumbbell strikes with both ends: first impulse", "closed form")
      .near(touches[0].impulse.z, 6, 1e-9);
  test::verified("rigid dumbbell strikes with both ends: second impulse", "closed form")
      .near(touches[1].impulse.z, 8, 1e-9);
}

TEST_F(Dumbbell, FrictionIsBoundByTheNormalImpulse) {
  domain_.nodes.velocity = {{4, 0, -3}, {4, 0, -3}, {}};
  domain::RigidBody& body = add();
  std::vector<BodyTouch> touches = {{0, {-3, 0, 0}, {0, 0, 1}, 0, {}}, {1, {3, 0, 0}, {0, 0, 1}, 0, {}}};
  stop_body(body, {.velocity = {}, .friction = 0.5}, touches);
  test::verified("rigid dumbbell strikes with friction: velocity along", "Coulomb")
      .near(body.velocity.x, 4 - 0.5 * 3, 1e-9);
  EXPECT_NEAR(body.velocity.z, 0, 1e-9);
}

TEST_F(Dumbbell, HeldAxesTakeTheirPartOfAnImpulse) {
  domain::RigidBody& body = add();
  hold_translation(body, 2, 0.5);
  hold_rotation(body, 1, 0.25);
  give_impulse(body, {3, 0, 0}, {0, 8, 8});
  EXPECT_LT(norm(body.velocity - Vec3{0, 2, 0.5}), 1e-15);
  EXPECT_LT(norm(body.spin - Vec3{0, 0.25, 24.0 / 36}), 1e-15);
  EXPECT_LT(norm(body.impulse - Vec3{0, 8, 8}), 1e-15);
}

TEST_F(Dumbbell, ReleasedNodesAreFree) {
  domain_.nodes.velocity = {{0, 1, 0}, {0, 3, 0}, {}};
  add();
  const Vec3 before = domain_.nodes.velocity[1];
  release_body(domain_, 0);
  EXPECT_TRUE(domain_.nodes.is_free(0));
  EXPECT_TRUE(domain_.nodes.is_free(1));
  EXPECT_EQ(domain_.body_of_node[1], no_index);
  EXPECT_EQ(norm(domain_.nodes.velocity[1] - before), 0);
  EXPECT_EQ(RigidBodies::kinetic_energy(domain_), 0);
}

}  // namespace
}  // namespace crumple::constraints::rigid_motion_test
