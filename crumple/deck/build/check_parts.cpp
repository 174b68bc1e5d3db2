// SPDX-License-Identifier: BSD-3-Clause
// What a part puts together: elements, material and equation of state.
#include <fmt/core.h>

#include <cmath>
#include <variant>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

constexpr std::string_view equations = "*EOS_GRUNEISEN or *EOS_LINEAR_POLYNOMIAL";

/// Of solids of *MAT_JOHNSON_COOK without an equation of state, which LS-DYNA refuses.
void warn_of_elastic_pressure(const RawPart& raw, const RawMaterial& material, Report& report) {
  const auto& law = std::get<model::JohnsonCook>(material.material.law);
  report.field_warning(
      raw.where,
      {"EOSID", std::to_string(raw.equation_of_state), "the id of an equation of state",
       fmt::format(
           "LS-DYNA refuses solids of {} without one; here the pressure is then elastic, with the bulk "
           "modulus of E and PR, {:.4g}{}",
           material.where.keyword, law.youngs_modulus / (3 * (1 - 2 * law.poissons_ratio)),
           law.least_pressure < 0 ? ", and PC and SPALL do nothing" : ""),
       "equation"});
}

/// A cohesive section and a cohesive material go together.
void check_cohesive(const RawPart& raw, const RawMaterial& material, const model::SolidSection& section,
                    Report& report) {
  const bool law = model::use_of(material.material.law).only_cohesive;
  const bool formulation = model::is_cohesive(section.formulation);
  if (law == formulation) return;
  report.field_error(
      raw.where,
      {"MID", std::to_string(raw.material), formulation ? "a cohesive material" : "a material of stresses",
       formulation ? fmt::format("section {} of the part is cohesive, ELFORM 19, which goes with "
                                 "*MAT_COHESIVE_MIXED_MODE and *MAT_COHESIVE_ELASTIC",
                                 section.id)
                   : fmt::format("{} goes with a section of ELFORM 19", material.where.keyword),
       "cohesive"});
}

void check_solids(const RawPart& raw, const RawMaterial& material, Report& report) {
  const auto* const weld = std::get_if<model::SpotWeldLaw>(&material.material.law);
  if (weld != nullptr) check_solid_weld(raw, *weld, report);
  const model::LawUse use = model::use_of(material.material.law);
  const std::string eos = std::to_string(raw.equation_of_state);
  if (!use.solids && weld == nullptr)
    report.field_unsupported(raw.where, {"MID", std::to_string(raw.material), "a material of solids",
                                         fmt::format("{} is there for {} only", material.where.keyword,
                                                     use.shells ? "shells" : "beams"),
                                         "elements"});
  else if (raw.equation_of_state != 0 && !use.takes_equation_of_state)
    report.field_error(raw.where, {"EOSID", eos, "0",
                                   fmt::format("{} brings its own pressure; an equation of state goes with "
                                               "*MAT_JOHNSON_COOK, *MAT_ELASTIC_PLASTIC_HYDRO and *MAT_NULL",
                                               material.where.keyword),
                                   "equation"});
  else if (raw.equation_of_state == 0 && use.needs_equation_of_state)
    report.field_error(raw.where, {"EOSID", eos, "the id of an equation of state",
                                   fmt::format("solids of {} have no other pressure; add it with {}",
                                               material.where.keyword, equations),
                                   "equation"});
  else if (raw.equation_of_state == 0 && use.takes_equation_of_state)
    warn_of_elastic_pressure(raw, material, report);
  const auto* fluid = std::get_if<model::NullMaterial>(&material.material.law);
  if (fluid != nullptr && fluid->least_pressure > 0)
    report.field_error(
        material.where,
        {"PC", fmt::format("{:g}", fluid->least_pressure), "a pressure not above zero",
         "it is the lower bound of the pressure, tension is below zero; 0 is no bound", "cut-off"});
}

void check_shells(const RawPart& raw, const RawMaterial& material, const model::ShellSection& section,
                  Report& report) {
  const model::LawUse use = model::use_of(material.material.law);
  if (use.only_membranes && !model::is_membrane(section.formulation))
    report.field_unsupported(
        raw.where,
        {"MID", std::to_string(raw.material), "a material of shells that bend",
         fmt::format("{} is there for membranes only, ELFORM 5 and 9", material.where.keyword), "membranes"});
  if (!use.shells)
    report.field_unsupported(raw.where, {"MID", std::to_string(raw.material), "a material of shells",
                                         fmt::format("{} is there for {} only", material.where.keyword,
                                                     use.solids ? "solids" : "beams"),
                                         "elements"});
  if (raw.equation_of_state != 0)
    report.field_error(raw.where, {"EOSID", std::to_string(raw.equation_of_state), "0",
                                   "shells have no equation of state: their stress across is zero, and the "
                                   "pressure follows from it",
                                   "equation"});
}

/// G and E, PR describe the same metal.
void check_shear_modulus(const RawPart& raw, const RawMaterial& material, Report& report) {
  const auto* law = std::get_if<model::JohnsonCook>(&material.material.law);
  if (law == nullptr || raw.equation_of_state == 0 || !(law->shear_modulus > 0)) return;
  const double other = 0.5 * law->youngs_modulus / (1 + law->poissons_ratio);
  constexpr double tolerance = 0.05;
  if (std::fabs(other - law->shear_modulus) > tolerance * law->shear_modulus)
    report.warning(material.where, "shear",
                   fmt::format("G is {:.4g}, and {:.4g} by E and PR; with an equation of state G is taken",
                               law->shear_modulus, other));
}

}  // namespace

void check_contact_of_null_shells(Build& build) {
  if (build.model.contacts.empty()) return;
  for (const model::ShellElement& shell : build.model.shells) {
    if (shell.part == no_index) continue;
    const model::Part& part = build.model.parts[static_cast<std::size_t>(shell.part)];
    if (part.material == no_index || model::is_rigid(build.model, part)) continue;
    if (static_cast<std::size_t>(part.material) >= build.deck.materials.size()) continue;  // of layers
    const RawMaterial& raw = build.deck.materials[static_cast<std::size_t>(part.material)];
    const auto* skin = std::get_if<model::NullMaterial>(&raw.material.law);
    if (skin == nullptr || skin->youngs_modulus > 0) continue;
    build.report.field_warning(
        raw.where,
        {"YM", "0", "a number above zero",
         fmt::format("shells of part {} have no contact stiffness: what touches them passes through, unless "
                     "SOFT = 1 or 2 gives them some",
                     part.id),
         "modulus"});
    return;
  }
}

void check_part(const RawPart& raw, const model::Part& part, Build& build) {
  // Beams and springs have been told which materials they take when their parts were built.
  const model::ElementKind kind = model::kind_of(part);
  if (kind == model::ElementKind::Beam || kind == model::ElementKind::Discrete) {
    if (raw.equation_of_state != 0)
      build.report.field_error(raw.where, {"EOSID", std::to_string(raw.equation_of_state), "0",
                                           "only solids have an equation of state", "equation"});
    return;
  }
  const RawMaterial& material = build.deck.materials[static_cast<std::size_t>(part.material)];
  if (part.solid_section != no_index) {
    check_solids(raw, material, build.report);
    check_cohesive(raw, material, build.model.solid_sections[static_cast<std::size_t>(part.solid_section)],
                   build.report);
    check_shear_modulus(raw, material, build.report);
  } else {
    check_shells(raw, material, build.model.shell_sections[static_cast<std::size_t>(part.section)],
                 build.report);
  }
}

}  // namespace crumple::deck
