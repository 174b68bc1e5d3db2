// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstring>
#include <vector>

#include "model/material.hpp"

namespace crumple::materials::testing {

template <class Real>
bool same_bits(const std::vector<Real>& a, const std::vector<Real>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Real)) == 0;
}

inline constexpr double youngs_modulus = 210000;
inline constexpr double poissons_ratio = 0.3;
inline constexpr double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
inline constexpr double initial_yield = 250;

inline model::Material plastic_kinematic(double tangent, double beta, double rate = 0, double exponent = 0) {
  model::Material material;
  material.id = 1;
  material.density = 7.85e-9;
  model::PlasticKinematic law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.yield_stress = initial_yield;
  law.tangent_modulus = tangent;
  law.isotropic_fraction = beta;
  law.cowper_symonds_rate = rate;
  law.cowper_symonds_exponent = exponent;
  material.law = law;
  return material;
}

inline model::Material tabulated(const std::vector<double>& strain, const std::vector<double>& stress) {
  model::Material material;
  material.id = 2;
  material.density = 7.85e-9;
  model::PiecewiseLinearPlasticity law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.plastic_strain = strain;
  law.yield_stress = stress;
  material.law = law;
  return material;
}

/// 500 MPa (e + p)^0.22 from the intersection with the elastic line on.
inline model::Material power_law(double rate = 0, double exponent = 0) {
  model::Material material;
  material.id = 3;
  material.density = 7.85e-9;
  model::PowerLawPlasticity law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.strength = 500;
  law.exponent = 0.22;
  law.yield_strain = std::pow(youngs_modulus / 500, 1 / (0.22 - 1));
  law.cowper_symonds_rate = rate;
  law.cowper_symonds_exponent = exponent;
  material.law = law;
  return material;
}

/// Steel 4340 of Johnson & Cook (1985), without heat and fracture, in t, mm, s.
inline model::JohnsonCook johnson_cook_law() {
  model::JohnsonCook law;
  law.youngs_modulus = youngs_modulus;
  law.poissons_ratio = poissons_ratio;
  law.yield_stress = 792;
  law.hardening = 510;
  law.exponent = 0.26;
  law.rate_coefficient = 0.014;
  law.reference_rate = 1;
  return law;
}
inline model::Material johnson_cook(const model::JohnsonCook& law) {
  model::Material material;
  material.id = 4;
  material.density = 7.83e-9;
  material.law = law;
  return material;
}

/// Slope of the yield stress over the plastic strain that belongs to a tangent modulus.
inline double plastic_modulus(double tangent) {
  return youngs_modulus * tangent / (youngs_modulus - tangent);
}

inline model::JohnsonCook slow_johnson_cook() {
  model::JohnsonCook law = johnson_cook_law();
  law.rate_coefficient = 0;
  return law;
}

inline std::vector<model::Material> all_materials() {
  return {plastic_kinematic(2100, 0),
          plastic_kinematic(2100, 0.3),
          plastic_kinematic(2100, 1),
          plastic_kinematic(0, 0),
          tabulated({0, 0.002, 0.01, 0.011, 0.05, 0.2}, {250, 300, 310, 380, 381, 420}),
          tabulated({0, 0.1, 0.3}, {250, 240, 245}),
          tabulated({0}, {250}),
          power_law(),
          johnson_cook(slow_johnson_cook())};
}

inline model::Material hot_johnson_cook(bool viscoplastic) {
  model::JohnsonCook law = johnson_cook_law();
  law.thermal_exponent = 1.03;
  law.melting_rise = 1500;
  law.heat_capacity = 477e6;
  law.damage = {0.05, 3.44, -2.12, 0.002, 0.61};
  law.least_fracture_strain = 1e-6;
  law.viscoplastic = viscoplastic;
  return johnson_cook(law);
}

inline model::Material tabulated_by_rate(bool viscoplastic, bool logarithmic) {
  model::Material material = tabulated({0}, {1});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.viscoplastic = viscoplastic;
  law.logarithmic_rates = logarithmic;
  for (const double rate : {0.1, 10.0, 1000.0})
    law.by_rate.push_back({logarithmic ? std::log(rate) : rate,
                           {0, 0.01 * rate / (1 + rate) + 0.01, 0.3},
                           {250 + 10 * std::log(rate), 330 + 12 * std::log(rate), 450 + rate / 20}});
  return material;
}

/// Yield stress at a plastic strain, formulated independently.
inline double yield_stress(const model::Material& material, double plastic) {
  if (const auto* law = std::get_if<model::PlasticKinematic>(&material.law))
    return law->yield_stress + law->isotropic_fraction * plastic_modulus(law->tangent_modulus) * plastic;
  if (const auto* law = std::get_if<model::PowerLawPlasticity>(&material.law))
    return law->strength * std::pow(law->yield_strain + plastic, law->exponent);
  if (const auto* law = std::get_if<model::JohnsonCook>(&material.law))
    return law->yield_stress + law->hardening * std::pow(plastic, law->exponent);
  const auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  std::size_t k = 0;
  while (k + 1 < law.plastic_strain.size() && plastic >= law.plastic_strain[k + 1]) ++k;
  if (k + 1 == law.plastic_strain.size()) return law.yield_stress[k];
  const double share =
      (plastic - law.plastic_strain[k]) / (law.plastic_strain[k + 1] - law.plastic_strain[k]);
  return law.yield_stress[k] + share * (law.yield_stress[k + 1] - law.yield_stress[k]);
}

/// Those, and with rate effects, heat and damage.
inline std::vector<model::Material> all_materials_with_rates() {
  auto materials = all_materials();
  materials.push_back(plastic_kinematic(2100, 0.3, 40.4, 5));
  for (const bool viscoplastic : {false, true}) {
    materials.push_back(plastic_kinematic(2100, 0.3, 40.4, 5));
    std::get<model::PlasticKinematic>(materials.back().law).viscoplastic = viscoplastic;
    materials.push_back(power_law(40.4, 5));
    std::get<model::PowerLawPlasticity>(materials.back().law).viscoplastic = viscoplastic;
    materials.push_back(hot_johnson_cook(viscoplastic));
    materials.push_back(tabulated_by_rate(viscoplastic, false));
    materials.push_back(tabulated_by_rate(viscoplastic, true));
  }
  return materials;
}

}  // namespace crumple::materials::testing
