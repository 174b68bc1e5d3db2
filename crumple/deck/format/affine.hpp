// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "deck/format/vector.hpp"

namespace crumple::deck {

/// Where a transformation puts points: x' = linear x + shift.
struct Affine {
  std::array<Vector, 3> linear{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};  ///< by rows
  Vector shift{};

  Vector of_point(const Vector& x) const;
  Vector of_direction(const Vector& x) const;
  double determinant() const;
  /// It moves without turning, mirroring and scaling.
  bool is_shift() const;
  /// Whether directions along the global axes stay along them, each its own or the opposite one.
  bool keeps_axes() const;
  /// It moves, turns and mirrors, but lengths stay.
  bool keeps_lengths() const;
  bool mirrors() const { return determinant() < 0; }
};

/// First `first`, then `second`.
Affine then(const Affine& first, const Affine& second);

Affine shift_by(const Vector& shift);
/// Along the global axes, from the origin.
Affine scaling(const Vector& factor);
/// By an angle [rad], right-handed about an axis through a point. The axis is not zero.
Affine rotation(const Vector& axis, const Vector& point, double angle);
/// At the plane through a point with a normal that is not zero.
Affine mirroring(const Vector& point, const Vector& normal);

}  // namespace crumple::deck
