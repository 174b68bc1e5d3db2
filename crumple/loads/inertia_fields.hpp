// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "loads/part_selection.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Forces of inertia in a frame that accelerates by f a and turns by f w about an axis through c, on all
/// masses or on some: -m (f a + f^2 w x (w x (x - c))), f following a curve. The forces of a changing f w and
/// of Coriolis are left out, as in LS-DYNA (Keyword User's Manual, *LOAD_BODY, remarks on angular velocity).
/// Rigid bodies whose inertia is given feel them at their centres, with the moment -w x (J w); others at
/// their nodes.
class InertiaFields {
 public:
  /// The model must outlive the loads.
  InertiaFields(const model::Model& model, const domain::Domain& domain);

  /// Adds the forces at time n and, by the trapezoidal rule, their work since time n-1 to the ledger's
  /// external work. On entry velocities are those of n-1/2 and clock.step is the step between.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Field {
    const model::InertiaField* given = nullptr;
    NodeShares selection;        ///< unless of all
    std::vector<Index> bodies;   ///< with given inertia
    std::size_t first_body = 0;  ///< place of their moments in previous_moment_
  };
  double push_nodes(const Field& field, const math::Vec3& factors, domain::Domain& domain);
  double push_bodies(const Field& field, const math::Vec3& factors, domain::Domain& domain);

  const model::Model* model_;
  std::vector<Field> fields_;
  std::vector<char> in_given_body_;          ///< of domain nodes: their body's mass is not theirs
  std::vector<double> previous_;             ///< factor of each field at time n-1
  std::vector<math::Vec3> previous_moment_;  ///< of each body of each field [force * length]
  std::vector<double> work_;                 ///< of the pieces of nodes; kept for its room alone
};

}  // namespace crumple::loads
