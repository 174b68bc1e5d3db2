// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned_array.hpp"
#include "contact/enforcement/dealt_corners.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"

namespace crumple::contact {

/// What the touches of a contact do to its nodes: sums by place, each in the order of the touches and made by
/// one thread, so that they have the same bits for any number of threads; and the work of these forces.
///
/// Order of calls in a step: clear() and count() for all contacts, then add() for all.
class NodalSums {
 public:
  /// `is_damped`: whether a part of normal forces is damping.
  NodalSums(const Surface& surface, bool is_damped);

  /// Clears domain.contact_force where the last add() has set it.
  void clear(domain::Domain& domain) const;

  /// Adds to domain.contact_weight with how much weight the touches act on each node.
  void count(domain::Domain& domain, std::span<const Touch> touches);

  /// Adds the forces and couples of the touches to nodes.force and domain.contact_force, and the work since
  /// the last call to the report. Clears domain.contact_weight at their nodes.
  void add(domain::Domain& domain, std::span<const Touch> touches, domain::ContactReport& report);

  /// Places with a force after the last add(), ascending, and the force there [force].
  const std::vector<Index>& places() const { return active_; }
  Vec3 force_at(Index place) const { return previous_normal_[place] + previous_friction_[place]; }

  /// Declares the nodal forces of the last add().
  void declare(domain::StateList& list);
  /// To be called once after a restart has filled what was declared. Throws Error if it does not fit.
  void resume() const;

 private:
  /// Twice the work of a node's mean force over its velocity [force length/time].
  struct Power {
    double normal = 0;
    double friction = 0;
    double damping = 0;  ///< of the normal one

    Power& operator+=(const Power& other);
  };
  /// What a thread notes of the places of its own.
  struct Share {
    std::vector<Index> active;  ///< with a force now, ascending
    std::vector<Index> both;    ///< with a force now or at the last call, ascending
    std::vector<Power> power;   ///< of those
  };
  std::span<const Index> previous_places(Index share) const;
  void sum(domain::Domain& domain, std::span<const Touch> touches, Index share);
  void add_corner(const Touch& touch, int corner, std::vector<Index>& active);
  void measure_power(const domain::Domain& domain, Index share);
  void hand_over(domain::Domain& domain, Index share);

  const Surface* surface_;
  DealtCorners dealt_;
  bool is_dealt_ = false;  ///< by count(), for the touches that add() gets
  std::vector<Share> shares_;
  std::vector<Index> active_;         ///< places with a force after the last add(), ascending
  std::vector<std::uint8_t> marked_;  ///< 1 for places in a share's active
  AlignedArray<Vec3> normal_;         ///< on the nodes now, by place [force]
  AlignedArray<Vec3> friction_;       ///< the same
  AlignedArray<Vec3> previous_normal_;
  AlignedArray<Vec3> previous_friction_;
  AlignedArray<Vec3> damping_;  ///< the part of the normal forces that is damping; empty without
  AlignedArray<Vec3> previous_damping_;
};

/// Weight with which a touch counts at one of its nodes: a little more than the node's own, as the couple of
/// friction acts on all of them.
double lent_weight(double weight);

/// The first of the nodes that bear a couple: those of the segment below a node, all of two edges, as an edge
/// alone bears none about itself, and of two segments.
int first_bearing(const Touch& touch);

}  // namespace crumple::contact
