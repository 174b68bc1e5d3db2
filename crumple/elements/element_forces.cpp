// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "elements/common/chunk_task.hpp"
#include "elements/common/damage_growth.hpp"
#include "elements/common/erosion_check.hpp"
#include "elements/common/short_steps.hpp"
#include "elements/common/stiffness_damping.hpp"
#include "elements/elements.hpp"
#include "elements/energy_trace.hpp"
#include "elements/line/beam_kernel_list.hpp"
#include "elements/line/discrete_elements.hpp"
#include "elements/registry.hpp"
#include "elements/shell/shell_task.hpp"
#include "elements/solid/nodal_average.hpp"
#include "elements/solid/solid_task.hpp"

namespace crumple::elements {
namespace {

using domain::Chunk;
using domain::Domain;

/// Constants of all blocks in the precision of the run, and the kernels that go with them.
template <class Real>
class Pass {
 public:
  explicit Pass(Domain& domain) : domain_(domain) {
    std::size_t bytes = bytes_per_node * static_cast<std::size_t>(domain.nodes.count());
    for (domain::ShellBlock& block : domain.shells) {
      shells_.push_back(from_numbers<ShellConstants<Real>>(block.element_constants));
      layers_.push_back(calls_of(block));
      bytes += domain::state_of<Real>(block).size() * sizeof(Real);
    }
    for (domain::SolidBlock& block : domain.solids) {
      solids_.push_back(from_numbers<SolidConstants<Real>>(block.element_constants));
      bytes += domain::state_of<Real>(block).size() * sizeof(Real);
    }
    from_memory_ = bytes > most_cached_bytes;
    for (const domain::ElementBlock* block : domain.blocks())
      erosion_.push_back(block->erosion ? erosion_check(*block, domain.clock.time, domain.clock.step)
                                        : ErosionCheck{});
    for (const domain::ElementBlock* block : domain.blocks())
      damage_.push_back(block->damage ? damage_growth(*block, domain.clock.step) : DamageGrowth{});
    for (const domain::ElementBlock* block : domain.blocks()) short_steps_.push_back(short_steps(*block));
    const auto add_damping = [&](const domain::DampedBlock& block) {
      damping_.push_back(block.damping ? damping_of(block, domain.clock.step) : StiffnessDamping{});
    };
    for (const domain::ShellBlock& block : domain.shells) add_damping(block);
    for (const domain::SolidBlock& block : domain.solids) add_damping(block);
    for (const domain::BeamBlock& block : domain.beams) add_damping(block);
    for (const domain::BeamBlock& block : domain.beams)
      beams_.push_back(beam_constants(block.element_constants));
  }

  void work_off(const Chunk& chunk, ElementSums& sums) const {
    const auto solid = chunk.block - static_cast<Index>(shells_.size());
    const auto beam = solid - static_cast<Index>(solids_.size());
    const auto discrete = beam - static_cast<Index>(beams_.size());
    if (solid < 0)
      work_off_shells(domain_.shells[chunk.block], chunk, shells_[chunk.block], sums);
    else if (beam < 0)
      work_off_solids(domain_.solids[solid], chunk, solids_[solid], sums);
    else if (discrete < 0)
      work_off_beams(domain_.beams[beam], chunk, beams_[beam], sums);
    else
      add_discrete_forces(domain_, domain_.discretes[discrete], chunk, sums);
  }

 private:
  std::vector<LayerCall<Real>> calls_of(const domain::ShellBlock& block) const {
    std::vector<LayerCall<Real>> calls;
    for (const domain::LayerRun& run : block.runs)
      calls.push_back({materials::shell_material_update<Real>(domain_.execution.isa, run.law), run.first,
                       run.points, run.history, run.constants, run.can_fail});
    return calls;
  }

  void work_off_shells(domain::ShellBlock& block, const Chunk& chunk, const ShellConstants<Real>& constants,
                       ElementSums& sums) const {
    auto task = chunk_task<ShellTask, Real>(domain_, block, chunk);
    task.from_memory = from_memory_;
    task.constants = constants;
    task.erosion = erosion_of(chunk);
    task.damage = damage_of(chunk);
    task.short_steps = short_steps_of(chunk);
    if (block.damping) task.damping = &damping_[static_cast<std::size_t>(chunk.block)];
    task.material = materials::shell_material_update<Real>(domain_.execution.isa, constants.material);
    const std::vector<LayerCall<Real>>& layers = layers_[chunk.block];
    task.layers = layers.data();
    task.layer_calls = static_cast<int>(layers.size());
    task.layers_hold = block.layers_hold;
    shell_kernel<Real>(domain_.execution.isa, constants.formulation)(task, sums);
  }
  void work_off_solids(domain::SolidBlock& block, const Chunk& chunk, const SolidConstants<Real>& constants,
                       ElementSums& sums) const {
    auto task = chunk_task<SolidTask, Real>(domain_, block, chunk);
    task.from_memory = from_memory_;
    task.constants = constants;
    task.erosion = erosion_of(chunk);
    task.damage = damage_of(chunk);
    task.short_steps = short_steps_of(chunk);
    if (block.damping) task.damping = &damping_[static_cast<std::size_t>(chunk.block)];
    task.material = materials::solid_material_update<Real>(domain_.execution.isa, constants.material);
    solid_kernel<Real>(domain_.execution.isa, constants.formulation)(task, sums);
  }
  void work_off_beams(domain::BeamBlock& block, const Chunk& chunk, const BeamConstants& constants,
                      ElementSums& sums) const {
    const std::size_t first = static_cast<std::size_t>(chunk.first_group) * lanes;
    BeamTask task{
        .position = domain_.nodes.position.data(),
        .angular_velocity = domain_.nodes.angular_velocity.data(),
        .force = domain_.nodes.force.data(),
        .node = block.node.data() + first * 2,
        .target = block.target.data() + first * 2,
        .state = block.double_state.data() + first * block.components,
        .components = block.components,
        .groups = chunk.last_group - chunk.first_group,
        .energy = block.energy.data() + chunk.first_group,
        .group_step = block.group_step.empty() ? nullptr : block.group_step.data() + chunk.first_group,
        .step = domain_.clock.step,
        .time = domain_.clock.time,
        .constants = constants,
        .section = section_of(block, constants),
        .section_places = section_places(block.element_constants),
        .material = block.material_constants.data()};
    if (block.damping) {
      const StiffnessDamping& damping = damping_[static_cast<std::size_t>(chunk.block)];
      task.damping = damping.given;
      task.damping_item = damping.first;
    }
    beam_kernel(domain_.execution.isa, block.formulation)(task, sums);
  }

  /// The material of integrated beams.
  materials::SectionUpdate section_of(const domain::BeamBlock& block, const BeamConstants& constants) const {
    if (block.formulation != model::BeamFormulation::Integrated) return nullptr;
    return materials::section_material_update(domain_.execution.isa,
                                              static_cast<int>(constants.section_material));
  }

  const ErosionCheck* erosion_of(const Chunk& chunk) const {
    const ErosionCheck& check = erosion_[static_cast<std::size_t>(chunk.block)];
    return check.criteria == nullptr ? nullptr : &check;
  }
  const DamageGrowth* damage_of(const Chunk& chunk) const {
    const DamageGrowth& growth = damage_[static_cast<std::size_t>(chunk.block)];
    return growth.law == nullptr ? nullptr : &growth;
  }
  const ShortSteps* short_steps_of(const Chunk& chunk) const {
    const ShortSteps& steps = short_steps_[static_cast<std::size_t>(chunk.block)];
    return steps.least > 0 ? &steps : nullptr;
  }

  /// What a core's caches hold of a step's way through nodes and elements. Below it, asking ahead costs a
  /// tenth of the time.
  static constexpr std::size_t most_cached_bytes = std::size_t{16} << 20;
  static constexpr std::size_t bytes_per_node = 256;

  Domain& domain_;
  bool from_memory_ = false;
  std::vector<ShellConstants<Real>> shells_;
  std::vector<std::vector<LayerCall<Real>>> layers_;  ///< by block of shells; empty without layers
  std::vector<SolidConstants<Real>> solids_;
  std::vector<BeamConstants> beams_;
  std::vector<ErosionCheck> erosion_;      ///< by block
  std::vector<DamageGrowth> damage_;       ///< by block
  std::vector<ShortSteps> short_steps_;    ///< by block
  std::vector<StiffnessDamping> damping_;  ///< by block of shells, then of solids and beams
};

template <class Real>
void work_off_all(Domain& domain, std::vector<ElementSums>& sums) {
  const Pass<Real> pass(domain);
  const std::vector<Chunk>& chunks = domain.assembly.chunks();
  const std::vector<domain::ThreadShare>& shares = domain.assembly.shares();
  parallel_for(static_cast<Index>(shares.size()), domain.execution.threads, [&](Index s) {
    for (Index c = shares[s].first_chunk; c < shares[s].last_chunk; ++c) pass.work_off(chunks[c], sums[c]);
  });
}

domain::GroupEnergy operator+(const domain::GroupEnergy& a, const domain::GroupEnergy& b) {
  return {a.internal + b.internal, a.hourglass + b.hourglass, a.damping + b.damping, a.eroded + b.eroded};
}

domain::GroupEnergy sum_of(std::span<const domain::GroupEnergy> energies) {
  domain::GroupEnergy sum;
  for (const domain::GroupEnergy& energy : energies) sum = sum + energy;
  return sum;
}

/// Sums the energies of a block's groups, piece by piece in their order; small blocks in one, without room
/// for sums.
void sum_groups(domain::ElementBlock& block, int threads) {
  constexpr std::size_t piece = 1024;
  const std::span<const domain::GroupEnergy> groups(block.energy);
  std::vector<domain::GroupEnergy> sums;
  if (groups.size() > piece) {
    sums.resize((groups.size() + piece - 1) / piece);
    parallel_for(static_cast<Index>(sums.size()), threads, [&](Index p) {
      const std::size_t first = static_cast<std::size_t>(p) * piece;
      sums[p] = sum_of(groups.subspan(first, std::min(piece, groups.size() - first)));
    });
  }
  const domain::GroupEnergy all = sums.empty() ? sum_of(groups) : sum_of(sums);
  block.internal_energy = all.internal;
  block.hourglass_energy = all.hourglass;
  block.damping_energy = all.damping;
  block.eroded_energy = all.eroded;
}

}  // namespace

void add_element_forces(Domain& domain, EnergyTrace* trace) {
  const std::vector<Chunk>& chunks = domain.assembly.chunks();
  std::vector<ElementSums> sums(chunks.size());
  average_dilatations(domain);
  if (domain.execution.precision == Precision::Mixed)
    work_off_all<float>(domain, sums);
  else
    work_off_all<double>(domain, sums);
  if (trace != nullptr) trace->observe(domain);
  domain.assembly.gather_interface(domain.nodes.force, domain.execution.threads);
  domain.clock.element_limit = domain.clock.rigid_limit;
  const std::vector<domain::ElementBlock*> blocks = domain.blocks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    blocks[chunks[c].block]->eroded += sums[c].eroded;
    domain.clock.element_limit = std::min(domain.clock.element_limit, sums[c].shortest_step);
  }
  for (domain::ElementBlock* block : blocks) {
    if (block->rigid) continue;
    const double damped = block->damping_energy;
    sum_groups(*block, domain.execution.threads);
    domain.energy.damping += block->damping_energy - damped;
  }
}

}  // namespace crumple::elements
