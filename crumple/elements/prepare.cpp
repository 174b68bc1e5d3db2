// SPDX-License-Identifier: BSD-3-Clause
#include "elements/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "domain/build.hpp"
#include "elements/elements.hpp"
#include "elements/initial_stress.hpp"
#include "elements/lone_elements.hpp"
#include "elements/prepare_cohesives.hpp"
#include "materials/common/shell_material.hpp"

namespace crumple::elements {

double mass_factor(double mass_scaling_step, double step) {
  if (mass_scaling_step == 0) return 1;
  const double ratio = std::fabs(mass_scaling_step) / step;
  return mass_scaling_step < 0 && ratio < 1 ? 1 : ratio * ratio;
}

bool scales_mass(const model::Model& model, const domain::Domain& domain, const domain::ElementBlock& block) {
  const model::Part& part = model.parts[block.part];
  return domain.clock.kept_step > 0 && !block.rigid && part.material != no_index &&
         materials::has_stiffness(model.materials[part.material].law);
}

void require(bool holds, const model::Part& part, const std::string& what) {
  if (!holds) throw Error("Part " + std::to_string(part.id) + ": " + what + ".");
}

void add_mass(domain::Domain& domain, Index part, Index node, double mass) {
  domain.nodes.mass[node] += mass;
  if (domain.part_shares.empty()) return;
  domain::PartShare& share = domain.part_shares[static_cast<std::size_t>(part)];
  share.nodes.push_back(node);
  share.share.push_back(mass);
}

namespace {

bool asks_for_parts(const model::Model& model) {
  return !model.part_masses.empty() || !model.part_dampings.empty() || !model.relative_dampings.empty() ||
         std::any_of(model.inertia_fields.begin(), model.inertia_fields.end(),
                     [](const model::InertiaField& field) { return !field.parts.empty(); });
}

/// What several elements have added to a node becomes one entry, in the order of the nodes.
void merge_nodes(domain::PartShare& share, std::vector<double>& at_node) {
  for (std::size_t i = 0; i < share.nodes.size(); ++i)
    at_node[static_cast<std::size_t>(share.nodes[i])] += share.share[i];
  std::sort(share.nodes.begin(), share.nodes.end());
  share.nodes.erase(std::unique(share.nodes.begin(), share.nodes.end()), share.nodes.end());
  share.share.clear();
  for (const Index node : share.nodes) {
    share.share.push_back(at_node[static_cast<std::size_t>(node)]);
    at_node[static_cast<std::size_t>(node)] = 0;
  }
}

/// The mass of *ELEMENT_MASS_PART, in proportion to that of the elements.
void add_part_mass(const model::Model& model, const model::PartMass& given, domain::Domain& domain) {
  double present = 0;
  for (const Index part : given.parts)
    for (const double mass : domain.part_shares[static_cast<std::size_t>(part)].share) present += mass;
  const model::Part& first = model.parts[static_cast<std::size_t>(given.parts.front())];
  require(present > 0, first, "mass is added to it in proportion to that of its elements, which have none");
  require(given.final_mass == 0 || given.final_mass >= present, first,
          "its mass is " + std::to_string(present) + ", more than its final mass is to be");
  const double factor = (given.final_mass > 0 ? given.final_mass : present + given.added) / present;
  for (const Index part : given.parts) {
    domain::PartShare& share = domain.part_shares[static_cast<std::size_t>(part)];
    for (std::size_t i = 0; i < share.nodes.size(); ++i) {
      domain.nodes.mass[share.nodes[i]] += (factor - 1) * share.share[i];
      share.share[i] *= factor;
    }
  }
}

void finish_part_masses(const model::Model& model, domain::Domain& domain) {
  if (domain.part_shares.empty()) return;
  std::vector<double> at_node(static_cast<std::size_t>(domain.nodes.count()), 0.0);
  for (domain::PartShare& share : domain.part_shares) merge_nodes(share, at_node);
  for (const model::PartMass& given : model.part_masses) add_part_mass(model, given, domain);
  for (domain::PartShare& share : domain.part_shares)
    for (std::size_t i = 0; i < share.nodes.size(); ++i) share.share[i] /= domain.nodes.mass[share.nodes[i]];
}

/// Rigid elements limit the step where all others have no stiffness: something has to.
void limit_by_rigid_elements(const model::Model& model, domain::Domain& domain) {
  for (const domain::ElementBlock* block : domain.blocks()) {
    const model::Part& part = model.parts[block->part];
    const bool spring = part.material == no_index;
    const bool fluid = part.equation_of_state != no_index;
    if (block->rigid) continue;
    if (spring || fluid || materials::has_stiffness(model.materials[part.material].law)) return;
  }
  const auto look = [&](const auto& block) {
    if (block.rigid)
      domain.clock.rigid_limit = std::min(domain.clock.rigid_limit, stable_step(domain, block));
  };
  for (const domain::ShellBlock& block : domain.shells) look(block);
  for (const domain::SolidBlock& block : domain.solids) look(block);
  for (const domain::BeamBlock& block : domain.beams) look(block);
}

/// Solids of a run with ERODE go below DTMIN times the step that the elements allow at the start: TSSFAC is
/// in both. A shorter DTINIT is the first step.
void limit_solids_by_run(const model::Model& model, domain::Domain& domain) {
  if (!model.control.erodes_short_solids || !(model.control.minimum_step_factor > 0)) return;
  double first = model.control.initial_step > 0 ? model.control.initial_step / model.control.step_scale
                                                : std::numeric_limits<double>::max();
  const auto look = [&](const auto& blocks) {
    for (const auto& block : blocks)
      if (!block.rigid) first = std::min(first, stable_step(domain, block));
  };
  look(domain.shells);
  look(domain.solids);
  look(domain.beams);
  look(domain.discretes);
  const double least = model.control.minimum_step_factor * first;
  for (domain::SolidBlock& block : domain.solids)
    if (!block.rigid) block.least_step = std::max(block.least_step, least);
}

}  // namespace

void prepare_elements(const model::Model& model, domain::Domain& domain) {
  if (asks_for_parts(model)) domain.part_shares.resize(model.parts.size());
  if (model.control.mass_scaling_step < 0 && !model.control.scales_mass_once)
    domain.clock.kept_step = -model.control.mass_scaling_step;
  const LoneElements lone(model, domain);
  prepare_shells(model, lone, domain);
  prepare_solids(model, lone, domain);
  prepare_beams(model, domain);
  finish_part_masses(model, domain);
  set_discrete_beam_steps(model, domain);
  prepare_discretes(model, domain);
  set_cohesive_steps(model, domain);
  set_initial_stresses(model, domain);
  limit_by_rigid_elements(model, domain);
  limit_solids_by_run(model, domain);
  if (domain.clock.kept_step > 0)
    for (domain::ElementBlock* block : domain.blocks())
      if (!block->rigid) block->group_step.assign(static_cast<std::size_t>(block->groups()), 0.0);
  domain::deal_out(domain);
}

}  // namespace crumple::elements
