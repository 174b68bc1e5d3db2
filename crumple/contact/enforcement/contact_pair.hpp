// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "base/index.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/surface/segment_shape.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

using math::Vec3;

/// What a node-segment pair remembers from one step to the next. No padding, so that its bytes can be hashed.
struct RememberedPair {
  Index node = no_index;     ///< place in Surface::nodes
  Index segment = no_index;  ///< in Surface
  std::int32_t side = 0;     ///< side of the segment's normal on which the node belongs; 0 where it is round
  std::int16_t wrong = 0;    ///< 1 while the node is on the other side
  std::int16_t let_go = 0;   ///< 1 from where it was too deep until it has come back
  std::array<double, 4> weight{};  ///< of the segment's nodes, at the contact point
  double offset = 0;               ///< by which the contact distance is reduced [length]
  double gap = 0;                  ///< distance from the mid-surface, negative on the wrong side [length]
  double depth = 0;                ///< penetration, offset deducted [length]
  Vec3 friction;                   ///< on the node, in the segment's frame [force]
  Vec3 normal;                     ///< in which the node was pushed
  PenaltyMemory penalty;

  bool loaded() const { return penalty.slope_limit > 0 || dot(friction, friction) > 0; }
};
static_assert(sizeof(RememberedPair) == 192);

/// A node in contact with a segment, now.
struct ContactPair {
  Index node = no_index;     ///< place in Surface::nodes
  Index segment = no_index;  ///< in Surface
  std::int32_t side = 0;
  std::int16_t wrong = 0;
  std::int16_t let_go = 0;
  std::array<double, 4> weight{};
  Vec3 point;                ///< contact point, sum of weight[i] x[i] [length]
  Vec3 normal;               ///< unit vector in which the node is pushed
  double gap = 0;            ///< distance from the mid-surface, negative on the wrong side [length]
  double reach = 0;          ///< distance at which contact begins, offset deducted [length]
  double offset = 0;         ///< [length]
  double share = 1;          ///< of the force; below 1 in a concave ridge that is almost flat
  double fade = 1;           ///< part of that which acts where an edge takes over
  Vec3 slip;                 ///< movement of the node over the surface since the last step [length]
  Vec3 friction;             ///< friction force of the last step, turned with the segment [force]
  Frame frame;               ///< of the segment, where friction has needed it
  PenaltyMemory penalty;     ///< of the last step
  Index heir_of = no_index;  ///< segment of the remembered pair that it continues
  double last_speed = 0;     ///< now, of the points of the last step along the normal of then [length/time]

  double penetration() const { return reach - gap; }
  bool acts() const { return share * fade > 0; }
};

}  // namespace crumple::contact
