// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/wall_shapes.hpp"
#include "support/largest.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

namespace crumple::constraints::wall_shapes_test {
namespace {

using math::Vec3;
using model::WallShape;

model::RigidWall make(WallShape shape) {
  model::RigidWall wall;
  wall.shape = shape;
  wall.point = {1, 2, 3};
  wall.normal = {0, 0, 1};
  wall.edge = {1, 0, 0};
  wall.radius = 2;
  return wall;
}

/// Whether the wall is in the way of a node, and the velocity it then is left with.
struct Outcome {
  bool stopped = false;
  Vec3 velocity;
};
Outcome move(const model::RigidWall& wall, const Vec3& position, const Vec3& velocity, double step = 1) {
  return std::visit(
      [&](const auto& shape) {
        WallLimit limit;
        if (!limit_of(shape, position, velocity, step, limit)) return Outcome{false, velocity};
        EXPECT_NEAR(norm(limit.normal), 1, 1e-14);
        return Outcome{true, velocity + (limit.slowest - dot(velocity, limit.normal)) * limit.normal};
      },
      wall_surface(wall));
}

TEST(WallShapes, ARectangleStopsInsideItsEdgesOnly) {
  model::RigidWall wall = make(WallShape::Flat);
  wall.lengths = {4, 2, 0};
  // It spans x from 1 to 5 and, as m = n x l, y from 2 to 4.
  EXPECT_TRUE(move(wall, {1.1, 2.1, 3.5}, {0, 0, -1}).stopped);
  EXPECT_TRUE(move(wall, {4.9, 3.9, 3.5}, {0, 0, -1}).stopped);
  EXPECT_FALSE(move(wall, {0.9, 3, 3.5}, {0, 0, -1}).stopped);
  EXPECT_FALSE(move(wall, {5.1, 3, 3.5}, {0, 0, -1}).stopped);
  EXPECT_FALSE(move(wall, {3, 1.9, 3.5}, {0, 0, -1}).stopped);
  EXPECT_FALSE(move(wall, {3, 4.1, 3.5}, {0, 0, -1}).stopped);
}

TEST(WallShapes, ARectangleCountsWhereThePathMeetsIt) {
  model::RigidWall wall = make(WallShape::Flat);
  wall.lengths = {4, 2, 0};
  // Both begin beside the rectangle or end there; the path crosses the plane halfway.
  EXPECT_TRUE(move(wall, {0.5, 3, 3.5}, {2, 0, -1}).stopped);
  EXPECT_FALSE(move(wall, {4.5, 3, 3.5}, {2, 0, -1}).stopped);
}

TEST(WallShapes, ARectangleLetsPassWhatComesFromBehind) {
  model::RigidWall wall = make(WallShape::Flat);
  wall.lengths = {4, 2, 0};
  EXPECT_FALSE(move(wall, {2, 3, 2.9}, {0, 0, 1}).stopped);
  EXPECT_FALSE(move(wall, {2, 3, 2.9}, {0, 0, -1}).stopped);
}

TEST(WallShapes, ARectangleHoldsANodeThatRoundingPutBehind) {
  model::RigidWall wall = make(WallShape::Flat);
  wall.lengths = {4, 2, 0};
  const Outcome outcome = move(wall, {2, 3, 3 - 1e-15}, {0.5, 0, -1});
  EXPECT_TRUE(outcome.stopped);
  EXPECT_EQ(outcome.velocity.z, 0);
  EXPECT_EQ(outcome.velocity.x, 0.5);
}

TEST(WallShapes, LengthsOfZeroAreInfinite) {
  const model::RigidWall flat = make(WallShape::Flat);
  EXPECT_TRUE(move(flat, {1e6, -1e6, 3.5}, {0, 0, -1}).stopped);
  const model::RigidWall prism = make(WallShape::Prism);
  EXPECT_TRUE(move(prism, {1e6, -1e6, 3.5}, {0, 0, -1}).stopped);
  const model::RigidWall cylinder = make(WallShape::Cylinder);
  EXPECT_TRUE(move(cylinder, {3.5, 2, 1e6}, {-1, 0, 0}).stopped);
}

// The plane is oblique, so that a node that is put on it rounds to one side or the other.
TEST(WallShapes, AnEndlessRectangleStopsWhatAPlaneDoes) {
  model::RigidWall flat = make(WallShape::Flat);
  model::RigidWall plane = make(WallShape::Plane);
  flat.normal = plane.normal = {0.4, 0.2, 1};
  flat.edge = {1 / std::sqrt(1.16), 0, -0.4 / std::sqrt(1.16)};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-10, 10);
  int behind = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 position{number(random), number(random), 12 + number(random)};
    const Vec3 velocity{number(random), number(random), -40};
    const Outcome first = move(flat, position, velocity);
    const Outcome same = move(plane, position, velocity);
    EXPECT_EQ(first.stopped, same.stopped);
    EXPECT_EQ(norm(first.velocity - same.velocity), 0);
    if (!first.stopped) continue;
    const Vec3 on_plane = position + first.velocity;
    const double height = dot(on_plane - Vec3{1, 2, 3}, normalised(Vec3{0.4, 0.2, 1}));
    behind += height < 0 ? 1 : 0;
    EXPECT_TRUE(move(flat, on_plane, velocity).stopped) << height;
  }
  EXPECT_GT(behind, 100);
}

TEST(WallShapes, EveryFaceOfAPrismStops) {
  model::RigidWall wall = make(WallShape::Prism);
  wall.lengths = {4, 2, 6};
  // x from 1 to 5, y from 2 to 4, z from -3 to 3.
  const std::array<std::pair<Vec3, Vec3>, 6> arrivals = {{{{0.5, 3, 0}, {1, 0, 0}},
                                                          {{5.5, 3, 0}, {-1, 0, 0}},
                                                          {{3, 1.8, 0}, {0, 0.5, 0}},
                                                          {{3, 4.2, 0}, {0, -0.5, 0}},
                                                          {{3, 3, -3.3}, {0, 0, 0.5}},
                                                          {{3, 3, 3.3}, {0, 0, -0.5}}}};
  const std::array<double, 6> reach = {0.5, 0.5, 0.2, 0.2, 0.3, 0.3};
  test::Largest ways("nodes that meet the six faces of a rigid prism: way left, error", "geometry", 1e-14);
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    const auto& [position, velocity] = arrivals[i];
    const Outcome outcome = move(wall, position, velocity);
    EXPECT_TRUE(outcome.stopped) << i;
    ways.compare(norm(outcome.velocity), reach[i], 1, std::to_string(i));
    EXPECT_FALSE(move(wall, position, -velocity).stopped) << i;
  }
}

TEST(WallShapes, EndsOfACylinderStop) {
  model::RigidWall wall = make(WallShape::Cylinder);
  wall.lengths[0] = 5;
  test::verified("node that meets the end of a rigid cylinder: way left", "geometry")
      .near(move(wall, {1, 2.5, 8.2}, {0, 0, -1}).velocity.z, -0.2, 1e-14);
  EXPECT_NEAR(move(wall, {1, 2.5, 2.9}, {0, 0, 1}).velocity.z, 0.1, 1e-14);
  EXPECT_FALSE(move(wall, {1, 2.5, 8.2}, {3, 0, -1}).stopped) << "passes beside";
}

TEST(WallShapes, ANodeEndsOnTheSurfaceAlongItsNormal) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  int stopped = 0;
  test::Largest places("nodes that meet a rigid sphere: distance from its surface", "geometry", 1e-13);
  test::Largest pushes("nodes that meet a rigid sphere: push off the normal", "no friction", 1e-13);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = Vec3{1, 2, 3} + 2.3 * normalised(Vec3{number(random), number(random), number(random)});
    const Vec3 velocity = {number(random), number(random), number(random)};
    const Outcome ball = move(make(WallShape::Sphere), from, velocity);
    if (ball.stopped) {
      const Vec3 end = from + ball.velocity;
      places.compare(norm(end - Vec3{1, 2, 3}), 2);
      const Vec3 pushed = ball.velocity - velocity;
      pushes.add(norm(cross(pushed, end - Vec3{1, 2, 3})));
      ++stopped;
    } else {
      EXPECT_GE(norm(from + velocity - Vec3{1, 2, 3}), 2);
    }
  }
  EXPECT_GT(stopped, 200);
}

TEST(WallShapes, ANodeThatStartsInsideIsHeldAndNotThrownOut) {
  for (const WallShape shape : {WallShape::Sphere, WallShape::Cylinder, WallShape::Prism}) {
    model::RigidWall wall = make(shape);
    if (shape == WallShape::Prism) wall.lengths = {4, 4, 4};
    const Vec3 inside = shape == WallShape::Prism ? Vec3{2.5, 4, 2.5} : Vec3{2.5, 2, 3};
    const Vec3 inwards = shape == WallShape::Prism ? Vec3{0, 0, -0.1} : Vec3{-0.1, 0, 0};
    const Outcome outcome = move(wall, inside, inwards);
    EXPECT_TRUE(outcome.stopped);
    EXPECT_NEAR(norm(outcome.velocity), 0, 1e-14);
    EXPECT_FALSE(move(wall, inside, -inwards).stopped);
  }
}

}  // namespace
}  // namespace crumple::constraints::wall_shapes_test
