// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Small models of beams and springs made in code.

#include <functional>
#include <utility>

#include "model/beam_section.hpp"
#include "support/meshes.hpp"
#include "support/run.hpp"

namespace crumple::test {

/// A model with one part of beams and no mesh yet.
inline model::Model one_beam_part(const model::Material& material, const model::BeamSection& section) {
  model::Model model;
  model.materials.push_back(material);
  model.beam_sections.push_back(section);
  model.parts.push_back({.id = 1, .title = "beams", .beam_section = 0, .material = 0});
  model.control.end_time = 1.0;
  return model;
}

/// A solid rectangle, `s` wide along s and `t` along t.
inline model::BeamSection rectangle(double s, double t, double torsion) {
  model::BeamSection section;
  section.id = 1;
  section.area = s * t;
  section.inertia_s = s * t * t * t / 12;
  section.inertia_t = t * s * s * s / 12;
  section.torsion = torsion;
  return section;
}

/// A section of integrated beams.
inline model::BeamSection integrated(std::vector<model::SectionPoint> points, double shear_factor = 1) {
  model::BeamSection section;
  section.id = 1;
  section.shear_factor = shear_factor;
  model::set_points(section, std::move(points));
  return section;
}

/// Adds `count` beams along a line, place(u) with u in [0, 1], and the nodes between; returns the first node.
inline Index add_line(model::Model& model, Index count, const std::array<double, 3>& orientation,
                      const std::function<Point(double)>& place) {
  const Index first = model.nodes.count();
  for (Index i = 0; i <= count; ++i) {
    model.nodes.id.push_back(model.nodes.count() + 1);
    model.nodes.position.push_back(place(static_cast<double>(i) / count));
  }
  for (Index i = 0; i < count; ++i)
    model.beams.push_back({.id = static_cast<UserId>(model.beams.size()) + 1,
                           .part = 0,
                           .node = {first + i, first + i + 1},
                           .orientation = orientation});
  return first;
}

/// A model with one part of springs or dampers and no mesh yet.
inline model::Model one_spring_part(const model::SpringLaw& law, bool torsional = false) {
  model::Model model;
  model.spring_materials.push_back({.id = 1, .title = "law", .law = law});
  model.discrete_sections.push_back({.id = 1, .title = "section", .torsional = torsional});
  model.parts.push_back({.id = 1, .title = "springs", .discrete_section = 0, .spring_material = 0});
  model.control.end_time = 1.0;
  return model;
}

/// Adds a node with a mass and, of its own kind, a rotary inertia; returns its index.
inline Index add_mass(model::Model& model, const Point& at, double mass, double inertia = 0) {
  const Index node = model.nodes.count();
  model.nodes.id.push_back(node + 1);
  model.nodes.position.push_back(at);
  model.lumped_masses.push_back({.id = node + 1, .node = node, .mass = mass, .inertia = inertia});
  return node;
}

/// Runs to the end time while every step takes the share `damping` of all velocities.
inline void run_damped(timeloop::Simulation& simulation, double damping) {
  simulation.start();
  while (!simulation.finished()) {
    simulation.step();
    domain::NodeFields& nodes = simulation.domain().nodes;
    for (Index i = 0; i < nodes.count(); ++i) {
      nodes.velocity[i] = (1 - damping) * nodes.velocity[i];
      nodes.angular_velocity[i] = (1 - damping) * nodes.angular_velocity[i];
    }
  }
}

}  // namespace crumple::test
