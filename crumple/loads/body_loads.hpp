// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Forces of inertia in a frame that accelerates: -m a on every mass, for the acceleration a of the frame
/// (*LOAD_BODY). Rigid bodies feel it at their centres.
class BodyLoads {
 public:
  /// The model must outlive the loads.
  explicit BodyLoads(const model::Model& model) : model_(&model) {}

  /// Adds the forces at time n and, by the trapezoidal rule, their work since time n-1 to the ledger's
  /// external work. On entry velocities are those of n-1/2 and clock.step is the step between.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  const model::Model* model_;
  math::Vec3 previous_;              ///< acceleration of the frame at time n-1
  std::vector<math::Vec3> momenta_;  ///< of the pieces of nodes; kept for its room alone
};

/// Forces and moments on rigid bodies that follow curves in time (*LOAD_RIGID_BODY). Books their work in the
/// same way.
class RigidBodyLoads {
 public:
  /// The model must outlive the loads.
  explicit RigidBodyLoads(const model::Model& model)
      : model_(&model), previous_(model.rigid_body_loads.size()) {}

  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  const model::Model* model_;
  std::vector<double> previous_;  ///< factor of each load at time n-1
};

}  // namespace crumple::loads
