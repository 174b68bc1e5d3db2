// SPDX-License-Identifier: BSD-3-Clause
// *PART, *SECTION_SHELL, *HOURGLASS.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/rigid_inertia.hpp"
#include "deck/keywords/shell_formulations.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field part_card[] = {
    id("PID"),
    reference("SECID"),
    reference("MID"),
    reference("EOSID"),
    reference("HGID"),
    only("GRAV", {0}, "initialisation by gravity is not supported"),
    only("ADPOPT", {0}, "adaptive meshes are not supported"),
    harmless("TMID", {0}, "there is no thermal solution"),
};

constexpr Field part_contact_card[] = {
    real("FS", 0, not_negative),
    real("FD", 0, not_negative),
    real("DC", 0, not_negative),
    real("VC", 0, not_negative),
    real("OPTT", 0, not_negative),
    real_or_default("SFT", 1, above_zero),
    only("SSF", {0, 1}, "the stiffness is scaled by SFS and SFM of the contact"),
    only("CPARM8", {0}, "all edges and beams take part"),
};

// What LS-DYNA prints of the part.
constexpr Field part_print_card[] = {unused("PRBF")};

constexpr Field section_card[] = {
    id("SECID"),
    real("ELFORM"),  // checked_formulation()
    real_or_default("SHRF", 1.0, above_zero),
    integer_or_default("NIP", 2, within(1, 20, "points through the thickness")),
    unused("PROPT"),                  // what LS-DYNA prints
    real_or_id("QR", IdKind::Other),  // 0 is Gauss, 1 trapezoidal, negative a rule of *INTEGRATION_SHELL
    only("ICOMP", {0, 1}, "1 gives each point an angle, B1, B2, ..."),
    unused("SETYP"),  // for two-dimensional elements
};

constexpr Field section_thickness_card[] = {
    real("T1", 0, not_negative),
    real("T2", 0, not_negative),
    real("T3", 0, not_negative),
    real("T4", 0, not_negative),
    real("NLOC", 0, within(-1, 1, "1 is the upper surface, 0 the mid-surface, -1 the lower one")),
    only("MAREA", {0}, "use *ELEMENT_MASS for mass that is not structural"),
    unused("IDOF"),    // for other formulations
    unused("EDGSET"),  // for two-dimensional seatbelts
};

constexpr Field angle_card[] = {
    real("B1"), real("B2"), real("B3"), real("B4"), real("B5"), real("B6"), real("B7"), real("B8"),
};

constexpr Field hourglass_card[] = {
    id("HGID"),
    only("IHQ", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, hourglass_forms),
    real_or_default("QM", 0.1, not_negative),
    unused("IBQ"),                // LS-DYNA does not use it either: solids always have bulk viscosity
    real("Q1", 0, not_negative),  // default CONTROL_BULK_VISCOSITY's
    real("Q2", 0, not_negative),
    real("QB", 0, not_negative),  // default QM
    real("QW", 0, not_negative),  // default QB
};

/// QR: a rule of its own, or the number of one.
void take_rule(const Card& card, RawSection& raw, Report& report) {
  const double rule = card.real("QR");
  if (rule == 1) raw.section.thickness_rule = model::ThicknessRule::Trapezoid;
  if (rule < 0)
    raw.integration_rule = -static_cast<UserId>(rule);
  else if (rule != 0 && rule != 1)
    report.field_unsupported(card.where(), {"QR", std::string(card.text("QR")), "0, 1 or a negative number",
                                            "0 is Gauss, 1 trapezoidal, a negative number is one of "
                                            "*INTEGRATION_SHELL",
                                            "rule"});
}

/// The angles of ICOMP = 1, eight on a card.
std::vector<double> read_angles(Cards& cards, int points) {
  std::vector<double> angles;
  const double sign = cards.placement().map.mirrors() ? -1 : 1;
  while (static_cast<int>(angles.size()) < points) {
    const Card card = cards.next(angle_card);
    for (std::size_t i = 0; i < std::size(angle_card) && static_cast<int>(angles.size()) < points; ++i)
      angles.push_back(sign * card.real(angle_card[i].name) * std::numbers::pi / 180);
  }
  return angles;
}

/// Gauss and Lobatto rules are made for ten points at most.
void check_points(const Card& card, const RawSection& raw, Report& report) {
  const model::ShellSection& section = raw.section;
  if (raw.integration_rule != 0) return;
  const bool trapezoid = section.thickness_rule == model::ThicknessRule::Trapezoid;
  if (!card.good("NIP") || !card.good("QR")) return;
  if (!trapezoid && section.thickness_points > 10)
    report.field_error(card.where(), {"NIP", std::string(card.text("NIP")), "1 to 10 points",
                                      "more than ten points take the trapezoidal rule, QR = 1", "points"});
  if (trapezoid && section.thickness_points < 2)
    report.field_error(card.where(), {"NIP", std::string(card.text("NIP")), "2 to 20 points",
                                      "the trapezoidal rule has a point on each surface", "points"});
}

/// Forms of solids that add a stiffness by assumed strains.
bool is_assumed_strain(double form) {
  return form == 6 || form == 7 || form == 9 || form == 10;
}

}  // namespace

model::ShellFormulation shell_formulation(std::int64_t number) {
  using enum model::ShellFormulation;
  switch (number) {
    case 1:
      return HughesLiu;
    case 4:
      return Triangle;
    case 5:
      return Membrane;
    case 6:
      return HughesLiuSelectiveReduced;
    case 9:
      return FullyIntegratedMembrane;
    case 10:
      return BelytschkoWongChiang;
    case 16:
      return FullyIntegrated;
    default:
      return BelytschkoTsay;
  }
}

bool is_shell_formulation(double number) {
  constexpr std::array<double, 9> supported = {0, 1, 2, 4, 5, 6, 9, 10, 16};
  return std::find(supported.begin(), supported.end(), number) != supported.end();
}

std::int64_t checked_formulation(const Card& card, std::string_view field, Report& report) {
  const double number = card.real(field);
  if (is_shell_formulation(number)) return static_cast<std::int64_t>(number);
  report.field_unsupported(card.where(),
                           {field, std::string(card.text(field)), std::string(supported_formulations),
                            std::string(meaning_of_formulations), "formulation"});
  return 0;
}

void warn_of_hourglass_form(const Card& card, Report& report) {
  if (!card.good("IHQ") || card.real("IHQ") == 6 || !is_assumed_strain(card.real("IHQ"))) return;
  report.field_warning(
      card.where(),
      {"IHQ", std::string(card.text("IHQ")), "0 to 6 or 8",
       "computed as 6, assumed strains with a stiffness in rates: the others differ from it in large "
       "strains and in distorted elements",
       "form"});
}

void warn_of_hourglass_coefficient(const Card& card, std::string_view field, Report& report) {
  // LS-DYNA Keyword User's Manual, *HOURGLASS and *CONTROL_HOURGLASS. With IHQ 6 one is the whole stiffness
  // of the material.
  const bool assumed_strain = card.good("IHQ") && is_assumed_strain(card.real("IHQ"));
  const double largest = assumed_strain ? 1 : 0.15;
  if (card.good(field) && card.real(field) > largest)
    report.field_warning(card.where(), {field, std::string(card.text(field)),
                                        assumed_strain ? "a coefficient up to 1" : "a coefficient up to 0.15",
                                        "it is used, and the run may become unstable", "coefficient"});
}

model::HourglassForm hourglass_form(std::int64_t number) {
  return (number >= 4 && number <= 6) || is_assumed_strain(static_cast<double>(number))
             ? model::HourglassForm::Stiffness
             : model::HourglassForm::Viscous;
}

model::SolidHourglassForm solid_hourglass_form(std::int64_t number) {
  using enum model::SolidHourglassForm;
  switch (number) {
    case 1:
      return StandardViscous;
    case 3:
      return ExactVolumeViscous;
    case 4:
      return FlanaganBelytschkoStiffness;
    case 5:
      return ExactVolumeStiffness;
    case 6:
    case 7:
    case 9:
    case 10:
      return AssumedStrain;
    default:
      return FlanaganBelytschkoViscous;
  }
}

void read_part_contact(Cards& cards, RawPart& part) {
  if (cards.where().keyword.find("_CONTACT") == std::string_view::npos) return;
  const Card contact = cards.next(part_contact_card);
  part.contact_thickness = contact.real("OPTT");
  part.contact_thickness_scale = contact.real("SFT");
  part.friction = {contact.real("FS"), contact.real("FD"), contact.real("DC"), contact.real("VC")};
}

namespace {

void read_parts(Cards& cards, RawDeck& deck, bool with_inertia) {
  while (cards.more()) {
    RawPart part;
    part.title = cards.text_line("the title of a part");
    const Card card = cards.next(part_card);
    part.id = card.integer("PID");
    part.section = card.good("SECID") ? card.integer("SECID") : RawPart::unreadable;
    part.material = card.good("MID") ? card.integer("MID") : RawPart::unreadable;
    part.equation_of_state = card.good("EOSID") ? card.integer("EOSID") : 0;
    part.hourglass = card.good("HGID") ? card.integer("HGID") : 0;
    part.where = card.where();
    if (with_inertia) part.inertia = read_inertia(cards);
    read_part_contact(cards, part);
    if (cards.where().keyword.ends_with("_PRINT")) cards.next(part_print_card);
    if (card.good("PID")) deck.parts.push_back(std::move(part));
  }
}

}  // namespace

void read_part(Cards& cards, RawDeck& deck) {
  read_parts(cards, deck, false);
}

void read_part_inertia(Cards& cards, RawDeck& deck) {
  read_parts(cards, deck, true);
}

void read_section_shell(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawSection raw;
    raw.section.title = cards.heading().title;
    const Card card = cards.next(section_card);
    const Card second = cards.next(section_thickness_card);
    raw.section.id = card.integer("SECID");
    const std::int64_t formulation = checked_formulation(card, "ELFORM", cards.report());
    raw.formulation_given = formulation != 0;
    raw.section.formulation = shell_formulation(formulation);
    raw.section.shear_factor = card.real("SHRF");
    raw.section.thickness_points = card.good("NIP") ? static_cast<int>(card.integer("NIP")) : 2;
    raw.section.node_place = second.real("NLOC");
    raw.rule_where = card.where();
    take_rule(card, raw, cards.report());
    check_points(card, raw, cards.report());
    raw.section.thickness = {second.real("T1"), second.real("T2"), second.real("T3"), second.real("T4")};
    for (std::size_t i = 1; i < 4; ++i)
      if (raw.section.thickness[i] == 0) raw.section.thickness[i] = raw.section.thickness[0];
    raw.thickness_good = second.good("T1") && second.good("T2") && second.good("T3") && second.good("T4");
    if (card.real("ICOMP") == 1) raw.angles = read_angles(cards, raw.section.thickness_points);
    raw.where = second.where();
    raw.order = deck.section_count();
    if (card.good("SECID")) deck.sections.push_back(std::move(raw));
  }
}

void read_hourglass(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next(hourglass_card);
    RawHourglass raw;
    raw.id = card.integer("HGID");
    raw.control.form = hourglass_form(static_cast<std::int64_t>(card.real("IHQ")));
    raw.control.solid_form = solid_hourglass_form(static_cast<std::int64_t>(card.real("IHQ")));
    warn_of_hourglass_form(card, cards.report());
    raw.control.coefficient = card.real("QM");
    raw.control.bulk_quadratic = card.real("Q1");
    raw.control.bulk_linear = card.real("Q2");
    raw.control.bending = card.real("QB") != 0 ? card.real("QB") : raw.control.coefficient;
    raw.control.warping = card.real("QW") != 0 ? card.real("QW") : raw.control.bending;
    for (const std::string_view field : {"QM", "QB", "QW"})
      warn_of_hourglass_coefficient(card, field, cards.report());
    raw.where = card.where();
    if (card.good("HGID")) deck.hourglasses.push_back(raw);
  }
}

}  // namespace crumple::deck
