// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Sets of nodes whose velocities along some global axes are one: that of their common momentum. Where a node
/// of the set is fixed, all are.
class NodeSets {
 public:
  /// Makes the velocities at time zero one, too. Throws Error for a set without mass.
  NodeSets(const model::Model& model, domain::Domain& domain);

  bool empty() const { return sets_.empty(); }

  /// Changes the velocities v(n+1/2) of the nodes.
  void constrain(domain::Domain& domain) const;

 private:
  struct Set {
    std::vector<Index> nodes;  ///< domain nodes, ascending
    std::array<bool, 3> direction{};
    std::array<bool, 3> fixed{};
    double failure_time = 0;
  };
  std::vector<Set> sets_;
};

}  // namespace crumple::constraints
