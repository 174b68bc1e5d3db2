// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/node_fields.hpp"

namespace crumple::domain {

/// Velocities as they were before a step: with those behind it they give the velocities at time n.
struct EarlierVelocities {
  AlignedArray<Vec3> velocity;          ///< by domain node [length/time]
  AlignedArray<Vec3> angular_velocity;  ///< likewise [1/time]

  void keep(const NodeFields& nodes) {
    velocity = nodes.velocity;
    angular_velocity = nodes.angular_velocity;
  }
};

}  // namespace crumple::domain
