// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/bodies.hpp"
#include "support/largest.hpp"

namespace crumple::crossing_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

constexpr double thickness = 0.1;

/// A sheet of 4 x 4 unit squares in z = 0 and a triangle standing on its tip.
struct TipOverSheet {
  explicit TipOverSheet(const Vec3& x) : bodies(thickness) {
    sheet = bodies.sheet(4, 4, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
    tip = bodies.node(x);
    const Index b = bodies.node(x + Vec3{2, 0.3, 3});
    const Index c = bodies.node(x + Vec3{2, -0.3, 3});
    bodies.shell(tip, b, c, c);
  }
  std::vector<Vec3> moved(const domain::Domain& made, const Vec3& to) const {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    const Vec3 shift = to - x[at(made, tip)];
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += shift;
    return x;
  }
  Bodies bodies;
  Index sheet = 0;
  Index tip = 0;
};

// In one step from outside the contact distance to beyond the mid-surface, to within the contact distance of
// the other side or far beyond it: pushed back to where it came from.
TEST(Crossing, FastNodeIsReturnedToItsSide) {
  test::Largest off("node shot through a sheet in one step: penetration, error", "thickness and depth",
                    1e-12);
  for (const double side : {1.0, -1.0})
    for (const double depth : {0.03, 0.09, 0.25}) {
      TipOverSheet scene({1.4, 1.3, side * 0.3});
      domain::Domain made = scene.bodies.build();
      contact::Interface touching = scene.bodies.attach(made);
      test::add_forces(touching, made);
      test::move_to(touching, made, scene.moved(made, {1.45, 1.3, -side * depth}), 1e-4);
      EXPECT_GT(side * made.contact_force[at(made, scene.tip)].z, 0.0);
      off.compare(made.contacts[0].penetration, thickness + depth);
      EXPECT_EQ(touching.statistics().nodes_astray, 1);
      // It stays remembered while it slides on to a neighbour on the wrong side, and until it is back.
      test::move_to(touching, made, scene.moved(made, {2.3, 2.4, -side * depth}), 1e-4);
      EXPECT_GT(side * made.contact_force[at(made, scene.tip)].z, 0.0);
      off.compare(made.contacts[0].penetration, thickness + depth);
      test::move_to(touching, made, scene.moved(made, {2.3, 2.4, side * 0.05}), 1e-4);
      EXPECT_GT(side * made.contact_force[at(made, scene.tip)].z, 0.0);
      EXPECT_EQ(touching.statistics().nodes_astray, 0);
    }
}

// Back to its side and over an edge or a corner in the same step: it is not taken for one that has gone
// through.
TEST(Crossing, NodeThatReturnsOverAnEdgeBelongsToItsSide) {
  for (const double side : {1.0, -1.0})
    for (const Vec3& to : {Vec3{2.1, 1.45, 0}, Vec3{2.05, 2.05, 0}, Vec3{1.45, 1.45, 0}})
      for (const double height : {0.02, 0.06}) {
        TipOverSheet scene({1.9, 1.45, side * 0.3});
        domain::Domain made = scene.bodies.build();
        contact::Interface touching = scene.bodies.attach(made);
        test::add_forces(touching, made);
        test::move_to(touching, made, scene.moved(made, {1.9, 1.45, -side * 0.02}), 1e-4);
        EXPECT_EQ(touching.statistics().nodes_astray, 1);
        test::move_to(touching, made, scene.moved(made, to + Vec3{0, 0, side * height}), 1e-4);
        EXPECT_EQ(touching.statistics().nodes_astray, 0) << to.x << ' ' << to.y;
        EXPECT_GT(side * made.contact_force[at(made, scene.tip)].z, 0.0) << to.x << ' ' << to.y;
      }
}

// Through the plane of the sheet, but beyond its free edge: no crossing.
TEST(Crossing, PassingBesideTheFreeEdgeIsNoCrossing) {
  TipOverSheet scene({-0.3, 1.3, 0.2});
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  test::move_to(touching, made, scene.moved(made, {-0.12, 1.3, -0.25}), 1e-4);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  test::move_to(touching, made, scene.moved(made, {0.3, 1.3, -0.25}), 1e-4);
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  test::move_to(touching, made, scene.moved(made, {0.3, 1.3, -0.06}), 1e-4);
  EXPECT_LT(made.contact_force[at(made, scene.tip)].z, 0.0);
}

// A sheet that moves through a node at rest is the same thing.
TEST(Crossing, OnlyRelativeMotionCounts) {
  TipOverSheet scene({1.4, 1.3, 0.3});
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  for (Index n = 0; n < scene.tip; ++n) x[at(made, n)].z += 0.34;
  test::move_to(touching, made, x, 1e-4);
  EXPECT_GT(made.contact_force[at(made, scene.tip)].z, 0.0);
  EXPECT_NEAR(made.contacts[0].penetration, thickness + 0.04, 1e-12);
}

// A corner of the segment below a node is pushed across the others, so that two of its four triangles turn
// over and look the other way. The node has not moved: it stays on its side, and is pushed as before.
TEST(Crossing, ANodeStaysOnItsSideOfASegmentThatTurnsOver) {
  Bodies bodies(thickness);
  bodies.sheet(1, 1, [](double u, double v) { return Vec3{u, v, 0}; });
  const Index tip = bodies.node({0.12, 0.1, 0.2});
  const Index b = bodies.node({0.2, 0.3, 3});
  const Index c = bodies.node({0.2, -0.3, 3});
  bodies.shell(tip, b, c, c);
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
  x[at(made, tip)].z = 0.07;
  test::move_to(touching, made, x, 1e-4);
  constexpr Index corner = 3;
  constexpr int steps = 400;
  double deepest = 0;
  int turned = 0;
  for (int i = 1; i <= steps; ++i) {
    x[at(made, corner)] = Vec3{1, 1, 0} + static_cast<double>(i) / steps * Vec3{-1.6, -1.6, 0.03};
    test::move_to(touching, made, x, 1e-4);
    deepest = std::max(deepest, made.contacts[0].penetration);
    turned += x[at(made, corner)].x < 0 && made.contacts[0].active_pairs > 0 ? 1 : 0;
    EXPECT_GE(made.contact_force[at(made, tip)].z, 0.0);
  }
  EXPECT_GT(turned, steps / 10) << "the node must have been in contact while triangles had turned over";
  EXPECT_GT(deepest, 0.0);
  EXPECT_LT(deepest, thickness);
}

// Shot at a sheet so fast that it is beyond the mid-surface within a step, a node comes back by itself.
TEST(Crossing, ShotNodeComesBack) {
  TipOverSheet scene({1.4, 1.3, 0.15});
  scene.bodies.model.control.contact_stiffness_scale = 1e5;  // stability sets the stiffness
  domain::Domain made = scene.bodies.build(1.0);
  contact::Interface touching = scene.bodies.attach(made);
  const double step = 1e-3;
  made.clock.element_limit = step;
  for (Index n = scene.tip; n < scene.tip + 3; ++n) made.nodes.velocity[at(made, n)] = {0, 0, -120};
  std::vector<Index> held;
  held.reserve(scene.tip);
  for (Index n = 0; n < scene.tip; ++n) held.push_back(at(made, n));
  test::add_forces(touching, made);
  bool beyond = false;
  for (int i = 0; i < 400; ++i) {
    test::integrate(touching, made, step, held);
    beyond = beyond || made.nodes.position[at(made, scene.tip)].z < 0;
  }
  EXPECT_TRUE(beyond);
  EXPECT_GT(made.nodes.velocity[at(made, scene.tip)].z, 0.0);
}

}  // namespace
}  // namespace crumple::crossing_test
