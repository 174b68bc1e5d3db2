// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace crumple {

/// Arithmetic of the element and contact kernels. Nodal coordinates, velocities, masses and all sums are
/// double in both.
enum class Precision {
  Mixed,   ///< kernels in float, relative to the element
  Double,  ///< kernels in double
};

}  // namespace crumple
