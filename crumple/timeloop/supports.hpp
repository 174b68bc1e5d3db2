// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "constraints/local_constraints.hpp"
#include "constraints/tied_nodes.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::timeloop {

/// Measures what fixed degrees of freedom hold back.
class Supports {
 public:
  Supports() = default;
  /// Lists the held nodes in domain.supports. Does nothing if output does not ask for their forces.
  Supports(const model::Model& model, domain::Domain& domain);

  /// Into domain.supports the opposite of the forces that act along and about held axes at time n. All forces
  /// are in nodes.force on entry.
  void measure(domain::Domain& domain) const;

  /// Adds what tied nodes put on the nodes that carry them, once the ties have shared their momenta of the
  /// interval [time].
  void add_ties(domain::Domain& domain, const constraints::TiedNodes& ties, double interval) const;

  /// Adds what holds nodes along axes of their own, once it has acted over the interval.
  void add_local(domain::Domain& domain, const constraints::LocalConstraints& constraints) const;

  /// Declares domain.supports, which show time n until the next step.
  static void declare(domain::Domain& domain, domain::StateList& list) {
    if (!domain.supports.empty())
      list.add("supports", "force, force * length", domain::Entity::Run, 1, std::span(domain.supports));
  }

 private:
  /// Nodes that keep one velocity along some axes: one that is fixed holds all.
  struct Set {
    std::array<bool, 3> direction{};
    double failure_time = 0;
    std::vector<Index> nodes;  ///< of the domain
  };
  void add_sets(domain::Domain& domain) const;

  std::vector<Set> sets_;
  std::vector<Index> support_of_node_;  ///< place in domain.supports, or no_index; empty unless needed
};

}  // namespace crumple::timeloop
