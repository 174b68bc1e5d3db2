// SPDX-License-Identifier: BSD-3-Clause
#include "math/rotation.hpp"

#include <algorithm>

namespace crumple::math {

Vec3 solve(const Matrix3& a, const Vec3& b) {
  const auto& [p, q, r] = a.column;
  const Vec3 qr = cross(q, r);
  const double inverse = 1.0 / dot(p, qr);
  return inverse * Vec3{dot(b, qr), dot(p, cross(b, r)), dot(p, cross(q, b))};
}

namespace {

/// Turns columns i and j of `axes`, and the tensor with them, so that its entry ij vanishes.
void annihilate(Matrix3& tensor, Matrix3& axes, int i, int j) {
  Vec3& ti = tensor.column[static_cast<std::size_t>(i)];
  Vec3& tj = tensor.column[static_cast<std::size_t>(j)];
  const double off = ti[j];
  if (off == 0) return;
  const double theta = 0.5 * (tj[j] - ti[i]) / off;
  const double t = (theta >= 0 ? 1.0 : -1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1.0 / std::sqrt(t * t + 1);
  const double s = t * c;
  const auto turn = [&](Vec3& a, Vec3& b) {
    const Vec3 old = a;
    a = c * old - s * b;
    b = s * old + c * b;
  };
  turn(ti, tj);
  for (Vec3& column : tensor.column) {
    const double old = column[i];
    column[i] = c * old - s * column[j];
    column[j] = s * old + c * column[j];
  }
  ti[j] = tj[i] = 0;
  turn(axes.column[static_cast<std::size_t>(i)], axes.column[static_cast<std::size_t>(j)]);
}

}  // namespace

Quaternion quaternion_of(const Matrix3& columns) {
  const Vec3& a = columns.column[0];
  const Vec3& b = columns.column[1];
  const Vec3& c = columns.column[2];
  // The largest of the four squares is taken as divisor (S.W. Shepperd, J. Guidance and Control 1, 1978).
  const double trace = a.x + b.y + c.z;
  const double largest = std::max({trace, a.x, b.y, c.z});
  if (trace >= largest) return unit_quaternion(Quaternion{1 + trace, {b.z - c.y, c.x - a.z, a.y - b.x}});
  if (a.x >= largest)
    return unit_quaternion(Quaternion{b.z - c.y, {1 + 2 * a.x - trace, b.x + a.y, c.x + a.z}});
  if (b.y >= largest)
    return unit_quaternion(Quaternion{c.x - a.z, {b.x + a.y, 1 + 2 * b.y - trace, c.y + b.z}});
  return unit_quaternion(Quaternion{a.y - b.x, {c.x + a.z, c.y + b.z, 1 + 2 * c.z - trace}});
}

PrincipalAxes principal_axes(const Matrix3& tensor) {
  Matrix3 turned = tensor;
  Matrix3 axes{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  constexpr int sweeps = 20;  // each squares what is left off the diagonal; a few are enough
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    annihilate(turned, axes, 0, 1);
    annihilate(turned, axes, 0, 2);
    annihilate(turned, axes, 1, 2);
  }
  return {{turned.column[0].x, turned.column[1].y, turned.column[2].z}, quaternion_of(axes)};
}

}  // namespace crumple::math
