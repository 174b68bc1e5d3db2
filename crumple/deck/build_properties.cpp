// SPDX-License-Identifier: BSD-3-Clause
// Sections, materials, hourglass controls and curves.
#include <fmt/format.h>

#include <variant>

#include "deck/build.hpp"

namespace crumple::deck {

namespace {

/// Plastic strain up to which a hardening table is continued with its last slope, as LS-DYNA continues
/// curves.
constexpr double far_strain = 10;

/// Continues a hardening table to zero strain and far beyond its end.
void extend(model::PiecewiseLinearPlasticity& law, const Where& where, Report& report) {
  std::vector<double>& strain = law.plastic_strain;
  std::vector<double>& stress = law.yield_stress;
  if (strain.size() < 2) return;
  if (strain.front() > 0) {
    const double slope = (stress[1] - stress[0]) / (strain[1] - strain[0]);
    const double initial = stress[0] - slope * strain[0];
    if (!(initial > 0))
      report.error(
          where, "initial yield",
          fmt::format("continued to zero plastic strain the hardening curve gives a yield stress of {}; "
                      "start it at zero",
                      initial));
    strain.insert(strain.begin(), 0.0);
    stress.insert(stress.begin(), initial);
  }
  if (strain.back() >= far_strain) return;
  const std::size_t last = strain.size() - 1;
  const double slope = (stress[last] - stress[last - 1]) / (strain[last] - strain[last - 1]);
  if (slope < 0)
    report.warning(where, "softening",
                   "the hardening curve falls at its end; behind it the yield stress stays constant");
  if (!(slope > 0)) return;
  stress.push_back(stress[last] + slope * (far_strain - strain[last]));
  strain.push_back(far_strain);
}

void take_curve(const RawMaterial& raw, model::PiecewiseLinearPlasticity& law, Build& build) {
  const Index index = build.find(Item::Curve, {raw.hardening_curve, "LCSS", raw.curve_where});
  if (index == no_index) return;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  law.plastic_strain = curve.abscissa;
  law.yield_stress = curve.ordinate;
  for (std::size_t i = 0; i < curve.abscissa.size(); ++i)
    if (curve.abscissa[i] < 0 || !(curve.ordinate[i] > 0)) {
      build.report.error(
          raw.where, "hardening",
          fmt::format("curve {} gives the yield stress {} at plastic strain {}, expected strains "
                      "not below zero and stresses above zero",
                      curve.id, curve.ordinate[i], curve.abscissa[i]));
      return;
    }
}

}  // namespace

void build_properties(Build& build) {
  const RawDeck& deck = build.deck;
  model::Model& model = build.model;
  for (const RawCurve& raw : deck.curves) {
    build.enter(Item::Curve, {raw.curve.id, "LCID", raw.where}, model.curves.size());
    model.curves.push_back(raw.curve);
  }
  for (const RawSection& raw : deck.sections) {
    build.enter(Item::Section, {raw.section.id, "SECID", raw.where}, model.shell_sections.size());
    model.shell_sections.push_back(raw.section);
    model::ShellSection& section = model.shell_sections.back();
    if (!raw.formulation_given) section.formulation = deck.default_formulation;
    if (deck.warping_stiffness && section.formulation == model::ShellFormulation::BelytschkoTsay)
      section.formulation = model::ShellFormulation::BelytschkoWongChiang;
    // LS-DYNA takes Gauss points where Lobatto's rule has none of the order.
    const bool gauss = section.thickness_rule == model::ThicknessRule::Gauss;
    if (deck.lobatto_points && gauss && section.thickness_points >= 3)
      section.thickness_rule = model::ThicknessRule::Lobatto;
  }
  for (const RawHourglass& raw : deck.hourglasses) {
    build.enter(Item::Hourglass, {raw.id, "HGID", raw.where}, model.hourglass_controls.size());
    model.hourglass_controls.push_back(raw.control);
  }
  for (const RawMaterial& raw : deck.materials) {
    build.enter(Item::Material, {raw.material.id, "MID", raw.where}, model.materials.size());
    model.materials.push_back(raw.material);
    if (auto* law = std::get_if<model::PiecewiseLinearPlasticity>(&model.materials.back().law)) {
      if (raw.hardening_curve != 0) take_curve(raw, *law, build);
      extend(*law, raw.where, build.report);
    }
  }
}

}  // namespace crumple::deck
