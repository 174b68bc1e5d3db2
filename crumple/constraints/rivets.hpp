// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Massless links that keep the distance of two nodes. Each gives its nodes opposite impulses along the line
/// between them at time n such that their distance at n+1 is the link's length to round-off (Ryckaert,
/// Ciccotti & Berendsen, J. Comput. Phys. 23 (1977) 327-341, the bond constraint, solved in closed form: no
/// two links share a node).
class Rivets {
 public:
  /// Throws Error for a link between nodes at the same place or without mass.
  Rivets(const model::Model& model, const domain::Domain& domain);

  bool empty() const { return links_.empty(); }

  /// Changes the velocities v(n+1/2) of the nodes, that they move with for `next_step`.
  void constrain(domain::Domain& domain, double next_step) const;

 private:
  struct Link {
    Index first = no_index;  ///< domain nodes
    Index second = no_index;
    double length = 0;  ///< [length]
    double failure_time = 0;
  };
  std::vector<Link> links_;
};

}  // namespace crumple::constraints
