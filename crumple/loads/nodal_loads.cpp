// SPDX-License-Identifier: BSD-3-Clause
#include "loads/nodal_loads.hpp"

namespace crumple::loads {

NodalLoads::NodalLoads(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  for (const model::NodalLoad& load : model.nodal_loads)
    loads_.push_back({.node = domain.nodes.domain_node[load.node],
                      .force = {load.force[0], load.force[1], load.force[2]},
                      .curve = load.curve,
                      .previous = {}});
}

void NodalLoads::add_forces(domain::Domain& domain) {
  for (Load& load : loads_) {
    const double factor = load.curve == no_index ? 1.0 : model_->curves[load.curve].at(domain.clock.time);
    const math::Vec3 force = factor * load.force;
    domain::NodeForce& sum = domain.nodes.force[load.node];
    for (int axis = 0; axis < 3; ++axis) sum.force[axis] += force[axis];
    domain.energy.external_work +=
        0.5 * domain.clock.step * dot(load.previous + force, domain.nodes.velocity[load.node]);
    load.previous = force;
  }
}

}  // namespace crumple::loads
