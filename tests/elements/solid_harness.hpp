// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell_harness.hpp"

namespace crumple::elements::testing {

/// A formulation of solids with one of its hourglass forms.
struct SolidCase {
  model::SolidFormulation formulation = model::SolidFormulation::OnePointHexahedron;
  model::SolidHourglassForm form = model::SolidHourglassForm::FlanaganBelytschkoViscous;
  const char* name = "";

  bool one_point_hexahedron() const { return formulation == model::SolidFormulation::OnePointHexahedron; }
  bool viscous() const {
    return one_point_hexahedron() && form <= model::SolidHourglassForm::ExactVolumeViscous;
  }
};
inline constexpr std::array solid_cases{
    SolidCase{model::SolidFormulation::OnePointHexahedron, model::SolidHourglassForm::StandardViscous,
              "IHQ 1"},
    SolidCase{model::SolidFormulation::OnePointHexahedron,
              model::SolidHourglassForm::FlanaganBelytschkoViscous, "IHQ 2"},
    SolidCase{model::SolidFormulation::OnePointHexahedron, model::SolidHourglassForm::ExactVolumeViscous,
              "IHQ 3"},
    SolidCase{model::SolidFormulation::OnePointHexahedron,
              model::SolidHourglassForm::FlanaganBelytschkoStiffness, "IHQ 4"},
    SolidCase{model::SolidFormulation::OnePointHexahedron, model::SolidHourglassForm::ExactVolumeStiffness,
              "IHQ 5"},
    SolidCase{model::SolidFormulation::OnePointHexahedron, model::SolidHourglassForm::AssumedStrain, "IHQ 6"},
    SolidCase{.formulation = model::SolidFormulation::SelectiveHexahedron, .name = "ELFORM 2"},
    SolidCase{.formulation = model::SolidFormulation::AssumedStrainHexahedron, .name = "ELFORM -2"},
    SolidCase{.formulation = model::SolidFormulation::Tetrahedron, .name = "ELFORM 10"},
    SolidCase{.formulation = model::SolidFormulation::NodalPressureTetrahedron, .name = "ELFORM 13"},
    SolidCase{.formulation = model::SolidFormulation::QuadraticTetrahedron, .name = "ELFORM 16"}};

/// A model without mesh.
inline model::Model solid_model(const SolidCase& of, const model::Material& material) {
  model::Model model = test::one_solid_part(material);
  model.solid_sections[0].formulation = of.formulation;
  model.control.hourglass.solid_form = of.form;
  return model;
}

/// Tetrahedra where the formulation is for them.
inline void split_for(const SolidCase& of, model::Model& model) {
  if (model::is_tetrahedral(of.formulation)) test::split_into_tetrahedra(model);
  if (model::is_quadratic(of.formulation)) test::add_middle_nodes(model);
}

/// A cube of side 2 n of n x n x n hexahedra, or as many times six tetrahedra; every node but those on its
/// surface is moved by up to `distortion` of an element's side, those on the surface within it.
inline model::Model solid_cube(const SolidCase& of, Index n, double distortion,
                               const model::Material& material = elastic()) {
  model::Model model = solid_model(of, material);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double side = 2.0 * static_cast<double>(n);
  test::add_box(model, 0, n, n, n, [&](double u, double v, double w) {
    test::Point x{u * side, v * side, w * side};
    for (double& coordinate : x) {
      const double move = 2 * distortion * uniform(generator);
      if (coordinate > 0 && coordinate < side) coordinate += move;
    }
    return x;
  });
  split_for(of, model);
  return model;
}

/// Solids have no rotations.
inline void hold_rotations(model::Model& model) {
  for (Index node = 0; node < model.nodes.count(); ++node)
    model.fixed_nodes.push_back({.node = node, .rotation = {true, true, true}});
}

/// Half the product of the highest frequency of a free body and its stable step: below one it is stable
/// without a factor. By the power method, from forces.
inline double courant_number(model::Model model) {
  model.control.bulk_linear = model.control.bulk_quadratic = 0;
  Driven body(model, {Precision::Double, available_isas().back(), 1});
  body.update(0);
  const double limit = body.domain.clock.element_limit;
  const Index count = body.domain.nodes.count();
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Vec3> shape(count);
  for (Vec3& u : shape) u = {uniform(generator), uniform(generator), uniform(generator)};
  std::vector<Vec3> moved(count);
  double eigenvalue = 0;
  constexpr double size = 1e-9;
  for (int i = 0; i < 400; ++i) {
    double norm_squared = 0;
    for (Index n = 0; n < count; ++n) norm_squared += body.domain.nodes.mass[n] * dot(shape[n], shape[n]);
    const double factor = size * std::sqrt(body.domain.nodes.mass[0] / norm_squared);
    std::vector<Vec3> step(count);
    for (Index n = 0; n < count; ++n) {
      const Vec3 target = factor * shape[n];
      step[n] = target - moved[n];
      moved[n] = target;
    }
    body.step(1, step, std::vector<Vec3>(count));
    double work = 0;
    double mass = 0;
    for (Index n = 0; n < count; ++n) {
      work -= dot(body.force(n), moved[n]);
      mass += body.domain.nodes.mass[n] * dot(moved[n], moved[n]);
      shape[n] = (-1 / body.domain.nodes.mass[n]) * body.force(n);
    }
    eigenvalue = work / mass;
  }
  return 0.5 * std::sqrt(eigenvalue) * limit;
}

inline std::string name_of(const SolidCase& of, const domain::Execution& execution) {
  return std::string(of.name) + " " + name_of(execution);
}

}  // namespace crumple::elements::testing
