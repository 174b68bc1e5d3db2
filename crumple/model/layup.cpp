// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <variant>

#include "model/model.hpp"

namespace crumple::model {

namespace {

/// What the elements need to know of a law.
struct Stiffness {
  double plate = 0;  ///< E / (1 - nu^2) [stress]
  double shear = 0;  ///< G [stress]
  double ratio = 0;  ///< nu [-]
};

Stiffness stiffness_of(const Material& material) {
  return std::visit(
      [](const auto& law) {
        const double nu = law.poissons_ratio;
        return Stiffness{law.youngs_modulus / (1 - nu * nu), 0.5 * law.youngs_modulus / (1 + nu), nu};
      },
      material.law);
}

}  // namespace

Index layup_of(const Model& model, const ShellElement& shell) {
  return shell.layup != no_index ? shell.layup : model.parts[shell.part].layup;
}

const Material& material_of(const Model& model, const ShellElement& shell) {
  return model.materials[shell.layup != no_index ? model.layups[shell.layup].material
                                                 : model.parts[shell.part].material];
}

Material layup_material(const Model& model, const Layup& layup) {
  Material mean;
  double membrane = 0;
  double coupling = 0;
  double bending = 0;
  double shear = 0;
  double largest_ratio = 0.4;  // with more, the stiffness of contact would grow out of bounds
  for (const ShellLayer& layer : layup.layers) {
    const Material& material = model.materials[layer.material];
    const Stiffness own = stiffness_of(material);
    // As if the layer had its stiffness over its whole thickness.
    const double place = layup.follows_rule ? 0 : layer.place;
    const double square = layup.follows_rule ? 1.0 / 3 : place * place + layer.share * layer.share / 3;
    mean.density += layer.share * material.density;
    membrane += layer.share * own.plate;
    coupling += std::sqrt(3.0) * layer.share * place * own.plate;
    bending += 3 * layer.share * square * own.plate;
    shear += layer.share * own.shear;
    largest_ratio = std::max(largest_ratio, own.ratio);
  }
  // The largest eigenvalue: stretching and bending with the rotary inertia of the thickness alone.
  const double half = 0.5 * (membrane - bending);
  const double plate = 0.5 * (membrane + bending) + std::sqrt(half * half + coupling * coupling);
  Elastic law;
  if (plate > 0) {
    law.poissons_ratio = std::clamp(1 - 2 * shear / plate, -0.9, largest_ratio);
    law.youngs_modulus = plate * (1 - law.poissons_ratio * law.poissons_ratio);
  }
  mean.law = law;
  return mean;
}

}  // namespace crumple::model
