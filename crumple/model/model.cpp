// SPDX-License-Identifier: BSD-3-Clause
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::model {

int repeated_entry(const std::array<Index, 4>& node) {
  for (int k = 3; k >= 0; --k)
    if (node[(static_cast<std::size_t>(k) + 3) % 4] == node[static_cast<std::size_t>(k)]) return (k + 3) % 4;
  return -1;
}

bool is_tetrahedron(const SolidElement& solid) {
  const SolidNodes& n = solid.node;
  const bool repeats = n[3] == n[2] && n[5] == n[4] && n[6] == n[4] && n[7] == n[4];
  return repeats && n[0] != n[1] && n[0] != n[2] && n[0] != n[4] && n[1] != n[2] && n[1] != n[4] &&
         n[2] != n[4];
}

ElementKind kind_of(const Part& part) {
  if (part.solid_section != no_index) return ElementKind::Solid;
  if (part.beam_section != no_index) return ElementKind::Beam;
  return part.discrete_section != no_index ? ElementKind::Discrete : ElementKind::Shell;
}

const char* name_of(const SpringLaw& law) {
  static constexpr const char* names[] = {"spring",           "damper",           "elastoplastic spring",
                                          "nonlinear spring", "nonlinear damper", "Maxwell spring",
                                          "inelastic spring"};
  return names[law.index()];
}

std::array<double, 4> shell_thickness(const Model& model, const ShellElement& shell) {
  const bool own = shell.thickness[0] > 0;
  std::array<double, 4> t =
      own ? shell.thickness : model.shell_sections[model.parts[shell.part].section].thickness;
  const int repeated = repeated_entry(shell.node);
  if (repeated >= 0) {
    const std::size_t second = static_cast<std::size_t>(repeated + 1) % 4;
    const double first = t[(second + 1) % 4];
    // Written so that equal corners give their value to the last bit.
    t[second] = first + ((t[(second + 2) % 4] - first) + (t[(second + 3) % 4] - first)) / 3;
  }
  return t;
}

bool is_rigid(const Model& model, const Part& part) {
  return part.material != no_index && model.materials[part.material].rigid.has_value();
}

const HourglassControl& hourglass_of(const Model& model, const Part& part) {
  return part.hourglass == no_index ? model.control.hourglass : model.hourglass_controls[part.hourglass];
}

HourglassControl solid_hourglass_of(const Model& model, const Part& part) {
  HourglassControl control = hourglass_of(model, part);
  if (control.form != HourglassForm::Material) return control;
  const ConstitutiveLaw& law = model.materials[part.material].law;
  // Without shear stiffness there is none to assume strains for: the viscous form with its usual coefficient.
  if (std::holds_alternative<NullMaterial>(law)) return control;
  control.coefficient = is_elastic(law) ? 1 : 0.01;
  control.solid_form = SolidHourglassForm::AssumedStrain;
  return control;
}

const EquationOfState* equation_of_state_of(const Model& model, const Part& part) {
  return part.equation_of_state == no_index ? nullptr : &model.equations_of_state[part.equation_of_state];
}

BulkViscosity bulk_viscosity_of(const Model& model, const Part& part) {
  const HourglassControl& own = hourglass_of(model, part);
  return {own.bulk_quadratic > 0 ? own.bulk_quadratic : model.control.bulk_quadratic,
          own.bulk_linear > 0 ? own.bulk_linear : model.control.bulk_linear};
}

namespace {

bool within(Index index, std::size_t size) {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

bool finite(const std::array<double, 3>& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

void check_nodes(const Model& model, std::vector<std::string>& found) {
  if (model.nodes.id.size() != model.nodes.position.size())
    found.emplace_back("The node ids and node positions differ in number.");
  for (std::size_t i = 0; i < model.nodes.position.size(); ++i)
    if (!finite(model.nodes.position[i]))
      found.push_back("Node " + std::to_string(model.nodes.id[i]) +
                      " has a coordinate that is not a finite number.");
}

void check_parts(const Model& model, std::vector<std::string>& found) {
  for (const Part& part : model.parts) {
    const std::string name = "Part " + std::to_string(part.id);
    const bool discrete = within(part.discrete_section, model.discrete_sections.size());
    const int sections = int(within(part.section, model.shell_sections.size())) +
                         int(within(part.solid_section, model.solid_sections.size())) +
                         int(within(part.beam_section, model.beam_sections.size())) + int(discrete);
    if (sections != 1)
      found.push_back(name + " needs one section, of shells, solids, beams or discrete elements.");
    if (discrete ? !within(part.spring_material, model.spring_materials.size())
                 : !within(part.material, model.materials.size()))
      found.push_back(name + " has no material.");
    if (part.equation_of_state != no_index &&
        !within(part.equation_of_state, model.equations_of_state.size()))
      found.push_back(name + " refers to an equation of state that does not exist.");
  }
  for (const Material& material : model.materials)
    if (!(material.density > 0))
      found.push_back("Material " + std::to_string(material.id) + " needs a density above zero.");
}

void check_solids(const Model& model, std::vector<std::string>& found) {
  for (const SolidElement& solid : model.solids) {
    const std::string name = "Solid " + std::to_string(solid.id);
    if (!within(solid.part, model.parts.size()) || model.parts[solid.part].solid_section == no_index) {
      found.push_back(name + " has no part with a section of solids.");
      continue;
    }
    const SolidFormulation formulation =
        model.solid_sections[model.parts[solid.part].solid_section].formulation;
    if (is_tetrahedral(formulation) && !is_tetrahedron(solid))
      found.push_back(name + " is no tetrahedron, but the formulation of its section is for these only.");
    if (is_quadratic(formulation) != solid.node.has_middles())
      found.push_back(name + " has four nodes where its section is for ten, or ten where it is not.");
    for (const Index node : solid.node)
      if (!within(node, model.nodes.id.size()))
        found.push_back(name + " refers to a node that does not exist.");
  }
}

/// Elements between two nodes.
template <class Elements>
void check_lines(const Model& model, const Elements& elements, ElementKind kind, const std::string& what,
                 std::vector<std::string>& found) {
  for (const auto& element : elements) {
    const std::string name = what + " " + std::to_string(element.id);
    if (!within(element.part, model.parts.size()) || kind_of(model.parts[element.part]) != kind)
      found.push_back(name + " has no part with a section for it.");
    for (const Index node : element.node)
      if (!within(node, model.nodes.id.size()))
        found.push_back(name + " refers to a node that does not exist.");
  }
}

void check_shells(const Model& model, std::vector<std::string>& found) {
  for (const ShellElement& shell : model.shells) {
    const std::string name = "Shell " + std::to_string(shell.id);
    if (!within(shell.part, model.parts.size()) || model.parts[shell.part].section == no_index) {
      found.push_back(name + " has no part with a section of shells.");
      continue;
    }
    for (const Index node : shell.node)
      if (!within(node, model.nodes.id.size()))
        found.push_back(name + " refers to a node that does not exist.");
    const bool for_triangles =
        model.shell_sections[model.parts[shell.part].section].formulation == ShellFormulation::Triangle;
    if (for_triangles && repeated_entry(shell.node) < 0)
      found.push_back(name + " has four nodes, but the formulation of its section is for triangles only.");
    for (const double thickness : shell_thickness(model, shell))
      if (!(thickness > 0)) {
        found.push_back(name + " needs a thickness above zero.");
        break;
      }
  }
}

/// Every rigid part in one body, every node in one at most.
void check_rigid_bodies(const Model& model, std::vector<std::string>& found) {
  std::vector<Index> body_of_part(model.parts.size(), no_index);
  std::vector<Index> body_of_node(model.nodes.id.size(), no_index);
  for (Index b = 0; b < static_cast<Index>(model.rigid_bodies.size()); ++b) {
    const RigidBody& body = model.rigid_bodies[b];
    const std::string name = "Rigid body " + std::to_string(body.id);
    if (body.nodes.empty()) found.push_back(name + " has no nodes.");
    for (const Index part : body.parts) body_of_part[part] = b;
    for (const Index node : body.nodes) {
      if (!within(node, body_of_node.size())) {
        found.push_back(name + " refers to a node that does not exist.");
        continue;
      }
      Index& owner = body_of_node[node];
      if (owner != no_index && owner != b)
        found.push_back("Node " + std::to_string(model.nodes.id[node]) + " belongs to the rigid bodies " +
                        std::to_string(model.rigid_bodies[owner].id) + " and " + std::to_string(body.id) +
                        ", which are not merged.");
      owner = b;
    }
  }
  std::vector<char> has_elements(model.parts.size(), 0);
  const auto mark = [&](const auto& element) { has_elements[static_cast<std::size_t>(element.part)] = 1; };
  std::for_each(model.shells.begin(), model.shells.end(), mark);
  std::for_each(model.solids.begin(), model.solids.end(), mark);
  std::for_each(model.beams.begin(), model.beams.end(), mark);
  for (std::size_t part = 0; part < model.parts.size(); ++part)
    if (has_elements[part] && is_rigid(model, model.parts[part]) && body_of_part[part] == no_index)
      found.push_back("Part " + std::to_string(model.parts[part].id) +
                      " is of rigid material and belongs to no rigid body.");
}

}  // namespace

std::vector<std::string> faults(const Model& model) {
  std::vector<std::string> found;
  check_nodes(model, found);
  check_parts(model, found);
  if (found.empty()) check_shells(model, found);
  if (found.empty()) check_solids(model, found);
  if (found.empty()) check_rigid_bodies(model, found);
  if (found.empty()) check_lines(model, model.beams, ElementKind::Beam, "Beam", found);
  if (found.empty()) check_lines(model, model.discretes, ElementKind::Discrete, "Discrete element", found);
  return found;
}

}  // namespace crumple::model
