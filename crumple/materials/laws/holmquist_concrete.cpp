// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/holmquist_concrete.hpp"

#include <algorithm>
#include <variant>

#include "materials/common/checks.hpp"

namespace crumple::materials {
namespace {

using PorousPlace = HolmquistConcreteLaw::SolidUpdate<double>;

double compacted_pressure(const model::HolmquistConcrete& law, double bar) {
  return bar * (law.bulk_modulus + bar * (law.bulk_quadratic + bar * law.bulk_cubic));
}

/// mu at which the curve of the compacted concrete reaches PL for the first time; -1 if it never does.
double full_volume(const model::HolmquistConcrete& law) {
  constexpr int pieces = 4000;
  const double linear = law.lock_pressure / law.bulk_modulus;
  double high = 0;
  for (int i = 1; i <= pieces && high == 0; ++i)
    if (compacted_pressure(law, 4 * linear * i / pieces) >= law.lock_pressure) high = 4 * linear * i / pieces;
  if (high == 0) return -1;
  double low = high - 4 * linear / pieces;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (compacted_pressure(law, middle) < law.lock_pressure ? low : high) = middle;
  }
  return law.lock_volume + (1 + law.lock_volume) * high;
}

void check_strength(const model::Material& material, const model::HolmquistConcrete& law) {
  require(law.strength > 0, material, "the compressive strength FC must be above zero");
  require(law.cohesion >= 0 && law.pressure_factor >= 0 && law.pressure_power >= 0, material,
          "A, B and N must not be negative");
  require(law.least_fracture >= 0 && law.largest_strength >= 0, material,
          "EFMIN and SFMAX must not be negative");
  require(law.fracture_factor > 0 || law.least_fracture > 0, material,
          "one of D1 and EFMIN must be above zero, or the strain to fracture is none");
}

void check_pressure(const model::Material& material, const model::HolmquistConcrete& law) {
  require(law.crush_pressure > 0 && law.crush_volume > 0, material, "PC and UC must be above zero");
  require(law.lock_pressure > law.crush_pressure && law.lock_volume > law.crush_volume, material,
          "PL must be above PC, UL above UC");
  const double full = full_volume(law);
  require(full > 0, material, "the pressure by K1, K2 and K3 does not reach PL");
  const double slope = (law.lock_pressure - law.crush_pressure) / (full - law.crush_volume);
  require(slope <= std::min(law.crush_pressure / law.crush_volume, law.bulk_modulus), material,
          "the line from PC to PL must not be steeper than PC/UC and K1, with which it unloads");
}

}  // namespace

void HolmquistConcreteLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                           Index /*tensor*/) {
  declare_brittle_history(block, "largest_compression", can_fail(law));
}

bool HolmquistConcreteLaw::can_fail(const model::ConstitutiveLaw& law) {
  return erodes(std::get<Model>(law).erosion);
}

std::vector<double> HolmquistConcreteLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  check_brittle(material, law);
  check_strength(material, law);
  check_pressure(material, law);
  const double full = full_volume(law);
  std::vector<double> numbers = brittle_constants(material.density, law, PorousPlace::Count);
  numbers[PorousPlace::Cohesion] = law.cohesion;
  numbers[PorousPlace::PressureFactor] = law.pressure_factor;
  numbers[PorousPlace::PressurePower] = law.pressure_power;
  numbers[PorousPlace::UniaxialStrength] = law.strength;
  numbers[PorousPlace::PerStrength] = 1 / law.strength;
  numbers[PorousPlace::PerTension] = 1 / law.tension;
  numbers[PorousPlace::LargestStrength] = law.largest_strength > 0 ? law.largest_strength : without_limit;
  numbers[PorousPlace::CrushPressure] = law.crush_pressure;
  numbers[PorousPlace::CrushVolume] = law.crush_volume;
  numbers[PorousPlace::CrushSlope] = (law.lock_pressure - law.crush_pressure) / (full - law.crush_volume);
  numbers[PorousPlace::FullVolume] = full;
  numbers[PorousPlace::PerCrushing] = 1 / (full - law.crush_volume);
  numbers[PorousPlace::ElasticBulk] = law.crush_pressure / law.crush_volume;
  numbers[PorousPlace::LockVolume] = law.lock_volume;
  numbers[PorousPlace::LeastFracture] = law.least_fracture;
  return numbers;
}

}  // namespace crumple::materials
