// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/compression_tension.hpp"

#include <algorithm>

#include "materials/common/checks.hpp"
#include "materials/plasticity/hardening_table.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {
namespace {

/// Where the share of tension jumps, over which part of the yield stress it goes from 0 to 1.
constexpr double jump = 1e-3;

double least_of(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

}  // namespace

void CompressionTensionLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                            domain::ElementBlock& block, Index /*tensor*/) {
  declare_plastic_strain(block);
}

std::vector<double> CompressionTensionLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_cowper_symonds(material, law.cowper_symonds_rate, law.cowper_symonds_exponent);
  require_failure_strain(material, law.failure_strain);
  require_hardening_table(material, law.youngs_modulus, law.compression_strain, law.compression_stress);
  require_hardening_table(material, law.youngs_modulus, law.tension_strain, law.tension_stress);
  require(law.compression_pressure >= 0 && law.tension_pressure >= 0, material,
          "PC and PT are amounts of pressure and tension, and must not be negative");
  const double least = std::min(least_of(law.compression_stress), least_of(law.tension_stress));
  const double range = std::max(law.compression_pressure + law.tension_pressure, jump * least);
  const double middle = 0.5 * (law.tension_pressure - law.compression_pressure);
  std::vector<double> numbers(Tables);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poissons] = law.poissons_ratio;
  numbers[Start] = middle - 0.5 * range;
  numbers[PerRange] = 1 / range;
  numbers[Rate] = law.cowper_symonds_rate;
  numbers[Exponent] = law.cowper_symonds_exponent;
  numbers[Failure] = law.failure_strain;
  numbers[Least] = least;
  numbers[CompressionRows] = static_cast<double>(law.compression_strain.size());
  numbers[TensionRows] = static_cast<double>(law.tension_strain.size());
  append_table(law.compression_strain, law.compression_stress, false, numbers);
  append_table(law.tension_strain, law.tension_stress, false, numbers);
  return numbers;
}

}  // namespace crumple::materials
