// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "base/index.hpp"
#include "contact/enforcement/penalty.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

using math::Vec3;

struct Configuration;
struct ContactPair;
struct Surface;

/// Two points of a surface that repel each other, whatever found them: a node and a point of a segment, or
/// points of two edges. Each point is a weighted mean of nodes; the weights of the first are positive and sum
/// up to 1, those of the second are negative and sum up to -1, so that sum of weight[i] v[i] is the velocity
/// of the first relative to the second.
struct Touch {
  static constexpr int most_nodes = 8;

  int nodes = 0;
  std::array<Index, most_nodes> place{};  ///< in Surface::nodes
  std::array<double, most_nodes> weight{};
  Vec3 normal;             ///< unit vector in which the first point is pushed
  double penetration = 0;  ///< [length]
  double reach = 0;  ///< penetration at which the mid-surfaces meet; the largest number if they never do
  /// Penetration that leaves no doubt that the contact has not held: through the whole thickness of a shell,
  /// to the middle of a solid behind a face; the largest number if there is none [length].
  double most = std::numeric_limits<double>::max();
  Index segment = no_index;  ///< of a node on a segment, whose node is the first; no_index of others
  double stiffness = 0;      ///< penalty stiffness [force/length]
  /// Penalty stiffness of a node of solids by how its faces look now, 0 of others: the touch keeps that with
  /// which it began, beside `stiffness` of the segment alone [force/length].
  double turning_stiffness = 0;
  PenaltyMemory penalty;  ///< at the last step, then at the present one
  double last_speed =
      0;            ///< at which the points of the last step part now along the normal of then [length/time]
  double area = 0;  ///< on which friction may act at most [length^2]
  /// Parts of the model that the two points belong to, for friction; no_index where that is unknown.
  std::array<Index, 2> part{no_index, no_index};
  double share = 1;  ///< of the force
  double fade = 1;   ///< part of that which acts where edges and nodes take over from each other
  /// A touch may begin deep without an approach: over the rim of a face, or where edges and nodes take over
  /// from each other. Its spring then begins with the energy of its penetration.
  bool starts_loaded = false;
  double withheld = 0;         ///< part of the normal force that passivity does not allow [force]
  bool has_potential = false;  ///< the force derives from a potential and needs no passivity limit
  /// Of both points above their segments, along the normals: of pinballs in the faces of solids [length].
  std::array<double, 2> height{};
  Vec3 slip;           ///< movement of the first point over the second since the last step [length]
  Vec3 friction;       ///< on the first point, at the last step, turned to now; then the present one [force]
  Vec3 normal_force;   ///< on the first point now [force]
  double damping = 0;  ///< part of that which is damping; below zero it takes from the spring [force]
  /// On the nodes that bear a couple, see Forces: takes up the moment that the forces leave [force].
  std::array<Vec3, most_nodes> couple{};

  /// On the first point, once the forces are known [force].
  Vec3 force() const { return normal_force + friction; }
  /// By the penalty, as a spring of its mean stiffness [energy].
  double stored_energy() const {
    return 0.5 * norm(normal_force) * std::max(0.0, penetration - penalty.rest_depth);
  }
  bool is_raised() const { return height[0] != 0 || height[1] != 0; }

  void add(Index node_place, double node_weight) {
    place[nodes] = node_place;
    weight[nodes] = node_weight;
    ++nodes;
  }
};

/// Penetration of a node and a segment that leaves no doubt that the contact has not held: through the whole
/// thickness of a shell, to the middle of a solid behind a face [length].
double most_penetration(const Surface& surface, const ContactPair& pair);

/// A node and a segment.
Touch touch_of(const Surface& surface, const ContactPair& pair);

/// Sum of the forces on the first side of a contact of two sides [force].
Vec3 force_on_first_side(const Surface& surface, std::span<const Touch> touches);

/// Asks for what touch_of() and node_stiffness() will read of the surface for pairs soon after `i`: in a
/// large model it comes from memory.
void prefetch_touch_after(const Surface& surface, std::span<const ContactPair> pairs, std::size_t i);

/// Penalty stiffness of the node of a pair. A node of solids has a share of each of its faces, as far as they
/// look against the pair's normal: a quarter of all that meet in it, which in the middle of a plane is one
/// face. With that the nodes of a plane, those at its rim included, bear an even pressure with one
/// penetration [force/length].
double node_stiffness(const Surface& surface, const Configuration& x, const ContactPair& pair);

}  // namespace crumple::contact
