// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/point_in_solid.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace crumple::constraints::point_in_solid_test {
namespace {

using math::Vec3;

using Corners = std::array<Vec3, 8>;

constexpr Corners skewed = {{{0, 0, 0},
                             {2, 0.3, -0.1},
                             {2.4, 1.7, 0.2},
                             {-0.2, 1.5, 0.1},
                             {0.3, 0.1, 1.2},
                             {2.1, -0.2, 1.5},
                             {2.2, 1.9, 1.1},
                             {0.1, 1.4, 1.3}}};

/// The trilinear map, written out once more.
Vec3 map(const Corners& corner, double r, double s, double t) {
  const auto line = [](const Vec3& a, const Vec3& b, double at) {
    return 0.5 * (1 - at) * a + 0.5 * (1 + at) * b;
  };
  const Vec3 low = line(line(corner[0], corner[1], r), line(corner[3], corner[2], r), s);
  const Vec3 high = line(line(corner[4], corner[5], r), line(corner[7], corner[6], r), s);
  return line(low, high, t);
}

template <std::size_t Count>
double sum_of(const std::array<double, Count>& weight) {
  return std::accumulate(weight.begin(), weight.end(), 0.0);
}

TEST(PointInSolid, WeightsOfAHexahedronGiveThePoint) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> natural(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double r = natural(random);
    const double s = natural(random);
    const double t = natural(random);
    const Vec3 point = map(skewed, r, s, t);
    const auto found = point_in_hexahedron(skewed, point);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->beyond, 0);
    EXPECT_NEAR(sum_of(found->weight), 1, 1e-15);
    EXPECT_NEAR(found->weight[0], 0.125 * (1 - r) * (1 - s) * (1 - t), 1e-14);
    EXPECT_NEAR(found->weight[5], 0.125 * (1 + r) * (1 - s) * (1 + t), 1e-14);
    Vec3 again;
    for (std::size_t k = 0; k < 8; ++k) again += found->weight[k] * skewed[k];
    EXPECT_LT(norm(again - point), 1e-14);
  }
}

TEST(PointInSolid, OnAFaceTheOthersHaveNoWeight) {
  const auto found = point_in_hexahedron(skewed, map(skewed, 0.3, -0.6, 1 + 1e-11));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->beyond, 0);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(found->weight[k], 0);
  EXPECT_EQ(sum_of(found->weight), 1);
}

TEST(PointInSolid, TellsHowFarOutsideAPointIs) {
  const auto near = point_in_hexahedron(skewed, map(skewed, 1.02, 0.2, 0.1));
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->beyond, 0.02, 1e-13);
  const auto far = point_in_hexahedron(skewed, {40, 3, -20});
  EXPECT_TRUE(!far || far->beyond > 0.5);
}

// A wedge repeats the nodes of an edge; the map has no inverse on that edge, and Newton's method is slow.
TEST(PointInSolid, WedgesAndPyramids) {
  const Corners wedge = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 1}, {0.5, 0, 1}, {0.5, 1, 1}, {0.5, 1, 1}}};
  const Corners pyramid = {{{0, 0, 0},
                            {1, 0, 0},
                            {1, 1, 0},
                            {0, 1, 0},
                            {0.5, 0.5, 1},
                            {0.5, 0.5, 1},
                            {0.5, 0.5, 1},
                            {0.5, 0.5, 1}}};
  for (const Corners& corner : {wedge, pyramid})
    for (const Vec3& point :
         {Vec3{0.5, 0.5, 0.4}, Vec3{0.4, 0.6, 0.8}, Vec3{0.5, 0.5, 1}, Vec3{0.2, 0.3, 0}}) {
      const auto found = point_in_hexahedron(corner, point);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->beyond, 0);
      Vec3 again;
      for (std::size_t k = 0; k < 8; ++k) again += found->weight[k] * corner[k];
      EXPECT_LT(norm(again - point), 1e-8);
    }
  const auto outside = point_in_hexahedron(wedge, {0.9, 0.5, 0.8});
  EXPECT_TRUE(!outside || outside->beyond > 0.5);
}

TEST(PointInSolid, WeightsOfATetrahedronAreShares) {
  const std::array<Vec3, 4> corner = {{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}}};
  const auto inside = point_in_tetrahedron(corner, {0.5, 0.6, 0.8});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->beyond, 0);
  EXPECT_NEAR(inside->weight[0], 0.35, 1e-15);
  EXPECT_NEAR(inside->weight[1], 0.25, 1e-15);
  EXPECT_NEAR(inside->weight[2], 0.2, 1e-15);
  EXPECT_NEAR(inside->weight[3], 0.2, 1e-15);
  const auto on_face = point_in_tetrahedron(corner, {0.5, 0.6, 1e-10});
  ASSERT_TRUE(on_face);
  EXPECT_EQ(on_face->weight[3], 0);
  const auto outside = point_in_tetrahedron(corner, {-0.04, 0.6, 0.8});
  ASSERT_TRUE(outside);
  EXPECT_NEAR(outside->beyond, 0.04, 1e-15);
  EXPECT_FALSE(point_in_tetrahedron({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {0, 0, 1}));
}

}  // namespace
}  // namespace crumple::constraints::point_in_solid_test
