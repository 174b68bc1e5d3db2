// SPDX-License-Identifier: BSD-3-Clause
// Sections, materials, hourglass controls and curves.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "base/counted.hpp"
#include "deck/build/build.hpp"

namespace crumple::deck {

Index find_points(Build& build, const Reference& reference) {
  const Index index = build.find(Item::Curve, reference);
  if (index == no_index) return no_index;
  if (build.deck.curves[static_cast<std::size_t>(index)].function.empty()) {
    // That it has less than two points has been reported where it stands.
    const bool has_points = build.model.curves[static_cast<std::size_t>(index)].abscissa.size() > 1;
    return has_points ? index : no_index;
  }
  build.report.field_error(reference.where, {reference.field, std::to_string(reference.id),
                                             "a curve of *DEFINE_CURVE, given by points",
                                             "*DEFINE_CURVE_FUNCTION is a function of time", "function"});
  return no_index;
}

std::vector<Index> curves_of(const RawTable& raw, Build& build) {
  std::vector<Index> found;
  const std::vector<RawCurve>& curves = build.deck.curves;
  if (raw.curve.empty() && raw.first_curve + raw.value.size() > curves.size()) {
    build.report.error(raw.where, "curves",
                       fmt::format("table {} has {}, and {} behind it; each value needs its "
                                   "*DEFINE_CURVE, in the same order, or use *DEFINE_TABLE_2D",
                                   raw.id, counted(raw.value.size(), "value"),
                                   counted(curves.size() - raw.first_curve, "curve")));
    return std::vector<Index>(raw.value.size(), no_index);
  }
  for (std::size_t i = 0; i < raw.value.size(); ++i) {
    const UserId id = raw.curve.empty() ? curves[raw.first_curve + i].curve.id : raw.curve[i];
    if (id == 0) {  // reported
      found.push_back(no_index);
      continue;
    }
    found.push_back(find_points(build, {id, "CURVEID", raw.where}));
  }
  return found;
}

namespace {

/// LCSR: factors on the yield stress over strain rate.
void take_factors(const RawMaterial& raw, model::PiecewiseLinearPlasticity& law, Build& build) {
  if (raw.rate_curve == 0) return;
  const Index index = find_points(build, {raw.rate_curve, "LCSR", raw.curve_where});
  if (index == no_index) return;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  law.factor_rate = curve.abscissa;
  law.rate_factor = curve.ordinate;
  // Constant below the first point.
  if (curve.abscissa.front() > 0) {
    law.factor_rate.insert(law.factor_rate.begin(), 0.0);
    law.rate_factor.insert(law.rate_factor.begin(), curve.ordinate.front());
  }
  for (std::size_t i = 0; i < curve.abscissa.size(); ++i)
    if (curve.abscissa[i] < 0 || !(curve.ordinate[i] > 0)) {
      build.report.error(raw.where, "rate",
                         fmt::format("curve {} gives the factor {} at strain rate {}, expected rates not "
                                     "below zero and factors above zero",
                                     curve.id, curve.ordinate[i], curve.abscissa[i]));
      return;
    }
}

/// LCDM: damage over the plastic strain behind EPPF, which the law has as its first strain. Where it reaches
/// one the point fails.
void take_damage_curve(const RawMaterial& raw, model::PiecewiseLinearPlasticity& law, Build& build) {
  if (law.damage.empty() || raw.more_curves[0] == 0) return;
  const Index index = find_points(build, {raw.more_curves[0], "LCDM", raw.curve_where});
  if (index == no_index) return;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  const bool starts = curve.abscissa.front() == 0 && curve.ordinate.front() == 0;
  const bool grows = std::is_sorted(curve.ordinate.begin(), curve.ordinate.end());
  if (!starts || !grows || curve.ordinate.back() > 1) {
    build.report.field_error(raw.curve_where,
                             {"LCDM", std::to_string(curve.id), "a curve from (0, 0) on that does not fall",
                              "it is the damage, up to 1, over the plastic strain behind EPPF", "damage"});
    return;
  }
  const double begin = law.damage_strain.front();
  law.damage_strain.front() = 0;
  // With EPPF of zero the first point is there.
  for (std::size_t i = begin > 0 ? 0 : 1; i < curve.abscissa.size(); ++i) {
    law.damage_strain.push_back(begin + curve.abscissa[i]);
    law.damage.push_back(curve.ordinate[i]);
    if (curve.ordinate[i] < 1) continue;
    const double ruptured = law.damage_strain.back();
    law.failure_strain = law.failure_strain > 0 ? std::min(law.failure_strain, ruptured) : ruptured;
    break;
  }
}

/// LCID of crushable foam: the yield stress over the crushed volume.
void take_crush(const RawMaterial& raw, model::CrushableFoam& law, Build& build) {
  if (raw.hardening_curve == 0) return;
  const Index index = find_points(build, {raw.hardening_curve, "LCID", raw.curve_where});
  if (index == no_index) return;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  law.crush = curve.abscissa;
  law.yield_stress = curve.ordinate;
  const auto below_zero = [](double stress) { return stress < 0; };
  const bool none =
      std::all_of(curve.ordinate.begin(), curve.ordinate.end(), [](double stress) { return stress == 0; });
  if (none || std::any_of(curve.ordinate.begin(), curve.ordinate.end(), below_zero))
    build.report.error(
        raw.where, "crush",
        fmt::format("curve {} must give yield stresses that are positive in compression", curve.id));
}

/// A curve of a foam that springs back: nominal stress over strain, both positive in compression.
void take_compression(const model::Curve& curve, const RawMaterial& raw, std::vector<double>& strain,
                      std::vector<double>& stress, Report& report) {
  strain = curve.abscissa;
  stress = curve.ordinate;
  const bool starts = strain.front() == 0 && stress.front() == 0;
  const bool grows = std::is_sorted(stress.begin(), stress.end()) && stress.back() > 0;
  if (!starts || !grows)
    report.error(
        raw.where, "compression",
        fmt::format("curve {} must start at (0, 0), and its stresses must not fall: it is the nominal "
                    "stress over 1 - stretch, both positive in compression",
                    curve.id));
}

/// LCID or TBID of a foam that springs back. The slowest curve of a table is that of unloading, too.
void take_compression(const RawMaterial& raw, model::LowDensityFoam& law, Build& build) {
  if (raw.hardening_curve == 0) return;
  const auto take = [&](Index index, std::vector<double>& strain, std::vector<double>& stress) {
    take_compression(build.model.curves[static_cast<std::size_t>(index)], raw, strain, stress, build.report);
  };
  const Index place = build.find_quietly(Item::Table, raw.hardening_curve);
  if (place == no_index) {
    const Index index = find_points(build, {raw.hardening_curve, "LCID", raw.curve_where});
    if (index != no_index) take(index, law.compression, law.stress);
    return;
  }
  const RawTable& table = build.deck.tables[static_cast<std::size_t>(place)];
  const bool ascends =
      std::adjacent_find(table.value.begin(), table.value.end(), std::greater_equal<>()) == table.value.end();
  if (table.value.empty() || table.value.front() < 0 || !ascends) {
    build.report.error(table.where, "rates",
                       fmt::format("table {} must have strain rates that ascend, none below zero", table.id));
    return;
  }
  const std::vector<Index> curves = curves_of(table, build);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i] == no_index) continue;
    if (i == 0) {
      law.slowest = table.value[i];
      take(curves[i], law.compression, law.stress);
      continue;
    }
    law.faster.push_back({table.value[i], {}, {}});
    take(curves[i], law.faster.back().compression, law.faster.back().stress);
  }
}

/// A curve of discrete beams: of at least two points, through the origin.
Index direction_curve(const RawDirectionCurve& raw, Build& build) {
  if (raw.id == 0) return no_index;
  const Index index = find_points(build, {raw.id, raw.field, raw.where});
  if (index == no_index) return no_index;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  double most = 0;
  for (const double y : curve.ordinate) most = std::max(most, std::fabs(y));
  constexpr double small = 1e-9;
  if (curve.abscissa.front() > 0 || curve.abscissa.back() <= 0 || std::fabs(curve.at(0)) > small * most)
    build.report.field_error(
        raw.where,
        {raw.field, std::to_string(raw.id), "a curve through the origin, to the right of it or to both sides",
         fmt::format("curve {} goes from {:g} to {:g} and has {:g} at 0", raw.id, curve.abscissa.front(),
                     curve.abscissa.back(), curve.at(0)),
         "curve"});
  return index;
}

/// A curve of unloading, which rises: its inverse is needed where it is shifted.
Index unloading_curve(const RawDirectionCurve& raw, const model::DiscreteBeamLaw& law, Build& build) {
  const Index index = direction_curve(raw, build);
  if (index == no_index || law.unloading != model::DiscreteBeamLaw::Unloading::Curve) return index;
  const std::vector<double>& force = build.model.curves[static_cast<std::size_t>(index)].ordinate;
  if (std::adjacent_find(force.begin(), force.end(), std::greater_equal<>()) != force.end())
    build.report.field_error(raw.where,
                             {raw.field, std::to_string(raw.id), "a curve that rises throughout",
                              "unloading follows it from any point of the curve of loading", "unloading"});
  return index;
}

void take_direction_curves(const RawMaterial& raw, model::DiscreteBeamLaw& law, Build& build) {
  if (law.kind == model::DiscreteBeamLaw::Kind::Cable) {
    law.stress_curve = direction_curve(raw.direction_curves[0], build);
    return;
  }
  for (std::size_t i = 0; i < law.direction.size(); ++i) {
    law.direction[i].curve = direction_curve(raw.direction_curves[i], build);
    law.direction[i].damping_curve = direction_curve(raw.damping_curves[i], build);
    law.direction[i].unloading_curve = unloading_curve(raw.unloading_curves[i], law, build);
    const RawDirectionCurve& factors = raw.damping_factors[i];
    if (factors.id != 0)
      law.direction[i].damping_factor = find_points(build, {factors.id, factors.field, factors.where});
  }
}

/// One table of ids for all kinds of sections, in the order of the deck; the indices of shells, solids, beams
/// and discrete elements follow each other.
void enter_sections(Build& build) {
  struct Entry {
    Reference reference;
    std::size_t index = 0;
  };
  const RawDeck& deck = build.deck;
  std::vector<Entry> entries(deck.section_count());
  std::size_t index = 0;
  const auto take = [&](const auto& raws) {
    for (const auto& raw : raws) entries[raw.order] = {{raw.section.id, "SECID", raw.where}, index++};
  };
  take(deck.sections);
  take(deck.solid_sections);
  take(deck.beam_sections);
  take(deck.discrete_sections);
  for (const Entry& entry : entries)
    if (entry.reference.id != 0) build.enter(Item::Section, entry.reference, entry.index);
}

/// A curve of a spring or damper: it must have both signs and go through the origin. That of an elastic
/// spring may begin or end there: its first or last slope goes on, as in LS-DYNA (S. Bala, Modeling symmetric
/// and unsymmetric nonlinear discrete springs, d3view, 2006).
Index spring_curve(const RawSpringMaterial& raw, UserId id, std::string_view field, Build& build) {
  if (id == 0) return no_index;
  const Index index = find_points(build, {id, field, raw.where});
  if (index == no_index) return no_index;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  constexpr double small = 1e-9;
  const bool both = curve.abscissa.front() < 0 && curve.abscissa.back() > 0;
  const double most = std::max(std::fabs(curve.ordinate.front()), std::fabs(curve.ordinate.back()));
  const bool one_sided = !both && field == "LCD" && curve.abscissa.size() > 1 &&
                         (curve.abscissa.front() == 0 || curve.abscissa.back() == 0);
  if (one_sided)
    build.report.warning(raw.where, "spring curve " + std::to_string(id),
                         fmt::format("curve {} has one direction alone: in the other one the slope at (0, 0) "
                                     "goes on, as in LS-DYNA; give points of both for another force there",
                                     id));
  if ((!both && !one_sided) || std::fabs(curve.at(0)) > small * most)
    build.report.field_error(raw.where,
                             {field, std::to_string(id), "a curve from below zero to above through (0, 0)",
                              "it holds for both directions, the negative one first", "curve"});
  return index;
}

/// LCFD: forces and deformations without a sign, from the origin on.
Index one_sided_curve(const RawSpringMaterial& raw, Build& build) {
  if (raw.curve == 0) return no_index;
  const Index index = find_points(build, {raw.curve, raw.curve_field, raw.where});
  if (index == no_index) return no_index;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  const bool starts = curve.abscissa.front() == 0 && curve.ordinate.front() == 0;
  if (!starts || *std::min_element(curve.ordinate.begin(), curve.ordinate.end()) < 0)
    build.report.field_error(raw.where, {raw.curve_field, std::to_string(raw.curve),
                                         "a curve from (0, 0) on with forces not below zero",
                                         "it holds for the direction of CTF, without signs", "curve"});
  return index;
}

/// Materials of springs and dampers, behind the others.
void build_spring_materials(Build& build) {
  model::Model& model = build.model;
  for (const RawSpringMaterial& raw : build.deck.spring_materials) {
    build.enter(Item::Material, {raw.material.id, "MID", raw.where},
                model.materials.size() + model.spring_materials.size());
    model.spring_materials.push_back(raw.material);
    model::SpringLaw& law = model.spring_materials.back().law;
    if (auto* spring = std::get_if<model::NonlinearSpring>(&law)) {
      spring->curve = spring_curve(raw, raw.curve, raw.curve_field, build);
      if (raw.rate_curve != 0)
        spring->rate_curve = find_points(build, {raw.rate_curve, raw.rate_field, raw.where});
    } else if (auto* damper = std::get_if<model::NonlinearDamper>(&law)) {
      damper->curve = spring_curve(raw, raw.curve, raw.curve_field, build);
    } else if (auto* inelastic = std::get_if<model::InelasticSpring>(&law)) {
      inelastic->curve = one_sided_curve(raw, build);
    }
  }
}

void build_step_curve(Build& build) {
  if (const auto& raw = build.deck.step_curve)
    build.model.control.step_curve = build.find(Item::Curve, {raw->curve, "LCTM", raw->where});
}

}  // namespace

void build_properties(Build& build, const ReadOptions& options) {
  const RawDeck& deck = build.deck;
  model::Model& model = build.model;
  double end_time = options.end_time.value_or(deck.control.end_time);
  if (!(end_time > 0)) end_time = 1;
  for (const RawCurve& raw : deck.curves) {
    build.enter(Item::Curve, {raw.curve.id, "LCID", raw.where}, model.curves.size());
    model.curves.push_back(raw.function.empty() ? raw.curve : sample_function(raw, end_time, build.report));
  }
  build_step_curve(build);
  for (std::size_t i = 0; i < deck.tables.size(); ++i)
    build.enter(Item::Table, {deck.tables[i].id, "TBID", deck.tables[i].where}, i);
  for (const RawSection& raw : deck.sections) {
    model.shell_sections.push_back(raw.section);
    model::ShellSection& section = model.shell_sections.back();
    if (!raw.formulation_given) section.formulation = deck.default_formulation;
    if (deck.warping_stiffness && section.formulation == model::ShellFormulation::BelytschkoTsay)
      section.formulation = model::ShellFormulation::BelytschkoWongChiang;
    if (model::is_membrane(section.formulation)) {
      // Membranes have the same strain at every place of the thickness.
      section.thickness_points = 1;
      section.thickness_rule = model::ThicknessRule::Gauss;
      if (section.node_place != 0)
        build.report.field_warning(
            raw.where, {"NLOC", fmt::format("{:g}", section.node_place), "0",
                        "membranes have no bending, so their nodes lie in the middle", "membrane"});
      section.node_place = 0;
    }
    // LS-DYNA takes Gauss points where Lobatto's rule has none of the order.
    const bool gauss = section.thickness_rule == model::ThicknessRule::Gauss;
    if (deck.lobatto_points && gauss && section.thickness_points >= 3)
      section.thickness_rule = model::ThicknessRule::Lobatto;
  }
  for (const RawSolidSection& raw : deck.solid_sections) model.solid_sections.push_back(raw.section);
  build_beam_sections(build);
  for (const RawDiscreteSection& raw : deck.discrete_sections) model.discrete_sections.push_back(raw.section);
  enter_sections(build);
  for (std::size_t i = 0; i < deck.integration_rules.size(); ++i)
    build.enter(Item::IntegrationRule,
                {deck.integration_rules[i].id, "IRID", deck.integration_rules[i].where}, i);
  for (const RawHourglass& raw : deck.hourglasses) {
    build.enter(Item::Hourglass, {raw.id, "HGID", raw.where}, model.hourglass_controls.size());
    model.hourglass_controls.push_back(raw.control);
  }
  for (const RawEquationOfState& raw : deck.equations_of_state) {
    build.enter(Item::EquationOfState, {raw.equation.id, "EOSID", raw.where},
                model.equations_of_state.size());
    model.equations_of_state.push_back(raw.equation);
  }
  for (const RawMaterial& raw : deck.materials) {
    build.enter(Item::Material, {raw.material.id, "MID", raw.where}, model.materials.size());
    model.materials.push_back(raw.material);
    if (auto* law = std::get_if<model::PiecewiseLinearPlasticity>(&model.materials.back().law)) {
      take_hardening(raw, *law, build);
      take_factors(raw, *law, build);
      take_damage_curve(raw, *law, build);
    }
    if (auto* law = std::get_if<model::SheetPlasticity>(&model.materials.back().law))
      take_hardening(raw, *law, build);
    if (auto* law = std::get_if<model::CompressionTension>(&model.materials.back().law))
      take_hardening(raw, *law, build);
    if (auto* law = std::get_if<model::DiscreteBeamLaw>(&model.materials.back().law))
      take_direction_curves(raw, *law, build);
    if (auto* law = std::get_if<model::Fabric>(&model.materials.back().law)) {
      const auto find = [&](std::size_t place, std::string_view field) {
        const UserId id = raw.leakage_curves[place];
        return id == 0 ? no_index : build.find(Item::Curve, {id, field, raw.curve_where});
      };
      law->leakage.coefficient_time = find(0, "FLC");
      law->leakage.area_pressure = find(1, "FAC");
    }
    if (auto* law = std::get_if<model::CrushableFoam>(&model.materials.back().law))
      take_crush(raw, *law, build);
    if (auto* law = std::get_if<model::LowDensityFoam>(&model.materials.back().law))
      take_compression(raw, *law, build);
    take_foam_curves(raw, model.materials.back().law, build);
    take_rate_factors(raw, model.materials.back().law, build);
  }
  build_spring_materials(build);
  take_erosions(build);
  take_damages(build);
}

}  // namespace crumple::deck
