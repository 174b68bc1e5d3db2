// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest point and the distance by the kernels against the plain one: the same bits.

#include "contact/surface/nearest_point_kernel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>

namespace crumple::contact::nearest_point_kernel_test {
namespace {

std::uint64_t bits(double a) {
  return std::bit_cast<std::uint64_t>(a);
}

void expect_same(const NearestPoint& a, const NearestPoint& b) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(bits(a.point[axis]), bits(b.point[axis]));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(bits(a.weight[k]), bits(b.weight[k])) << k;
  EXPECT_EQ(bits(a.distance_squared), bits(b.distance_squared));
  EXPECT_EQ(a.feature, b.feature);
  EXPECT_EQ(a.local, b.local);
}

SegmentShape shape_with(const std::array<Vec3, 4>& corner) {
  SegmentShape shape{corner, 0.25 * ((corner[0] + corner[1]) + (corner[2] + corner[3])), false};
  shape.triangle = corner[2].x == corner[3].x && corner[2].y == corner[3].y && corner[2].z == corner[3].z;
  if (shape.triangle) shape.centre = (1.0 / 3.0) * (corner[0] + corner[1] + corner[2]);
  return shape;
}

class NearestPointKernelTest : public ::testing::TestWithParam<Isa> {
 protected:
  void compare(const SegmentShape& shape, const Vec3& p) {
    const NearestPoint plain = nearest_point(shape, p);
    expect_same(nearest_point_kernel(GetParam())(shape, p), plain);
    ++features_[plain.feature];
    pairs_.set(held_, shape, p);
    expected_[static_cast<std::size_t>(held_)] = std::sqrt(plain.distance_squared);
    if (++held_ == together_) measure_distances();
  }
  /// Of the pairs since the last time; the number of those measured together goes round.
  void measure_distances() {
    std::array<double, PairsInLanes::lanes + 1> found{};
    constexpr double untouched = -7;
    found.fill(untouched);
    distances_kernel(GetParam())(pairs_, held_, found.data());
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(held_); ++lane)
      EXPECT_EQ(bits(found[lane]), bits(expected_[lane]));
    EXPECT_EQ(found[static_cast<std::size_t>(held_)], untouched);
    together_ = together_ % PairsInLanes::lanes + 1;
    held_ = 0;
  }
  double anywhere() { return std::uniform_real_distribution<double>(-1, 1)(random_); }
  Vec3 point(double size) {
    const double x = size * anywhere();
    const double y = size * anywhere();
    return {x, y, size * anywhere()};
  }

  std::mt19937 random_{3};
  std::map<Feature, int> features_;
  PairsInLanes pairs_;
  std::array<double, PairsInLanes::lanes> expected_{};
  int held_ = 0;
  int together_ = 1;
};

TEST_P(NearestPointKernelTest, IsThatOfWarpedSegmentsToTheBit) {
  const std::array<Vec3, 4> square{Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{-1, 1, 0}};
  for (int i = 0; i < 20000; ++i) {
    std::array<Vec3, 4> corner = square;
    for (Vec3& a : corner) a += point(0.5);
    compare(shape_with(corner), point(2));
    corner[3] = corner[2];
    compare(shape_with(corner), point(2));
  }
  EXPECT_GT(features_[Feature::Face], 1000);
  EXPECT_GT(features_[Feature::Edge], 1000);
  EXPECT_GT(features_[Feature::Corner], 1000);
}

TEST_P(NearestPointKernelTest, IsTheSameWhereSeveralPlacesAreEquallyNear) {
  const std::array<Vec3, 4> square{Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{-1, 1, 0}};
  for (double x = -2; x <= 2; x += 0.5)
    for (double y = -2; y <= 2; y += 0.5)
      for (const double z : {0.0, 0.5}) compare(shape_with(square), {x, y, z});
  EXPECT_GT(features_[Feature::Edge], 10);
  EXPECT_GT(features_[Feature::Corner], 10);
}

TEST_P(NearestPointKernelTest, IsTheSameOfSegmentsWithoutArea) {
  const Vec3 a{1, 2, 3};
  const Vec3 b{2, 2, 3};
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = point(4);
    compare(shape_with({a, b, a, b}), p);
    compare(shape_with({a, a, b, b}), p);
    compare(shape_with({a, 0.5 * (a + b), b, 0.5 * (a + b)}), p);
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, NearestPointKernelTest, ::testing::ValuesIn(available_isas()),
                         [](const auto& tested) { return std::string(isa_name(tested.param)); });

}  // namespace
}  // namespace crumple::contact::nearest_point_kernel_test
