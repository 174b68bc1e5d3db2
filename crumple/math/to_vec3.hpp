// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "math/vec3.hpp"

namespace crumple::math {

/// The vector of three components as the model holds them.
inline Vec3 to_vec3(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

}  // namespace crumple::math
