// SPDX-License-Identifier: BSD-3-Clause
// What holds for shells and solids where the deck leaves it open (docs/theory/hourglass.md, "Which form to
// take").
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Elements for which what the deck leaves open makes a difference.
struct OpenElements {
  bool deformable_shells = false;
  bool hourglassing_shells = false;  ///< with hourglass control that *CONTROL_HOURGLASS decides about
  bool hourglassing_solids = false;  ///< the same
};

OpenElements open_elements(const model::Model& model) {
  OpenElements found;
  for (const model::SolidElement& solid : model.solids) {
    if (solid.part == no_index) continue;
    const model::Part& part = model.parts[solid.part];
    if (part.solid_section == no_index || part.hourglass != no_index || model::is_rigid(model, part))
      continue;
    const bool null = part.material != no_index &&
                      std::holds_alternative<model::NullMaterial>(model.materials[part.material].law);
    if (!null &&
        model.solid_sections[part.solid_section].formulation == model::SolidFormulation::OnePointHexahedron)
      found.hourglassing_solids = true;
  }
  for (const model::ShellElement& shell : model.shells) {
    if (shell.part == no_index) continue;
    const model::Part& part = model.parts[shell.part];
    if (part.section == no_index || model::is_rigid(model, part)) continue;
    found.deformable_shells = true;
    const model::ShellFormulation formulation = model.shell_sections[part.section].formulation;
    found.hourglassing_shells =
        found.hourglassing_shells || (part.hourglass == no_index && model::is_hourglassing(formulation));
  }
  return found;
}

/// Of NFAIL1 and NFAIL4, those for which the model has shells.
std::string deletion_in_use(const RawDistortedShells& raw, const model::Model& model) {
  bool one_point = false;
  bool fully_integrated = false;
  for (const model::ShellElement& shell : model.shells) {
    if (shell.part == no_index) continue;
    const model::Part& part = model.parts[shell.part];
    if (part.section == no_index || model::is_rigid(model, part)) continue;
    const bool full =
        model.shell_sections[part.section].formulation == model::ShellFormulation::FullyIntegrated;
    (full ? fully_integrated : one_point) = true;
  }
  if (raw.one_point && one_point) return "NFAIL1";
  return raw.fully_integrated && fully_integrated ? "NFAIL4" : "";
}

/// Whether the model has shells of that kind.
bool has_shells(const Build& build, RawShellOption::About about) {
  using About = RawShellOption::About;
  const model::Model& model = build.model;
  const std::vector<RawSection>& sections = build.deck.sections;
  return std::ranges::any_of(model.shells, [&](const model::ShellElement& shell) {
    if (shell.part == no_index) return false;
    const model::Part& part = model.parts[shell.part];
    if (part.section == no_index) return false;
    const model::ShellSection& section = model.shell_sections[part.section];
    // Those of *PART_COMPOSITE come behind the deck's own ones.
    const bool is_given = static_cast<std::size_t>(part.section) < sections.size();
    switch (about) {
      case About::OffsetShells:
        return section.node_place != 0;
      case About::HughesLiuShells:
        return section.formulation == model::ShellFormulation::HughesLiu ||
               section.formulation == model::ShellFormulation::HughesLiuSelectiveReduced;
      case About::LayeredShells:
        return !is_given || !sections[part.section].angles.empty() ||
               sections[part.section].integration_rule != 0;
      case About::ShellsOfNoFormulation:
        return is_given && !sections[part.section].formulation_given;
    }
    return false;
  });
}

}  // namespace

void check_shell_options(Build& build) {
  for (const RawShellOption& option : build.deck.shell_options)
    if (has_shells(build, option.about))
      build.report.field_unsupported(option.where, {option.field,
                                                    option.read,
                                                    std::string(option.expected),
                                                    std::string(option.hint),
                                                    "option",
                                                    {},
                                                    true});
}

void settle_distorted_shells(Build& build) {
  const RawDistortedShells& raw = build.deck.distorted_shells;
  const std::string field = deletion_in_use(raw, build.model);
  if (field.empty()) return;
  build.model.control.report_distorted_shells = true;
  build.report.warning(
      raw.where, "distorted",
      fmt::format("{} is not zero: LS-DYNA deletes shells with a negative Jacobian, or stops; here they "
                  "stay, and the end of the run says whether there are any",
                  field));
}

void settle_defaults(Build& build, bool as_ls_dyna) {
  model::Control& control = build.model.control;
  const bool ls_dyna = as_ls_dyna || build.deck.takes_ls_dyna_defaults;
  const bool open_hourglass = !build.deck.control_hourglass;
  const bool open_thickness = !build.deck.control_shell;
  if (open_hourglass && !ls_dyna) control.hourglass.form = model::HourglassForm::Material;
  if (open_thickness) control.thickness_change = !ls_dyna;
  if (ls_dyna) return;
  const OpenElements open = open_elements(build.model);
  const bool thickness = open_thickness && open.deformable_shells;
  const bool shells = open_hourglass && open.hourglassing_shells;
  const bool solids = open_hourglass && open.hourglassing_solids;
  std::string taken;
  const auto take = [&](bool it, std::string_view what) {
    if (it) taken += fmt::format("{}{}", taken.empty() ? "" : "; ", what);
  };
  take(thickness, "no *CONTROL_SHELL: the thickness of shells follows their strain (ISTUPD 1)");
  take(shells, "no *CONTROL_HOURGLASS: shells resist hourglassing with their material's stiffness");
  take(solids, "no *CONTROL_HOURGLASS: one-point hexahedra resist hourglassing by assumed strains (IHQ 6)");
  if (taken.empty()) return;
  taken += "; --ls-dyna-defaults takes ";
  taken += thickness || shells ? "constant thickness and viscous control instead" : "viscous control instead";
  build.report.add(Severity::Note, {{}, 0, 0, 0}, "defaults", taken);
}

}  // namespace crumple::deck
