// SPDX-License-Identifier: BSD-3-Clause
// Contacts that end although the node is still where it must not be are counted, and those that end by rule
// are not.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/bodies.hpp"
#include "support/meshes.hpp"

namespace crumple::lost_nodes_test {
namespace {

using test::at;
using test::Bodies;
using test::Vec3;

constexpr double step = 1e-4;

/// A sheet of 6 x 4 unit squares in z = 0 and a triangle above it that stands on its tip, which is then shot
/// through the sheet in one step, to {1.45, 1.3, -0.09}.
struct ShotTip {
  explicit ShotTip(double release_depth = 0) : bodies(0.1) {
    bodies.contact.release_depth = release_depth;
    sheet = bodies.sheet(6, 4, [](double u, double v) { return Vec3{6 * u, 4 * v, 0}; });
    const Vec3 start{1.4, 1.3, 0.3};
    tip = bodies.node(start);
    const Index b = bodies.node(start + Vec3{2, 0.3, 3});
    const Index c = bodies.node(start + Vec3{2, -0.3, 3});
    bodies.shell(tip, b, c, c);
    made = bodies.build();
    touching.emplace_back(bodies.attach(made));
    test::add_forces(touching[0], made);
    move({1.45, 1.3, -0.09});
  }
  void move(const Vec3& to) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    const Vec3 shift = to - x[at(made, tip)];
    for (Index n = tip; n < tip + 3; ++n) x[at(made, n)] += shift;
    test::move_to(touching[0], made, x, step);
  }
  const domain::LostContacts& lost() const { return made.contacts[0].lost_nodes; }

  Bodies bodies;
  Index sheet = 0;
  Index tip = 0;
  domain::Domain made;
  std::vector<contact::Interface> touching;
};

TEST(LostNodes, OneThatLeavesItsSegmentBehindTheSurfaceIsCountedAndNamed) {
  ShotTip scene;
  ASSERT_EQ(scene.touching[0].statistics().nodes_astray, 1);
  EXPECT_EQ(scene.lost().count, 0);
  const Vec3 three_segments_on{4.6, 2.4, -0.09};
  scene.move(three_segments_on);
  EXPECT_EQ(scene.touching[0].statistics().nodes_astray, 0);
  EXPECT_EQ(scene.lost().count, 1);
  EXPECT_EQ(scene.lost().node, scene.bodies.model.nodes.id[scene.tip]);
  // Only the first is named, and what is lost is not counted again.
  scene.move({4.6, 2.4, -0.08});
  EXPECT_EQ(scene.lost().count, 1);
}

TEST(LostNodes, OneThatANeighbourTakesOverIsNot) {
  ShotTip scene;
  scene.move({2.3, 2.4, -0.09});
  EXPECT_EQ(scene.touching[0].statistics().nodes_astray, 1);
  EXPECT_EQ(scene.lost().count, 0);
}

TEST(LostNodes, OneThatComesBackAndLeavesIsNot) {
  ShotTip scene;
  scene.move({1.45, 1.3, 0.5});
  EXPECT_EQ(scene.touching[0].statistics().nodes_astray, 0);
  EXPECT_EQ(scene.lost().count, 0);
}

TEST(LostNodes, OneThatSlidesOverAFreeEdgeIsNot) {
  ShotTip scene;
  scene.move({1.5, 0.4, -0.09});
  ASSERT_EQ(scene.touching[0].statistics().nodes_astray, 1);
  scene.move({1.5, -0.4, -0.09});
  EXPECT_EQ(scene.touching[0].statistics().nodes_astray, 0);
  EXPECT_EQ(scene.lost().count, 0);
}

/// A sheet of 6 x 4 squares, 6 wide, that bends at x = 3, z = 0, and a triangle below it, whose tip is then
/// shot through the left slope and moved along over the right one. Seen from there the bend is a ridge, the
/// nearest place of both slopes, or a valley, in which each slope has a nearest place of its own.
TEST(LostNodes, OneThatTheOtherSlopeOfABendTakesOverIsNot) {
  for (const double slope : {-1.0, 0.2}) {
    Bodies bodies(0.1);
    bodies.sheet(6, 4, [&](double u, double v) { return Vec3{6 * u, 4 * v, slope * std::fabs(6 * u - 3)}; });
    const Vec3 start{2.8, 1.3, -0.6};
    const Index tip = bodies.node(start);
    const Index b = bodies.node(start + Vec3{0.3, 0.3, -3});
    const Index c = bodies.node(start + Vec3{0.3, -0.3, -3});
    bodies.shell(tip, b, c, c);
    domain::Domain made = bodies.build();
    contact::Interface touching = bodies.attach(made);
    test::add_forces(touching, made);
    const auto move = [&](double x, double above) {
      std::vector<Vec3> positions(made.nodes.position.begin(), made.nodes.position.end());
      const Vec3 to{x, 1.3, slope * std::fabs(x - 3) + above};
      const Vec3 shift = to - positions[at(made, tip)];
      for (Index n = tip; n < tip + 3; ++n) positions[at(made, n)] += shift;
      test::move_to(touching, made, positions, step);
    };
    move(2.98, 0.04);
    ASSERT_EQ(touching.statistics().nodes_astray, 1) << slope;
    for (const double x : {3.005, 3.02, 3.1, 3.2, 3.3}) {
      move(x, 0.04);
      EXPECT_GE(touching.statistics().nodes_astray, 1) << slope << ", " << x;
      EXPECT_LT(made.contact_force[at(made, tip)].z, 0) << slope << ", " << x;
    }
    EXPECT_EQ(made.contacts[0].lost_nodes.count, 0) << slope;
  }
}

/// PENMAX lets a node go that is too deep: that is no loss.
TEST(LostNodes, OneThatIsTooDeepIsNot) {
  ShotTip scene(0.1);
  ASSERT_EQ(scene.lost().count, 0);
  scene.move({4.6, 2.4, -0.09});
  EXPECT_EQ(scene.lost().count, 0);
}

TEST(LostNodes, OneWhoseShellErodesIsNot) {
  ShotTip scene;
  test::make_erodible(scene.made);
  test::erode(scene.made, {1 * 4 + 1});
  scene.move({1.45, 1.3, -0.1});
  EXPECT_EQ(scene.touching[0].statistics().nodes_astray, 0);
  EXPECT_EQ(scene.lost().count, 0);
}

/// A block of 6 x 2 x 1 elements, 6 x 2 x `height` in size, below z = 0, and a small one whose lowest nodes
/// are 0.01 above it and then 0.05 below its upper side.
struct SunkBlock {
  explicit SunkBlock(double height = 1) : bodies(0.1) {
    bodies.take_two_parts_of_solids();
    test::add_box(bodies.model, 0, 6, 2, 1, [&](double u, double v, double w) {
      return test::Point{6 * u, 2 * v, height * (w - 1)};
    });
    small = test::add_box(bodies.model, 1, 1, 1, 1, [](double u, double v, double w) {
      return test::Point{0.4 + 0.2 * u, 0.4 + 0.2 * v, 0.01 + 0.2 * w};
    });
    made = bodies.build();
    touching.emplace_back(bodies.attach(made));
    test::add_forces(touching[0], made);
    move({0, 0, -0.06});
  }
  void move(const Vec3& by) {
    std::vector<Vec3> x(made.nodes.position.begin(), made.nodes.position.end());
    for (Index n = small; n < small + 8; ++n) x[at(made, n)] += by;
    test::move_to(touching[0], made, x, step);
  }

  Bodies bodies;
  Index small = 0;
  domain::Domain made;
  std::vector<contact::Interface> touching;
};

TEST(LostNodes, OnesThatLeaveTheirFaceWithinTheSolidAreCounted) {
  SunkBlock scene;
  ASSERT_GT(scene.made.contacts[0].penetration, 0.04);
  EXPECT_EQ(scene.made.contacts[0].lost_nodes.count, 0);
  scene.move({4.05, 0, 0});
  EXPECT_EQ(scene.made.contacts[0].lost_nodes.count, 4);
}

TEST(LostNodes, OnesThatLeaveOverTheRimOfTheirFaceAreNot) {
  SunkBlock scene;
  scene.move({0, -3, 0});
  EXPECT_EQ(scene.made.contacts[0].lost_nodes.count, 0);
  EXPECT_EQ(scene.made.contacts[0].penetration, 0);
}

/// Deeper than territories reach, it passes from face to face although the candidates were found afresh
/// meanwhile.
TEST(LostNodes, OnesThatANeighbourTakesOverDeepInTheSolidAreNot) {
  SunkBlock scene(4);
  for (int i = 0; i < 23; ++i) scene.move({0, 0, -0.05});
  ASSERT_NEAR(scene.made.contacts[0].penetration, 1.2, 1e-12);
  for (int i = 0; i < 50; ++i) scene.move({0.1, 0, 0});
  EXPECT_EQ(scene.made.contacts[0].lost_nodes.count, 0);
  EXPECT_NEAR(scene.made.contacts[0].penetration, 1.2, 1e-12);
}

}  // namespace
}  // namespace crumple::lost_nodes_test
