// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Blocks of solids with bars of trusses in them.

#include <cmath>
#include <functional>
#include <vector>

#include "support/lines.hpp"
#include "support/run.hpp"

namespace crumple::test {

/// Concrete in kg, mm, ms.
inline model::Material elastic_concrete(double poissons_ratio = 0) {
  return {.id = 1,
          .title = "concrete",
          .density = 2.4e-6,
          .law = model::Elastic{.youngs_modulus = 30.0, .poissons_ratio = poissons_ratio}};
}

/// A block of concrete from zero to `size` in part 0, and a part 1 of steel trusses without mesh.
struct ReinforcedBlock {
  model::Model model;
  Point size;

  ReinforcedBlock(const std::array<Index, 3>& elements, const Point& extent, double bar_area,
                  double poissons_ratio = 0)
      : model(one_solid_part(elastic_concrete(poissons_ratio))), size(extent) {
    // Viscous hourglass control would take energy.
    model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
    add_box(model, 0, elements[0], elements[1], elements[2], [&](double u, double v, double w) {
      return Point{u * extent[0], v * extent[1], w * extent[2]};
    });
    model.materials.push_back(elastic_steel());
    model.materials.back().id = 2;
    model.beam_sections.emplace_back().id = 2;
    model.beam_sections[0].formulation = model::BeamFormulation::Truss;
    model.beam_sections[0].area = bar_area;
    model.parts.push_back({.id = 2, .title = "bars", .beam_section = 0, .material = 1});
    model::EmbeddedBeams embedded;
    embedded.id = 5;
    for (Index i = 0; i < static_cast<Index>(model.solids.size()); ++i) embedded.solids.push_back(i);
    model.embedded_beams.push_back(embedded);
  }

  /// Adds a bar of `count` trusses on a line between two points; returns its first node.
  Index add_bar(Index count, const Point& from, const Point& to) {
    const auto first_beam = static_cast<Index>(model.beams.size());
    const Index first = add_line(model, count, {}, [&](double u) {
      return Point{from[0] + u * (to[0] - from[0]), from[1] + u * (to[1] - from[1]),
                   from[2] + u * (to[2] - from[2])};
    });
    for (Index i = first_beam; i < static_cast<Index>(model.beams.size()); ++i) {
      model.beams[i].part = 1;
      model.embedded_beams[0].beams.push_back(i);
    }
    return first;
  }

  /// Gives all nodes an initial velocity by their place.
  void set_velocities(const std::function<math::Vec3(const Point&)>& velocity) {
    for (Index node = 0; node < model.nodes.count(); ++node) {
      const math::Vec3 v = velocity(model.nodes.position[node]);
      model.initial_velocities.push_back({.node = node, .velocity = {v.x, v.y, v.z}});
    }
  }
};

}  // namespace crumple::test
