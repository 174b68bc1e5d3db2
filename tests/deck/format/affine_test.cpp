// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/affine.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace crumple::deck::affine_test {
namespace {

void expect_near(const Vector& a, const Vector& b) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12) << i;
}

constexpr double right_angle = std::numbers::pi / 2;

TEST(Affine, RotatesRightHandedAboutAnAxisThroughAPoint) {
  const Affine about_z = rotation({0, 0, 2}, {1, 0, 0}, right_angle);
  expect_near(about_z.of_point({2, 0, 5}), {1, 1, 5});
  expect_near(about_z.of_point({1, 0, -1}), {1, 0, -1});
  expect_near(about_z.of_direction({1, 0, 0}), {0, 1, 0});
  EXPECT_TRUE(about_z.keeps_lengths());
  EXPECT_FALSE(about_z.is_shift());
  EXPECT_FALSE(about_z.mirrors());
}

TEST(Affine, MirrorsAtAPlane) {
  const Affine mirror = mirroring({1, 0, 0}, {3, 0, 0});
  expect_near(mirror.of_point({4, 2, 1}), {-2, 2, 1});
  EXPECT_TRUE(mirror.mirrors());
  EXPECT_TRUE(mirror.keeps_lengths());
}

TEST(Affine, TheFirstActsFirst) {
  const Affine turn = rotation({0, 0, 1}, {}, right_angle);
  const Affine shift = shift_by({10, 0, 0});
  expect_near(then(turn, shift).of_point({1, 0, 0}), {10, 1, 0});
  expect_near(then(shift, turn).of_point({1, 0, 0}), {0, 11, 0});
  expect_near(then(scaling({2, 3, 4}), shift).of_point({1, 1, 1}), {12, 3, 4});
  EXPECT_TRUE(shift.is_shift());
  EXPECT_FALSE(scaling({2, 2, 2}).keeps_lengths());
}

}  // namespace
}  // namespace crumple::deck::affine_test
