// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::loads {

/// Forces and moments on nodes that follow a curve in time.
class NodalLoads {
 public:
  /// The model must outlive the loads.
  NodalLoads(const model::Model& model, const domain::Domain& domain);

  /// Adds the forces at time n and, by the trapezoidal rule, their work since time n-1 to the ledger's
  /// external work. On entry nodes.velocity is v(n-1/2) and clock.step the step between.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Load {
    Index node = no_index;  ///< domain node
    math::Vec3 force;       ///< at a factor of one [force]
    math::Vec3 moment;      ///< at a factor of one [force * length]
    Index curve = no_index;
    double previous = 0;  ///< factor at time n-1
  };
  const model::Model* model_;
  std::vector<Load> loads_;
};

}  // namespace crumple::loads
