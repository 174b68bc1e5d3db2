// SPDX-License-Identifier: BSD-3-Clause
// What makes points of a material fail beside its law: *MAT_ADD_EROSION, *MAT_ADD_DAMAGE_GISSMO.
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <utility>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// The material that something is added to; null, with a message, if there is none that takes it.
model::Material* failing_material(Build& build, UserId id, const Where& where) {
  model::Model& model = build.model;
  const Index index = build.find(Item::Material, {id, "MID", where});
  if (index == no_index) return nullptr;
  if (static_cast<std::size_t>(index) >= model.materials.size()) {
    build.report.field_unsupported(where, {"MID", std::to_string(id), "a material of shells or solids",
                                           "springs and dampers do not fail by it", "elements"});
    return nullptr;
  }
  model::Material& material = model.materials[static_cast<std::size_t>(index)];
  if (!material.rigid) return &material;
  build.report.field_warning(where, {"MID", std::to_string(id), "a deformable material",
                                     "a rigid body does not fail: left out", "rigid"});
  return nullptr;
}

/// Reports a curve that is not above zero everywhere.
bool is_positive(const model::Curve& curve, std::string_view field, const Where& where, Report& report) {
  const auto bad =
      std::find_if(curve.ordinate.begin(), curve.ordinate.end(), [](double y) { return !(y > 0); });
  if (bad == curve.ordinate.end()) return true;
  report.field_error(where, {field, std::to_string(curve.id), "a curve above zero",
                             fmt::format("curve {} has {:g}", curve.id, *bad), "curve"});
  return false;
}

/// A curve, or one for each value of a table. Empty, with a message, if it is neither.
model::CurveFamily family_of(Build& build, const Reference& reference) {
  model::CurveFamily family;
  const Index place = build.find_quietly(Item::Table, reference.id);
  std::vector<Index> curves;
  if (place == no_index) {
    family.value = {0};
    curves = {find_points(build, reference)};
  } else {
    const RawTable& table = build.deck.tables[static_cast<std::size_t>(place)];
    family.value = table.value;
    curves = curves_of(table, build);
    if (curves.empty())
      build.report.error(table.where, "empty", fmt::format("table {} has no values", table.id));
  }
  for (const Index index : curves) {
    if (index == no_index) return {};
    const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
    if (!is_positive(curve, reference.field, reference.where, build.report)) return {};
    family.curve.push_back(curve);
  }
  return family;
}

/// A field of a curve alone, where the deck names a table. True if it does.
bool refuses_table(Build& build, const Reference& reference, const char* hint) {
  if (build.find_quietly(Item::Table, reference.id) == no_index) return false;
  build.report.field_unsupported(
      reference.where, {reference.field, std::to_string(reference.id), "the id of a curve", hint, "table"});
  return true;
}

void take_failure_strain(const RawDamage& raw, model::GissmoDamage& damage, Build& build) {
  const Where& where = raw.curves_where;
  if (raw.failure > 0) {
    damage.failure_strain = family_of(build, {raw.failure, "LCSDG", where});
    return;
  }
  const FieldFault fault{"LCSDG", std::to_string(raw.failure), "the id of a curve or of a table of curves",
                         raw.failure < 0 ? "*DEFINE_FUNCTION is not supported"
                                         : "it is the plastic strain at failure over triaxiality",
                         raw.failure < 0 ? "function" : "missing"};
  if (raw.failure < 0)
    build.report.field_unsupported(where, fault);
  else
    build.report.field_error(where, fault);
}

void take_critical_strain(const RawDamage& raw, model::GissmoDamage& damage, Build& build) {
  if (raw.critical > 0) damage.critical_strain = model::constant_family(raw.critical);
  if (raw.critical < 0)
    damage.critical_strain =
        family_of(build, {static_cast<UserId>(-raw.critical), "ECRIT", raw.curves_where});
  if (raw.critical == 0 && damage.critical_damage == 0 && damage.acts)
    build.report.field_warning(raw.curves_where,
                               {"DCRIT", "0", "ECRIT, or DCRIT above zero",
                                "the stress fades from the first plastic strain on", "uncoupled"});
}

void take_fading(const RawDamage& raw, model::GissmoDamage& damage, Build& build) {
  damage.fading_exponent = model::constant_family(raw.fading == 0 ? 1 : raw.fading);
  if (raw.fading >= 0) return;
  const Reference reference{static_cast<UserId>(-raw.fading), "FADEXP", raw.curves_where};
  if (!refuses_table(build, reference, "the exponent depends on the size of the element alone"))
    damage.fading_exponent = family_of(build, reference);
}

void take_regularization(const RawDamage& raw, model::GissmoDamage& damage, Build& build) {
  if (raw.regularization == 0) return;
  const Reference reference{std::abs(raw.regularization), "LCREGD", raw.curves_where};
  if (raw.regularization > 0) {
    if (!refuses_table(build, reference, "the factor does not depend on the strain rate"))
      damage.size_factor = family_of(build, reference);
    return;
  }
  damage.size_factor = family_of(build, reference);
  if (damage.shear_reduction == 0 && damage.biaxial_reduction == 0) return;
  build.report.field_error(
      raw.curves_where,
      {"LCREGD", std::to_string(raw.regularization), "a curve, above zero, or SHRF and BIAXF of zero",
       "a table over triaxiality stands in the place of both", "both"});
}

void take_rates(const RawDamage& raw, model::GissmoDamage& damage, Build& build) {
  if (raw.rates == 0) return;
  const Reference reference{std::abs(raw.rates), "LCSRS", raw.more_where};
  const Index index = find_points(build, reference);
  if (index == no_index) return;
  const model::Curve& curve = build.model.curves[static_cast<std::size_t>(index)];
  if (!is_positive(curve, reference.field, reference.where, build.report)) return;
  damage.rate_factor = curve;
  damage.logarithmic_rates = curve.abscissa.front() < 0;
  damage.rates_scale_critical = raw.rates > 0;
}

void take_damage(const RawDamage& raw, Build& build) {
  model::Material* const material = failing_material(build, raw.material, raw.where);
  if (material == nullptr) return;
  const std::string id = std::to_string(raw.material);
  if (material->damage) {
    build.report.field_error(raw.where, {"MID", id, "a material without damage",
                                         "it has some by an earlier keyword", "damaged twice"});
    return;
  }
  if (!model::has_plastic_strain(material->law)) {
    build.report.field_unsupported(raw.where, {"MID", id, "a law with a plastic strain",
                                               "the plastic strain is what makes damage grow", "elastic"});
    return;
  }
  model::GissmoDamage damage = raw.damage;
  take_failure_strain(raw, damage, build);
  take_critical_strain(raw, damage, build);
  take_fading(raw, damage, build);
  take_regularization(raw, damage, build);
  take_rates(raw, damage, build);
  if (!damage.failure_strain.empty() && !damage.fading_exponent.empty()) material->damage = std::move(damage);
}

}  // namespace

void take_erosions(Build& build) {
  for (const RawErosion& raw : build.deck.erosions) {
    model::Material* const material = failing_material(build, raw.material, raw.where);
    if (material == nullptr) continue;
    material->least_step = std::max(material->least_step, raw.least_step);
    if (material->erosion)
      build.report.field_error(raw.where, {"MID", std::to_string(raw.material), "a material without criteria",
                                           "it has some by an earlier *MAT_ADD_EROSION", "twice"});
    else if (raw.criteria.any())
      material->erosion = raw.criteria;
    else if (!raw.damages && raw.least_step == 0)
      build.report.warning(raw.where, "criteria", "there is no criterion, so nothing fails by it");
  }
}

void take_damages(Build& build) {
  for (const RawDamage& raw : build.deck.damages) take_damage(raw, build);
}

}  // namespace crumple::deck
