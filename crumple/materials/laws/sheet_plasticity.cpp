// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/sheet_plasticity.hpp"

#include <algorithm>
#include <cmath>

#include "materials/common/checks.hpp"
#include "materials/laws/orthotropic_elastic.hpp"
#include "materials/plasticity/hardening_table.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {
namespace {

/// The factor p on the shear that makes R45 what is wanted: R45 + 1 is the strain along a strip at 45 degrees
/// over that across the sheet, and grows with p.
double shear_scale(double a, double c, double h, double m, double r45) {
  const auto found = [&](double p) {
    const BarlatYield<double> yield(a, c, h, p, m);
    const auto value = yield.at({0.5, 0.5, 0.5});
    return value.size / (value.normal.x + value.normal.y) - 1;
  };
  double low = 1e-3;
  double high = 1e3;
  for (int i = 0; i < 200; ++i) {
    const double middle = std::sqrt(low * high);
    (found(middle) < r45 ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

void check_sheet_hardening(const model::Material& material, const model::SheetPlasticity& law) {
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_cowper_symonds(material, law.cowper_symonds_rate, law.cowper_symonds_exponent);
  const auto& strain = law.plastic_strain;
  const auto& stress = law.yield_stress;
  require(strain.size() == stress.size(), material,
          "the hardening table needs as many yield stresses as plastic strains");
  if (strain.empty()) {
    require(law.strength > 0 && law.yield_strain > 0, material,
            "the strength coefficient and the strain at yield must be above zero");
    require(law.hardening_exponent >= 0 && law.hardening_exponent <= 1, material,
            "the exponent of hardening must be from 0 to 1");
    return;
  }
  require_hardening_table(material, law.youngs_modulus, strain, stress);
}

}  // namespace

std::vector<double> SheetLaw::constants_of(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  check_sheet_hardening(material, law);
  std::vector<double> numbers(Count);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poissons] = law.poissons_ratio;
  numbers[Rate] = law.cowper_symonds_rate;
  numbers[Exponent] = law.cowper_symonds_exponent;
  numbers[Strength] = law.strength;
  numbers[Power] = law.hardening_exponent;
  numbers[YieldStrain] = law.yield_strain;
  const std::size_t points = law.plastic_strain.size();
  numbers[Points] = static_cast<double>(points);
  numbers[Least] = points > 0 ? *std::min_element(law.yield_stress.begin(), law.yield_stress.end())
                              : law.strength * std::pow(law.yield_strain, law.hardening_exponent);
  append_table(law.plastic_strain, law.yield_stress, false, numbers);
  return numbers;
}

void NormalAnisotropyLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                          Index /*tensor*/) {
  declare_plastic_strain(block);
}

std::vector<double> NormalAnisotropyLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.r00 > 0, material, "R must be above zero");
  std::vector<double> numbers = constants_of(material);
  // xx^2 + yy^2 - 2 R / (R + 1) xx yy + 2 (2 R + 1) / (R + 1) xy^2.
  numbers[First] = 2 / (law.r00 + 1);
  numbers[Second] = 2 * (2 * law.r00 + 1) / (law.r00 + 1);
  return numbers;
}

void BarlatLaw::declare_history(const model::ConstitutiveLaw& /*law*/, domain::ElementBlock& block,
                                Index /*tensor*/) {
  declare_plastic_strain(block);
  domain::add_item(block, "material_axis", "-", 2);
}

std::vector<double> BarlatLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require(law.r00 > 0 && law.r45 > 0 && law.r90 > 0, material, "R00, R45 and R90 must be above zero");
  require(law.yield_exponent >= 2 && law.yield_exponent <= 20, material,
          "the exponent M must be from 2 to 20");
  std::vector<double> numbers = constants_of(material);
  const double along = law.r00 / (1 + law.r00);
  const double across = law.r90 / (1 + law.r90);
  const double c = 2 * std::sqrt(along * across);
  const double h = std::sqrt(along / across);
  numbers[First] = 2 - c;
  numbers[Second] = c;
  numbers[AcrossScale] = h;
  numbers[ShearScale] = shear_scale(2 - c, c, h, law.yield_exponent, law.r45);
  numbers[YieldExponent] = law.yield_exponent;
  return numbers;
}

void BarlatLaw::prepare_element(const model::ConstitutiveLaw& law, const LaminaAxes& axes,
                                domain::ElementBlock& block, Index history, Index place) {
  OrthotropicElasticLaw::set_axes(std::get<Model>(law).axes, axes, block, history + 2 * block.points, place);
}

}  // namespace crumple::materials
