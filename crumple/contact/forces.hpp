// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "base/aligned_array.hpp"
#include "contact/contact_pair.hpp"
#include "contact/surface.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::contact {

/// Turns contacts into nodal forces and keeps their energy.
class Forces {
 public:
  Forces(const Surface& surface, const model::SingleSurfaceContact& contact, double step_scale);

  /// Adds the forces of all pairs to nodes.force and domain.contact_force, writes the friction force that
  /// each pair must remember into it, and adds the work since the last call to the report. The forces on the
  /// nodes of a segment are those on the node, reversed and shared out by the weights, so that their sum is
  /// zero. Pairs may come in any number, ordered by (node, segment); sums follow that order.
  void add(domain::Domain& domain, std::span<ContactPair> pairs, domain::ContactReport& report);

  /// Pairs of the last call whose stiffness the stability limit cut.
  Index limited() const { return limited_; }

  /// Declares the nodal forces of the last call.
  void declare(domain::StateList& list);

 private:
  /// On the node of a pair [force].
  struct PairForce {
    Vec3 normal;
    Vec3 friction;
    bool limited = false;
  };

  void count_touches(std::span<const ContactPair> pairs);
  double inverse_mass(const domain::NodeFields& nodes, const ContactPair& pair) const;
  double least_stiffness(const domain::NodeFields& nodes, const ContactPair& pair, double step) const;
  PairForce evaluate(const domain::Domain& domain, const ContactPair& pair) const;
  Vec3 friction(const ContactPair& pair, double normal_force, double stiffness, double step) const;
  void scatter(std::span<const ContactPair> pairs);
  void add_work(const domain::Domain& domain, domain::ContactReport& report);
  void hand_over(domain::Domain& domain);

  const Surface* surface_;
  model::SingleSurfaceContact contact_;
  double step_scale_;
  double budget_;
  Index limited_ = 0;
  std::vector<PairForce> pair_forces_;
  std::vector<Index> touches_;  ///< pairs that act on a node, by place
  std::vector<Index> active_;   ///< places with a force now, ascending
  std::vector<Index> previous_active_;
  AlignedArray<Vec3> normal_;    ///< on the nodes now, by place [force]
  AlignedArray<Vec3> friction_;  ///< the same
  AlignedArray<Vec3> previous_normal_;
  AlignedArray<Vec3> previous_friction_;
};

}  // namespace crumple::contact
