// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::elements {

using ShellCorners = std::array<math::Vec3, 4>;

/// Area of the projection on the plane normal to both diagonals, half of |r31 x r42| [length^2].
double shell_area(const ShellCorners& corner);

/// Length that a wave must cross in one step: area over the longest side, and twice that for a triangle
/// (*CONTROL_TIMESTEP, ISDO = 0; LS-DYNA Theory Manual, "Time step calculations for shell elements")
/// [length].
double characteristic_length(const ShellCorners& corner, bool triangle);

/// The two numbers of element_state::frame: with J0 = (g1, g2) = (r31 - r42, r31 + r42) at time zero in axes
/// whose first lies along g1, the second column of J0^-1 over its first entry.
std::array<double, 2> reference_frame(const ShellCorners& corner);

/// Share of the element's mass that each of the four entries of the connectivity gets: a quarter, and a third
/// for each corner of a triangle, halved where the entry is repeated.
std::array<double, 4> mass_shares(const std::array<Index, 4>& node);

/// True if two neighbouring entries are the same node.
bool is_triangle(const std::array<Index, 4>& node);

}  // namespace crumple::elements
