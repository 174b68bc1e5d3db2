// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/part_masses.hpp"

#include <map>

namespace crumple::output {

double shell_mass(const View& view, const model::ShellElement& shell) {
  const model::Model& model = view.model;
  const domain::NodeFields& nodes = view.domain.nodes;
  const auto at = [&](std::size_t k) { return nodes.reference[nodes.domain_node[shell.node[k]]]; };
  const math::Vec3 first = at(2) - at(0);
  const math::Vec3 second = at(3) - at(1);
  const double area = 0.5 * math::norm(math::cross(first, second));
  const auto thickness = model::shell_thickness(model, shell);
  const double mean = 0.25 * (thickness[0] + thickness[1] + thickness[2] + thickness[3]);
  return model::material_of(model, shell).density * area * mean;
}

PartMasses::PartMasses(const View& view) {
  std::vector<std::map<Index, double>> by_node(view.model.parts.size());
  for (const model::ShellElement& shell : view.model.shells) {
    const bool triangle = shell.node[3] == shell.node[2];
    const int corners = triangle ? 3 : 4;
    const double share = shell_mass(view, shell) / corners;
    for (int corner = 0; corner < corners; ++corner)
      by_node[shell.part][view.domain.nodes.domain_node[shell.node[corner]]] += share;
  }
  for (const domain::SolidBlock& block : view.domain.solids) {
    const double density = view.model.materials[view.model.parts[block.part].material].density;
    const domain::StateItem* const volume = block.find("reference_volume");
    if (volume == nullptr) continue;
    for (Index place = 0; place < block.elements; ++place)
      for (Index corner = 0; corner < block.corners; ++corner)
        by_node[block.part][block.node_of(place, corner)] +=
            density * block.state(place, volume->first) * block.mass_share(corner);
  }
  for (const domain::BeamBlock& block : view.domain.beams) {
    const model::Part& part = view.model.parts[block.part];
    const model::BeamSection& section = view.model.beam_sections[part.beam_section];
    const double density = view.model.materials[part.material].density;
    const auto volume_of = [&](double length) {
      if (section.formulation != model::BeamFormulation::Discrete) return section.area * length;
      return section.discrete.volume > 0 ? section.discrete.volume : section.discrete.cable_area * length;
    };
    const domain::StateItem* const length = block.find("reference_length");
    if (length == nullptr) continue;
    for (Index place = 0; place < block.elements; ++place)
      for (const Index node : block.nodes_of(place))
        by_node[block.part][node] += 0.5 * density * volume_of(block.state(place, length->first));
  }
  for (const auto& nodes : by_node) shares_.emplace_back(nodes.begin(), nodes.end());
}

PartMasses::Motion PartMasses::motion(const domain::NodeFields& nodes, Index part) const {
  Motion result;
  math::Vec3 momentum;
  for (const auto& [node, mass] : shares_[part]) {
    const math::Vec3& velocity = nodes.velocity[node];
    result.mass += mass;
    result.kinetic_energy += 0.5 * mass * math::dot(velocity, velocity);
    momentum += mass * velocity;
  }
  if (result.mass > 0) result.velocity = (1.0 / result.mass) * momentum;
  return result;
}

PartMasses::Motion PartMasses::motion_with_body(const domain::Domain& domain, Index part) const {
  for (const domain::RigidBody& body : domain.rigid_bodies)
    if (body.part == part && body.has_given_inertia) return {body.mass, body.kinetic_energy, body.velocity};
  return motion(domain.nodes, part);
}

double PartMasses::mass(Index part) const {
  double sum = 0;
  for (const auto& share : shares_[part]) sum += share.second;
  return sum;
}

}  // namespace crumple::output
