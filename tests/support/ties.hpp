// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Models of two parts that are tied to each other, shared by the tests of all folders.

#include <cmath>

#include "support/meshes.hpp"
#include "support/rigid.hpp"

namespace crumple::test {

inline constexpr double modulus = 210;
inline constexpr double density = 7.85e-6;

/// Ties the nodes of part 1 to the surface of part 0.
inline model::TiedContact& add_tie(model::Model& model, model::TieMethod method) {
  model::TiedContact& tied = model.tied_contacts.emplace_back();
  tied.id = 7;
  tied.method = method;
  tied.side[0].parts = {1};
  tied.side[1].parts = {0};
  return tied;
}

/// mm, ms, kg: two blocks of 10 x 4 x 4 end to end at x = 10, the first with `coarse` elements along an edge
/// of its cross section, the second, `gap` apart, with `fine`; without lateral strain.
inline model::Model two_blocks(Index coarse, Index fine, Index along,
                               model::TieMethod method = model::TieMethod::Constraint, double gap = 0) {
  model::Model model =
      one_solid_part({.id = 1, .title = "steel", .density = density, .law = model::Elastic{modulus, 0}});
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  model.parts.push_back({.id = 2, .title = "second", .solid_section = 0, .material = 0});
  const auto add = [&](Index part, Index cells, double start) {
    return add_box(model, part, along, cells, cells, [=](double u, double v, double w) {
      return Point{start + 10 * u, 4 * v, 4 * w};
    });
  };
  add(0, coarse, 0);
  add(1, fine, 10 + gap);
  add_tie(model, method);
  return model;
}

/// Two blocks, 4 elements long, tied over a gap.
inline model::Model offset_blocks(model::TieMethod method, Index coarse, Index fine, double gap) {
  model::Model model = two_blocks(coarse, fine, 4, method, gap);
  model.tied_contacts[0].tolerance = 2 * gap;
  return model;
}

/// Two bars of 100 x 4 x 4, the first with a pulse of one sign that runs into the second, all of it there at
/// the end time.
inline model::Model two_bars(Index first_cells, Index second_cells,
                             model::TieMethod method = model::TieMethod::Constraint, double gap = 0) {
  model::Model model =
      one_solid_part({.id = 1, .title = "steel", .density = density, .law = model::Elastic{modulus, 0}});
  model.solid_sections[0].formulation = model::SolidFormulation::SelectiveHexahedron;
  model.parts.push_back({.id = 2, .title = "second", .solid_section = 0, .material = 0});
  const auto add = [&](Index part, Index cells, double start) {
    return add_box(model, part, 50, cells, cells, [=](double u, double v, double w) {
      return Point{start + 100 * u, 4 * v, 4 * w};
    });
  };
  add(0, first_cells, 0);
  add(1, second_cells, 100 + gap);
  add_tie(model, method);
  // A push at the free end for the time in which a wave runs 40 mm.
  const double wave_speed = std::sqrt(modulus / density);
  const double length = 40 / wave_speed;
  model::Curve curve{.id = 1, .abscissa = {}, .ordinate = {}};
  constexpr int points = 40;
  for (int i = 0; i <= points; ++i) {
    curve.abscissa.push_back(length * i / points);
    curve.ordinate.push_back(0.5 - 0.5 * std::cos(2 * M_PI * i / points));
  }
  curve.abscissa.push_back(1e6);
  curve.ordinate.push_back(0);
  model.curves.push_back(curve);
  for (Index i = 0; i < model.nodes.count(); ++i) {
    const auto& x = model.nodes.position[i];
    if (x[0] > 1e-9) continue;
    const auto rim = [](double a) { return a < 1e-9 || a > 4 - 1e-9 ? 0.5 : 1.0; };
    const double area = 16.0 / (first_cells * first_cells) * rim(x[1]) * rim(x[2]);
    model.nodal_loads.push_back({.node = i, .force = {0.1 * area, 0, 0}, .moment = {}, .curve = 0});
  }
  model.control.end_time = 180 / wave_speed;
  return model;
}

/// Gives the nodes velocities with no order in them: bodies shake and tumble.
inline void shake(model::Model& model) {
  for (Index i = 0; i < model.nodes.count(); ++i)
    model.initial_velocities.push_back({.node = i,
                                        .velocity = {std::sin(1.0 * i), std::sin(2.0 * i), std::sin(3.0 * i)},
                                        .angular_velocity = {}});
}

/// A plate of 40 x 20 in the plane z = 0, held at its ends x = 0 and x = 40, and a strip of 20 x 20 on its
/// middle line x = 20, loaded sideways at the top; in one mesh or tied.
inline model::Model shell_joint(bool tied, Index cells) {
  model::Model model = one_part(elastic_steel(), shell_section(1.0, 3));
  model.parts.push_back({.id = 2, .title = "strip", .section = 0, .material = 0});
  const Index columns = 2 * cells;
  const Index plate = add_grid(model, 0, cells, columns, [](double u, double v) {
    return Point{20 * u, 40 * v, 0};
  });
  const Index strip = add_grid(model, 1, cells, cells, [](double u, double v) {
    return Point{20 * u, 20, 20 * v};
  });
  for (Index i = 0; i <= cells; ++i)
    for (const Index row : {Index{0}, columns})
      model.fixed_nodes.push_back({.node = plate + row * (cells + 1) + i,
                                   .translation = {true, true, true},
                                   .rotation = {true, true, true}});
  add_constant_curve(model, 1.0);
  for (Index i = 0; i <= cells; ++i)
    model.nodal_loads.push_back(
        {.node = strip + cells * (cells + 1) + i, .force = {0, 1e-4, 0}, .moment = {}, .curve = 0});
  if (tied) {
    add_tie(model, model::TieMethod::Constraint).ties_rotations = true;
  } else {
    for (model::ShellElement& shell : model.shells)
      for (Index& node : shell.node)
        if (node >= strip && node <= strip + cells) node = plate + cells * (cells + 1) + (node - strip);
  }
  model.control.end_time = 1.0;
  return model;
}

}  // namespace crumple::test
