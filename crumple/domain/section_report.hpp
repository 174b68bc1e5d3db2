// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// What the elements of a cross-section put on its nodes at time n: pulled apart, the force points from the
/// nodes to the elements.
struct SectionReport {
  UserId id = 0;
  math::Vec3 force{};     ///< [force]
  math::Vec3 moment{};    ///< about the centroid [force * length]
  math::Vec3 centroid{};  ///< mean of the places of the nodes [length]
};

}  // namespace crumple::domain
