// SPDX-License-Identifier: BSD-3-Clause
// Nodes, parts and shells.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"
#include "model/elastic_moduli.hpp"

namespace crumple::deck {

namespace {

/// Turns the nodes of a triangle so that the third is the one given twice; its thickness holds twice, too.
void turn_triangle(model::ShellElement& shell) {
  const int repeated = model::repeated_entry(shell.node);
  if (repeated < 0) return;
  const auto by = (static_cast<std::ptrdiff_t>(repeated) + 2) % 4;
  std::rotate(shell.node.begin(), shell.node.begin() + by, shell.node.end());
  std::rotate(shell.thickness.begin(), shell.thickness.begin() + by, shell.thickness.end());
  shell.thickness[3] = shell.thickness[2];
}

/// A node twice, other than a triangle's third.
bool repeats_node(const std::array<Index, 4>& node) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (node[i] == node[j] && !(i == 2 && j == 3)) return true;
  return false;
}

/// A quadrilateral whose section is for triangles.
void check_formulation(const model::ShellElement& shell, const Where& where, Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(shell.part)];
  const auto& section = build.model.shell_sections[static_cast<std::size_t>(part.section)];
  if (section.formulation != model::ShellFormulation::Triangle || shell.node[2] == shell.node[3]) return;
  build.report.error(
      where, "not_a_triangle",
      fmt::format("shell {} of part {} has four nodes, but ELFORM 4 of section {} is for triangles; choose a "
                  "quadrilateral's ELFORM, triangles of the part are then computed by ELFORM 4 all the same",
                  shell.id, part.id, section.id));
}

/// Area that is not above zero, or sides that cross each other.
void check_shape(const model::ShellElement& shell, const Where& where, Build& build) {
  const auto& positions = build.model.nodes.position;
  std::array<Vector, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = positions[static_cast<std::size_t>(shell.node[i])];
  // Half the cross product of the diagonals is the area, for a triangle too.
  const Vector area = cross(difference(x[2], x[0]), difference(x[3], x[1]));
  double longest = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Vector side = difference(x[i], x[j]);
      longest = std::max(longest, dot(side, side));
    }
  constexpr double flat = 1e-9;
  if (!(std::sqrt(dot(area, area)) > flat * longest)) {
    build.report.error(
        where, "area",
        fmt::format("shell {} has no area; check the order of its nodes and their coordinates", shell.id));
    return;
  }
  if (shell.node[2] == shell.node[3]) return;
  int turned = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector corner = cross(difference(x[(i + 1) % 4], x[i]), difference(x[(i + 3) % 4], x[i]));
    if (dot(corner, area) < 0) ++turned;
  }
  if (turned >= 2)
    build.report.error(
        where, "crossed",
        fmt::format("the sides of shell {} cross each other; give its nodes in order around it", shell.id));
  else if (turned == 1)
    build.report.warning(
        where, "concave",
        fmt::format("shell {} has a corner that points inwards; its results will be poor", shell.id));
}

/// A node's thickness of zero takes the section's. False if neither has one.
bool complete_thickness(model::ShellElement& shell, const Build& build) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(shell.part)];
  const auto& section = build.model.shell_sections[static_cast<std::size_t>(part.section)];
  const bool own =
      std::any_of(shell.thickness.begin(), shell.thickness.end(), [](double t) { return t > 0; });
  for (std::size_t i = 0; i < 4; ++i) {
    if (own && !(shell.thickness[i] > 0)) shell.thickness[i] = section.thickness[i];
    if (!(shell.thickness[i] > 0 || section.thickness[i] > 0)) return false;
  }
  return true;
}

/// Says once per section that a shell of it has no thickness.
void report_thickness(const model::ShellElement& shell, Build& build, std::vector<char>& reported) {
  const model::Part& part = build.model.parts[static_cast<std::size_t>(shell.part)];
  const RawSection& section = build.deck.sections[static_cast<std::size_t>(part.section)];
  char& done = reported[static_cast<std::size_t>(part.section)];
  if (done || !section.thickness_good) return;
  done = 1;
  build.report.field_error(
      section.where,
      {"T1", "0", "a thickness above zero",
       fmt::format("shell {} (part {}) has none of its own from *ELEMENT_SHELL_THICKNESS", shell.id, part.id),
       "thickness"});
}

/// A section by its kind, for messages.
struct SectionPlace {
  std::string_view elements;
  UserId id;
  const Where& where;
};
SectionPlace place_of_section(const model::Part& part, const Build& build) {
  const auto place = [](std::string_view elements, const auto& raws, Index index) {
    const auto& raw = raws[static_cast<std::size_t>(index)];
    return SectionPlace{elements, raw.section.id, raw.where};
  };
  switch (model::kind_of(part)) {
    case ElementKind::Solid:
      return place("solids", build.deck.solid_sections, part.solid_section);
    case ElementKind::Beam:
      return place("beams", build.deck.beam_sections, part.beam_section);
    case ElementKind::Discrete:
      return place("discrete elements", build.deck.discrete_sections, part.discrete_section);
    default:
      return place("shells", build.deck.sections, part.section);
  }
}

std::string_view words_of(ElementKind kind) {
  static constexpr std::string_view words[] = {"shells", "solids", "beams", "discrete elements"};
  return words[static_cast<std::size_t>(kind)];
}

/// Whether a part has an id in a field; says so if not.
bool is_given(UserId id, std::string_view field, std::string_view what, const RawPart& raw, Build& build) {
  if (id != 0) return true;
  build.report.field_error(
      raw.where,
      {field, "0", fmt::format("the id of {}", what),
       "a part may have none only if it has no elements, and neither section nor material", "missing"});
  return false;
}

/// The material of a part by its id: springs and dampers have their own, which are entered behind the others.
/// False if there is none, or one of the other kind, which has been reported.
bool find_material(const RawPart& raw, bool has_section, model::Part& part, Build& build) {
  if (raw.material == RawPart::unreadable || !is_given(raw.material, "MID", "a material", raw, build))
    return false;
  const Index index = build.find(Item::Material, {raw.material, "MID", raw.where});
  if (index == no_index) return false;
  const auto others = static_cast<Index>(build.deck.materials.size());
  const bool is_spring = index >= others;
  const bool needs_spring = model::kind_of(part) == ElementKind::Discrete;
  if (has_section && is_spring != needs_spring) {
    build.report.field_error(
        raw.where, {"MID", std::to_string(raw.material),
                    needs_spring ? "a material of springs or dampers" : "a material with a density",
                    needs_spring ? "the section is *SECTION_DISCRETE; take *MAT_SPRING_ or *MAT_DAMPER_"
                                 : "materials of springs and dampers go with *SECTION_DISCRETE only",
                    "kind"});
    return false;
  }
  (is_spring ? part.spring_material : part.material) = is_spring ? index - others : index;
  return true;
}

/// The section of a part by its id; false if there is none, which has been reported.
bool find_section(const RawPart& raw, model::Part& part, Build& build) {
  if (!raw.layers.empty()) {
    part.section = static_cast<Index>(raw.own_section);
    return true;
  }
  if (raw.section == RawPart::unreadable || !is_given(raw.section, "SECID", "a section", raw, build))
    return false;
  const Index index = build.find(Item::Section, {raw.section, "SECID", raw.where});
  if (index == no_index) return false;
  // Entered behind each other: those of shells, solids, beams, discrete elements.
  const model::Model& model = build.model;
  const auto shells = static_cast<Index>(model.shell_sections.size());
  const auto solids = shells + static_cast<Index>(model.solid_sections.size());
  const auto beams = solids + static_cast<Index>(model.beam_sections.size());
  if (index < shells)
    part.section = index;
  else if (index < solids)
    part.solid_section = index - shells;
  else if (index < beams)
    part.beam_section = index - solids;
  else
    part.discrete_section = index - beams;
  return true;
}

/// Ids of the parts that elements name, ascending.
std::vector<UserId> parts_with_elements(const RawDeck& deck) {
  std::vector<UserId> parts;
  const auto add = [&](const auto& elements) {
    for (const auto& element : elements)
      if (parts.empty() || parts.back() != element.part) parts.push_back(element.part);
  };
  add(deck.shells);
  add(deck.solids);
  add(deck.beams);
  add(deck.discretes);
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// Shells have no hourglass form 6.
void warn_of_assumed_strain(const RawPart& raw, const model::Part& part, Build& build) {
  if (part.section == no_index ||
      model::hourglass_of(build.model, part).solid_form != model::SolidHourglassForm::AssumedStrain)
    return;
  build.report.warning(
      raw.where, "hourglass",
      fmt::format("part {} of shells is under hourglass control IHQ 6, which is for solids; its shells take "
                  "the stiffness form, IHQ 4",
                  raw.id));
}

/// A law that has no bulk modulus of its own takes that of the equation of state, for what wants Poisson's
/// ratio: hourglass control and damping by stiffness.
void complete_elasticity(const model::Part& part, Build& build) {
  if (part.material == no_index || part.equation_of_state == no_index) return;
  model::Material& material = build.model.materials[static_cast<std::size_t>(part.material)];
  auto* const law = std::get_if<model::HydroPlasticity>(&material.law);
  if (law == nullptr) return;
  const auto& equation = build.model.equations_of_state[static_cast<std::size_t>(part.equation_of_state)];
  const double bulk = model::initial_bulk_modulus(equation, material.density);
  if (bulk > 0) model::set_moduli(*law, bulk, law->shear_modulus);
}

}  // namespace

Index find_part_of(Build& build, ElementKind kind, const Reference& reference) {
  const Index index = build.find(Item::Part, reference);
  if (index == no_index) return no_index;
  const model::Part& part = build.model.parts[static_cast<std::size_t>(index)];
  if (model::kind_of(part) == kind) return index;
  const SectionPlace section = place_of_section(part, build);
  build.report.field_error(
      reference.where,
      {reference.field, std::to_string(reference.id),
       fmt::format("a part with a section of {}", words_of(kind)),
       fmt::format("section {} of part {} is one of {} ({}); give the elements a part of their own",
                   section.id, part.id, section.elements, build.report.place(section.where)),
       "kind"});
  return no_index;
}

void build_nodes(Build& build) {
  model::Nodes& nodes = build.model.nodes;
  nodes.id.reserve(build.deck.nodes.size());
  nodes.position.reserve(build.deck.nodes.size());
  for (const RawNode& raw : build.deck.nodes) {
    build.enter(Item::Node, {raw.id, "NID", raw.where}, nodes.id.size());
    nodes.id.push_back(raw.id);
    nodes.position.push_back(raw.position);
  }
}

void build_parts(Build& build) {
  const std::vector<UserId> used = parts_with_elements(build.deck);
  for (const RawPart& raw : build.deck.parts) {
    // Pre-processors write such a part for something that is not in this deck.
    if (raw.section == 0 && raw.material == 0 && raw.layers.empty() &&
        !std::binary_search(used.begin(), used.end(), raw.id)) {
      build.drop_part(raw.id);
      build.report.add(
          Severity::Note, raw.where, "empty",
          fmt::format("part {} has no section, no material and no elements, and is left out", raw.id));
      continue;
    }
    model::Part part;
    part.id = raw.id;
    part.title = raw.title;
    part.contact_thickness = raw.contact_thickness;
    part.contact_thickness_scale = raw.contact_thickness_scale;
    const bool has_section = find_section(raw, part, build);
    const bool is_composite = !raw.layers.empty();
    const bool has_material = is_composite || find_material(raw, has_section, part, build);
    if (raw.hourglass != 0) part.hourglass = build.find(Item::Hourglass, {raw.hourglass, "HGID", raw.where});
    if (raw.equation_of_state != 0 && part.solid_section != no_index)
      part.equation_of_state = build.find(Item::EquationOfState, {raw.equation_of_state, "EOSID", raw.where});
    complete_elasticity(part, build);
    const bool complete = has_section && has_material;
    if (complete && !is_composite) check_part(raw, part, build);
    if (!complete || !build_part_layup(build, raw, part)) {
      build.drop_part(raw.id);
      if (build.report.allow_unsupported())
        build.report.warning(raw.where, "dropped",
                             fmt::format("part {} is left out with its elements", raw.id));
      continue;
    }
    warn_of_assumed_strain(raw, part, build);
    build.enter(Item::Part, {raw.id, "PID", raw.where}, build.model.parts.size());
    build.model.parts.push_back(std::move(part));
  }
}

void build_shells(Build& build) {
  static constexpr std::array<std::string_view, 4> fields = {"N1", "N2", "N3", "N4"};
  std::vector<model::ShellElement>& shells = build.model.shells;
  shells.reserve(build.deck.shells.size());
  build.shells_of_part.assign(build.model.parts.size(), 0);
  build.lines_of_part.assign(build.model.parts.size(), 0);
  std::vector<char> without_thickness(build.model.shell_sections.size(), 0);
  for (const RawShell& raw : build.deck.shells) {
    if (build.is_dropped(raw.part)) continue;
    model::ShellElement shell;
    shell.id = raw.id;
    shell.thickness = raw.thickness;
    shell.material_angle = raw.material_angle;
    shell.part = find_part_of(build, ElementKind::Shell, {raw.part, "PID", raw.where});
    bool complete = shell.part != no_index;
    for (std::size_t i = 0; i < 4; ++i) {
      const bool triangle = i == 3 && raw.node[3] == raw.node[2];
      shell.node[i] = triangle ? shell.node[2] : build.find(Item::Node, {raw.node[i], fields[i], raw.where});
      complete = complete && shell.node[i] != no_index;
    }
    build.enter(Item::Shell, {raw.id, "EID", raw.where}, shells.size());
    if (complete && raw.layers != 0) complete = build_element_layup(build, raw, shell);
    if (complete) turn_triangle(shell);
    if (complete && repeats_node(shell.node)) {
      build.report.error(
          raw.where, "repeated",
          fmt::format(
              "shell {} has a node twice; a triangle has two equal neighbours, its third node as fourth",
              raw.id));
      complete = false;
    }
    if (complete && raw.material_system != 0) complete = turn_to_system(build, raw, shell);
    if (complete) {
      if (!complete_thickness(shell, build)) report_thickness(shell, build, without_thickness);
      check_shape(shell, raw.where, build);
      check_formulation(shell, raw.where, build);
      ++build.shells_of_part[static_cast<std::size_t>(shell.part)];
    }
    shells.push_back(shell);
  }
}

void check_empty_parts(Build& build) {
  for (const RawPart& raw : build.deck.parts) {
    const Index index = build.find_quietly(Item::Part, raw.id);
    if (index == no_index) continue;
    const auto part = static_cast<std::size_t>(index);
    if (build.shells_of_part[part] == 0 && build.solids_of_part[part] == 0 && build.lines_of_part[part] == 0)
      build.report.warning(raw.where, "empty", fmt::format("part {} has no elements", raw.id));
  }
}

}  // namespace crumple::deck
