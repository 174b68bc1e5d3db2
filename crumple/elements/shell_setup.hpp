// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "elements/shell_geometry.hpp"

namespace crumple::elements {

/// Present positions of an element's nodes.
ShellCorners corners_of(const domain::Domain& domain, const std::array<Index, 4>& node);

/// Unit normals of the bilinear surface at the corners, turned to the side of r31 x r42; where two sides at
/// a corner do not span a plane (repeated node), the element's own normal.
std::array<math::Vec3, 4> corner_normals(const ShellCorners& corner);

}  // namespace crumple::elements
