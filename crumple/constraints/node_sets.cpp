// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/node_sets.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace crumple::constraints {

NodeSets::NodeSets(const model::Model& model, domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  sets_.reserve(model.constrained_node_sets.size());
  for (const model::ConstrainedNodeSet& given : model.constrained_node_sets) {
    Set set;
    set.direction = given.direction;
    set.failure_time = given.failure_time;
    set.nodes.reserve(given.nodes.size());
    for (const Index node : given.nodes) set.nodes.push_back(nodes.domain_node[node]);
    std::sort(set.nodes.begin(), set.nodes.end());
    double mass = 0;
    for (const Index node : set.nodes) {
      mass += nodes.moving_mass(node);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((nodes.fixed[node] & domain::fixed_translation(static_cast<int>(axis))) != 0)
          set.fixed[axis] = true;
    }
    if (!(mass > 0)) throw Error("A set of *CONSTRAINED_NODE_SET has no mass.");
    sets_.push_back(std::move(set));
  }
  constrain(domain);
}

void NodeSets::constrain(domain::Domain& domain) const {
  domain::NodeFields& nodes = domain.nodes;
  for (const Set& set : sets_) {
    if (domain.clock.time >= set.failure_time) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (!set.direction[static_cast<std::size_t>(axis)]) continue;
      double mass = 0;  // it may grow
      double momentum = 0;
      for (const Index node : set.nodes) {
        mass += nodes.moving_mass(node);
        momentum += nodes.moving_mass(node) * nodes.velocity[node][axis];
      }
      const double velocity = set.fixed[static_cast<std::size_t>(axis)] ? 0 : momentum / mass;
      for (const Index node : set.nodes) nodes.velocity[node][axis] = velocity;
    }
  }
}

}  // namespace crumple::constraints
