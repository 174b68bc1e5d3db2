// SPDX-License-Identifier: BSD-3-Clause
#include "loads/nodal_loads.hpp"

namespace crumple::loads {

NodalLoads::NodalLoads(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  for (const model::NodalLoad& load : model.nodal_loads) {
    if (load.plane.given()) continue;  // FollowerLoads
    loads_.push_back({.node = domain.nodes.domain_node[load.node],
                      .force = {load.force[0], load.force[1], load.force[2]},
                      .moment = {load.moment[0], load.moment[1], load.moment[2]},
                      .curve = load.curve,
                      .previous = 0});
  }
}

void NodalLoads::add_forces(domain::Domain& domain) {
  for (Load& load : loads_) {
    const double factor = load.curve == no_index ? 1.0 : model_->curves[load.curve].at(domain.clock.time);
    domain::NodeForce& sum = domain.nodes.force[load.node];
    for (int axis = 0; axis < 3; ++axis) {
      sum.force[axis] += factor * load.force[axis];
      sum.moment[axis] += factor * load.moment[axis];
    }
    const double rate = dot(load.force, domain.nodes.velocity[load.node]) +
                        dot(load.moment, domain.nodes.angular_velocity[load.node]);
    domain.energy.external_work += 0.5 * domain.clock.step * (load.previous + factor) * rate;
    load.previous = factor;
  }
}

void NodalLoads::declare(domain::StateList& list) {
  for (Load& load : loads_) list.keep("nodal_load", "-", domain::Entity::Node, load.previous);
}

}  // namespace crumple::loads
