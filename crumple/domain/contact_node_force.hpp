// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "base/index.hpp"
#include "math/vec3.hpp"

namespace crumple::domain {

/// What one contact puts on one node at time n.
struct ContactNodeForce {
  Index contact = no_index;  ///< in Domain::contacts
  Index node = no_index;     ///< domain node
  std::uint8_t side = 0;     ///< of the contact that the node is on: 1 the first, 2 the second, 3 both
  math::Vec3 force{};        ///< normal and friction [force]
};

}  // namespace crumple::domain
