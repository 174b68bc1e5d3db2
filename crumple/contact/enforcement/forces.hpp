// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Enforcement: from touches to nodal forces. A Touch is two points, each a weighted mean of nodes, that repel
// each other; which detector found it makes no difference here.
//
//     force |                   /    Penalty (penalty.hpp): linear with k, the smaller stiffness of node
//           |                 /      and segment, up to half of the reach; from there the slope grows to
//           |               /        10 k at the mid-surface. It never exceeds the limit of stability.
//           |           __/
//           |      __--'             k as in LS-DYNA's Theory Manual (2006), contact-impact; stability and
//           | __--'                  passivity are our own derivation (docs/theory/contact.md, "Forces").
//           +-----------+------+---- penetration
//                    reach/2  reach
//
// Stability: of the bound 4 on (omega dt)^2 the elements use 4 TSSFAC^2, contact a budget of the rest. Nodes
// lend their mass to all touches of all contacts on them, in proportion to the weights (count()), so that the
// limit on each touch holds for all of them together. Passivity: a contact spring returns no more energy than
// it absorbed; what exceeds that is withheld and reported. Friction: Coulomb's law by a tangential spring
// that sticks and slips, with the couple of its two points (couple.hpp), so that moment of momentum is kept.
// Energy: work of the nodal forces by the trapezoidal rule.
//
// Order of calls in a step: count() for all contacts, then bound_step() and evaluate() for all, then apply()
// for all. Multipliers (multipliers.hpp) replace count() and evaluate(): predict(), then solve() for the
// forces that leave no penetration at the end of the next step.

#include <cstdint>
#include <span>
#include <vector>

#include "base/aligned_array.hpp"
#include "contact/enforcement/couple.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Turns contacts into nodal forces and keeps their energy.
class Forces {
 public:
  Forces(const Surface& surface, const model::Contact& contact, const model::Control& control);

  /// Sets the upper bound on the next step before add() is called, where it is below that of the elements
  /// [time].
  void bound_step(const domain::Domain& domain, double bound);

  /// Adds to domain.contact_weight with how much weight the touches act on each node: its mass is shared out
  /// among them in that proportion when stability is judged, whichever contact they belong to. A touch that
  /// comes or goes at the rim of a segment so changes nothing at once.
  void count(domain::Domain& domain, std::span<const Touch> touches) const;

  /// Computes the forces of all touches by the penalty law. The touches of all contacts have been counted.
  void evaluate(const domain::Domain& domain, std::span<Touch> touches);

  /// Adds the forces that the touches have to nodes.force and domain.contact_force, and the work since the
  /// last call to the report. The force on the second point is that on the first, reversed, and each is
  /// shared out among the nodes by the weights, so that their sum is zero. Sums follow the order of the
  /// touches. Takes the touches out of domain.contact_weight.
  void apply(domain::Domain& domain, std::span<const Touch> touches, domain::ContactReport& report);

  /// Touches of the last call whose stiffness the stability limit cut.
  Index limited() const { return limited_; }

  /// Places with a force after the last call, ascending, and the force there [force].
  const std::vector<Index>& places() const { return previous_active_; }
  Vec3 force_at(Index place) const { return previous_normal_[place] + previous_friction_[place]; }

  /// Declares the nodal forces of the last call.
  void declare(domain::StateList& list);
  /// To be called once after a restart has filled what was declared. Throws Error if it does not fit.
  void resume() const;

 private:
  void share_step(double share);
  double inverse_mass(const domain::Domain& domain, const Touch& touch) const;
  double stiffness(const domain::NodeFields& nodes, Touch& touch, double step, double most) const;
  double stiffness_by_mass(const domain::NodeFields& nodes, const Touch& touch, double step) const;
  bool evaluate_touch(const domain::Domain& domain, Touch& touch) const;
  /// Input of passive_spring_force().
  struct Spring {
    double wanted = 0;     ///< force by the penalty law [force]
    double inverse = 0;    ///< 1/m* with the shared masses [1/mass]
    double step = 0;       ///< from n to n+1 at most [time]
    double last_step = 0;  ///< from n-1 to n [time]
  };
  double whole_inverse_mass(const domain::NodeFields& nodes, const Touch& touch) const;
  double passive_spring_force(const domain::NodeFields& nodes, const PenaltyMemory& before, Touch& touch,
                              const Spring& spring) const;
  double slope_limit(const PenaltyMemory& before, double inverse, double step) const;
  double friction_budget(double used) const;
  void add_friction(const domain::Domain& domain, Touch& touch, double stiffness, double inverse) const;
  static Vec3 friction(const model::Friction& law, const Touch& touch, double normal_force, double stiffness,
                       double step);
  void scatter(domain::Domain& domain, std::span<const Touch> touches);
  void add_work(const domain::Domain& domain, domain::ContactReport& report);
  void hand_over(domain::Domain& domain);

  const Surface* surface_;
  model::Contact contact_;
  double stiffness_scale_;
  double step_scale_;
  double step_share_ = 1;      ///< of the elements' stable step that a step is at most now
  double budget_ = 0;          ///< of a touch that begins
  double largest_budget_ = 0;  ///< of one that goes on
  Index limited_ = 0;
  std::vector<std::uint8_t> is_limited_;  ///< by touch
  std::vector<std::uint8_t> marked_;      ///< 1 for places in active_
  std::vector<Index> active_;             ///< places with a force now, ascending
  std::vector<Index> previous_active_;
  std::vector<Index> both_;      ///< places with a force now or a step ago, ascending
  AlignedArray<Vec3> normal_;    ///< on the nodes now, by place [force]
  AlignedArray<Vec3> friction_;  ///< the same
  AlignedArray<Vec3> previous_normal_;
  AlignedArray<Vec3> previous_friction_;
  /// The part of the normal forces that is damping; empty without.
  AlignedArray<Vec3> damping_;
  AlignedArray<Vec3> previous_damping_;
};

}  // namespace crumple::contact
