// SPDX-License-Identifier: BSD-3-Clause
// Edges that have gone through each other and are no longer pushed apart are counted; those that end by rule
// are not.
#include <gtest/gtest.h>

#include <vector>

#include "contact/bodies.hpp"

namespace crumple::lost_edges_test {
namespace {

using test::Bodies;
using test::Vec3;

/// Two wires of one beam each, 2 long, that cross: the upper one along x, 0.15 above the lower one, which is
/// along y. The upper one is then shot through the lower one in a step.
struct ShotWire {
  ShotWire() {
    bodies.add_wires(0.05);
    upper = bodies.wire(1, [](double u) { return Vec3{2 * u - 1, 0, 0.15}; });
    lower = bodies.wire(1, [](double u) { return Vec3{0, 2 * u - 1, 0}; });
    made = bodies.build(1.0);
    touching.emplace_back(bodies.attach(made));
    test::add_forces(touching[0], made);
    move({0, 0, -0.32});
  }
  void move(const Vec3& by) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index n = upper; n < lower; ++n) x[test::at(made, n)] += by;
    test::move_to(touching[0], made, x, 1e-3);
  }
  const domain::LostContacts& lost() const { return made.contacts[0].lost_edges; }
  Index astray() const { return touching[0].statistics().edges_astray; }

  Bodies bodies;
  Index upper = 0;
  Index lower = 0;
  domain::Domain made;
  std::vector<contact::Interface> touching;
};

TEST(LostEdges, OnesThatArePulledFurtherThroughThanTheyAreLongAreCountedOnceAndNamed) {
  ShotWire scene;
  ASSERT_EQ(scene.astray(), 1);
  scene.move({0, 0, -1.5});
  EXPECT_EQ(scene.astray(), 1);
  EXPECT_EQ(scene.lost().count, 0);
  scene.move({0, 0, -0.5});
  EXPECT_EQ(scene.astray(), 0);
  EXPECT_EQ(scene.lost().count, 1);
  EXPECT_EQ(scene.lost().cycle, scene.made.clock.cycle);
  EXPECT_EQ(scene.lost().node, scene.bodies.model.nodes.id[scene.lower]);
  scene.move({0, 0, -0.5});
  EXPECT_EQ(scene.lost().count, 1);
}

TEST(LostEdges, OnesThatComeBackAreReleased) {
  ShotWire scene;
  scene.move({0, 0, 0.5});
  EXPECT_EQ(scene.astray(), 0);
  EXPECT_EQ(scene.lost().count, 0);
}

TEST(LostEdges, OnesThatSlideOffAnEndAreReleased) {
  ShotWire scene;
  for (int i = 0; i < 12; ++i) scene.move({0.1, 0, 0});
  EXPECT_EQ(scene.astray(), 0);
  EXPECT_EQ(scene.lost().count, 0);
}

// A wire of several beams: the contact goes over from one to the next, and is lost with none.
TEST(LostEdges, OnesThatSlideToTheNextBeamAreKept) {
  Bodies bodies;
  bodies.add_wires(0.05);
  const Index upper = bodies.wire(4, [](double u) { return Vec3{4 * u - 2.4, 0, 0.15}; });
  const Index lower = bodies.wire(1, [](double u) { return Vec3{0, 2 * u - 1, 0}; });
  domain::Domain made = bodies.build(1.0);
  contact::Interface touching = bodies.attach(made);
  test::add_forces(touching, made);
  const auto move = [&](const Vec3& by) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index n = upper; n < lower; ++n) x[test::at(made, n)] += by;
    test::move_to(touching, made, x, 1e-3);
  };
  move({0, 0, -0.32});
  for (int i = 0; i < 15; ++i) {
    move({0.1, 0, 0});
    EXPECT_EQ(touching.statistics().edges_astray, 1) << i;
  }
  EXPECT_EQ(made.contacts[0].lost_edges.count, 0);
}

}  // namespace
}  // namespace crumple::lost_edges_test
