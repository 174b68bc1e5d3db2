// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "math/vec3.hpp"

namespace crumple::elements {

/// Rotary inertia per mass [length^2] of the nodes of a C0 triangle with which its bending and transverse
/// shear together are no faster than `rate`^2 (1/time^2): the frequencies of a mesh are bounded by those of
/// its elements (own derivation, docs/theory/c0_triangle.md). `own` is t^2/12 [length^2], `shear_speed` the
/// root of kappa G / rho [length/time].
double triangle_inertia(const std::array<math::Vec3, 3>& corner, double own, double shear_speed, double rate);

}  // namespace crumple::elements
