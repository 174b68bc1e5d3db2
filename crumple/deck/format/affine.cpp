// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/affine.hpp"

#include <cmath>

namespace crumple::deck {

namespace {

/// What rounding leaves of a rotation: angles are given with few digits, matrices are products of a few.
constexpr double hardly_any = 1e-9;

Vector sum(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// The map with this linear part that leaves a point where it is.
Affine about(const Vector& point, Affine map) {
  map.shift = difference(point, map.of_direction(point));
  return map;
}

}  // namespace

Vector Affine::of_direction(const Vector& x) const {
  return {dot(linear[0], x), dot(linear[1], x), dot(linear[2], x)};
}

Vector Affine::of_point(const Vector& x) const {
  return sum(of_direction(x), shift);
}

double Affine::determinant() const {
  return dot(linear[0], cross(linear[1], linear[2]));
}

bool Affine::is_shift() const {
  const Affine unmoved;
  for (std::size_t i = 0; i < 3; ++i)
    if (length_of(difference(linear[i], unmoved.linear[i])) > hardly_any) return false;
  return true;
}

bool Affine::keeps_axes() const {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j && std::fabs(linear[i][j]) > hardly_any * std::fabs(linear[j][j])) return false;
  return true;
}

bool Affine::keeps_lengths() const {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (std::fabs(dot(linear[i], linear[j]) - (i == j ? 1 : 0)) > hardly_any) return false;
  return true;
}

Affine then(const Affine& first, const Affine& second) {
  Affine both;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      both.linear[i][j] = 0;
      for (std::size_t k = 0; k < 3; ++k) both.linear[i][j] += second.linear[i][k] * first.linear[k][j];
    }
  both.shift = second.of_point(first.shift);
  return both;
}

Affine shift_by(const Vector& shift) {
  Affine map;
  map.shift = shift;
  return map;
}

Affine scaling(const Vector& factor) {
  Affine map;
  for (std::size_t i = 0; i < 3; ++i) map.linear[i][i] = factor[i];
  return map;
}

// Rodrigues' formula: x' = x cos + (a x x) sin + a (a . x) (1 - cos), with a of length one.
Affine rotation(const Vector& axis, const Vector& point, double angle) {
  const double length = length_of(axis);
  const Vector a = {axis[0] / length, axis[1] / length, axis[2] / length};
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const std::array<Vector, 3> turn = {Vector{0, -a[2], a[1]}, Vector{a[2], 0, -a[0]}, Vector{-a[1], a[0], 0}};
  Affine map;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      map.linear[i][j] = (i == j ? c : 0) + turn[i][j] * s + a[i] * a[j] * (1 - c);
  return about(point, map);
}

Affine mirroring(const Vector& point, const Vector& normal) {
  const double length = length_of(normal);
  const Vector n = {normal[0] / length, normal[1] / length, normal[2] / length};
  Affine map;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) map.linear[i][j] = (i == j ? 1 : 0) - 2 * n[i] * n[j];
  return about(point, map);
}

}  // namespace crumple::deck
