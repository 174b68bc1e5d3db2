// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a point lies in a solid: the shape functions of the solid's corners there.

#include <array>
#include <cstddef>
#include <optional>

#include "math/vec3.hpp"

namespace crumple::constraints {

/// The weights of the corners of a solid at a point: the sum is 1, and their mean of the corners is the
/// point.
template <std::size_t Corners>
struct PointInSolid {
  std::array<double, Corners> weight{};
  double beyond = 0;  ///< how far outside it is, in natural coordinates, of which a solid is 2 wide; else 0
};

/// By Newton's method for the natural coordinates of the trilinear map, from the centre on. Corners in the
/// order of model::SolidElement; some may be equal. A coordinate within 1e-8 of a face counts as on it, so
/// that the other corners have no weight. Absent where the map does not reach the point: it is far outside.
std::optional<PointInSolid<8>> point_in_hexahedron(const std::array<math::Vec3, 8>& corner,
                                                   const math::Vec3& point);

/// Likewise by the volumes between the point and the faces. Absent for a tetrahedron without volume.
std::optional<PointInSolid<4>> point_in_tetrahedron(const std::array<math::Vec3, 4>& corner,
                                                    const math::Vec3& point);

}  // namespace crumple::constraints
