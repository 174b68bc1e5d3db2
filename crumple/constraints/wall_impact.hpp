// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>

#include "base/index.hpp"

namespace crumple::constraints {

/// A node in the way of a wall with mass.
struct PushedNode {
  Index node = no_index;
  double slowest = 0;  ///< least velocity along the normal, relative to the wall, that is no passing
                       ///< [length/time]
  double limit = 0;    ///< the wall pushes it if it is faster than this [length/time]
  double mass = 0;     ///< what resists a push along the normal [mass]
};

/// A wall with mass before an impact; velocities along its normal.
struct SlidingWall {
  double mass = 0;                                           ///< [mass]
  double velocity = 0;                                       ///< [length/time]
  double lowest = -std::numeric_limits<double>::infinity();  ///< at this nothing takes anything
  double highest = std::numeric_limits<double>::infinity();  ///< what cannot move lets it be no faster
  double tolerance = 4e-16;  ///< to which the impulse is known, over the largest velocity [-]
};

/// The velocity of the wall after a perfectly plastic impact [length/time]. `impulse` tells what the nodes
/// take from a wall that leaves the impact with a given velocity; the more the faster it is [force * time].
/// As what is faster than the wall takes nothing, the nodes only push.
double common_velocity(const SlidingWall& wall, const std::function<double(double)>& impulse);

}  // namespace crumple::constraints
