// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <optional>

namespace crumple::deck {

/// A place or a direction, in global axes, as the model has them.
using Vector = std::array<double, 3>;

inline Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double length_of(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}

inline bool is_finite(const Vector& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// Right-handed axes of unit length: the first along `first`, the second in the plane that `first` and
/// `other` span, on the side of `other`. Absent if the two span no plane, but for rounding.
inline std::optional<std::array<Vector, 3>> local_axes(const Vector& first, const Vector& other) {
  const auto of_length_one = [](const Vector& a) -> std::optional<Vector> {
    const double length = length_of(a);
    if (!(length > 0)) return std::nullopt;
    return Vector{a[0] / length, a[1] / length, a[2] / length};
  };
  const std::optional<Vector> x = of_length_one(first);
  constexpr double parallel = 1e-9;  // sine of the angle between the two
  const Vector normal = cross(first, other);
  const std::optional<Vector> z = of_length_one(normal);
  if (!x || !z || length_of(normal) <= parallel * length_of(first) * length_of(other)) return std::nullopt;
  return std::array{*x, cross(*z, *x), *z};
}

}  // namespace crumple::deck
