// SPDX-License-Identifier: BSD-3-Clause
#include "materials/laws/piecewise_linear_plasticity.hpp"

#include <algorithm>

#include "materials/common/checks.hpp"
#include "materials/plasticity/hardening_table.hpp"
#include "materials/plasticity/plastic_state.hpp"

namespace crumple::materials {
namespace {

void check_rates(const model::Material& material, const model::PiecewiseLinearPlasticity& law) {
  require_cowper_symonds(material, law.cowper_symonds_rate, law.cowper_symonds_exponent);
  require(law.factor_rate.size() == law.rate_factor.size() && ascending(law.factor_rate), material,
          "the curve of rate factors needs as many factors as strain rates, in ascending order");
  for (const double factor : law.rate_factor)
    require(factor > 0, material, "every factor of the curve over strain rate must be above zero");
  for (std::size_t k = 0; k + 1 < law.by_rate.size(); ++k)
    require(law.by_rate[k + 1].rate > law.by_rate[k].rate, material,
            "the strain rates of the hardening curves must ascend");
}

}  // namespace

void PiecewiseLinearPlasticityLaw::declare_history(const model::ConstitutiveLaw& /*law*/,
                                                   domain::ElementBlock& block, Index /*tensor*/) {
  declare_plastic_strain(block);
}

void PiecewiseLinearPlasticityLaw::require_failed_points(const model::Material& material, const Model& law) {
  require(
      law.failed_points >= 0 && law.failed_share >= 0 && law.failed_share <= 1, material,
      "the number of failed points that make an element fail must not be negative, their share not above 1");
}

std::vector<double> PiecewiseLinearPlasticityLaw::constants(const model::Material& material) {
  const auto& law = std::get<Model>(material.law);
  require_elastic(material, law.youngs_modulus, law.poissons_ratio);
  require_failure_strain(material, law.failure_strain);
  check_rates(material, law);
  std::vector<model::HardeningAtRate> curves = law.by_rate;
  if (curves.empty()) curves.push_back({0, law.plastic_strain, law.yield_stress});
  const bool has_factors = law.by_rate.empty() && !law.factor_rate.empty();
  double least = 1e300;
  for (const model::HardeningAtRate& curve : curves) {
    require_hardening_table(material, law.youngs_modulus, curve.plastic_strain, curve.yield_stress);
    least = std::min(least, *std::min_element(curve.yield_stress.begin(), curve.yield_stress.end()));
  }

  std::vector<double> numbers(Rows);
  numbers[Youngs] = law.youngs_modulus;
  numbers[Poissons] = law.poissons_ratio;
  // Curves by rate go before a curve of factors, and that before the power, as in LS-DYNA.
  const bool has_power = law.by_rate.empty() && law.factor_rate.empty();
  numbers[Rate] = has_power ? law.cowper_symonds_rate : 0;
  numbers[Exponent] = law.cowper_symonds_exponent;
  numbers[Failure] = law.failure_strain;
  // The return brackets its root by the least yield stress there can be: factors may fall with the rate.
  const auto factors = std::minmax_element(law.rate_factor.begin(), law.rate_factor.end());
  numbers[Least] = has_factors ? least * *factors.first / *factors.second : least;
  // VP = 0 multiplies the whole yield stress.
  numbers[Base] = law.viscoplastic ? law.viscoplastic_base : 0;
  numbers[Logarithmic] = law.logarithmic_rates ? 1 : 0;
  numbers[Factors] = has_factors ? static_cast<double>(law.factor_rate.size()) : 0;
  numbers[Curves] = static_cast<double>(curves.size());
  if (has_factors) append_table(law.factor_rate, law.rate_factor, false, numbers);
  for (const model::HardeningAtRate& curve : curves) {
    numbers.insert(numbers.end(), {curve.rate, static_cast<double>(curve.plastic_strain.size())});
    append_table(curve.plastic_strain, curve.yield_stress, false, numbers);
  }
  return numbers;
}

}  // namespace crumple::materials
