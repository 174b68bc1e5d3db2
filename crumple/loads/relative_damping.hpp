// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "loads/part_selection.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Damping of the motion of parts against a rigid body (*DAMPING_RELATIVE): the force -D m (v - v_b) on each
/// node, v_b the velocity of the body at the place of the node, and the opposite on the body there, so that
/// momentum is kept. D = 4 pi xi f is what damps an oscillation of frequency f with the share xi of critical.
/// Source: LS-DYNA Keyword User's Manual, Volume I, *DAMPING_RELATIVE; docs/theory/loads.md.
class RelativeDampings {
 public:
  /// The model must outlive the loads.
  RelativeDampings(const model::Model& model, const domain::Domain& domain);

  /// Adds the forces at time n and, by the trapezoidal rule, what they took since time n-1 to the ledger's
  /// damping energy. On entry velocities are those of n-1/2 and clock.step is the step between.
  void add_forces(domain::Domain& domain);

  /// The part of an undamped stable step that is stable at time n: 1 without damping [-].
  double stable_share(double undamped_step) const;

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  /// Sum of the forces on a body, and their moment about its centre.
  struct Push {
    math::Vec3 force;
    math::Vec3 moment;
  };
  struct Damping {
    const model::RelativeDamping* given = nullptr;
    NodeShares selection;
    double coupling = 1;               ///< by how much the motion of the body raises the rate [-]
    double rate = 0;                   ///< D at time n [1/time]
    std::vector<math::Vec3> on_nodes;  ///< force at time n
    Push on_body;                      ///< the same
  };

  static double damp(Damping& damping, domain::Domain& domain);

  const model::Model* model_;
  std::vector<Damping> dampings_;
};

}  // namespace crumple::loads
