// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Forces and moments on nodes and rigid bodies that keep to the normal of a plane through three nodes,
/// (x2 - x1) x (x3 - x1) at time n (*LOAD_NODE and *LOAD_RIGID_BODY with DOF 4 and 8). There is no load while
/// the nodes lie on one line.
class FollowerLoads {
 public:
  /// The model must outlive the loads.
  FollowerLoads(const model::Model& model, const domain::Domain& domain);

  /// Adds the forces at time n and, by the trapezoidal rule, their work since time n-1 to the ledger's
  /// external work. On entry velocities are those of n-1/2 and clock.step is the step between.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Load {
    Index node = no_index;  ///< domain node; or a body
    Index body = no_index;
    std::array<Index, 3> plane{};  ///< domain nodes
    double force = 0;              ///< along the normal at a factor of one [force]
    double moment = 0;             ///< about the normal at a factor of one [force * length]
    Index curve = no_index;
  };
  const model::Model* model_;
  std::vector<Load> loads_;
  std::vector<math::Vec3> previous_;  ///< of each load: factor times normal at time n-1
};

}  // namespace crumple::loads
