// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "math/vec3.hpp"

namespace crumple::math {

/// A rotation, as a quaternion of unit length.
struct Quaternion {
  double w = 1;
  Vec3 v;
};

/// The rotation `second` after `first`.
inline Quaternion operator*(const Quaternion& second, const Quaternion& first) {
  return {second.w * first.w - dot(second.v, first.v),
          second.w * first.v + first.w * second.v + cross(second.v, first.v)};
}

/// The same rotation with a length of one.
inline Quaternion unit_quaternion(const Quaternion& q) {
  const double inverse = 1.0 / std::sqrt(q.w * q.w + dot(q.v, q.v));
  return {inverse * q.w, inverse * q.v};
}

/// The rotation about `c` whose half angle has the tangent |c| (Cayley's transform of 2 c). Without any
/// function but the root, so that it has the same bits everywhere.
inline Quaternion cayley_rotation(const Vec3& c) {
  return unit_quaternion(Quaternion{1.0, c});
}

/// A matrix of three rows and columns, held by columns.
struct Matrix3 {
  std::array<Vec3, 3> column{};
};

inline Matrix3 unit_matrix() {
  return {{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
}

inline Vec3 operator*(const Matrix3& a, const Vec3& b) {
  return b.x * a.column[0] + b.y * a.column[1] + b.z * a.column[2];
}
/// The transposed matrix times a vector.
inline Vec3 transposed_product(const Matrix3& a, const Vec3& b) {
  return {dot(a.column[0], b), dot(a.column[1], b), dot(a.column[2], b)};
}

/// The rotation as a matrix, whose columns are the images of the axes.
inline Matrix3 matrix_of(const Quaternion& q) {
  const double ww = q.w * q.w - dot(q.v, q.v);
  const auto image = [&](const Vec3& e) { return ww * e + 2 * dot(q.v, e) * q.v + 2 * q.w * cross(q.v, e); };
  return {{image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1})}};
}

/// Solution of a x = b by Cramer's rule. The matrix must not be singular.
Vec3 solve(const Matrix3& a, const Vec3& b);

/// Principal moments and axes of a symmetric tensor.
struct PrincipalAxes {
  Vec3 moment;
  Quaternion axes;  ///< from the principal axes to those of the tensor
};

/// By Jacobi's rotations (C.G.J. Jacobi, 1846; G.H. Golub, C.F. Van Loan, Matrix Computations, section 8.5).
/// The axes are right-handed, in no particular order. Only plain operations and roots.
PrincipalAxes principal_axes(const Matrix3& tensor);

/// The rotation that has these columns, which are right-handed and of unit length.
Quaternion quaternion_of(const Matrix3& columns);

}  // namespace crumple::math
