// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include <vector>

#include "contact/bodies.hpp"
#include "contact/move_apart.hpp"
#include "support/largest.hpp"

namespace crumple::initial_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

constexpr double thickness = 0.1;

/// A tip that starts at the height z above a sheet.
struct TipAt {
  explicit TipAt(double z) : bodies(thickness) {
    bodies.sheet(2, 2, [](double u, double v) { return Vec3{2 * u, 2 * v, 0}; });
    tip = bodies.node({0.4, 0.3, z});
    const Index b = bodies.node({0.4, 1.3, z + 2});
    const Index c = bodies.node({0.4, -0.7, z + 2});
    bodies.shell(tip, b, c, c);
  }
  void lift(contact::Interface& touching, domain::Domain& made, const Vec3& by) const {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += by;
    test::move_to(touching, made, x, 1e-3);
  }
  Bodies bodies;
  Index tip = 0;
};

TEST(InitialPenetration, GivesNoForceAndIsReported) {
  const TipAt scene(0.07);
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  EXPECT_EQ(norm(made.contact_force[at(made, scene.tip)]), 0.0);
  EXPECT_EQ(made.contacts[0].energy, 0.0);
  EXPECT_EQ(touching.statistics().initial_penetrations, 1);
  test::verified("tip that overlaps at the start: overlap reported", "geometry")
      .near(touching.statistics().worst_initial, 0.03, 1e-15);
  EXPECT_EQ(touching.statistics().worst_initial_node, scene.bodies.model.nodes.id[scene.tip]);
}

// A weld keeps the tip at its distance from a node of the sheet, while the sheet turns about it.
TEST(InitialPenetration, WeldedNodesDoNotTouchTheirPartnersSegmentsUntilTheWeldBreaks) {
  TipAt scene(0.15);
  constexpr Index middle_of_sheet = 4;
  scene.bodies.model.nodes.position[middle_of_sheet] = {0.4, 0.3, 0};
  model::SpotWeld weld;
  weld.id = 1;
  weld.nodes = {scene.tip, middle_of_sheet};
  scene.bodies.model.spot_welds = {weld};
  domain::Domain made = scene.bodies.build();
  made.welds.push_back({.id = 1});
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  scene.lift(touching, made, {0, 0, -0.08});
  EXPECT_EQ(norm(made.contact_force[at(made, scene.tip)]), 0.0);
  made.welds[0].broken = true;
  // What it has come nearer meanwhile was no approach.
  scene.lift(touching, made, {0, 0, 0.001});
  EXPECT_EQ(norm(made.contact_force[at(made, scene.tip)]), 0.0);
  scene.lift(touching, made, {0, 0, -0.02});
  EXPECT_GT(made.contact_force[at(made, scene.tip)].z, 0.0);
}

TEST(InitialPenetration, ClosingFurtherPushesAndOpeningRecovers) {
  const TipAt scene(0.07);
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  const double modulus = 1000.0 / 1.5;
  const double stiffness = 0.1 * modulus / std::sqrt(2.0);
  const auto force = [&] {
    test::settle(touching, made);
    return made.contact_force[at(made, scene.tip)].z;
  };
  test::Largest forces("tip that overlaps at the start, pressed and let go: force, error",
                       "stiffness times depth beyond the overlap", 1e-12);
  scene.lift(touching, made, {0, 0, -0.01});
  forces.compare(force(), stiffness * 0.01);
  // Also after sliding on to the next segment.
  for (int i = 0; i < 10; ++i) scene.lift(touching, made, {0.1, 0, 0});
  forces.compare(force(), stiffness * 0.01);
  // Opened to 0.09, the contact distance is 0.09 from then on.
  scene.lift(touching, made, {0, 0, 0.03});
  EXPECT_EQ(force(), 0.0);
  scene.lift(touching, made, {0, 0, -0.02});
  forces.compare(force(), stiffness * 0.02);
  // Opened fully, it is the true one.
  scene.lift(touching, made, {0, 0, 0.04});
  EXPECT_EQ(force(), 0.0);
  scene.lift(touching, made, {0, 0, -0.02});
  forces.compare(force(), stiffness * 0.01);
}

// PENMAX counts what comes beyond the overlap at the start.
TEST(InitialPenetration, IsNoReasonToLetANodeGo) {
  TipAt scene(0.07);
  scene.bodies.contact.release_depth = 0.2;
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  const auto force_after = [&](double shift) {
    scene.lift(touching, made, {0, 0, shift});
    test::settle(touching, made);
    return made.contact_force[at(made, scene.tip)].z;
  };
  const double stiffness = 0.1 * (1000.0 / 1.5) / std::sqrt(2.0);
  EXPECT_NEAR(force_after(-0.01), stiffness * 0.01, 1e-10);
  EXPECT_EQ(force_after(-0.011), 0);
  EXPECT_EQ(force_after(0.011), 0);
}

// Coincident surfaces: neither side is known, nothing pushes, and the side is taken where the node goes.
TEST(InitialPenetration, NodeOnTheMidSurfaceLeavesFreely) {
  for (const double side : {1.0, -1.0}) {
    const TipAt scene(0.0);
    domain::Domain made = scene.bodies.build();
    contact::Interface touching = scene.bodies.attach(made);
    test::add_forces(touching, made);
    const auto force = [&] { return made.contact_force[at(made, scene.tip)].z; };
    EXPECT_EQ(force(), 0.0);
    scene.lift(touching, made, {0, 0, side * 0.05});
    EXPECT_EQ(force(), 0.0);
    scene.lift(touching, made, {0, 0, -side * 0.01});
    EXPECT_GT(side * force(), 0.0);
  }
}

TEST(BirthAndDeath, ContactActsOnlyInBetween) {
  TipAt scene(0.2);
  scene.bodies.contact.birth_time = 0.0015;
  scene.bodies.contact.death_time = 0.0045;
  domain::Domain made = scene.bodies.build();
  contact::Interface touching = scene.bodies.attach(made);
  test::add_forces(touching, made);
  scene.lift(touching, made, {0, 0, -0.12});  // t = 1: not yet born
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  scene.lift(touching, made, {0, 0, 0});  // t = 2: found overlapping, which it tracks
  EXPECT_EQ(touching.statistics().initial_penetrations, 1);
  scene.lift(touching, made, {0, 0, -0.01});
  EXPECT_EQ(made.contacts[0].active_pairs, 1);
  scene.lift(touching, made, {0, 0, -0.01});
  EXPECT_EQ(made.contacts[0].active_pairs, 1);
  scene.lift(touching, made, {0, 0, -0.01});  // t = 5: dead
  EXPECT_EQ(made.contacts[0].active_pairs, 0);
  EXPECT_EQ(norm(made.contact_force[at(made, scene.tip)]), 0.0);
}

// Two sheets closer than their thickness: each goes half of the way. A fixed one leaves all of it to the
// other.
TEST(Initial, OverlapsAreMovedApart) {
  for (const char* held : {"", "nodes", "body"}) {
    const bool fixed = *held != 0;
    Bodies bodies(0.1);
    const Index low = bodies.sheet(4, 4, [](double u, double v) { return Vec3{u, v, 0}; });
    const Index high = bodies.sheet(4, 4, [](double u, double v) { return Vec3{u, v, 0.06}; });
    bodies.model.contacts.push_back(bodies.contact);
    if (held == std::string("body")) {
      bodies.model.rigid_bodies.resize(1);
      for (Index i = low; i < high; ++i) bodies.model.rigid_bodies[0].nodes.push_back(i);
    } else if (fixed) {
      for (Index i = low; i < high; ++i)
        bodies.model.fixed_nodes.push_back({.node = i, .translation = {true, true, true}, .rotation = {}});
    }
    const contact::MovedApart moved = contact::move_apart(bodies.model, {});
    EXPECT_EQ(moved.nodes, fixed ? 25 : 50);
    EXPECT_NEAR(moved.farthest, fixed ? 0.04 : 0.02, 1e-9);
    EXPECT_EQ(moved.left, 0);
    test::verified(std::string("two sheets that overlap, moved apart: place of the upper one, ") +
                       (fixed ? "the other held" : "both free"),
                   "geometry")
        .near(bodies.model.nodes.position[high + 7][2], fixed ? 0.1 : 0.08, 1e-9);
    EXPECT_NEAR(bodies.model.nodes.position[low + 7][2], fixed ? 0.0 : -0.02, 1e-9);
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    EXPECT_LT(touching.statistics().worst_initial, 1e-9);
    for (const domain::InitialOverlap& overlap : made.contacts[0].initial_overlaps)
      EXPECT_LT(overlap.depth, 1e-9);
  }
}

TEST(Initial, OverlapsAreListedTheDeepestFirst) {
  Bodies bodies(0.1);
  bodies.sheet(2, 2, [](double u, double v) { return Vec3{4 * u, 4 * v, 0}; });
  bodies.sheet(1, 1, [](double u, double v) { return Vec3{0.5 + u, 0.5 + v, 0.05 + 0.03 * u}; });
  domain::Domain made = bodies.build();
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const auto& overlaps = made.contacts[0].initial_overlaps;
  ASSERT_EQ(overlaps.size(), 4U);
  EXPECT_NEAR(overlaps[0].depth, 0.05, 1e-12);
  EXPECT_NEAR(overlaps[1].depth, 0.05, 1e-12);
  EXPECT_NEAR(overlaps[2].depth, 0.02, 1e-12);
  EXPECT_EQ(overlaps[0].node, 1009);
  EXPECT_EQ(overlaps[0].element, 5000);
}

}  // namespace
}  // namespace crumple::initial_test
