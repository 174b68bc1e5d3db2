// SPDX-License-Identifier: BSD-3-Clause
#include "elements/section_forces.hpp"

#include <algorithm>

#include "elements/elements.hpp"
#include "elements/solid/nodal_average.hpp"

namespace crumple::elements {
namespace {

using domain::Domain;
using domain::ElementBlock;
using math::Vec3;

/// What is the same for all elements of a block.
void copy_kind(const domain::ShellBlock& from, domain::ShellBlock& to) {
  to.formulation = from.formulation;
  to.thickness_points = from.thickness_points;
  to.plane_points = from.plane_points;
  to.runs = from.runs;
  to.layers_hold = from.layers_hold;
}
void copy_kind(const domain::SolidBlock& from, domain::SolidBlock& to) {
  to.formulation = from.formulation;
}
void copy_kind(const domain::BeamBlock& from, domain::BeamBlock& to) {
  to.formulation = from.formulation;
}
void copy_kind(const domain::DiscreteBlock& from, domain::DiscreteBlock& to) {
  to.torsional = from.torsional;
}

/// A block of some elements of another one, their nodes numbered as there.
template <class Block>
Block block_of(const Block& from, const std::vector<Index>& places) {
  Block block;
  copy_kind(from, block);
  block.part = from.part;
  block.corners = from.corners;
  block.points = from.points;
  block.elements = static_cast<Index>(places.size());
  for (const Index place : places) block.element.push_back(from.element[place]);
  block.items = from.items;
  block.components = from.components;
  block.element_constants = from.element_constants;
  block.material_constants = from.material_constants;
  if constexpr (requires { block.damping; }) {
    block.damping = from.damping;
    block.damping_moduli = from.damping_moduli;
  }
  block.node.resize(static_cast<std::size_t>(block.groups()) * block.corners * lanes);
  for (Index place = 0; place < block.groups() * lanes; ++place)
    for (Index corner = 0; corner < block.corners; ++corner)
      block.node[(static_cast<std::size_t>(place / lanes) * block.corners + corner) * lanes + place % lanes] =
          from.node_of(places[std::min(place, block.elements - 1)], corner);
  return block;
}

/// Places in a block of some elements of the model, which `wanted` marks.
std::vector<Index> places_of(const ElementBlock& block, const std::vector<char>& wanted) {
  std::vector<Index> places;
  if (block.rigid) return places;
  for (Index place = 0; place < block.elements; ++place)
    if (wanted[static_cast<std::size_t>(block.element[place])] != 0) places.push_back(place);
  return places;
}

template <class Block>
std::vector<char> marked(const std::vector<Block>& blocks, const std::vector<Index>& elements) {
  Index count = 0;
  for (const Block& block : blocks)
    for (const Index element : block.element) count = std::max(count, element + 1);
  std::vector<char> marks(static_cast<std::size_t>(count), 0);
  for (const Index element : elements) marks[static_cast<std::size_t>(element)] = 1;
  return marks;
}

void copy_state(const ElementBlock& from, const std::vector<Index>& places, ElementBlock& to) {
  for (Index place = 0; place < to.groups() * lanes; ++place) {
    const Index source = places[std::min(place, to.elements - 1)];
    for (Index component = 0; component < to.components; ++component) {
      if (from.float_state.empty())
        to.double_state[to.offset(place, component)] = from.double_state[from.offset(source, component)];
      else
        to.float_state[to.offset(place, component)] = from.float_state[from.offset(source, component)];
    }
  }
}

}  // namespace

SectionForces::SectionForces(const model::Model& model, const Domain& domain) {
  if (!model.output.of(model::HistoryFile::Secforc).asked) return;
  for (const model::CrossSection& given : model.output.cross_sections) {
    sections_.push_back(make_section(given, domain));
    reports_.push_back({.id = given.id});
  }
  for (const domain::SolidBlock& block : domain.solids)
    averages_ = averages_ || (!sections_.empty() && !block.average.node.empty());
}

SectionForces::Section SectionForces::make_section(const model::CrossSection& given, const Domain& domain) {
  Section section;
  Domain& part = section.part;
  part.execution = domain.execution;
  part.execution.threads = 1;
  Index number = 0;
  const auto add = [&](const auto& blocks, const std::vector<Index>& elements, auto& into) {
    const std::vector<char> wanted = marked(blocks, elements);
    for (const auto& block : blocks) {
      const std::vector<Index> places = places_of(block, wanted);
      if (!places.empty()) {
        auto& own = into.emplace_back(block_of(block, places));
        own.allocate(block.float_state.empty() ? Precision::Double : Precision::Mixed);
        section.source.emplace_back(number, places);
      }
      ++number;
    }
  };
  add(domain.shells, given.shells, part.shells);
  add(domain.solids, given.solids, part.solids);
  add(domain.beams, given.beams, part.beams);
  add(domain.discretes, given.discretes, part.discretes);

  std::vector<Index> part_node(static_cast<std::size_t>(domain.nodes.count()), no_index);
  for (ElementBlock* block : part.blocks())
    for (Index& node : block->node) {
      Index& its = part_node[static_cast<std::size_t>(node)];
      if (its == no_index) {
        its = static_cast<Index>(section.node.size());
        section.node.push_back(node);
      }
      node = its;
    }
  for (const Index model_node : given.nodes) {
    const Index node = domain.nodes.domain_node[model_node];
    section.own.push_back(node);
    if (part_node[node] != no_index) section.cut.push_back(part_node[node]);
  }
  const std::size_t count = section.node.size();
  domain::NodeFields& nodes = part.nodes;
  nodes.position.resize(count);
  nodes.velocity.resize(count);
  nodes.angular_velocity.resize(count);
  if (domain.nodes.float_records.empty())
    nodes.double_records.resize(count);
  else
    nodes.float_records.resize(count);
  part.assembly.build(part.blocks(), static_cast<Index>(count), {});
  nodes.force.resize(count + static_cast<std::size_t>(part.assembly.slots()));
  return section;
}

void SectionForces::copy_present(const Domain& domain, Section& section) {
  domain::NodeFields& nodes = section.part.nodes;
  for (std::size_t i = 0; i < section.node.size(); ++i) {
    const Index node = section.node[i];
    nodes.position[i] = domain.nodes.position[node];
    nodes.velocity[i] = domain.nodes.velocity[node];
    nodes.angular_velocity[i] = domain.nodes.angular_velocity[node];
  }
  nodes.publish_all();
  std::fill(nodes.force.begin(), nodes.force.end(), domain::NodeForce{});
  const std::vector<const ElementBlock*> whole = domain.blocks();
  const std::vector<ElementBlock*> own = section.part.blocks();
  for (std::size_t b = 0; b < own.size(); ++b)
    copy_state(*whole[section.source[b].first], section.source[b].second, *own[b]);
  section.part.clock = domain.clock;
}

void SectionForces::measure(Domain& domain) {
  // The averages stand in the state, from where they are copied.
  if (averages_) average_dilatations(domain);
  for (std::size_t s = 0; s < sections_.size(); ++s) {
    Section& section = sections_[s];
    copy_present(domain, section);
    add_element_forces(section.part);
    domain::SectionReport& report = reports_[s];
    report.force = report.moment = report.centroid = {};
    for (const Index node : section.own)
      report.centroid += (1.0 / static_cast<double>(section.own.size())) * domain.nodes.position[node];
    for (const Index node : section.cut) {
      const domain::NodeForce& sum = section.part.nodes.force[node];
      const Vec3 force{sum.force[0], sum.force[1], sum.force[2]};
      report.force += force;
      report.moment += cross(section.part.nodes.position[node] - report.centroid, force) +
                       Vec3{sum.moment[0], sum.moment[1], sum.moment[2]};
    }
  }
}

}  // namespace crumple::elements
