// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Rigid bodies made in code, shared by the tests of all folders.

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "support/meshes.hpp"

namespace crumple::test {

/// A number for the list of a test's properties.
inline std::string figure(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

/// Nodes of the elements of a part, ascending.
inline std::vector<Index> nodes_of_part(const model::Model& model, Index part) {
  std::vector<Index> nodes;
  for (const model::ShellElement& shell : model.shells)
    if (shell.part == part) nodes.insert(nodes.end(), shell.node.begin(), shell.node.end());
  for (const model::SolidElement& solid : model.solids)
    if (solid.part == part) nodes.insert(nodes.end(), solid.node.begin(), solid.node.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Gives the part a rigid material of its own and makes it a body. Call when its mesh is there.
inline model::RigidBody& make_rigid(model::Model& model, Index part) {
  model::Material material = model.materials[model.parts[part].material];
  material.id = static_cast<UserId>(model.materials.size()) + 1;
  material.rigid.emplace();
  model.parts[part].material = static_cast<Index>(model.materials.size());
  model.materials.push_back(material);
  model::RigidBody body;
  body.id = model.parts[part].id;
  body.parts = {part};
  body.nodes = nodes_of_part(model, part);
  model.rigid_bodies.push_back(body);
  return model.rigid_bodies.back();
}

/// Adds a curve that has the same ordinate always; returns its index.
inline Index add_constant_curve(model::Model& model, double ordinate) {
  model.curves.push_back({static_cast<UserId>(model.curves.size()) + 1, {0, 1e6}, {ordinate, ordinate}});
  return static_cast<Index>(model.curves.size()) - 1;
}

}  // namespace crumple::test
