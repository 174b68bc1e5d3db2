// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/holmquist_ceramic.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {
namespace {

using CeramicPlace = HolmquistCeramicLaw::SolidUpdate<double>;

void check_ceramic(const model::Material& material, const model::HolmquistCeramic& law) {
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require(law.shear_modulus > 0 && law.bulk_modulus > 0, material, "G and K1 must be above zero");
  require(law.limit_pressure > 0 && law.elastic_limit > law.limit_pressure, material,
          "the pressure PHEL at the Hugoniot elastic limit must be above zero, HEL above PHEL");
  require(law.tension > 0, material, "the largest hydrostatic tension T must be above zero");
  require(law.intact_factor > 0 && law.fractured_factor >= 0, material,
          "A must be above zero, B must not be negative");
  require(law.intact_power >= 0 && law.fractured_power >= 0 && law.fracture_power >= 0, material,
          "the powers N, M and D2 must not be negative");
  require(law.fracture_factor >= 0 && law.largest_fractured >= 0, material,
          "D1 and SFMAX must not be negative");
  require(law.rate_coefficient >= 0 && law.reference_rate > 0, material,
          "the rate coefficient C must not be negative, the reference rate EPS0 be above zero");
  require(law.bulking >= 0 && law.bulking <= 1, material, "BETA must be between 0 and 1");
}

}  // namespace

void HolmquistCeramicLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                          Index /*tensor*/) {
  declare_brittle_history(block, "bulking_pressure", can_fail(law));
}

bool HolmquistCeramicLaw::can_fail(const model::ConstitutiveLaw& law) {
  return erodes(std::get<Model>(law).erosion);
}

std::vector<double> HolmquistCeramicLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  check_ceramic(material, law);
  constexpr double never = 1e15;
  std::vector<double> numbers(CeramicPlace::Count);
  numbers[CeramicPlace::Shear] = law.shear_modulus;
  numbers[CeramicPlace::Tension] = law.tension;
  numbers[CeramicPlace::RateCoefficient] = law.rate_coefficient;
  numbers[CeramicPlace::ReferenceRate] = law.reference_rate;
  numbers[CeramicPlace::PerDensity] = 1 / material.density;
  numbers[CeramicPlace::FailsInTension] = law.erosion.at_tension ? 1 : 0;
  numbers[CeramicPlace::FailsByDamage] = law.erosion.by_damage ? 1 : 0;
  numbers[CeramicPlace::FailureStrain] = law.erosion.plastic_strain;
  numbers[CeramicPlace::IntactFactor] = law.intact_factor;
  numbers[CeramicPlace::IntactPower] = law.intact_power;
  numbers[CeramicPlace::FracturedFactor] = law.fractured_factor;
  numbers[CeramicPlace::FracturedPower] = law.fractured_power;
  numbers[CeramicPlace::LargestFractured] = law.largest_fractured > 0 ? law.largest_fractured : never;
  numbers[CeramicPlace::LimitStress] = 1.5 * (law.elastic_limit - law.limit_pressure);
  numbers[CeramicPlace::PerPressure] = 1 / law.limit_pressure;
  numbers[CeramicPlace::Bulking] = law.bulking * law.bulk_modulus / (3 * law.shear_modulus);
  numbers[CeramicPlace::FractureFactor] = law.fracture_factor;
  numbers[CeramicPlace::FracturePower] = law.fracture_power;
  numbers[CeramicPlace::Bulk] = law.bulk_modulus;
  numbers[CeramicPlace::BulkQuadratic] = law.bulk_quadratic;
  numbers[CeramicPlace::BulkCubic] = law.bulk_cubic;
  return numbers;
}

}  // namespace crumple::materials
