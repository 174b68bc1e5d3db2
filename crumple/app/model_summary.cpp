// SPDX-License-Identifier: BSD-3-Clause
#include "app/model_summary.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "app/bounding_box.hpp"
#include "elements/registry.hpp"
#include "materials/shell_material.hpp"
#include "output/part_masses.hpp"

namespace crumple::app {

namespace {

/// Rows of the table of parts; of more parts only the first are listed.
constexpr Index part_rows = 60;

std::string thickness_range(const model::Model& model, Index part) {
  double least = 1e300;
  double most = 0;
  for (const model::ShellElement& shell : model.shells) {
    if (shell.part != part) continue;
    for (const double thickness : model::shell_thickness(model, shell)) {
      least = std::min(least, thickness);
      most = std::max(most, thickness);
    }
  }
  if (most == 0) return "-";
  return least == most ? fmt::format("{:.4g}", most) : fmt::format("{:.4g}-{:.4g}", least, most);
}

void print_parts(std::ostream& out, const model::Model& model, const domain::Domain& domain) {
  const output::PartMasses masses(output::View{model, domain, 0});
  std::vector<Index> shells(model.parts.size());
  for (const model::ShellElement& shell : model.shells) ++shells[shell.part];
  fmt::print(out, "  {:>8} {:>8}  {:<22} {:<18} {:>3} {:>14} {:>11}  title\n", "part", "shells", "element",
             "material", "nip", "thickness", "mass");
  const Index rows = std::min(part_rows, static_cast<Index>(model.parts.size()));
  for (Index p = 0; p < rows; ++p) {
    const model::Part& part = model.parts[p];
    const model::ShellSection& section = model.shell_sections[part.section];
    fmt::print(out, "  {:>8} {:>8}  {:<22} {:<18} {:>3} {:>14} {:>11.4g}  {}\n", part.id, shells[p],
               elements::shell_kind(section.formulation).name,
               materials::shell_material_name(model.materials[part.material].law), section.thickness_points,
               thickness_range(model, p), masses.mass(p), part.title);
  }
  if (rows < static_cast<Index>(model.parts.size()))
    fmt::print(out, "  ... and {} parts more\n", model.parts.size() - rows);
}

double lumped_mass(const model::Model& model) {
  double sum = 0;
  for (const model::LumpedMass& mass : model.lumped_masses) sum += mass.mass;
  return sum;
}

void print_conditions(std::ostream& out, const model::Model& model) {
  fmt::print(out, "  nodes held            {}\n", model.fixed_nodes.size());
  fmt::print(out, "  initial velocities    {}\n", model.initial_velocities.size());
  if (!model.nodal_loads.empty()) fmt::print(out, "  nodal loads           {}\n", model.nodal_loads.size());
  if (!model.pressure_loads.empty())
    fmt::print(out, "  pressure loads        {}\n", model.pressure_loads.size());
  for (const model::RigidWall& wall : model.rigid_walls)
    fmt::print(out, "  rigid wall {:<10} stops {} nodes, friction {:g}\n", wall.id, wall.nodes.size(),
               wall.friction);
  for (const model::SingleSurfaceContact& contact : model.contacts)
    fmt::print(out, "  contact {:<13} single surface, {} parts, friction {:g}/{:g}\n", contact.id,
               contact.parts.size(), contact.static_friction, contact.dynamic_friction);
  if (model.contacts.empty()) fmt::print(out, "  contact               none\n");
}

}  // namespace

void print_reading(std::ostream& out, const deck::ReadResult& deck) {
  for (const auto& file : deck.files) fmt::print(out, "Read {}\n", file.string());
  if (!deck.unit_system.empty()) fmt::print(out, "Units seem to be {}\n", deck.unit_system);
  for (const deck::IgnoredKeyword& keyword : deck.ignored_keywords)
    fmt::print(out, "{} {} ({} times, first at {}:{})\n",
               keyword.changes_physics ? "LEFT OUT, although it changes the result:" : "Ignored:",
               keyword.keyword, keyword.count, keyword.file, keyword.line);
}

void print_model(std::ostream& out, const model::Model& model, const domain::Domain& domain) {
  const auto triangles =
      std::count_if(model.shells.begin(), model.shells.end(),
                    [](const model::ShellElement& shell) { return shell.node[2] == shell.node[3]; });
  double mass = 0;
  for (const double nodal : domain.nodes.mass) mass += nodal;
  const BoundingBox box = bounding_box(model);
  if (!model.title.empty()) fmt::print(out, "\n{}\n", model.title);
  fmt::print(out, "\nModel\n");
  fmt::print(out, "  nodes                 {}\n", model.nodes.count());
  fmt::print(out, "  shells                {} ({} of them triangles)\n", model.shells.size(), triangles);
  fmt::print(out, "  mass                  {:.6g}, of it lumped {:.6g} at {} nodes, added {:.4g}\n", mass,
             lumped_mass(model), model.lumped_masses.size(), domain.added_mass);
  fmt::print(out, "  box                   x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, z {:.6g} to {:.6g}\n",
             box.lowest[0], box.highest[0], box.lowest[1], box.highest[1], box.lowest[2], box.highest[2]);
  print_conditions(out, model);
  print_parts(out, model, domain);
}

}  // namespace crumple::app
