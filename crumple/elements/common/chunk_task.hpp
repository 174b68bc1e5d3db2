// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::elements {

/// The task of one chunk of a block, but for constants and material: where nodes, forces and state are.
template <template <class> class Task, class Real>
Task<Real> chunk_task(domain::Domain& domain, domain::ElementBlock& block, const domain::Chunk& chunk) {
  Task<Real> task;
  task.nodes = domain::records<Real>(domain.nodes).data();
  task.force = domain.nodes.force.data();
  const std::size_t first = static_cast<std::size_t>(chunk.first_group) * lanes;
  task.node = block.node.data() + first * block.corners;
  task.target = block.target.data() + first * block.corners;
  task.state = domain::state_of<Real>(block).data() + first * block.components;
  task.components = block.components;
  task.groups = chunk.last_group - chunk.first_group;
  task.energy = block.energy.data() + chunk.first_group;
  task.group_step = block.group_step.empty() ? nullptr : block.group_step.data() + chunk.first_group;
  task.step = static_cast<Real>(domain.clock.step);
  task.material_constants = block.material_constants.data();
  return task;
}

}  // namespace crumple::elements
