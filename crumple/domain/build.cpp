// SPDX-License-Identifier: BSD-3-Clause
#include "domain/build.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "domain/local_holds.hpp"
#include "domain/numbering.hpp"
#include "math/to_vec3.hpp"

namespace crumple::domain {
namespace {

using math::to_vec3;

void require_sound(const model::Model& model) {
  const std::vector<std::string> found = model::faults(model);
  if (found.empty()) return;
  std::string text = "The model cannot be run:";
  for (const std::string& fault : found) text += "\n  " + fault;
  throw Error(text);
}

void place_nodes(const model::Model& model, Domain& domain) {
  NodeFields& nodes = domain.nodes;
  const std::size_t count = nodes.model_node.size();
  nodes.position.resize(count);
  nodes.velocity.resize(count);
  nodes.angular_velocity.resize(count);
  nodes.acceleration.resize(count);
  nodes.mass.assign(count, 0.0);
  nodes.inertia.assign(count, 0.0);
  nodes.fixed.assign(count, 0);
  domain.contact_weight.resize(count);
  domain.contact_force.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    nodes.position[i] = to_vec3(model.nodes.position[nodes.model_node[i]]);
  nodes.reference = nodes.position;
  if (domain.execution.precision == Precision::Mixed)
    nodes.float_records.resize(count);
  else
    nodes.double_records.resize(count);
}

void set_conditions(const model::Model& model, NodeFields& nodes) {
  for (const model::LumpedMass& lumped : model.lumped_masses) {
    nodes.mass[nodes.domain_node[lumped.node]] += lumped.mass;
    nodes.inertia[nodes.domain_node[lumped.node]] += lumped.inertia;
  }
  for (const model::InitialVelocity& initial : model.initial_velocities) {
    const Index node = nodes.domain_node[initial.node];
    nodes.velocity[node] = to_vec3(initial.velocity);
    nodes.angular_velocity[node] = to_vec3(initial.angular_velocity);
  }
  for (const model::FixedNode& fixed : model.fixed_nodes) {
    const Index node = nodes.domain_node[fixed.node];
    for (int axis = 0; axis < 3; ++axis) {
      if (fixed.translation[axis]) {
        nodes.fixed[node] |= fixed_translation(axis);
        nodes.velocity[node][axis] = 0;
      }
      if (fixed.rotation[axis]) {
        nodes.fixed[node] |= fixed_rotation(axis);
        nodes.angular_velocity[node][axis] = 0;
      }
    }
  }
}

bool is_triangle(const model::ShellElement& shell) {
  return model::repeated_entry(shell.node) >= 0;
}

/// The same order of nodes, begun so that a triangle repeats its third node.
std::array<Index, 4> triangle_last(const std::array<Index, 4>& node) {
  const int repeated = model::repeated_entry(node);
  if (repeated < 0) return node;
  std::array<Index, 4> turned;
  for (std::size_t k = 0; k < 4; ++k) turned[k] = node[(k + static_cast<std::size_t>(repeated) + 2) % 4];
  return turned;
}

template <class Corners>
void connect(ElementBlock& block, const NodeFields& nodes, const Corners& corners_of) {
  block.node.resize(static_cast<std::size_t>(block.groups()) * block.corners * lanes);
  for (Index place = 0; place < block.groups() * lanes; ++place) {
    const auto corner = corners_of(block.element[std::min(place, block.elements - 1)]);
    const std::size_t group = static_cast<std::size_t>(place / lanes) * block.corners * lanes;
    for (std::size_t k = 0; k < corner.size(); ++k)
      block.node[group + k * lanes + place % lanes] = nodes.domain_node[corner[k]];
  }
}

/// A block of some elements of a part, without its connectivity.
template <class Block>
Block begin_block(const model::Model& model, Index part, const std::vector<Index>& elements) {
  Block block;
  block.part = part;
  block.rigid = model::is_rigid(model, model.parts[part]);
  block.elements = static_cast<Index>(elements.size());
  block.element = elements;
  return block;
}

ShellBlock make_block(const model::Model& model, const NodeFields& nodes, Index part,
                      const std::vector<Index>& shells) {
  auto block = begin_block<ShellBlock>(model, part, shells);
  const model::ShellSection& section = model.shell_sections[model.parts[part].section];
  block.formulation = section.formulation;
  if (is_triangle(model.shells[shells.front()]))
    block.formulation = model::is_membrane(section.formulation) ? model::ShellFormulation::MembraneTriangle
                                                                : model::ShellFormulation::Triangle;
  block.layup = model::layup_of(model, model.shells[shells.front()]);
  block.has_own_layup = model.shells[shells.front()].layup != no_index;
  block.thickness_points = block.layup == no_index
                               ? section.thickness_points
                               : static_cast<Index>(model.layups[block.layup].layers.size());
  connect(block, nodes, [&](Index shell) { return triangle_last(model.shells[shell].node); });
  return block;
}

SolidBlock make_solid_block(const model::Model& model, const NodeFields& nodes, Index part,
                            const std::vector<Index>& solids) {
  auto block = begin_block<SolidBlock>(model, part, solids);
  block.formulation = model.solid_sections[model.parts[part].solid_section].formulation;
  if (model::is_quadratic(block.formulation)) {
    block.corners = 10;
    connect(block, nodes, [&](Index solid) {
      const model::SolidNodes& node = model.solids[solid].node;
      std::array<Index, 10> found{};
      for (std::size_t k = 0; k < 4; ++k) found[k] = node[model::corners_of_tetrahedron[k]];
      for (std::size_t k = 0; k < model::SolidNodes::middles; ++k) found[4 + k] = node.middle(k);
      return found;
    });
  } else if (model::is_tetrahedral(block.formulation)) {
    block.corners = 4;
    connect(block, nodes, [&](Index solid) {
      const model::SolidNodes& node = model.solids[solid].node;
      return std::array<Index, 4>{node[0], node[1], node[2], node[4]};
    });
  } else {
    block.corners = 8;
    connect(block, nodes, [&](Index solid) { return model.solids[solid].node; });
  }
  return block;
}

BeamBlock make_beam_block(const model::Model& model, const NodeFields& nodes, Index part,
                          const std::vector<Index>& beams) {
  auto block = begin_block<BeamBlock>(model, part, beams);
  const model::BeamSection& section = model.beam_sections[model.parts[part].beam_section];
  block.formulation = section.formulation;
  if (section.formulation == model::BeamFormulation::Integrated)
    block.points = static_cast<Index>(section.points.size());
  connect(block, nodes, [&](Index beam) { return model.beams[beam].node; });
  return block;
}

DiscreteBlock make_discrete_block(const model::Model& model, const NodeFields& nodes, Index part,
                                  const std::vector<Index>& discretes) {
  auto block = begin_block<DiscreteBlock>(model, part, discretes);
  block.torsional = model.discrete_sections[model.parts[part].discrete_section].torsional;
  connect(block, nodes, [&](Index discrete) { return model.discretes[discrete].node; });
  return block;
}

/// A block of a part's quadrilaterals and one of its triangles, which have a formulation of their own; and as
/// many more as there are layups of its elements.
void add_blocks(const model::Model& model, Index part, std::vector<Index> shells, Domain& domain) {
  const auto triangles = std::stable_partition(
      shells.begin(), shells.end(), [&](Index shell) { return !is_triangle(model.shells[shell]); });
  const std::vector<Index> split[2] = {{shells.begin(), triangles}, {triangles, shells.end()}};
  for (const std::vector<Index>& shape : split) {
    std::map<Index, std::vector<Index>> by_layup;
    for (const Index shell : shape) by_layup[model.shells[shell].layup].push_back(shell);
    for (const auto& [layup, alike] : by_layup)
      domain.shells.push_back(make_block(model, domain.nodes, part, alike));
  }
}

}  // namespace

void deal_out(Domain& domain) {
  domain.assembly.build(domain.blocks(), domain.nodes.count(),
                        {domain.execution.threads, domain.execution.groups_per_chunk});
  domain.nodes.force.resize(static_cast<std::size_t>(domain.nodes.count()) + domain.assembly.slots());
}

Domain build(const model::Model& model, const Execution& execution) {
  require_sound(model);
  Domain domain;
  domain.execution = execution;
  Numbering numbering = number_for_locality(model);
  domain.nodes.model_node = std::move(numbering.model_node);
  domain.nodes.domain_node = std::move(numbering.domain_node);
  place_nodes(model, domain);
  set_conditions(model, domain.nodes);
  list_local_holds(model, 0, domain.nodes);
  for (Index part = 0; part < static_cast<Index>(model.parts.size()); ++part)
    add_blocks(model, part, std::move(numbering.shells_by_part[part]), domain);
  for (Index part = 0; part < static_cast<Index>(model.parts.size()); ++part)
    if (const auto& solids = numbering.solids_by_part[part]; !solids.empty())
      domain.solids.push_back(make_solid_block(model, domain.nodes, part, solids));
  for (Index part = 0; part < static_cast<Index>(model.parts.size()); ++part) {
    if (const auto& beams = numbering.beams_by_part[part]; !beams.empty())
      domain.beams.push_back(make_beam_block(model, domain.nodes, part, beams));
    if (const auto& discretes = numbering.discretes_by_part[part]; !discretes.empty())
      domain.discretes.push_back(make_discrete_block(model, domain.nodes, part, discretes));
  }
  deal_out(domain);
  domain.nodes.publish_all();
  return domain;
}

}  // namespace crumple::domain
