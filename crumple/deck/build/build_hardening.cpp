// SPDX-License-Identifier: BSD-3-Clause
// Curves of the yield stress over the plastic strain.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Plastic strain up to which a hardening table is continued with its last slope, as LS-DYNA continues
/// curves.
constexpr double far_strain = 10;

/// Continues a hardening curve that begins behind zero strain to there; `points` is where it stands.
void extend_to_zero(std::vector<double>& strain, std::vector<double>& stress, const RawMaterial& material,
                    const Where& points, Report& report) {
  const double slope = (stress[1] - stress[0]) / (strain[1] - strain[0]);
  const double initial = stress[0] - slope * strain[0];
  if (!(initial > 0))
    report.error(
        material.where, "initial yield",
        fmt::format("continued to zero plastic strain the hardening curve gives a yield stress of {}; "
                    "start it at zero",
                    initial));
  else
    report.warning(
        points, "initial yield",
        fmt::format("the yield stress of material {} is given from plastic strain {:.4g} on; its first slope "
                    "is continued to zero, where it gives the yield stress {:.4g}; start it at zero",
                    material.material.id, strain.front(), initial));
  strain.insert(strain.begin(), 0.0);
  stress.insert(stress.begin(), initial);
}

/// Continues a hardening curve to zero strain and far beyond its end.
void extend(std::vector<double>& strain, std::vector<double>& stress, const RawMaterial& material,
            const Where& points, Report& report) {
  if (strain.size() < 2) return;
  if (strain.front() > 0) extend_to_zero(strain, stress, material, points, report);
  if (strain.back() >= far_strain) return;
  const std::size_t last = strain.size() - 1;
  const double slope = (stress[last] - stress[last - 1]) / (strain[last] - strain[last - 1]);
  if (slope < 0)
    report.warning(material.where, "softening",
                   "the hardening curve falls at its end; behind it the yield stress stays constant");
  if (!(slope > 0)) return;
  stress.push_back(stress[last] + slope * (far_strain - strain[last]));
  strain.push_back(far_strain);
}

/// A curve of the model as strains and stresses of hardening.
void take_hardening(const model::Curve& curve, const Where& where, std::vector<double>& strain,
                    std::vector<double>& stress, Report& report) {
  strain = curve.abscissa;
  stress = curve.ordinate;
  for (std::size_t i = 0; i < curve.abscissa.size(); ++i)
    if (curve.abscissa[i] < 0 || !(curve.ordinate[i] > 0)) {
      report.error(where, "hardening",
                   fmt::format("curve {} gives the yield stress {} at plastic strain {}, expected strains "
                               "not below zero and stresses above zero",
                               curve.id, curve.ordinate[i], curve.abscissa[i]));
      return;
    }
}

/// Strain rates of a table, or their natural logarithms where it is interpolated in these.
std::vector<double> rates_of(const RawMaterial& raw, const RawTable& table, Report& report) {
  std::vector<double> rates = table.value;
  if (!raw.by_log_of_rates || rates.front() < 0) return rates;
  if (rates.front() == 0)
    report.error(
        table.where, "logarithm",
        fmt::format("table {} begins with the rate 0, which has no logarithm, and is interpolated in the "
                    "logarithms of its rates by _LOG_INTERPOLATION; begin with a small rate",
                    table.id));
  for (double& rate : rates) rate = std::log(std::max(rate, 1e-30));
  return rates;
}

/// Hardening curves by strain rate.
void take_table(const RawMaterial& raw, const RawTable& table, model::PiecewiseLinearPlasticity& law,
                Build& build) {
  law.plastic_strain = {0};
  law.yield_stress = {1};
  if (table.value.empty()) {
    build.report.error(table.where, "empty", fmt::format("table {} has no values", table.id));
    return;
  }
  // A first value below zero says that all are natural logarithms of the rates.
  law.logarithmic_rates = table.value.front() < 0 || raw.by_log_of_rates;
  const std::vector<double> rates = rates_of(raw, table, build.report);
  const std::vector<Index> curves = curves_of(table, build);
  for (std::size_t i = 0; i < table.value.size(); ++i) {
    if (curves[i] == no_index) continue;
    model::HardeningAtRate at{rates[i], {}, {}};
    const model::Curve& curve = build.model.curves[static_cast<std::size_t>(curves[i])];
    take_hardening(curve, raw.where, at.plastic_strain, at.yield_stress, build.report);
    const Where& points = build.deck.curves[static_cast<std::size_t>(curves[i])].where;
    extend(at.plastic_strain, at.yield_stress, raw, points, build.report);
    law.by_rate.push_back(std::move(at));
  }
}

/// A curve of hardening, none if its number is zero. Tables by strain rate are not supported.
void take_curve(const RawMaterial& raw, const Reference& curve, std::vector<double>& strain,
                std::vector<double>& stress, Build& build) {
  if (curve.id == 0) return;
  if (build.find_quietly(Item::Table, curve.id) != no_index) {
    build.report.field_unsupported(curve.where, {curve.field, std::to_string(curve.id), "the id of a curve",
                                                 "a table by strain rate is not supported", "table"});
    return;
  }
  const Index index = find_points(build, curve);
  if (index == no_index) return;
  take_hardening(build.model.curves[static_cast<std::size_t>(index)], raw.where, strain, stress,
                 build.report);
  extend(strain, stress, raw, build.deck.curves[static_cast<std::size_t>(index)].where, build.report);
}

}  // namespace

void take_hardening(const RawMaterial& raw, model::PiecewiseLinearPlasticity& law, Build& build) {
  const Where* points = &raw.where;
  if (raw.hardening_curve != 0) {
    const Index table = build.find_quietly(Item::Table, raw.hardening_curve);
    if (table != no_index) {
      take_table(raw, build.deck.tables[static_cast<std::size_t>(table)], law, build);
      return;
    }
    const Index index = find_points(build, {raw.hardening_curve, "LCSS", raw.curve_where});
    if (index == no_index) return;
    points = &build.deck.curves[static_cast<std::size_t>(index)].where;
    take_hardening(build.model.curves[static_cast<std::size_t>(index)], raw.where, law.plastic_strain,
                   law.yield_stress, build.report);
  }
  extend(law.plastic_strain, law.yield_stress, raw, *points, build.report);
}

void take_hardening(const RawMaterial& raw, model::SheetPlasticity& law, Build& build) {
  take_curve(raw, {raw.hardening_curve, law.is_normal ? "HLCID" : "LCID", raw.curve_where},
             law.plastic_strain, law.yield_stress, build);
}

void take_hardening(const RawMaterial& raw, model::CompressionTension& law, Build& build) {
  take_curve(raw, {raw.hardening_curve, "LCIDC", raw.curve_where}, law.compression_strain,
             law.compression_stress, build);
  take_curve(raw, {raw.more_curves[0], "LCIDT", raw.curve_where}, law.tension_strain, law.tension_stress,
             build);
}

}  // namespace crumple::deck
