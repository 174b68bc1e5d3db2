// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Spot welds: rigid bodies of a few nodes that are released when the forces in them, the plastic strain
/// around them or the time reach a limit.
class SpotWelds {
 public:
  /// Adds a rigid body to the domain for each weld, and a report. Throws Error naming a weld that cannot be.
  SpotWelds(const model::Model& model, domain::Domain& domain);

  /// At time n, when all forces on the nodes are there and before the kick: computes the force in every weld
  /// and releases those that fail.
  void break_overloaded(domain::Domain& domain) const;

  bool empty() const { return welds_.empty(); }

 private:
  /// A shell at a node of a weld.
  struct NearbyShell {
    Index block = no_index;
    Index place = no_index;
  };
  struct Weld {
    model::SpotWeld limits;
    Index body = no_index;                           ///< in domain.rigid_bodies
    Index first = no_index;                          ///< domain nodes of the line that tension acts along,
    Index second = no_index;                         ///< if there are two, apart from each other
    std::vector<std::vector<NearbyShell>> around{};  ///< of each node, where a strain limit needs them
  };
  static bool overloaded(const domain::Domain& domain, const Weld& weld, domain::WeldReport& report);
  static double plastic_strain(const domain::Domain& domain, const std::vector<NearbyShell>& shells);
  void find_shells(const domain::Domain& domain);

  std::vector<Weld> welds_;
};

}  // namespace crumple::constraints
