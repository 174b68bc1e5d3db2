// SPDX-License-Identifier: BSD-3-Clause
#include "materials/common/checks.hpp"

#include "base/error.hpp"

namespace crumple::materials {

void require(bool holds, const model::Material& material, const std::string& what) {
  if (!holds) throw Error("Material " + std::to_string(material.id) + ": " + what + ".");
}

void require_elastic(const model::Material& material, double youngs_modulus, double poissons_ratio) {
  require(youngs_modulus > 0, material, "Young's modulus must be above zero");
  require(poissons_ratio > -1 && poissons_ratio < 0.5, material,
          "Poisson's ratio must be above -1 and below 0.5");
}

void require_cowper_symonds(const model::Material& material, double rate, double exponent) {
  require(rate >= 0, material, "the Cowper-Symonds rate C must not be negative");
  require(rate == 0 || exponent > 0, material,
          "the Cowper-Symonds exponent p must be above zero where the rate C is given");
}

void fail_axis(UserId shell) {
  throw Error("Shell " + std::to_string(shell) +
              ": the direction of its material's axis a is normal to the shell; give another vector.");
}

void fail_solid_axes(UserId solid) {
  throw Error("Solid " + std::to_string(solid) +
              ": the directions of its material's axes are parallel, or zero; give other vectors.");
}

void require_failure_strain(const model::Material& material, double failure_strain) {
  require(failure_strain >= 0, material, "the failure strain must not be negative; zero is no failure");
}

}  // namespace crumple::materials
