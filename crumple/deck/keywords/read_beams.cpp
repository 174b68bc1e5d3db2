// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_BEAM, *SECTION_BEAM, *MAT_RESULTANT_PLASTICITY.
#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_release = "released degrees of freedom are not supported; the ends are rigid";

constexpr Field element_card[] = {
    sized(8, id("EID")),
    sized(8, id("PID")),
    sized(8, id("N1")),
    sized(8, id("N2")),
    sized(8, reference("N3")),
    sized(8, only("RT1", {0}, no_release)),
    sized(8, only("RR1", {0}, no_release)),
    sized(8, only("RT2", {0}, no_release)),
    sized(8, only("RR2", {0}, no_release)),
    sized(8, unused("LOCAL")),  // axes of the releases
};

constexpr Field orientation_card[] = {direction(real("VX")), direction(real("VY")), direction(real("VZ"))};

constexpr Field section_card[] = {
    id("SECID"),
    integer_or_default("ELFORM", 1),
    real_or_default("SHRF", 1, above_zero),  // of spot welds
    unused("QR"),                            // of integrated beams
    integer("CST", 0, within(0, 2, "0 is a rectangle, 1 a circle or tube, 2 arbitrary")),  // of spot welds
    unused("SCOOR"),  // of discrete beams
    only("NSM", {0}, "use *ELEMENT_MASS for mass that is not structural"),
    unused("NAUPD"),  // of discrete beams
};

constexpr Field resultant_card[] = {
    real("A", 0, above_zero),    real("ISS", 0, above_zero),
    real("ITT", 0, above_zero),  real("J", 0, not_negative),  // zero: ISS + ITT
    real("SA", 0, not_negative),
};

constexpr Field truss_card[] = {
    real("A", 0, above_zero),
    only("RAMPT", {0}, "there is no dynamic relaxation with an initial stress"),
    only("STRESS", {0}, "there is no dynamic relaxation with an initial stress"),
};

constexpr Field weld_card[] = {
    real("TS1", 0, above_zero),
    real("TS2", 0, not_negative),
    real("TT1", 0, not_negative),
    real("TT2", 0, not_negative),
    unused("PRINT"),  // output
    unused("-"),
    only("ITOFF", {0}, "welds twist elastically and plastically"),
};

constexpr Field resultant_plasticity_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("YIELD", 0, above_zero),
    unused("ETAN"),  // of shells
};

/// A number of ELFORM; without a formulation it is one that is not there yet.
struct NamedForm {
  std::int64_t number;
  std::optional<model::BeamFormulation> formulation;
  std::string_view name;
};

constexpr NamedForm forms[] = {
    {2, model::BeamFormulation::BelytschkoSchwer, "the Belytschko-Schwer beam of resultants"},
    {3, model::BeamFormulation::Truss, "the truss"},
    {9, model::BeamFormulation::SpotWeld, "the spot weld beam"},
    {1, {}, "the Hughes-Liu beam, integrated over its section (the default)"},
    {4, {}, "the Belytschko-Schwer beam, integrated over its section"},
    {5, {}, "the Belytschko-Schwer tube, integrated over its section"},
    {6, {}, "the discrete beam or cable"},
    {7, {}, "the plane strain shell element in two dimensions"},
    {8, {}, "the axisymmetric shell element in two dimensions"},
    {11, {}, "the Hughes-Liu beam of warped axes"},
    {12, {}, "the resultant warped beam"},
    {13, {}, "the Belytschko-Schwer beam of resultants with shear, small displacements"},
    {14, {}, "the elbow"},
};

/// The formulation of ELFORM; nothing, reported, if it is not supported.
std::optional<model::BeamFormulation> formulation_of(const Card& card, Report& report) {
  if (!card.good("ELFORM")) return {};
  const std::int64_t number = card.integer("ELFORM");
  const auto form = std::find_if(std::begin(forms), std::end(forms),
                                 [&](const NamedForm& f) { return f.number == number; });
  if (form != std::end(forms) && form->formulation) return form->formulation;
  std::string hint = form == std::end(forms) ? "" : fmt::format("{} is {}; ", number, form->name);
  hint += "give A, ISS, ITT and J of the section with ELFORM 2";
  report.code_unsupported(
      card.where(),
      {"ELFORM", std::string(card.text("ELFORM")),
       "2 (the Belytschko-Schwer beam of resultants), 3 (the truss) or 9 (the spot weld)", hint, "value"});
  return {};
}

/// A standard cross section has its name in the place of the area.
bool names_a_shape(const Cards& cards) {
  return cards.peek().find("SECTION_") != std::string_view::npos;
}

/// The section of a spot weld, a circle of diameter TS1 or a tube whose inner diameter is TT1.
void take_weld_section(const Card& first, const Card& size, model::BeamSection& section, Report& report) {
  const double outer = size.real("TS1");
  const double inner = size.real("TT1");
  // A rectangle without a width is meant as a circle.
  if (first.integer("CST") == 2 || (first.integer("CST") == 0 && inner > 0))
    report.field_unsupported(first.where(),
                             {"CST", std::string(first.text("CST")), "1", "spot welds are round", "shape"});
  for (const auto& [one, other] : {std::pair{"TS1", "TS2"}, std::pair{"TT1", "TT2"}})
    if (size.real(other) != 0 && size.real(other) != size.real(one))
      report.field_unsupported(size.where(),
                               {other, std::string(size.text(other)), "zero or that of the first end",
                                "spot welds have one diameter", "taper"});
  if (size.good("TS1") && size.good("TT1") && inner >= outer)
    report.field_error(size.where(), {"TT1", std::string(size.text("TT1")), "an inner diameter below TS1",
                                      "the wall of the tube has no thickness", "tube"});
  const double square = outer * outer - inner * inner;
  section.area = 0.25 * std::numbers::pi * square;
  section.inertia_s = section.inertia_t = std::numbers::pi / 64 * square * (outer * outer + inner * inner);
  section.torsion = 2 * section.inertia_s;
  section.shear_area = first.real("SHRF") * section.area;
}

/// The second card by the formulation of the first.
void read_size(Cards& cards, const Card& first, model::BeamSection& section) {
  if (section.formulation == model::BeamFormulation::SpotWeld) {
    take_weld_section(first, cards.next(weld_card), section, cards.report());
    return;
  }
  const bool truss = section.formulation == model::BeamFormulation::Truss;
  const Card size = cards.next(truss ? Layout(truss_card) : Layout(resultant_card));
  section.area = size.real("A");
  if (truss) return;
  section.inertia_s = size.real("ISS");
  section.inertia_t = size.real("ITT");
  section.torsion = size.real("J") > 0 ? size.real("J") : size.real("ISS") + size.real("ITT");
  section.shear_area = size.real("SA");
}

RawBeam beam_of(const Card& card) {
  RawBeam beam;
  beam.id = card.integer("EID");
  beam.part = card.integer("PID");
  beam.node = {card.integer("N1"), card.integer("N2")};
  beam.orientation_node = card.good("N3") ? card.integer("N3") : 0;
  beam.where = card.where();
  return beam;
}

bool has_ids(const Card& card) {
  return card.good("EID") && card.good("PID") && card.good("N1") && card.good("N2");
}

}  // namespace

void read_element_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(element_card);
    if (has_ids(card)) deck.beams.push_back(beam_of(card));
  }
}

void read_element_beam_orientation(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(element_card);
    const Card vector = cards.next(orientation_card);
    RawBeam beam = beam_of(card);
    beam.orientation = {vector.real("VX"), vector.real("VY"), vector.real("VZ")};
    if (has_ids(card)) deck.beams.push_back(beam);
  }
}

void read_section_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawBeamSection raw;
    raw.section.title = cards.heading().title;
    const Card card = cards.next(section_card);
    const std::optional<model::BeamFormulation> formulation = formulation_of(card, cards.report());
    raw.section.id = card.integer("SECID");
    raw.where = card.where();
    raw.order = deck.section_count();
    // Without a formulation the rest cannot be told; the part of the section is left out with its elements.
    if (!formulation || names_a_shape(cards)) {
      if (formulation)
        cards.report().unsupported(
            card.where(), "shape",
            "standard cross sections (SECTION_01 and so on) are not supported; give A, "
            "ISS, ITT and J instead");
      cards.skip_rest();
      if (card.good("SECID")) deck.unsupported.push_back({raw.section.id, card.where()});
      return;
    }
    raw.section.formulation = *formulation;
    read_size(cards, card, raw.section);
    if (card.good("SECID")) deck.beam_sections.push_back(std::move(raw));
  }
}

void read_mat_resultant_plasticity(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(resultant_plasticity_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = model::ResultantPlasticity{card.real("E"), card.real("PR"), card.real("YIELD")};
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
