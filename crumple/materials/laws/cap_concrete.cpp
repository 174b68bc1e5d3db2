// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/cap_concrete.hpp"

#include <cmath>

#include "materials/common/checks.hpp"
#include "materials/common/corner_volume.hpp"

namespace crumple::materials {
namespace {

double strength_at(const model::CapConcrete::Strength& of, double trace) {
  return of.constant - of.nonlinear * std::exp(-of.exponent * trace) + of.linear * trace;
}

/// Root of a function that rises from `low` to `high`.
template <class Function>
double root_between(double low, double high, const Function& value) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (value(middle) < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// I at which the strength ends, or far in tension if it does not.
double apex_of(const model::CapConcrete::Strength& of) {
  constexpr double far = 1e15;
  double low = -of.constant;
  while (low > -far * of.constant && strength_at(of, low) > 0) low *= 2;
  if (strength_at(of, low) > 0) return low;
  return root_between(low, 0, [&](double trace) { return strength_at(of, trace); });
}

/// -Li2(-b) = int of ln(1 + b exp(-v)) over v from 0 on, by Simpson's rule.
double negative_dilogarithm(double b) {
  constexpr int intervals = 4000;
  const double end = 40 + std::log1p(b);
  const double h = end / intervals;
  double sum = std::log1p(b) + std::log1p(b * std::exp(-end));
  for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * std::log1p(b * std::exp(-h * i));
  return sum * h / 3;
}

void check_strength(const model::Material& material, const model::CapConcrete& law) {
  require(law.compression.constant > law.compression.nonlinear && law.compression.nonlinear >= 0, material,
          "the strength's constant ALPHA must be above LAMBDA, and that not negative");
  require(law.compression.exponent >= 0 && law.compression.linear >= 0, material,
          "BETA and THETA must not be negative");
  for (const model::CapConcrete::Strength& ratio : {law.torsion, law.extension})
    require(ratio.exponent >= 0 && ratio.nonlinear >= 0 && ratio.linear >= 0, material,
            "THETA, LAMBDA and BETA of torsion and extension must not be negative");
}

void check_cap(const model::Material& material, const model::CapConcrete& law) {
  require(law.cap_ratio > 0, material, "the cap's aspect ratio R must be above zero");
  require(law.cap_start > 0, material, "the cap's initial location X0 must be above zero");
  require(law.crush_volume >= 0 && law.crush_linear >= 0 && law.crush_quadratic >= 0, material,
          "W, D1 and D2 must not be negative");
}

void check_damage(const model::Material& material, const model::CapConcrete& law) {
  require(law.ductile_shape > 0 && law.brittle_shape > 0, material, "B and D must be above zero");
  require(law.compression_energy > 0 && law.tension_energy > 0 && law.shear_energy > 0, material,
          "the fracture energies must be above zero");
  require(law.compression_power >= 0 && law.tension_power >= 0 && law.pressure_power >= 0, material,
          "PWRC, PWRT and PMOD must not be negative");
  require(law.first_damage >= 0 && law.first_damage < 1, material,
          "the damage from the start must be at least 0 and below 1");
  require(law.kept_damage >= 0 && law.kept_damage <= 1, material,
          "the brittle damage that stays under pressure must be between 0 and 1");
  if (!law.has_rate_effects) return;
  for (const model::CapConcrete::Fluidity& of : {law.compression_rate, law.tension_rate})
    require(of.coefficient >= 0 && of.exponent >= 0 && of.exponent < 1 && of.limit >= 0, material,
            "fluidities and their limits must not be negative, their exponents be below 1");
  require(law.shear_fluidity >= 0 && law.energy_power >= 0, material, "SRATE and REPOW must not be negative");
}

void set_surface(const model::CapConcrete& law, std::vector<double>& numbers) {
  const auto put = [&](int place, const model::CapConcrete::Strength& of) {
    numbers[place] = of.constant;
    numbers[place + 1] = of.linear;
    numbers[place + 2] = of.nonlinear;
    numbers[place + 3] = of.exponent;
  };
  put(CapCompression, law.compression);
  put(CapTorsion, law.torsion);
  put(CapExtension, law.extension);
  numbers[CapRatio] = law.cap_ratio;
  numbers[CapStart] = law.cap_start;
  numbers[CapApex] = apex_of(law.compression);
  const auto end_of = [&](double cap) {
    return cap + law.cap_ratio * strength_at(law.compression, cap) - law.cap_start;
  };
  numbers[CapFirst] = root_between(numbers[CapApex], law.cap_start, end_of);
  numbers[CapVolume] = law.crush_volume;
  numbers[CapLinear] = law.crush_linear;
  numbers[CapQuadratic] = law.crush_quadratic;
  numbers[CapTripleBulk] = 3 * law.bulk_modulus;
  numbers[CapStiffness] = 9 * law.bulk_modulus / law.shear_modulus;
}

void set_damage(const model::CapConcrete& law, std::vector<double>& numbers) {
  const double b = law.ductile_shape;
  const double d = law.brittle_shape;
  numbers[ConcreteErodes] = law.erodes ? 1 : 0;
  numbers[ConcreteErosion] = law.erosion_strain > 0 ? law.erosion_strain : -1e30;
  numbers[ConcreteRootModulus] = std::sqrt(law.youngs_modulus);
  numbers[ConcreteBrittleShape] = d;
  numbers[ConcreteBrittleLength] = (1 + d) * std::log1p(d) / d;
  numbers[ConcreteDuctileShape] = b;
  numbers[ConcreteDuctileLength] = (1 + b) * std::log1p(b) / b;
  numbers[ConcreteDuctileDilog] = (1 + b) / b * negative_dilogarithm(b);
  numbers[ConcreteTension] = law.tension_energy;
  numbers[ConcreteCompression] = law.compression_energy;
  numbers[ConcreteShear] = law.shear_energy;
  numbers[ConcreteTensionPower] = law.tension_power;
  numbers[ConcreteCompressionPower] = law.compression_power;
  numbers[ConcretePressurePower] = law.pressure_power;
  numbers[ConcreteFirst] = law.first_damage;
  numbers[ConcreteKept] = law.kept_damage;
  numbers[ConcreteByVolume] = law.recovers_by_volume ? 1 : 0;
  numbers[ConcreteRates] = law.has_rate_effects ? 1 : 0;
  const auto put = [&](int place, const model::CapConcrete::Fluidity& of) {
    numbers[place] = of.coefficient;
    numbers[place + 1] = of.exponent;
    numbers[place + 2] = of.limit;
  };
  put(ConcreteTensionFluidity, law.tension_rate);
  put(ConcreteCompressionFluidity, law.compression_rate);
  numbers[ConcreteShearFluidity] = law.shear_fluidity;
  numbers[ConcreteEnergyPower] = law.energy_power;
}

}  // namespace

void CapConcreteLaw::declare_history(const model::ConstitutiveLaw& law, domain::ElementBlock& block,
                                     Index /*tensor*/) {
  domain::add_item(block, "concrete_strain", "-", 6 * block.points);
  domain::add_item(block, "cap_growth", "stress", block.points);
  domain::add_item(block, "lost_stress", "-", block.points);
  domain::add_item(block, "brittle_threshold", "stress^1/2", block.points);
  domain::add_item(block, "brittle_damage", "-", block.points);
  domain::add_item(block, "ductile_threshold", "stress^1/2", block.points);
  domain::add_item(block, "ductile_damage", "-", block.points);
  domain::add_item(block, "element_length", "length", block.points);
  domain::add_item(block, "failed", "-", block.points);
  if (std::get<Model>(law).has_rate_effects)
    domain::add_item(block, "overstress", "stress", 6 * block.points);
}

void CapConcreteLaw::prepare_solid_element(const model::ConstitutiveLaw& /*law*/, const SolidCorners& corners,
                                           UserId /*solid*/, domain::ElementBlock& block, Index history,
                                           Index place) {
  const double length = std::cbrt(corner_volume(corners));
  for (int p = 0; p < block.points; ++p) block.set_state(place, history + Length * block.points + p, length);
}

std::vector<double> CapConcreteLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  check_strength(material, law);
  check_cap(material, law);
  check_damage(material, law);
  std::vector<double> numbers(ConcreteCount);
  set_surface(law, numbers);
  set_damage(law, numbers);
  numbers[ConcreteYoungs] = law.youngs_modulus;
  numbers[ConcretePoisson] = law.poissons_ratio;
  numbers[ConcreteWaveSquare] = (law.bulk_modulus + 4.0 / 3 * law.shear_modulus) / material.density;
  return numbers;
}

}  // namespace crumple::materials
