// SPDX-License-Identifier: BSD-3-Clause
// Stresses at time zero.
#include <fmt/core.h>

#include <utility>
#include <vector>

#include "deck/build/build.hpp"
#include "model/initial_stress.hpp"

namespace crumple::deck {

namespace {

/// The elements that an entry is about, one or those of a set.
std::vector<Index> elements_of(const RawInitialStress& raw, bool shells, Build& build) {
  const std::string_view field = raw.is_set ? "SID" : "EID";
  const Item item =
      shells ? (raw.is_set ? Item::ShellSet : Item::Shell) : (raw.is_set ? Item::SolidSet : Item::Solid);
  const Index index = build.find(item, {raw.element, field, raw.where});
  if (index == no_index) return {};
  if (!raw.is_set) return {index};
  const auto place = static_cast<std::size_t>(index);
  return shells ? build.model.shell_sets[place].shells : build.solid_sets[place];
}

/// Builds what *INITIAL_STRESS_SHELL and _SOLID say; each kind of warning comes once.
class StressBuilder {
 public:
  explicit StressBuilder(Build& build) : build_(build) {}

  void add_shells(const RawInitialStress& raw) {
    for (const Index element : elements_of(raw, true, build_)) {
      const model::ShellElement& shell = build_.model.shells[static_cast<std::size_t>(element)];
      if (!accepts(raw, shell.part, model::layup_of(build_.model, shell))) continue;
      if (!check_planes(raw, shell)) continue;
      take(raw, element, taken_shells_, build_.model.shell_stresses);
    }
  }

  void add_solids(const RawInitialStress& raw) {
    for (const Index element : elements_of(raw, false, build_)) {
      const model::SolidElement& solid = build_.model.solids[static_cast<std::size_t>(element)];
      if (!accepts(raw, solid.part, no_index) || !check_points(raw, solid)) continue;
      take(raw, element, taken_solids_, build_.model.solid_stresses);
    }
  }

 private:
  void take(const RawInitialStress& raw, Index element, std::vector<bool>& taken,
            std::vector<model::InitialStress>& into) {
    const auto at = static_cast<std::size_t>(element);
    if (at >= taken.size()) taken.resize(at + 1);
    if (taken[at])
      build_.report.field_warning(
          raw.where, {raw.is_set ? "SID" : "EID", std::to_string(raw.element), "an element without stresses",
                      "an element has them already; the later ones count", "twice"});
    taken[at] = true;
    into.push_back(raw.stress);
    into.back().element = element;
  }

  /// False, with a message, if elements of the part cannot begin so.
  bool accepts(const RawInitialStress& raw, Index part_index, Index layup) {
    if (part_index == no_index) return false;
    const model::Part& part = build_.model.parts[static_cast<std::size_t>(part_index)];
    if (part.material == no_index) return false;
    const std::string_view field = raw.is_set ? "SID" : "EID";
    const model::Material& material = build_.model.materials[static_cast<std::size_t>(part.material)];
    if (material.rigid) {
      if (!std::exchange(warned_of_rigid_, true))
        build_.report.field_warning(
            raw.where, {field, std::to_string(raw.element), "an element of a part that is not rigid",
                        fmt::format("part {} is rigid, its elements have no stress", part.id), "rigid"});
      return false;
    }
    const std::string refusal = model::refusal_of_initial_stress(build_.model, part, layup, raw.stress);
    if (!refusal.empty()) {
      build_.report.field_unsupported(
          raw.where, {field, std::to_string(raw.element), "an element that can begin with these stresses",
                      fmt::format("part {}: {}", part.id, refusal), "law"});
      return false;
    }
    check_histories(raw, part, layup == no_index && model::has_back_stress(material.law));
    return true;
  }

  /// Of history variables only the back stress has a known meaning.
  void check_histories(const RawInitialStress& raw, const model::Part& part, bool back_stress) {
    if (!raw.has_histories || (back_stress && !raw.more_histories)) return;
    build_.report.field_unsupported(
        raw.where,
        {"NHISV", "history variables that are not zero",
         back_stress ? "five, the back stress" : "history variables that are zero",
         fmt::format("part {}: what its law remembers here is not what LS-DYNA's remembers; stresses and "
                     "plastic strain are enough",
                     part.id),
         "history"});
  }

  /// LS-DYNA's INTPERR: another number of points than the section has.
  bool check_planes(const RawInitialStress& raw, const model::ShellElement& shell) {
    const model::Part& part = build_.model.parts[static_cast<std::size_t>(shell.part)];
    if (part.section == no_index) return false;
    const model::ShellSection& section = build_.model.shell_sections[static_cast<std::size_t>(part.section)];
    const int planes = raw.stress.planes;
    if (planes != 1 && planes != 4 && model::repeated_entry(shell.node) < 0 &&
        has_four_planes(section.formulation)) {
      build_.report.field_error(
          raw.where, {"NPLANE", std::to_string(planes), "1 or 4",
                      fmt::format("shells of part {} have four points in plane", part.id), "planes"});
      return false;
    }
    const Index layup = model::layup_of(build_.model, shell);
    const std::size_t own = layup == no_index
                                ? static_cast<std::size_t>(section.thickness_points)
                                : build_.model.layups[static_cast<std::size_t>(layup)].layers.size();
    const std::size_t layers = raw.stress.points.size() / static_cast<std::size_t>(planes);
    if (layers != own && !std::exchange(warned_of_layers_, true))
      build_.report.field_warning(raw.where, {"NTHICK", std::to_string(layers), std::to_string(own),
                                              "stresses are interpolated through the thickness", "points"});
    return true;
  }

  bool check_points(const RawInitialStress& raw, const model::SolidElement& solid) {
    const model::Part& part = build_.model.parts[static_cast<std::size_t>(solid.part)];
    if (part.solid_section == no_index) return false;
    const auto formulation =
        build_.model.solid_sections[static_cast<std::size_t>(part.solid_section)].formulation;
    const std::size_t points = raw.stress.points.size();
    if (!model::is_selective(formulation) && !model::is_quadratic(formulation)) return true;
    const std::size_t own = model::is_quadratic(formulation) ? 4 : 8;
    if (points == 1 || points == own) return true;
    build_.report.field_error(
        raw.where,
        {"NINT", std::to_string(points), fmt::format("1 or {}", own),
         fmt::format("solids of part {} have {} points", part.id, own == 4 ? "four" : "eight"), "points"});
    return false;
  }

  static bool has_four_planes(model::ShellFormulation formulation) {
    using Formulation = model::ShellFormulation;
    return formulation == Formulation::FullyIntegrated ||
           formulation == Formulation::FullyIntegratedMembrane ||
           formulation == Formulation::HughesLiuSelectiveReduced;
  }

  Build& build_;
  std::vector<bool> taken_shells_;  ///< by element
  std::vector<bool> taken_solids_;
  bool warned_of_rigid_ = false;
  bool warned_of_layers_ = false;
};

}  // namespace

void build_initial_stresses(Build& build) {
  StressBuilder builder(build);
  for (const RawInitialStress& raw : build.deck.shell_stresses) builder.add_shells(raw);
  for (const RawInitialStress& raw : build.deck.solid_stresses) builder.add_solids(raw);
}

}  // namespace crumple::deck
