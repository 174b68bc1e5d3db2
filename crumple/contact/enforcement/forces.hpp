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

#include <limits>
#include <span>
#include <vector>

#include "contact/enforcement/couple.hpp"
#include "contact/enforcement/nodal_sums.hpp"
#include "contact/enforcement/penalty.hpp"
#include "contact/enforcement/touch.hpp"
#include "contact/surface/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// The steps around time n as the springs see them.
struct Steps {
  double judged = 0;     ///< by which stability is judged [time]
  double last = 0;       ///< from n-1 to n [time]
  double next = 0;       ///< from n to n+1, as far as it is known [time]
  double last_kick = 0;  ///< from n-3/2 to n-1/2: what the forces of n-1 acted for [time]
  double kick = 0;       ///< the same of the forces now [time]
};

/// Turns contacts into nodal forces and keeps their energy.
class Forces {
 public:
  Forces(const Surface& surface, const model::Contact& contact, const model::Control& control);

  /// Sets the upper bound on the next step before add() is called, where it is below that of the elements
  /// [time].
  void bound_step(const domain::Domain& domain, double bound);

  /// Clears domain.contact_force where the last apply() has set it: for all contacts before the first adds.
  void clear(domain::Domain& domain) const { sums_.clear(domain); }

  /// Adds to domain.contact_weight with how much weight the touches act on each node: its mass is shared out
  /// among them in that proportion when stability is judged, whichever contact they belong to. A touch that
  /// comes or goes at the rim of a segment so changes nothing at once.
  void count(domain::Domain& domain, std::span<const Touch> touches) { sums_.count(domain, touches); }

  /// Computes the forces of all touches by the penalty law. The touches of all contacts have been counted.
  /// `next_step`: from n to n+1 at most, where it is known to be shorter than the last one [time].
  void evaluate(const domain::Domain& domain, std::span<Touch> touches,
                double next_step = std::numeric_limits<double>::infinity());

  /// Adds the forces that the touches have to nodes.force and domain.contact_force, and the work since the
  /// last call to the report. The force on the second point is that on the first, reversed, and each is
  /// shared out among the nodes by the weights, so that their sum is zero. Sums follow the order of the
  /// touches. Takes the touches out of domain.contact_weight.
  void apply(domain::Domain& domain, std::span<const Touch> touches, domain::ContactReport& report) {
    sums_.add(domain, touches, report);
    last_kick_ = next_kick_;
  }

  /// Touches of the last call whose stiffness the stability limit cut.
  Index limited() const { return limited_; }

  /// The longest next step with which no touch of the last call gets too deep because stability limits its
  /// stiffness; infinite where none does [time].
  double longest_step() const { return longest_step_; }

  /// Nodal forces of the last call.
  const NodalSums& sums() const { return sums_; }
  /// Declares what the next call needs to know of this one.
  void declare(domain::StateList& list) {
    sums_.declare(list);
    list.keep("contact_last_kick", "time", domain::Entity::Contact, last_kick_);
  }
  NodalSums& sums() { return sums_; }

 private:
  void share_step(double share);
  double inverse_mass(const domain::Domain& domain, const Touch& touch) const;
  double stiffness(const domain::NodeFields& nodes, Touch& touch, double step) const;
  double stiffness_by_mass(const domain::NodeFields& nodes, const Touch& touch, double step) const;
  /// What the evaluation of touches has found.
  struct Outcome {
    Index limited = 0;                                      ///< by stability
    double step = std::numeric_limits<double>::infinity();  ///< at most, for depth [time]
  };
  /// What a touch has before it is too deep [length].
  struct Room {
    double stiffens = 0;  ///< penetration from which on it gets stiffer, whatever its surfaces are made of
    double most = 0;      ///< from which on it gets what stability allows, and a shorter step
  };
  Room room_of(const domain::NodeFields& nodes, const Touch& touch) const;
  void keep_energy(Touch& touch, const PenaltyLaw& law) const;
  void hold_depth(const domain::NodeFields& nodes, Touch& touch, PenaltyLaw& law, double inverse,
                  Outcome& outcome) const;
  void evaluate_touch(const domain::Domain& domain, Touch& touch, Outcome& outcome) const;
  double whole_inverse_mass(const domain::NodeFields& nodes, const Touch& touch) const;
  double passive_spring_force(const domain::NodeFields& nodes, const PenaltyMemory& before, Touch& touch,
                              double wanted, double inverse) const;
  void set_steps(const domain::Clock& clock, double next);
  double slope_limit(const PenaltyMemory& before, double inverse, double step) const;
  double friction_budget(double used) const;
  void add_friction(const domain::Domain& domain, Touch& touch, double stiffness, double inverse) const;
  static Vec3 friction(const model::Friction& law, const Touch& touch, double normal_force, double stiffness,
                       double step);

  const Surface* surface_;
  NodalSums sums_;
  model::Contact contact_;
  double stiffness_scale_;
  double step_scale_;
  double step_share_ = 1;      ///< of the elements' stable step that a step is at most now
  double budget_ = 0;          ///< of a touch that begins
  double largest_budget_ = 0;  ///< of one that goes on
  Steps steps_;
  double last_kick_ = 0;  ///< from n-3/2 to n-1/2 where it was not as long as the last step, else 0 [time]
  double next_kick_ = 0;
  Index limited_ = 0;
  double longest_step_ = std::numeric_limits<double>::infinity();  ///< by depth [time]
  std::vector<Outcome> outcomes_;                                  ///< by piece of the touches
};

}  // namespace crumple::contact
