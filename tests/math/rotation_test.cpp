// SPDX-License-Identifier: BSD-3-Clause
#include "math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace crumple::math::rotation_test {
namespace {

double difference(const Matrix3& a, const Matrix3& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += norm(a.column[i] - b.column[i]);
  return sum;
}

TEST(Rotation, CayleyTurnsByTwiceTheAngleWhoseTangentItIs) {
  const double angle = 0.7;
  const Matrix3 turn = matrix_of(cayley_rotation({0, 0, std::tan(angle / 2)}));
  EXPECT_LT(norm(turn * Vec3{1, 0, 2} - Vec3{std::cos(angle), std::sin(angle), 2}), 1e-15);
  EXPECT_LT(norm(transposed_product(turn, turn * Vec3{1, 2, 3}) - Vec3{1, 2, 3}), 1e-15);
}

TEST(Rotation, ProductIsOneAfterTheOther) {
  const Quaternion first = cayley_rotation({0.3, -0.2, 0.5});
  const Quaternion second = cayley_rotation({-0.1, 0.7, 0.2});
  const Vec3 v{1, -2, 0.5};
  EXPECT_LT(norm(matrix_of(second * first) * v - matrix_of(second) * (matrix_of(first) * v)), 1e-15);
}

TEST(Rotation, QuaternionOfAMatrixGivesItBack) {
  // Half turns about each axis make every one of the four squares the largest.
  for (const Vec3& c : {Vec3{0.1, 0.2, 0.3}, Vec3{40, 1, 2}, Vec3{1, 40, 2}, Vec3{1, 2, 40}, Vec3{}}) {
    const Matrix3 matrix = matrix_of(cayley_rotation(c));
    EXPECT_LT(difference(matrix_of(quaternion_of(matrix)), matrix), 1e-14);
  }
}

TEST(Rotation, SolvesLinearEquations) {
  const Matrix3 a{{Vec3{4, 1, 0}, Vec3{-1, 3, 0.5}, Vec3{0.2, 0.7, 2}}};
  const Vec3 x{1, -2, 3};
  EXPECT_LT(norm(solve(a, a * x) - x), 1e-14);
}

TEST(Rotation, PrincipalAxesMakeTheTensorDiagonal) {
  const Matrix3 axes = matrix_of(cayley_rotation({0.4, -1.2, 0.8}));
  for (const Vec3& moments : {Vec3{3, 1, 7}, Vec3{2, 2, 5}, Vec3{1, 1, 1}, Vec3{0, 4, 4}}) {
    Matrix3 tensor;
    for (int i = 0; i < 3; ++i) {
      Vec3 unit;
      unit[i] = 1;
      const Vec3 local = transposed_product(axes, unit);
      tensor.column[static_cast<std::size_t>(i)] =
          axes * Vec3{moments.x * local.x, moments.y * local.y, moments.z * local.z};
    }
    const PrincipalAxes found = principal_axes(tensor);
    const Matrix3 back = matrix_of(found.axes);
    for (int i = 0; i < 3; ++i) {
      const Vec3& axis = back.column[static_cast<std::size_t>(i)];
      EXPECT_LT(norm(tensor * axis - found.moment[i] * axis), 1e-14);
    }
    EXPECT_NEAR(dot(cross(back.column[0], back.column[1]), back.column[2]), 1, 1e-14);
  }
}

}  // namespace
}  // namespace crumple::math::rotation_test
