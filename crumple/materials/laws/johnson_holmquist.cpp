// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/johnson_holmquist.hpp"

#include <cstddef>

#include "materials/common/checks.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {

void declare_brittle_history(domain::ElementBlock& block, const char* memory, bool fails) {
  declare_volume(block);
  declare_plastic_strain(block);
  domain::add_item(block, "damage", "-", block.points);
  domain::add_item(block, memory, "-", block.points);
  if (fails) domain::add_item(block, "failed", "-", block.points);
}

bool erodes(const model::BrittleErosion& erosion) {
  return erosion.at_tension || erosion.plastic_strain > 0;
}

void check_brittle(const model::Material& material, const model::BrittleSolid& law) {
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.shear_modulus > 0 && law.bulk_modulus > 0, material, "G and K1 must be above zero");
  require(law.tension > 0, material, "the largest hydrostatic tension T must be above zero");
  require(law.rate_coefficient >= 0 && law.reference_rate > 0, material,
          "the rate coefficient C must not be negative, the reference rate EPS0 be above zero");
  require(law.fracture_factor >= 0 && law.fracture_power >= 0, material, "D1 and D2 must not be negative");
}

std::vector<double> brittle_constants(double density, const model::BrittleSolid& law, int count) {
  using Place = BrittlePoint<double>;
  std::vector<double> numbers(static_cast<std::size_t>(count));
  numbers[Place::Shear] = law.shear_modulus;
  numbers[Place::Tension] = law.tension;
  numbers[Place::RateCoefficient] = law.rate_coefficient;
  numbers[Place::ReferenceRate] = law.reference_rate;
  numbers[Place::PerDensity] = 1 / density;
  numbers[Place::FailsInTension] = law.erosion.at_tension ? 1 : 0;
  numbers[Place::FailsByDamage] = law.erosion.by_damage ? 1 : 0;
  numbers[Place::FailureStrain] = law.erosion.plastic_strain;
  numbers[Place::FractureFactor] = law.fracture_factor;
  numbers[Place::FracturePower] = law.fracture_power;
  numbers[Place::Bulk] = law.bulk_modulus;
  numbers[Place::BulkQuadratic] = law.bulk_quadratic;
  numbers[Place::BulkCubic] = law.bulk_cubic;
  return numbers;
}

}  // namespace crumple::materials
