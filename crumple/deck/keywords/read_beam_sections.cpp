// SPDX-License-Identifier: BSD-3-Clause
// *SECTION_BEAM.
#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/section_cards.hpp"
#include "model/beam_section.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field beam_section_card[] = {
    id("SECID"),
    integer_or_default("ELFORM", 1),
    real_or_default("SHRF", 1, above_zero),  // of integrated beams and spot welds
    real_or_id("QR", IdKind::Other),         // of integrated beams; negative: IRID
    integer("CST", 0, within(0, 2, "0 is a rectangle, 1 a circle or tube, 2 arbitrary")),  // likewise
    real("SCOOR", 0, within(-3, 3, "-3 to 3: which node the axes of discrete beams turn with")),
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

constexpr Field integrated_card[] = {
    real("TS1", 0, not_negative),
    real("TS2", 0, not_negative),
    real("TT1", 0, not_negative),
    real("TT2", 0, not_negative),
    real("NSLOC", 0, within(-1, 1, "a place from -1 to 1, 0 in the middle")),
    real("NTLOC", 0, within(-1, 1, "a place from -1 to 1, 0 in the middle")),
};

constexpr Field discrete_beam_card[] = {
    real("VOL", 0, not_negative),
    real("INER", 0, not_negative),
    reference("CID"),
    real("CA", 0, not_negative),
    real("OFFSET"),
    only("RRCON", {0, 1}, "0: the axes turn about r, 1: they do not"),
    only("SRCON", {0, 1}, "0: the axes turn about s, 1: they do not"),
    only("TRCON", {0, 1}, "0: the axes turn about t, 1: they do not"),
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

/// A number of ELFORM; without a formulation it is one that is not there yet.
struct BeamForm {
  std::int64_t number;
  std::optional<model::BeamFormulation> formulation;
  std::string_view name;
};

constexpr BeamForm beam_forms[] = {
    {2, model::BeamFormulation::BelytschkoSchwer, "the Belytschko-Schwer beam of resultants"},
    {3, model::BeamFormulation::Truss, "the truss"},
    {9, model::BeamFormulation::SpotWeld, "the spot weld beam"},
    {1, model::BeamFormulation::Integrated, "the Hughes-Liu beam, integrated over its section"},
    {4, model::BeamFormulation::Integrated, "the Belytschko-Schwer beam, integrated over its section"},
    {5, model::BeamFormulation::Integrated, "the Belytschko-Schwer tube, integrated over its section"},
    {6, model::BeamFormulation::Discrete, "the discrete beam or cable"},
    {7, {}, "the plane strain shell element in two dimensions"},
    {8, {}, "the axisymmetric shell element in two dimensions"},
    {11, {}, "the Hughes-Liu beam of warped axes"},
    {12, {}, "the resultant warped beam"},
    {13, {}, "the Belytschko-Schwer beam of resultants with shear, small displacements"},
    {14, {}, "the elbow"},
};

/// The formulation of ELFORM; nothing, reported, if it is not supported.
std::optional<model::BeamFormulation> beam_formulation_of(const Card& card, Report& report) {
  if (!card.good("ELFORM")) return {};
  const std::int64_t number = card.integer("ELFORM");
  const auto form = std::find_if(std::begin(beam_forms), std::end(beam_forms),
                                 [&](const BeamForm& f) { return f.number == number; });
  if (form != std::end(beam_forms) && form->formulation) return form->formulation;
  std::string hint = form == std::end(beam_forms) ? "" : fmt::format("{} is {}; ", number, form->name);
  hint += "take ELFORM 1, or give A, ISS, ITT and J of the section with ELFORM 2";
  report.code_unsupported(
      card.where(),
      {"ELFORM", std::string(card.text("ELFORM")),
       "1, 4, 5 (beams integrated over their section), 2 (the Belytschko-Schwer beam of resultants), 3 (the "
       "truss), 6 (the discrete beam) or 9 (the spot weld)",
       hint, "value"});
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

/// The mean of a dimension at both ends: the section is that half way. A second end of zero is as the first.
double mean_of(const Card& size, std::string_view one, std::string_view other) {
  const double first = size.real(one);
  const double second = size.real(other);
  return second > 0 ? 0.5 * (first + second) : first;
}

/// The rule of QR; a faulty one is reported.
model::SectionRule section_rule_of(const Card& first, Report& report) {
  const double number = first.real("QR") == 0 ? 2 : first.real("QR");
  for (int rule = 1; rule <= 5; ++rule)
    if (number == rule) return static_cast<model::SectionRule>(rule);
  report.field_error(first.where(),
                     {"QR", std::string(first.text("QR")), "1 to 5, or minus the id of an *INTEGRATION_BEAM",
                      "1 is one point, 2 and 3 are 2 x 2 and 3 x 3 Gauss points, 4 is 3 x 3 "
                      "Lobatto points, 5 is 4 x 4 Gauss points",
                      "rule"});
  return model::SectionRule::Gauss2;
}

/// Dimensions and points of an integrated beam, or the rule that it takes them from.
void take_integrated_section(const Card& first, const Card& size, RawBeamSection& raw, Report& report) {
  model::BeamSection& section = raw.section;
  section.shear_factor = first.real("SHRF");
  raw.size = {mean_of(size, "TS1", "TS2"), mean_of(size, "TT1", "TT2")};
  raw.reference = {size.real("NSLOC"), size.real("NTLOC")};
  if (!first.good("QR")) return;
  if (first.real("QR") < 0) {
    raw.rule = static_cast<UserId>(-first.real("QR"));
    return;
  }
  if (first.integer("CST") == 2) {
    report.field_error(first.where(), {"CST", std::string(first.text("CST")), "0 or 1 with QR above zero",
                                       "an arbitrary section takes its points from *INTEGRATION_BEAM: give "
                                       "minus its id as QR",
                                       "shape"});
    return;
  }
  const model::SectionRule rule = section_rule_of(first, report);
  const bool is_tube = first.integer("CST") == 1 || first.integer("ELFORM") == 5;
  if (!check_dimension(size, "TS1", is_tube ? "it is the outer diameter" : "it is the width along s", report))
    return;
  if (!is_tube && !check_dimension(size, "TT1", "it is the width along t", report)) return;
  if (is_tube && raw.size[1] >= raw.size[0]) {
    report.field_error(size.where(), {"TT1", std::string(size.text("TT1")), "an inner diameter below TS1",
                                      "the wall of the tube has no thickness", "tube"});
    return;
  }
  auto points = is_tube ? model::tube_points(raw.size[0], raw.size[1], rule)
                        : model::rectangle_points(raw.size[0], raw.size[1], rule);
  const double along_t = is_tube ? raw.size[0] : raw.size[1];
  model::move_nodes(points, 0.5 * raw.reference[0] * raw.size[0], 0.5 * raw.reference[1] * along_t);
  model::set_points(section, std::move(points));
}

void take_discrete_beam(const Card& first, const Card& size, RawBeamSection& raw) {
  model::DiscreteBeamData& data = raw.section.discrete;
  data.volume = size.real("VOL");
  data.inertia = size.real("INER");
  data.cable_area = size.real("CA");
  data.cable_offset = size.real("OFFSET");
  data.place = first.real("SCOOR");
  data.held = {size.real("RRCON") == 1, size.real("SRCON") == 1, size.real("TRCON") == 1};
  if (size.good("CID")) raw.system = size.integer("CID");
}

/// The second card by the formulation of the first.
void read_size(Cards& cards, const Card& first, RawBeamSection& raw) {
  model::BeamSection& section = raw.section;
  if (section.formulation == model::BeamFormulation::Discrete) {
    take_discrete_beam(first, cards.next(discrete_beam_card), raw);
    return;
  }
  if (section.formulation == model::BeamFormulation::Integrated) {
    take_integrated_section(first, cards.next(integrated_card), raw, cards.report());
    return;
  }
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

}  // namespace

bool check_dimension(const Card& size, std::string_view name, std::string_view hint, Report& report) {
  if (!size.good(name)) return false;
  if (size.real(name) > 0) return true;
  report.field_error(size.where(), {name, std::string(size.text(name)), "a number above zero",
                                    std::string(hint), "dimension"});
  return false;
}

void read_section_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawBeamSection raw;
    raw.section.title = cards.heading().title;
    const Card card = cards.next(beam_section_card);
    const std::optional<model::BeamFormulation> formulation = beam_formulation_of(card, cards.report());
    raw.section.id = card.integer("SECID");
    raw.where = card.where();
    raw.order = deck.section_count();
    // Without a formulation the rest cannot be read; the part of the section is left out with its elements.
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
    read_size(cards, card, raw);
    if (card.good("SECID")) deck.beam_sections.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
