// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "math/vec3.hpp"

namespace crumple::contact {

using math::Vec3;

/// What a force does at a point that keeps its height above a segment as the segment turns: c = sum of w_i
/// x_i
/// + height n. The weights alone share it out among the nodes as if n stood still; these are the forces that
/// are left of its work on c, height (dn/dx_i)^T `force`, with n = d1 x d2 / |d1 x d2| of the diagonals d1,
/// d2. They have no sum; their moment is that of the force at height n. `corner`: the segment's three or four
/// nodes [length]; `height` [length]; zero where the corners span no area [force].
std::array<Vec3, 4> turning_forces(std::span<const Vec3> corner, double height, const Vec3& force);

}  // namespace crumple::contact
