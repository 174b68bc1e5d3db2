// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small models made in code, shared by the tests of all folders.

#include <array>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "model/model.hpp"

namespace crumple::test {

using Point = std::array<double, 3>;

/// Steel in kg, mm, ms (stress in GPa).
inline model::Material elastic_steel() {
  return {.id = 1, .title = "steel", .density = 7.85e-6, .law = model::Elastic{210.0, 0.3}};
}

/// Mild steel in kg, mm, ms with a yield stress of 250 MPa, for parts that fold.
inline model::Material mild_steel() {
  return {.id = 1,
          .title = "steel",
          .density = 7.85e-6,
          .law = model::PlasticKinematic{.youngs_modulus = 210,
                                         .poissons_ratio = 0.3,
                                         .yield_stress = 0.25,
                                         .tangent_modulus = 1,
                                         .isotropic_fraction = 1}};
}

/// A section of one thickness.
inline model::ShellSection shell_section(
    double thickness, int points,
    model::ShellFormulation formulation = model::ShellFormulation::BelytschkoTsay) {
  model::ShellSection section;
  section.id = 1;
  section.formulation = formulation;
  section.thickness_points = points;
  section.thickness = {thickness, thickness, thickness, thickness};
  return section;
}

/// A model with one part of `material` and `section` and no mesh yet.
inline model::Model one_part(const model::Material& material, const model::ShellSection& section) {
  model::Model model;
  model.materials.push_back(material);
  model.shell_sections.push_back(section);
  model.parts.push_back({.id = 1, .title = "part", .section = 0, .material = 0});
  model.control.end_time = 1.0;
  return model;
}

/// Adds a mapped grid of columns x rows quadrilaterals to `part`: place(u, v) gives the position of the grid
/// point with u, v in [0, 1]. Returns the index of the first node; node (i, j) is first + j * (columns + 1) +
/// i.
inline Index add_grid(model::Model& model, Index part, Index columns, Index rows,
                      const std::function<Point(double, double)>& place) {
  const Index first = model.nodes.count();
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) {
      model.nodes.id.push_back(model.nodes.count() + 1);
      model.nodes.position.push_back(place(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index corner = first + j * (columns + 1) + i;
      model.shells.push_back({.id = static_cast<UserId>(model.shells.size()) + 1,
                              .part = part,
                              .node = {corner, corner + 1, corner + columns + 2, corner + columns + 1}});
    }
  return first;
}

/// A model of solids of one material, with one part and no mesh yet.
inline model::Model one_solid_part(const model::Material& material) {
  model::Model model;
  model.materials.push_back(material);
  model.solid_sections.emplace_back().id = 1;
  model.parts.push_back({.id = 1, .title = "part", .solid_section = 0, .material = 0});
  model.control.end_time = 1.0;
  return model;
}

/// Adds a mapped box of nx x ny x nz hexahedra to `part`: place(u, v, w) gives the position of the grid point
/// with u, v, w in [0, 1]. Node (i, j, k) is first + (k * (ny + 1) + j) * (nx + 1) + i, first is returned.
inline Index add_box(model::Model& model, Index part, Index nx, Index ny, Index nz,
                     const std::function<Point(double, double, double)>& place) {
  const Index first = model.nodes.count();
  for (Index k = 0; k <= nz; ++k)
    for (Index j = 0; j <= ny; ++j)
      for (Index i = 0; i <= nx; ++i) {
        model.nodes.id.push_back(model.nodes.count() + 1);
        model.nodes.position.push_back(
            place(static_cast<double>(i) / nx, static_cast<double>(j) / ny, static_cast<double>(k) / nz));
      }
  const Index row = nx + 1;
  const Index layer = row * (ny + 1);
  for (Index k = 0; k < nz; ++k)
    for (Index j = 0; j < ny; ++j)
      for (Index i = 0; i < nx; ++i) {
        const Index corner = first + k * layer + j * row + i;
        const Index above = corner + layer;
        model.solids.push_back({.id = static_cast<UserId>(model.solids.size()) + 1,
                                .part = part,
                                .node = {corner, corner + 1, corner + row + 1, corner + row, above, above + 1,
                                         above + row + 1, above + row}});
      }
  return first;
}

/// Makes six tetrahedra of each hexahedron, around its diagonal from node 1 to node 7 (H.W. Kuhn 1960): those
/// of neighbours in a box fit together.
inline void split_into_tetrahedra(model::Model& model) {
  constexpr std::array<std::array<std::size_t, 2>, 6> others = {
      {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}}};
  std::vector<model::SolidElement> split;
  split.reserve(6 * model.solids.size());
  for (const model::SolidElement& solid : model.solids)
    for (const auto& other : others) {
      const Index first = solid.node[0];
      const Index second = solid.node[other[0]];
      const Index third = solid.node[other[1]];
      const Index top = solid.node[6];
      split.push_back({.id = static_cast<UserId>(split.size()) + 1,
                       .part = solid.part,
                       .node = {first, second, third, third, top, top, top, top}});
    }
  model.solids = std::move(split);
}

/// Adds a node in the middle of each side of tetrahedra with four.
inline void add_middle_nodes(model::Model& model) {
  std::map<std::pair<Index, Index>, Index> known;
  for (model::SolidElement& solid : model.solids) {
    model::SolidNodes::Middles middle{};
    for (std::size_t side = 0; side < middle.size(); ++side) {
      Index a = solid.node[model::corners_of_tetrahedron[model::sides_of_tetrahedron[side][0]]];
      Index b = solid.node[model::corners_of_tetrahedron[model::sides_of_tetrahedron[side][1]]];
      if (a > b) std::swap(a, b);
      const auto [entry, is_new] = known.try_emplace({a, b}, model.nodes.count());
      middle[side] = entry->second;
      if (!is_new) continue;
      const auto& x = model.nodes.position[static_cast<std::size_t>(a)];
      const auto& y = model.nodes.position[static_cast<std::size_t>(b)];
      model.nodes.id.push_back(model.nodes.id.back() + 1);
      model.nodes.position.push_back({0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])});
    }
    solid.node = model::SolidNodes(solid.node, middle);
  }
}

/// Makes two wedges of each hexahedron.
inline void split_into_wedges(model::Model& model) {
  std::vector<model::SolidElement> split;
  split.reserve(2 * model.solids.size());
  for (const model::SolidElement& solid : model.solids) {
    const std::array<Index, 8>& n = solid.node;
    const std::array<Index, 8> wedges[2] = {{n[0], n[1], n[2], n[3], n[4], n[4], n[7], n[7]},
                                            {n[1], n[5], n[6], n[2], n[4], n[4], n[7], n[7]}};
    for (const std::array<Index, 8>& wedge : wedges)
      split.push_back({.id = static_cast<UserId>(split.size()) + 1, .part = solid.part, .node = wedge});
  }
  model.solids = std::move(split);
}

}  // namespace crumple::test
