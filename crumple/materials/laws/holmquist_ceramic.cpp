// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/holmquist_ceramic.hpp"

#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {
namespace {

using CeramicPlace = HolmquistCeramicLaw::SolidUpdate<double>;

void check_ceramic(const model::Material& material, const model::HolmquistCeramic& law) {
  check_brittle(material, law);
  require(law.limit_pressure > 0 && law.elastic_limit > law.limit_pressure, material,
          "the pressure PHEL at the Hugoniot elastic limit must be above zero, HEL above PHEL");
  require(law.intact_factor > 0 && law.fractured_factor >= 0, material,
          "A must be above zero, B must not be negative");
  require(law.intact_power >= 0 && law.fractured_power >= 0 && law.largest_fractured >= 0, material,
          "N, M and SFMAX must not be negative");
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
  std::vector<double> numbers = brittle_constants(material.density, law, CeramicPlace::Count);
  numbers[CeramicPlace::IntactFactor] = law.intact_factor;
  numbers[CeramicPlace::IntactPower] = law.intact_power;
  numbers[CeramicPlace::FracturedFactor] = law.fractured_factor;
  numbers[CeramicPlace::FracturedPower] = law.fractured_power;
  numbers[CeramicPlace::LargestFractured] = law.largest_fractured > 0 ? law.largest_fractured : without_limit;
  numbers[CeramicPlace::LimitStress] = 1.5 * (law.elastic_limit - law.limit_pressure);
  numbers[CeramicPlace::PerPressure] = 1 / law.limit_pressure;
  numbers[CeramicPlace::Bulking] = law.bulking * law.bulk_modulus / (3 * law.shear_modulus);
  return numbers;
}

}  // namespace crumple::materials
