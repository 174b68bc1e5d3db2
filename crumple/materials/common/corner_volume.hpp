// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "materials/common/solid_material.hpp"

namespace crumple::materials {

/// Volume of a hexahedron, of six tetrahedra around a diagonal: exact for plane faces.
inline double corner_volume(const SolidCorners& x) {
  constexpr int around[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};
  double six_volumes = 0;
  for (const auto& [i, j] : around) six_volumes += dot(cross(x[i] - x[0], x[j] - x[0]), x[6] - x[0]);
  return std::fabs(six_volumes) / 6;
}

}  // namespace crumple::materials
