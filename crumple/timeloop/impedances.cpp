// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/impedances.hpp"

#include <cmath>

#include "materials/common/shell_material.hpp"
#include "materials/common/solid_material.hpp"

namespace crumple::timeloop {
namespace {

/// Where an equation of state gives the pressure, the shear modulus is what the waves have beyond it.
loads::Impedance impedance_of(const model::Model& model, const model::Part& part) {
  const model::Material& material = model.materials[part.material];
  const model::EquationOfState* const equation = model::equation_of_state_of(model, part);
  const materials::SolidStart start = materials::solid_start(material, equation);
  double shear = 0;
  if (equation == nullptr) {
    shear = materials::elastic_constants(material).shear_modulus() * start.stiffness_share;
  } else {
    const double modulus = start.density * start.wave_speed * start.wave_speed;
    shear = 0.75 * (modulus - model::initial_bulk_modulus(*equation, material.density));
    if (shear < 1e-9 * modulus) shear = 0;  // round-off of a fluid
  }
  return {start.density * start.wave_speed, std::sqrt(start.density * shear)};
}

}  // namespace

std::vector<loads::Impedance> impedances_of_parts(const model::Model& model) {
  std::vector<loads::Impedance> found(model.parts.size());
  for (const model::ViscousSegment& segment : model.viscous_segments) {
    const auto part = static_cast<std::size_t>(model.solids[segment.solid].part);
    if (found[part].normal == 0) found[part] = impedance_of(model, model.parts[part]);
  }
  return found;
}

}  // namespace crumple::timeloop
