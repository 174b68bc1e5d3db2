// SPDX-License-Identifier: BSD-3-Clause
// Curves of honeycomb, soil and foams.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <variant>

#include "deck/build/build.hpp"
#include "model/elastic_moduli.hpp"

namespace crumple::deck {

namespace {

const model::Curve* curve_of(Build& build, UserId id, std::string_view field, const Where& where) {
  if (id == 0) return nullptr;
  const Index index = find_points(build, {id, field, where});
  return index == no_index ? nullptr : &build.model.curves[static_cast<std::size_t>(index)];
}

/// A curve over the relative volume, or over 1 - V: that begins at or below zero.
model::Honeycomb::Crush crush_of(const model::Curve& curve) {
  model::Honeycomb::Crush found{curve.abscissa, curve.ordinate};
  if (!(curve.abscissa.front() > 0)) return found;
  for (double& volume : found.crush) volume = 1 - volume;
  std::reverse(found.crush.begin(), found.crush.end());
  std::reverse(found.stress.begin(), found.stress.end());
  return found;
}

/// Factors over a strain rate.
void take_factors(const RawDirectionCurve& raw, model::Honeycomb::RateFactor& rates, Build& build) {
  const model::Curve* const curve = curve_of(build, raw.id, raw.field, raw.where);
  if (curve == nullptr) return;
  rates = {curve->abscissa, curve->ordinate};
  for (const double factor : curve->ordinate)
    if (!(factor > 0)) {
      build.report.error(
          raw.where, "rate",
          fmt::format("curve {} gives the factor {}, expected factors above zero", curve->id, factor));
      return;
    }
}

void take_crushes(const RawMaterial& raw, model::Honeycomb& law, Build& build) {
  static constexpr std::string_view names[] = {"LCA", "LCB", "LCC", "LCAB", "LCBC", "LCCA"};
  for (std::size_t k = 0; k < law.crush.size(); ++k) {
    // What is missing has been reported with the first that stands for it.
    const bool again = std::find(raw.more_curves.begin(), raw.more_curves.begin() + static_cast<int>(k),
                                 raw.more_curves[k]) != raw.more_curves.begin() + static_cast<int>(k);
    if (again && build.find_quietly(Item::Curve, raw.more_curves[k]) == no_index) continue;
    const model::Curve* const curve = curve_of(build, raw.more_curves[k], names[k], raw.curve_where);
    if (curve == nullptr) continue;
    const bool by_volume = law.over == model::Honeycomb::Abscissa::Volume;
    law.crush[k] = by_volume ? crush_of(*curve) : model::Honeycomb::Crush{curve->abscissa, curve->ordinate};
    const bool below =
        std::any_of(curve->ordinate.begin(), curve->ordinate.end(), [](double stress) { return stress < 0; });
    if (below && !again)
      build.report.error(
          raw.curve_where, "crush",
          fmt::format("curve {} must give yield stresses that are not below zero, over {}", curve->id,
                      by_volume ? "the relative volume, or over 1 - V from zero on"
                                : "the strain of its component, compression above zero"));
  }
  take_factors({raw.more_curves[6], "LCSR", raw.curve_where}, law.rates, build);
  for (std::size_t k = 0; k < law.own_rates.size(); ++k)
    take_factors(raw.rate_factors[k], law.own_rates[k], build);
}

/// LCID of soil: signs of the strains make no difference, as in LS-DYNA.
void take_pressures(const RawMaterial& raw, model::SoilAndFoam& law, Build& build) {
  const model::Curve* const curve = curve_of(build, raw.hardening_curve, "LCID", raw.curve_where);
  if (curve != nullptr) {
    law.compression = curve->abscissa;
    law.pressure = curve->ordinate;
    for (double& strain : law.compression) strain = std::fabs(strain);
    if (law.compression.front() > law.compression.back()) {
      std::reverse(law.compression.begin(), law.compression.end());
      std::reverse(law.pressure.begin(), law.pressure.end());
    }
    if (law.compression.front() > 0) {
      law.compression.insert(law.compression.begin(), 0.0);
      law.pressure.insert(law.pressure.begin(), 0.0);
    }
  }
  if (law.compression.size() < 2) return;
  double steepest = 0;
  bool falls = law.pressure.front() != 0;
  for (std::size_t k = 0; k + 1 < law.compression.size(); ++k) {
    const double rise = law.pressure[k + 1] - law.pressure[k];
    const double width = law.compression[k + 1] - law.compression[k];
    falls = falls || rise < 0 || !(width > 0);
    if (width > 0) steepest = std::max(steepest, rise / width);
  }
  if (falls)
    build.report.error(raw.where, "pressure",
                       "the pressure over -ln V must start at zero, and must not fall in compression");
  else if (law.crushes && steepest > 1.0001 * law.unloading_modulus)
    build.report.warning(
        raw.where, "unloading",
        fmt::format("KUN is {:.4g}, and the pressure rises by up to {:.4g}: where it does, unloading gives "
                    "more energy than loading took; take KUN not below that",
                    law.unloading_modulus, steepest));
  const double first =
      (law.pressure[1] - law.pressure[0]) / std::max(law.compression[1] - law.compression[0], 1e-30);
  const double bulk = law.crushes ? std::max(first, law.unloading_modulus) : first;
  model::set_moduli(law, bulk, law.shear_modulus);
}

/// LCRATE: constant before its first point.
void take_rate_factor(const RawMaterial& raw, model::BilkhuDuboisFoam& law, Build& build) {
  const model::Curve* const curve = curve_of(build, raw.rate_curve, "LCRATE", raw.curve_where);
  if (curve == nullptr) return;
  law.rate_factor = {curve->abscissa, curve->ordinate};
  const bool sound =
      curve->abscissa.front() >= 0 &&
      std::all_of(curve->ordinate.begin(), curve->ordinate.end(), [](double y) { return y > 0; });
  if (!sound)
    build.report.field_error(raw.curve_where, {"LCRATE", std::to_string(curve->id),
                                               "a curve of factors above zero over rates not below zero",
                                               "it is over the rate of -ln V, of either sign", "rate"});
  else if (curve->abscissa.front() > 0) {
    law.rate_factor.abscissa.insert(law.rate_factor.abscissa.begin(), 0.0);
    law.rate_factor.ordinate.insert(law.rate_factor.ordinate.begin(), curve->ordinate.front());
  }
}

/// LC/TBID of rubber or foam: force over the change of the gauge length.
void take_test(const RawMaterial& raw, model::SimplifiedRubber& law, Build& build) {
  if (build.find_quietly(Item::Table, raw.hardening_curve) != no_index) {
    build.report.field_unsupported(raw.curve_where,
                                   {"LC/TBID", std::to_string(raw.hardening_curve), "the id of a curve",
                                    "a table of curves by strain rate is not supported", "table"});
    return;
  }
  const model::Curve* const curve = curve_of(build, raw.hardening_curve, "LC/TBID", raw.curve_where);
  if (curve == nullptr || !(raw.gauge[0] > 0) || !(raw.gauge[1] > 0)) return;
  const double most = std::max(std::fabs(curve->ordinate.front()), std::fabs(curve->ordinate.back()));
  const bool both = curve->abscissa.front() < 0 && curve->abscissa.back() > 0;
  const bool rises = std::is_sorted(curve->ordinate.begin(), curve->ordinate.end());
  const bool within = curve->abscissa.front() > -raw.gauge[0];
  if (!both || !rises || !within || std::fabs(curve->at(0)) > 1e-9 * most) {
    build.report.error(raw.curve_where, "test",
                       fmt::format("curve {} must go from compression (not below -SGL) through (0, 0) to "
                                   "tension, and must not fall: it is the force of the test over the change "
                                   "of the gauge length",
                                   curve->id));
    return;
  }
  law.stretch.clear();
  law.stress.clear();
  for (std::size_t k = 0; k < curve->abscissa.size(); ++k) {
    law.stretch.push_back(1 + curve->abscissa[k] / raw.gauge[0]);
    law.stress.push_back(curve->ordinate[k] / raw.gauge[1]);
  }
  // The lines on both sides of the origin; it need not be a point of the curve.
  for (std::size_t k = 0; k + 1 < law.stretch.size(); ++k)
    if (law.stretch[k] <= 1 && law.stretch[k + 1] >= 1)
      law.youngs_modulus = std::max(
          law.youngs_modulus, (law.stress[k + 1] - law.stress[k]) / (law.stretch[k + 1] - law.stretch[k]));
  if (law.is_foam) return;
  law.poissons_ratio = 0.5 - law.youngs_modulus / (6 * law.bulk_modulus);
  if (law.bulk_modulus > 0 && !(law.poissons_ratio > 0))
    build.report.error(
        raw.where, "modulus",
        fmt::format("KM is {:.4g}, expected more than a third of the slope of curve {} at rest, "
                    "{:.4g}: Poisson's ratio would be below zero",
                    law.bulk_modulus, curve->id, law.youngs_modulus));
}

/// Whether the points of a curve are sound for Bilkhu & Du Bois' foam; says what is not.
bool is_yield(const model::Curve& curve, std::string_view field, const Where& where, Report& report) {
  const bool above =
      std::all_of(curve.ordinate.begin(), curve.ordinate.end(), [](double y) { return y > 0; });
  const std::size_t last = curve.ordinate.size() - 1;
  const bool falls = last > 0 && curve.ordinate[last] < curve.ordinate[last - 1];
  if (curve.abscissa.front() == 0 && above && !falls) return true;
  report.field_error(
      where, {field, std::to_string(curve.id),
              "a curve of numbers above zero from 0 on that does not fall at its end",
              curve.abscissa.front() < 0
                  ? "a part in tension, at strains below zero, is not supported: give TSC, VTSC, PC or VPC"
                  : "it is over -ln V, above zero in compression",
              "curve"});
  return false;
}

void take_yields(const RawMaterial& raw, model::BilkhuDuboisFoam& law, Build& build) {
  const auto take = [&](UserId id, std::string_view field, model::PointCurve& into) {
    const model::Curve* const curve = curve_of(build, id, field, raw.curve_where);
    if (curve == nullptr || !is_yield(*curve, field, raw.curve_where, build.report)) return false;
    into = {curve->abscissa, curve->ordinate};
    return true;
  };
  const bool has_pressure = take(raw.hardening_curve, "LCPY", law.pressure);
  const bool has_uniaxial = take(raw.more_curves[0], "LCUYS", law.uniaxial);
  take_rate_factor(raw, law, build);
  if (!has_pressure || !has_uniaxial) return;
  const double where_not = no_ellipse(law);
  if (where_not >= 0)
    build.report.error(
        raw.curve_where, "ellipse",
        fmt::format(
            "at -ln V = {:.4g} the yield pressure of curve {} is {:.4g}, and the uniaxial yield stress of "
            "curve {} is {:.4g}: no ellipse goes through both unless the pressure is above a third of "
            "the stress; just above a third the strength in shear has no bound, and with PR = 0 foam "
            "has about the same of both; both curves go on with their last slopes",
            where_not, raw.hardening_curve, model::value_at(law.pressure, where_not), raw.more_curves[0],
            model::value_at(law.uniaxial, where_not)));
  const double least = *std::min_element(law.uniaxial.ordinate.begin(), law.uniaxial.ordinate.end());
  if (law.tension_stress > least && law.tension_stress_share == 0)
    build.report.warning(
        raw.curve_where, "tension",
        fmt::format("TSC is {:g}, and LCUYS has {:g}: the strength in tension stays below that in "
                    "compression",
                    law.tension_stress, least));
}

}  // namespace

void build_nominal_honeycombs(Build& build) {
  model::Model& model = build.model;
  std::map<Index, Index> nominal;
  for (model::Part& part : model.parts) {
    if (part.solid_section == no_index || part.material == no_index) continue;
    if (!model.solid_sections[static_cast<std::size_t>(part.solid_section)].nominal_strain) continue;
    const auto* const law =
        std::get_if<model::Honeycomb>(&model.materials[static_cast<std::size_t>(part.material)].law);
    if (law == nullptr || law->over != model::Honeycomb::Abscissa::Strain) continue;
    const auto [place, is_new] = nominal.emplace(part.material, static_cast<Index>(model.materials.size()));
    if (is_new) {
      // Parts with another ELFORM may have the same material.
      model::Material material = model.materials[static_cast<std::size_t>(part.material)];
      std::get<model::Honeycomb>(material.law).over = model::Honeycomb::Abscissa::NominalStrain;
      model.materials.push_back(std::move(material));
    }
    part.material = place->second;
  }
}

void take_foam_curves(const RawMaterial& raw, model::ConstitutiveLaw& law, Build& build) {
  if (auto* honeycomb = std::get_if<model::Honeycomb>(&law)) take_crushes(raw, *honeycomb, build);
  if (auto* soil = std::get_if<model::SoilAndFoam>(&law)) take_pressures(raw, *soil, build);
  if (auto* foam = std::get_if<model::BilkhuDuboisFoam>(&law)) take_yields(raw, *foam, build);
  if (auto* rubber = std::get_if<model::SimplifiedRubber>(&law)) take_test(raw, *rubber, build);
}

}  // namespace crumple::deck
