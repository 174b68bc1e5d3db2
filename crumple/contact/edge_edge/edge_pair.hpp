// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "base/index.hpp"
#include "contact/enforcement/penalty.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

using math::Vec3;

/// What of two edges is in contact: the edges where they cross, or an end of one with the other.
enum class EdgeMeeting : std::int32_t {
  Crossing,
  FirstStart,  ///< the start of the first edge
  FirstEnd,
  SecondStart,
  SecondEnd,
};

/// Names a contact of edges; in the order in which they are worked off.
struct EdgePairKey {
  Index first = no_index;  ///< in Edges
  Index second = no_index;
  EdgeMeeting meeting = EdgeMeeting::Crossing;

  bool operator==(const EdgePairKey&) const = default;
  bool operator<(const EdgePairKey& other) const {
    return std::tie(first, second, meeting) < std::tie(other.first, other.second, other.meeting);
  }
};

/// What a contact of edges remembers from one step to the next. No padding, so that its bytes can be hashed.
struct RememberedEdgePair {
  EdgePairKey key;
  std::int32_t wrong = 0;            ///< 1 while the edges have gone through each other
  std::array<double, 2> fraction{};  ///< contact points, as in NearestOnEdges
  double offset = 0;                 ///< by which the contact distance is reduced [length]
  double depth = 0;  ///< penetration, offset deducted, if it has a share of the force [length]
  double share = 0;  ///< of the force
  Vec3 normal;       ///< in which the first edge is pushed
  Vec3 side;         ///< of the second edge on which the first one belongs, as EdgePair::side
  Vec3 friction;     ///< on the first edge, along it, across it, and along the normal [force]
  PenaltyMemory penalty;

  bool loaded() const { return penalty.slope_limit > 0 || dot(friction, friction) > 0; }
  /// False of a pair that met at an end of an edge and was not through: there the line between the nearest
  /// points turns freely about the end, and the pair beside it may know better.
  bool knows_side() const {
    const auto inside = [](double f) { return f > 0 && f < 1; };
    return wrong != 0 || (inside(fraction[0]) && inside(fraction[1]));
  }
};
static_assert(sizeof(RememberedEdgePair) == 200);

/// Something that is known of a node and an edge.
struct NodeOnEdge {
  Index node = no_index;  ///< of the domain
  Index edge = no_index;
  double value = 0;

  bool operator<(const NodeOnEdge& other) const {
    return node != other.node ? node < other.node : edge < other.edge;
  }
};
static_assert(sizeof(NodeOnEdge) == 16);

/// Two edges in contact, now.
struct EdgePair {
  EdgePairKey key;
  std::int32_t wrong = 0;
  std::array<double, 2> fraction{};
  Vec3 normal;  ///< unit vector in which the first edge is pushed
  /// The normal, but for edges that have gone through each other and meet at an end: there the normal turns
  /// freely about the end, and only the common perpendicular tells on which side the first edge belongs.
  Vec3 side;
  double gap = 0;     ///< distance of the lines, negative if they have gone through each other [length]
  double reach = 0;   ///< distance at which contact begins, offset deducted [length]
  double offset = 0;  ///< [length]
  double share = 1;   ///< of the force; 0 where others see to this contact
  Vec3 slip;          ///< movement of the first contact point over the second since the last step [length]
  Vec3 friction;      ///< on the first edge at the last step, turned with the edges [force]
  PenaltyMemory penalty;       ///< of the last step
  bool starts_loaded = false;  ///< nodes at the edges had the contact before, as Touch::starts_loaded
  double last_speed = 0;       ///< now, of the points of the last step along the normal of then [length/time]

  double penetration() const { return reach - gap; }
};

}  // namespace crumple::contact
