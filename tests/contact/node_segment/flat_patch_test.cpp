// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/bodies.hpp"
#include "support/largest.hpp"

namespace crumple::flat_patch_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

// A unit segment in the plane z = 0, and one node of a small segment above the point (x, y) at height z.
struct NodeOverPlate {
  explicit NodeOverPlate(const Vec3& tip, double thickness = 0.1) : bodies(thickness) {
    plate = bodies.sheet(1, 1, [](double u, double v) { return Vec3{u, v, 0}; });
    tip_node = bodies.node(tip);
    const Index b = bodies.node(tip + Vec3{1, 0, 1});
    const Index c = bodies.node(tip + Vec3{0, 1, 1});
    bodies.shell(tip_node, b, c, c);
  }
  Bodies bodies;
  Index plate = 0;
  Index tip_node = 0;
};

/// Moves one node to the height z in one step, by contact's account of the velocity.
void put(contact::Interface& touching, domain::Domain& made, Index node, double z) {
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  x[at(made, node)].z = z;
  test::move_to(touching, made, x, 1e-3);
}

TEST(FlatPatch, PenaltyForceIsExact) {
  NodeOverPlate scene({0.5, 0.25, 0.2});
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);

  const double depth = 0.01;
  put(touching, made, scene.tip_node, 0.1 - depth);
  test::settle(touching, made);
  // K = E / (3 (1 - 2 nu)); the square has A = 1 and a diagonal of sqrt(2), the triangle of the tip an area
  // of sqrt(3) / 2 and sides of sqrt(2). The softer of the two governs.
  const double modulus = 1000.0 / (3 * 0.5);
  const double square = 0.1 * modulus / std::sqrt(2.0);
  const double triangle = 0.1 * modulus * (std::sqrt(3.0) / 2) / std::sqrt(2.0);
  const double expected = std::min(square, triangle) * depth;
  test::verified("node pressed on a plate: contact force", "SLSFAC K A / diagonal times depth")
      .within(made.contact_force[at(made, scene.tip_node)].z, expected, 1e-13);
  test::verified("node pressed on a plate: penetration", "prescribed")
      .near(made.contacts[0].penetration, depth, 1e-15);
  EXPECT_EQ(made.contacts[0].active_pairs, 1);
  EXPECT_EQ(made.nodes.force[at(made, scene.tip_node)].force[2],
            made.contact_force[at(made, scene.tip_node)].z);
}

TEST(FlatPatch, ForceAndMomentBalanceToRoundOff) {
  NodeOverPlate scene({0.3, 0.2, 0.2});
  // A warped plate: no symmetry is left.
  scene.bodies.model.nodes.position[scene.plate + 3] = {1.1, 0.9, 0.12};
  scene.bodies.model.nodes.position[scene.plate + 1] = {-0.1, 1.05, -0.03};
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  put(touching, made, scene.tip_node, 0.07);
  const double size = norm(made.contact_force[at(made, scene.tip_node)]);
  ASSERT_GT(size, 0.1);
  test::verified("node pressed on a warped plate: sum of forces over the force", "conservation of momentum")
      .below(norm(test::total_force(made)) / size, 1e-14);
  test::verified("node pressed on a warped plate: sum of moments over the force", "conservation")
      .below(norm(test::total_moment(made)) / size, 1e-14);
}

TEST(FlatPatch, BothSidesPushAway) {
  for (const double side : {1.0, -1.0}) {
    NodeOverPlate scene({0.5, 0.25, side * 0.2});
    for (Index n = scene.tip_node + 1; n <= scene.tip_node + 2; ++n)
      scene.bodies.model.nodes.position[n][2] = side * 1.2;
    domain::Domain made = scene.bodies.build();
    contact::Interface touching = scene.bodies.attach(made);
    test::add_forces(touching, made);
    put(touching, made, scene.tip_node, side * 0.06);
    EXPECT_GT(side * made.contact_force[at(made, scene.tip_node)].z, 0.0);
  }
}

TEST(FlatPatch, ThicknessFollowsTheRule) {
  // True thickness 0.6 is cut to 0.4 of the shortest edge, unless the user gives one.
  NodeOverPlate scene({0.5, 0.25, 0.9}, 0.6);
  domain::Domain made = scene.bodies.build();
  EXPECT_DOUBLE_EQ(scene.bodies.attach(made).surface().half_thickness[0], 0.2);
  scene.bodies.contact.side[0].contact_thickness = 0.5;
  EXPECT_DOUBLE_EQ(scene.bodies.attach(made).surface().half_thickness[0], 0.25);
  scene.bodies.contact.side[0].contact_thickness = 0;
  scene.bodies.contact.side[0].thickness_scale = 0.5;
  EXPECT_DOUBLE_EQ(scene.bodies.attach(made).surface().half_thickness[0], 0.15);
  // *PART_CONTACT: a factor beside that of the contact; a thickness goes before all else.
  model::Part& part = scene.bodies.model.parts[scene.bodies.model.shells[0].part];
  part.contact_thickness_scale = 0.8;
  EXPECT_DOUBLE_EQ(scene.bodies.attach(made).surface().half_thickness[0], 0.12);
  scene.bodies.contact.side[0].contact_thickness = 0.5;
  EXPECT_DOUBLE_EQ(scene.bodies.attach(made).surface().half_thickness[0], 0.25);
  part.contact_thickness = 0.7;
  EXPECT_DOUBLE_EQ(scene.bodies.attach(made).surface().half_thickness[0], 0.35);
}

// Above an edge that segments share, above their diagonals and above a face the force is that of a node above
// one segment. Above a node of the sheet that node and the tip push each other off: both are nodes, and both
// belong to a segment of the other.
TEST(FlatPatch, NodeAboveAnInnerEdgeGetsOneForce) {
  const double depth = 0.004;
  test::Largest off("node above faces, an inner edge, a diagonal and a node: force, error",
                    "stiffness times depth", 1e-12);
  for (const Vec3& foot : {Vec3{0.1, 0.2, 0}, Vec3{0.5, 0.3, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.25, 0.25, 0}}) {
    Bodies bodies(0.02);
    bodies.sheet(2, 2, [](double u, double v) { return Vec3{u, v, 0}; });
    const Index tip = bodies.node(foot + Vec3{0, 0, 0.1});
    const Index b = bodies.node(foot + Vec3{1, 0, 1});
    const Index c = bodies.node(foot + Vec3{0, 1, 1});
    bodies.shell(tip, b, c, c);
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    put(touching, made, tip, 0.02 - depth);
    test::settle(touching, made);
    const int pairs = foot.x == 0.5 && foot.y == 0.5 ? 2 : 1;
    EXPECT_EQ(made.contacts[0].active_pairs, pairs);
    const double stiffness = 0.1 * (1000.0 / 1.5) * 0.5 / std::sqrt(2.0);
    off.compare(made.contact_force[at(made, tip)].z, pairs * stiffness * depth);
  }
}

}  // namespace
}  // namespace crumple::flat_patch_test
