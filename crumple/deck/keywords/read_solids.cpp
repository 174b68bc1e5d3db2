// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_SOLID, *SECTION_SOLID.
#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "deck/keywords/families.hpp"
#include "deck/keywords/mirrored.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::array<std::string_view, 8> node_names = {"N1", "N2", "N3", "N4", "N5", "N6", "N7", "N8"};

constexpr Field element_card[] = {
    sized(8, id("EID")),       sized(8, id("PID")),       sized(8, reference("N1")),
    sized(8, reference("N2")), sized(8, reference("N3")), sized(8, reference("N4")),
    sized(8, reference("N5")), sized(8, reference("N6")), sized(8, reference("N7")),
    sized(8, reference("N8")),
};

constexpr Field node_card[] = {
    sized(8, reference("N1")),
    sized(8, reference("N2")),
    sized(8, reference("N3")),
    sized(8, reference("N4")),
    sized(8, reference("N5")),
    sized(8, reference("N6")),
    sized(8, reference("N7")),
    sized(8, reference("N8")),
    sized(8, reference("N9", IdKind::Node)),
    sized(8, reference("N10", IdKind::Node)),
};

constexpr Field section_card[] = {
    id("SECID"),
    integer_or_default("ELFORM", 1),
    only("AET", {0}, "ambient elements are not supported"),
    unused("-"),
    unused("--"),
    unused("---"),
    only("COHOFF", {0}, "only ELFORM 20 and 22 place the layer by it, and they are not supported"),
    only("GASKETT", {0}, "there are no gaskets"),
};

/// A number of ELFORM; without a formulation it is one that is not there yet.
struct NamedForm {
  std::int64_t number;
  std::optional<model::SolidFormulation> formulation;
  std::string_view name;
  std::string_view instead;  ///< hint, or how the formulation deviates
};

constexpr std::string_view take_hexahedron = "take 2, or 1 with hourglass control";
constexpr std::string_view take_tetrahedron = "take 13, or 10, with four nodes";
constexpr std::string_view equal_nodes = "wedges are computed as hexahedra with equal nodes";
constexpr std::string_view as_assumed_strains =
    "bending is freed of shear by assumed strains in elements of any shape, not by factors of their aspect "
    "ratio; results differ where the mesh is coarse";
constexpr std::string_view as_quadratic =
    "computed as 16, with quadratic shape functions, not as composed of tetrahedra with four nodes";
constexpr std::string_view as_selective =
    "computed as 2, without rotations at its nodes or enhanced strains: stiffer in bending where the mesh is "
    "coarse";
constexpr std::string_view as_one_point =
    "computed as 1, with the curves of *MAT_MODIFIED_HONEYCOMB over the nominal strain; forces act on the "
    "deformed hexahedron, not on the first one";
constexpr std::string_view take_cohesive =
    "take 19; forces act at the nodes of the shells, in their middle surfaces, without moments";
constexpr std::string_view take_cohesive_wedge = "take 19, with N4 the same as N3 and N8 the same as N7";
constexpr std::string_view no_substitute = "there is nothing like it here";

constexpr NamedForm forms[] = {
    {1, model::SolidFormulation::OnePointHexahedron, "the hexahedron with one point", ""},
    {-2, model::SolidFormulation::AssumedStrainHexahedron,
     "the fully integrated hexahedron for poor aspect ratios, accurate form", as_assumed_strains},
    {-1, model::SolidFormulation::AssumedStrainHexahedron,
     "the fully integrated hexahedron for poor aspect ratios, efficient form", as_assumed_strains},
    {2, model::SolidFormulation::SelectiveHexahedron, "the selectively reduced hexahedron", ""},
    {3, model::SolidFormulation::SelectiveHexahedron, "the hexahedron with rotations at its nodes",
     as_selective},
    {4, {}, "the tetrahedron with rotations at its nodes", take_tetrahedron},
    {5, {}, "the ALE hexahedron", "take 1, the mesh then moves with the material"},
    {6, {}, "the Eulerian hexahedron", no_substitute},
    {7, {}, "the ambient Eulerian hexahedron", no_substitute},
    {9, model::SolidFormulation::OnePointHexahedron, "the one-point hexahedron for crushed honeycomb",
     as_one_point},
    {10, model::SolidFormulation::Tetrahedron, "the tetrahedron with one point", ""},
    {11, {}, "the multi-material ALE hexahedron", no_substitute},
    {12, {}, "the multi-material ALE hexahedron with void", no_substitute},
    {13, model::SolidFormulation::NodalPressureTetrahedron, "the tetrahedron with averaged nodal pressure",
     ""},
    {15, model::SolidFormulation::SelectiveHexahedron, "the wedge with two points", equal_nodes},
    {16, model::SolidFormulation::QuadraticTetrahedron, "the ten-node tetrahedron", ""},
    {17, model::SolidFormulation::QuadraticTetrahedron, "the composite ten-node tetrahedron", as_quadratic},
    {18, model::SolidFormulation::SelectiveHexahedron, "the hexahedron for linear statics", as_selective},
    {19, model::SolidFormulation::CohesiveHexahedron, "the cohesive hexahedron", ""},
    {20, {}, "the cohesive hexahedron with offsets for shells", take_cohesive},
    {21, {}, "the cohesive wedge", take_cohesive_wedge},
    {22, {}, "the cohesive wedge with offsets for shells", take_cohesive_wedge},
    {115, model::SolidFormulation::OnePointHexahedron, "the wedge with one point", equal_nodes},
};

/// The formulation of ELFORM; another than the supported ones is reported.
model::SolidFormulation formulation_of(const Card& card, Report& report) {
  if (!card.good("ELFORM")) return model::SolidFormulation::OnePointHexahedron;
  const std::int64_t number = card.integer("ELFORM");
  const auto form = std::find_if(std::begin(forms), std::end(forms),
                                 [&](const NamedForm& f) { return f.number == number; });
  if (form != std::end(forms) && form->formulation) {
    if (!form->instead.empty())
      report.field_warning(card.where(),
                           {"ELFORM", std::string(card.text("ELFORM")), "1, 2, 10, 13, 16 or 19",
                            fmt::format("of {}: {}", form->name, form->instead), "formulation"});
    return *form->formulation;
  }
  std::string supported;
  for (const NamedForm& row : forms)
    if (row.formulation && row.instead.empty())
      supported += fmt::format("{}{} ({})", supported.empty() ? "" : ", ", row.number, row.name);
  const std::string hint = form == std::end(forms)
                               ? std::string(take_hexahedron)
                               : fmt::format("{} is {}; {}", number, form->name, form->instead);
  report.code_unsupported(card.where(),
                          {"ELFORM", std::string(card.text("ELFORM")), supported, hint, "value"});
  // Its material is cohesive: that should not be a second error.
  const bool cohesive = number >= 20 && number <= 22;
  return cohesive ? model::SolidFormulation::CohesiveHexahedron : model::SolidFormulation::OnePointHexahedron;
}

/// Nodes that are left out at the end repeat the last one: four make a tetrahedron, five a pyramid. False,
/// with a message, if the rest does not make an element.
bool complete_nodes(RawSolid& solid, Report& report) {
  const auto end = std::find(solid.node.begin(), solid.node.end(), 0);
  const auto given = static_cast<std::size_t>(end - solid.node.begin());
  if (given == solid.node.size()) return true;
  const auto later = std::find_if(end, solid.node.end(), [](UserId node) { return node != 0; });
  FieldFault fault{node_names[given], "0", "the id of a node", {}, "left out"};
  if (later != solid.node.end())
    fault.hint = "only the last nodes of tetrahedra (N5 to N8) and pyramids (N6 to N8) may be left out";
  else if (given < 4)
    fault.hint = "a solid has at least four nodes";
  else if (given > 5)
    fault.hint = "a wedge is N1, N2, N3, N4, N5, N5, N6, N6, a hexahedron has eight nodes";
  if (!fault.hint.empty()) {
    report.field_error(solid.nodes_where, fault);
    return false;
  }
  std::fill(end, solid.node.end(), solid.node[given - 1]);
  return true;
}

/// N5 to N10 of a card with all ten. False, with a message, if some of them are missing.
bool take_middles(const Card& card, RawSolid& solid, Report& report) {
  constexpr std::array<std::string_view, 6> names = {"N5", "N6", "N7", "N8", "N9", "N10"};
  if (!card.good("N9") || !card.good("N10")) return false;
  if (card.integer("N9") == 0 && card.integer("N10") == 0) return true;
  for (std::size_t i = 0; i < names.size(); ++i) {
    solid.middle[i] = card.integer(names[i]);
    if (solid.middle[i] != 0) continue;
    report.field_error(
        card.where(), {names[i], "0", "the id of a node",
                       "a tetrahedron with ten nodes has N5 to N10 in the middle of its sides; leave out all "
                       "six of them, or none",
                       "left out"});
    return false;
  }
  std::fill(solid.node.begin() + 4, solid.node.end(), solid.node[3]);
  return true;
}

/// True if all of them could be read.
bool take_nodes(const Card& card, RawSolid& solid) {
  bool good = true;
  for (std::size_t i = 0; i < node_names.size(); ++i) {
    good = good && card.good(node_names[i]);
    solid.node[i] = card.integer(node_names[i]);
  }
  solid.nodes_where = card.where();
  return good;
}

}  // namespace

void read_element_solid(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(element_card);
    RawSolid solid;
    solid.id = card.integer("EID");
    solid.part = card.integer("PID");
    solid.where = card.where();
    bool good = take_nodes(card, solid);
    // A first card without nodes has them on the next one.
    const bool no_nodes =
        std::all_of(solid.node.begin(), solid.node.end(), [](UserId node) { return node == 0; });
    if (good && no_nodes) {
      const Card second = cards.next(node_card);
      good = take_nodes(second, solid) && take_middles(second, solid, cards.report());
    }
    if (!good || !card.good("EID") || !card.good("PID")) continue;
    if (!complete_nodes(solid, cards.report())) continue;
    if (cards.placement().map.mirrors()) {
      mirror_solid(solid.node);
      mirror_middles(solid.middle);
    }
    deck.solids.push_back(solid);
  }
}

void read_section_solid(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawSolidSection raw;
    raw.section.title = cards.heading().title;
    const Card card = cards.next(section_card);
    raw.section.id = card.integer("SECID");
    raw.section.formulation = formulation_of(card, cards.report());
    // 0 and a blank field are one for LS-DYNA.
    const std::string_view form = card.text("ELFORM");
    raw.section.nominal_strain = form.empty() || form == "0" || form == "9";
    raw.where = card.where();
    raw.order = deck.section_count();
    if (card.good("SECID")) deck.solid_sections.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
