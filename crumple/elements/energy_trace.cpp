// SPDX-License-Identifier: BSD-3-Clause
#include "elements/energy_trace.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.hpp"

namespace crumple::elements {
namespace {

using domain::Chunk;
using domain::Domain;
using domain::ElementBlock;
using math::Vec3;

Vec3 vector_of(const double (&a)[4]) {
  return {a[0], a[1], a[2]};
}

/// Places of the elements of a chunk in its block, without the fill.
std::pair<Index, Index> places_of(const Chunk& chunk, const ElementBlock& block) {
  return {chunk.first_group * lanes, std::min(chunk.last_group * lanes, block.elements)};
}

/// All that the elements of a chunk have got so far [energy].
double energy_of(const Chunk& chunk, const ElementBlock& block) {
  double sum = 0;
  for (Index group = chunk.first_group; group < chunk.last_group; ++group) {
    const domain::GroupEnergy& energy = block.energy[static_cast<std::size_t>(group)];
    sum += energy.internal + energy.hourglass + energy.damping + energy.eroded;
  }
  return sum;
}

/// What the elements of a block are called, and their user numbers by their index in the model.
struct Named {
  const char* kind;
  UserId id;
};
Named named(const model::Model& model, const Domain& domain, Index block, Index element) {
  const auto is_of = [&](const auto& blocks) {
    const bool found = block < static_cast<Index>(blocks.size());
    if (!found) block -= static_cast<Index>(blocks.size());
    return found;
  };
  if (is_of(domain.shells)) return {"shell", model.shells[element].id};
  if (is_of(domain.solids)) return {"solid", model.solids[element].id};
  if (is_of(domain.beams)) return {"beam", model.beams[element].id};
  return {"discrete element", model.discretes[element].id};
}

}  // namespace

EnergyTrace::EnergyTrace(const Domain& domain) {
  const std::vector<const ElementBlock*> blocks = domain.blocks();
  const std::vector<Chunk>& chunks = domain.assembly.chunks();
  first_.push_back(0);
  for (const Chunk& chunk : chunks) {
    const ElementBlock& block = *blocks[static_cast<std::size_t>(chunk.block)];
    std::vector<Entry> own;
    const auto [from, to] = places_of(chunk, block);
    for (Index place = from; place < to; ++place)
      for (Index corner = 0; corner < block.corners; ++corner) {
        const std::size_t at =
            (static_cast<std::size_t>(place / lanes) * block.corners + corner) * lanes + place % lanes;
        own.push_back({block.target[at], block.node[at]});
      }
    std::sort(own.begin(), own.end(), [](const Entry& a, const Entry& b) { return a.target < b.target; });
    const auto same = [](const Entry& a, const Entry& b) { return a.target == b.target; };
    own.erase(std::unique(own.begin(), own.end(), same), own.end());
    entries_.insert(entries_.end(), own.begin(), own.end());
    first_.push_back(static_cast<Index>(entries_.size()));
  }
  previous_.resize(entries_.size());
  residual_.resize(chunks.size());
  for (const Chunk& chunk : chunks)
    energy_.push_back(energy_of(chunk, *blocks[static_cast<std::size_t>(chunk.block)]));
}

void EnergyTrace::observe(const Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  const std::vector<const ElementBlock*> blocks = domain.blocks();
  const double half_step = 0.5 * domain.clock.step;
  parallel_for(static_cast<Index>(residual_.size()), domain.execution.threads, [&](Index chunk) {
    double work = 0;
    for (Index i = first_[chunk]; i < first_[chunk + 1]; ++i) {
      const domain::NodeForce& now = nodes.force[entries_[i].target];
      const Work present{vector_of(now.force), vector_of(now.moment)};
      const Index node = entries_[i].node;
      work += dot(previous_[i].force + present.force, nodes.velocity[node]) +
              dot(previous_[i].moment + present.moment, nodes.angular_velocity[node]);
      previous_[i] = present;
    }
    const Chunk& of = domain.assembly.chunks()[chunk];
    const double energy = energy_of(of, *blocks[static_cast<std::size_t>(of.block)]);
    residual_[chunk] += energy - energy_[chunk] + half_step * work;
    energy_[chunk] = energy;
  });
}

std::vector<domain::EnergyResidual> EnergyTrace::parts(const model::Model& model,
                                                       const Domain& domain) const {
  std::vector<domain::EnergyResidual> found(model.parts.size());
  for (std::size_t part = 0; part < found.size(); ++part) found[part].id = model.parts[part].id;
  const std::vector<const ElementBlock*> blocks = domain.blocks();
  for (const ElementBlock* block : blocks)
    found[block->part].energy += block->internal_energy + block->hourglass_energy + block->eroded_energy;
  const std::vector<Chunk>& chunks = domain.assembly.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c)
    found[blocks[static_cast<std::size_t>(chunks[c].block)]->part].residual += residual_[c];
  return found;
}

std::vector<domain::ElementResidual> EnergyTrace::worst(const model::Model& model, const Domain& domain,
                                                        std::size_t count) const {
  std::vector<Index> order(residual_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return std::fabs(residual_[a]) > std::fabs(residual_[b]); });
  order.resize(std::min(order.size(), count));
  const std::vector<const ElementBlock*> blocks = domain.blocks();
  std::vector<domain::ElementResidual> found;
  found.reserve(order.size());
  for (const Index c : order) {
    const Chunk& chunk = domain.assembly.chunks()[c];
    const ElementBlock& block = *blocks[static_cast<std::size_t>(chunk.block)];
    const auto [from, to] = places_of(chunk, block);
    const Named first = named(model, domain, chunk.block, block.element[from]);
    domain::ElementResidual entry;
    entry.part = model.parts[block.part].id;
    entry.kind = first.kind;
    entry.first = first.id;
    entry.last = named(model, domain, chunk.block, block.element[to - 1]).id;
    entry.elements = to - from;
    entry.residual = residual_[c];
    Index fastest = entries_[first_[c]].node;
    for (Index i = first_[c]; i < first_[c + 1]; ++i)
      if (norm(domain.nodes.velocity[entries_[i].node]) > norm(domain.nodes.velocity[fastest]))
        fastest = entries_[i].node;
    entry.node = model.nodes.id[domain.nodes.model_node[fastest]];
    entry.speed = norm(domain.nodes.velocity[fastest]);
    entry.place = domain.nodes.position[fastest];
    found.push_back(entry);
  }
  return found;
}

void EnergyTrace::declare(domain::StateList& list) {
  list.keep_list("energy_trace_forces", "force, force*length", domain::Entity::Run, 6, previous_);
  list.keep_list("energy_trace_residuals", "energy", domain::Entity::Run, 1, residual_);
  list.keep_list("energy_trace_energies", "energy", domain::Entity::Run, 1, energy_);
}

}  // namespace crumple::elements
