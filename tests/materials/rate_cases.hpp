// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "materials/sample_materials.hpp"

namespace crumple::materials::testing {

inline constexpr double root3 = 1.7320508075688772;

/// Yield stress over plastic strain and effective strain rate, formulated independently for each law.
using YieldStress = std::function<double(double plastic, double rate)>;

inline double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at <= x.front()) return y.front();
  for (std::size_t k = 0; k + 1 < x.size(); ++k)
    if (at <= x[k + 1]) return y[k] + (y[k + 1] - y[k]) / (x[k + 1] - x[k]) * (at - x[k]);
  return y.back();
}

struct Case {
  const char* name;
  model::Material material;
  YieldStress yield;
};

inline const std::vector<double> table_strain{0, 0.02, 0.1, 1.0};
inline const std::vector<double> rates{0.1, 10, 100, 2000};
inline const std::vector<std::vector<double>> table_stress{
    {250, 300, 350, 500}, {280, 340, 380, 520}, {300, 380, 400, 520}, {350, 420, 480, 700}};

inline model::Material by_rate(bool logarithmic) {
  model::Material material = tabulated({0}, {1});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  law.logarithmic_rates = logarithmic;
  law.by_rate.reserve(rates.size());
  for (std::size_t k = 0; k < rates.size(); ++k)
    law.by_rate.push_back({logarithmic ? std::log(rates[k]) : rates[k], table_strain, table_stress[k]});
  return material;
}
inline double yield_by_rate(double plastic, double rate, bool logarithmic) {
  std::vector<double> x = rates;
  if (logarithmic)
    for (double& r : x) r = std::log(r);
  std::vector<double> y;
  y.reserve(table_stress.size());
  for (const auto& stress : table_stress) y.push_back(interpolated(table_strain, stress, plastic));
  return interpolated(x, y, logarithmic ? std::log(std::max(rate, 1e-20)) : rate);
}

inline void set_viscoplastic(model::Material& material, bool value) {
  std::visit(
      [&](auto& law) {
        if constexpr (requires { law.viscoplastic; }) law.viscoplastic = value;
      },
      material.law);
}

inline std::vector<Case> cases(bool viscoplastic) {
  constexpr double c = 40.4;
  constexpr double p = 5;
  const double h = plastic_modulus(2100);
  const auto cowper = [](double rate) { return 1 + std::pow(rate / c, 1 / p); };
  std::vector<Case> all;
  all.push_back({"isotropic", plastic_kinematic(2100, 1, c, p),
                 [=](double plastic, double rate) { return (initial_yield + h * plastic) * cowper(rate); }});
  all.push_back({"power", power_law(c, p), [=](double plastic, double rate) {
                   const double first = std::pow(youngs_modulus / 500, 1 / (0.22 - 1));
                   return 500 * std::pow(first + plastic, 0.22) * cowper(rate);
                 }});
  model::Material table = tabulated({0, 0.02, 0.5}, {250, 300, 400});
  auto& law = std::get<model::PiecewiseLinearPlasticity>(table.law);
  law.cowper_symonds_rate = c;
  law.cowper_symonds_exponent = p;
  const auto rest = [](double plastic) { return interpolated({0, 0.02, 0.5}, {250, 300, 400}, plastic); };
  all.push_back({"table", table, [=](double plastic, double rate) { return rest(plastic) * cowper(rate); }});
  if (viscoplastic) {
    law.viscoplastic_base = 230;
    all.push_back({"table with base", table,
                   [=](double plastic, double rate) { return rest(plastic) + 230 * (cowper(rate) - 1); }});
  }
  model::Material curve = tabulated({0, 0.02, 0.5}, {250, 300, 400});
  auto& curved = std::get<model::PiecewiseLinearPlasticity>(curve.law);
  curved.factor_rate = {0, 1, 50, 1000};
  curved.rate_factor = {1.1, 1.2, 1.4, 2};
  all.push_back({"curve of factors", curve, [=](double plastic, double rate) {
                   return rest(plastic) * interpolated({0, 1, 50, 1000}, {1.1, 1.2, 1.4, 2}, rate);
                 }});
  all.push_back({"Johnson-Cook", johnson_cook(johnson_cook_law()), [](double plastic, double rate) {
                   return (792 + 510 * std::pow(plastic, 0.26)) * (1 + 0.014 * std::log(std::max(rate, 1.0)));
                 }});
  model::JohnsonCook steepening = johnson_cook_law();
  steepening.exponent = 1.5;
  all.push_back({"Johnson-Cook with n = 1.5", johnson_cook(steepening), [](double plastic, double rate) {
                   return (792 + 510 * std::pow(plastic, 1.5)) * (1 + 0.014 * std::log(std::max(rate, 1.0)));
                 }});
  for (const bool logarithmic : {false, true})
    all.push_back({logarithmic ? "curves by log rate" : "curves by rate", by_rate(logarithmic),
                   [=](double plastic, double rate) { return yield_by_rate(plastic, rate, logarithmic); }});
  for (Case& one : all) set_viscoplastic(one.material, viscoplastic);
  return all;
}

}  // namespace crumple::materials::testing
