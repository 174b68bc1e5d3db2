// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Parts of cohesive solids, shared by the tests of all folders.

#include "model/model.hpp"

namespace crumple::test {

/// Adds a part of cohesive solids with a law and a density per area; returns its index.
inline Index add_layer(model::Model& model, const model::Cohesive& law, double density) {
  model.materials.push_back({.id = static_cast<UserId>(model.materials.size()) + 1,
                             .title = "glue",
                             .density = density,
                             .law = law});
  model::SolidSection& section = model.solid_sections.emplace_back();
  section.id = static_cast<UserId>(model.solid_sections.size());
  section.formulation = model::SolidFormulation::CohesiveHexahedron;
  model.parts.push_back({.id = static_cast<UserId>(model.parts.size()) + 1,
                         .title = "glue",
                         .solid_section = static_cast<Index>(model.solid_sections.size()) - 1,
                         .material = static_cast<Index>(model.materials.size()) - 1});
  return static_cast<Index>(model.parts.size()) - 1;
}

}  // namespace crumple::test
