// SPDX-License-Identifier: BSD-3-Clause
#include "elements/shells.hpp"

#include <algorithm>
#include <vector>

#include "base/parallel.hpp"
#include "elements/registry.hpp"
#include "elements/shell_geometry.hpp"
#include "elements/shell_setup.hpp"
#include "elements/shell_task.hpp"

namespace crumple::elements {
namespace {

using domain::Chunk;
using domain::Domain;
using domain::ShellBlock;

template <class Real>
void work_off(Domain& domain, const Chunk& chunk, const ShellConstants<Real>& constants, ShellSums& sums) {
  ShellBlock& block = domain.shells[chunk.block];
  ShellTask<Real> task;
  task.constants = constants;
  task.nodes = domain::records<Real>(domain.nodes).data();
  task.force = domain.nodes.force.data();
  const std::size_t first = static_cast<std::size_t>(chunk.first_group) * lanes;
  task.node = block.node.data() + first * 4;
  task.target = block.target.data() + first * 4;
  task.state = domain::state_of<Real>(block).data() + first * block.components;
  task.components = block.components;
  task.groups = chunk.last_group - chunk.first_group;
  task.step = static_cast<Real>(domain.clock.step);
  task.material_constants = block.material_constants.data();
  task.material = materials::shell_material_update<Real>(domain.execution.isa, task.constants.material);
  shell_kernel<Real>(domain.execution.isa, task.constants.formulation)(task, sums);
}

/// Works off all chunks of all blocks.
template <class Real>
void work_off_all(Domain& domain, std::vector<ShellSums>& sums) {
  std::vector<ShellConstants<Real>> constants;
  for (const ShellBlock& block : domain.shells)
    constants.push_back(from_numbers<Real>(block.element_constants));
  const std::vector<Chunk>& chunks = domain.assembly.chunks();
  parallel_for(static_cast<Index>(chunks.size()), domain.execution.threads,
               [&](Index c) { work_off<Real>(domain, chunks[c], constants[chunks[c].block], sums[c]); });
}

/// Visits every active element with its present stable step.
template <class Visit>
void for_each_step(const Domain& domain, const ShellBlock& block, const Visit& visit) {
  const auto constants = from_numbers<double>(block.element_constants);
  for (Index place = 0; place < block.elements; ++place) {
    if (block.state(place, constants.own + element_state::active) == 0) continue;
    const double length = characteristic_length(corners_of(domain, block.nodes_of(place)), false);
    visit(place, length * constants.slowness * block.state(place, constants.own + element_state::step_scale));
  }
}

}  // namespace

void add_shell_forces(Domain& domain) {
  const std::vector<Chunk>& chunks = domain.assembly.chunks();
  const int threads = domain.execution.threads;
  std::vector<ShellSums> sums(chunks.size());
  if (domain.execution.precision == Precision::Mixed)
    work_off_all<float>(domain, sums);
  else
    work_off_all<double>(domain, sums);
  domain.assembly.gather_interface(domain.nodes.force, threads);
  domain.clock.element_limit = 1e30;
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    ShellBlock& block = domain.shells[chunks[c].block];
    block.internal_energy += sums[c].internal_energy - sums[c].eroded_internal;
    block.hourglass_energy += sums[c].hourglass_energy - sums[c].eroded_hourglass;
    block.eroded_energy += sums[c].eroded_internal + sums[c].eroded_hourglass;
    block.eroded += sums[c].eroded;
    domain.clock.element_limit = std::min(domain.clock.element_limit, sums[c].shortest_step);
  }
}

double stable_step(const Domain& domain, const ShellBlock& block) {
  double shortest = 1e30;
  for_each_step(domain, block, [&](Index, double step) { shortest = std::min(shortest, step); });
  return shortest;
}

domain::ControllingElement controlling_element(const model::Model& model, const Domain& domain) {
  domain::ControllingElement found;
  double shortest = 1e30;
  for (const ShellBlock& block : domain.shells)
    for_each_step(domain, block, [&](Index place, double step) {
      if (step >= shortest) return;
      shortest = step;
      found = {model.shells[block.element[place]].id, model.parts[block.part].id};
    });
  return found;
}

}  // namespace crumple::elements
