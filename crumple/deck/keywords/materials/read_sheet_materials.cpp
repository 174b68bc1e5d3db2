// SPDX-License-Identifier: BSD-3-Clause
// *MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC, *MAT_3-PARAMETER_BARLAT.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

/// Strain up to which linear hardening is tabulated.
constexpr double end_of_line = 10;

constexpr Field normal_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("SIGY", 0, not_negative),
    real("ETAN", 0, not_negative),
    real("R"),  // below zero: its amount, with a warning
    reference("HLCID", IdKind::Function),
};

constexpr std::string_view sheet_hardening_rules =
    "1 is linear, 2 a power of the strain, 3 a curve; others become a curve, HR = 3 with LCID";

constexpr Field barlat_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    Field{"HR", FieldType::Real, 1, check_of(Check::Kind::Only, {1, 2, 3}, sheet_hardening_rules), true},
    real("P1", 0, not_negative),
    real("P2", 0, not_negative),
    unused("ITER"),  // the return is iterated to its end
};
constexpr Field barlat_second_card[] = {
    real("M", 0, within(2, 20, "the exponent of the yield surface, 6 for bcc and 8 for fcc metals")),
    real("R00", 0, above_zero),
    real("R45", 0, above_zero),
    real("R90", 0, above_zero),
    reference("LCID"),
    real("E0", 0, not_negative),
    real("SPI", 0, not_negative),
    unused("P3"),  // of HR = 5 and 6
};
constexpr std::string_view no_heat_treatment = "there is no heat treatment";
constexpr Field barlat_third_card[] = {
    only("AOPT", {0, 2, 3},
         "0 is along the side from N1 to N2, 2 along the vector a, 3 along v x normal of the shell"),
    real("C", 0, not_negative),
    real("P", 0, not_negative),
    only("VLCID", {0}, "plastic flow keeps the volume"),
    unused("NONE"),
    only("PB", {0}, "the yield surface follows from R00, R45 and R90; give those"),
    only("HTA", {0}, no_heat_treatment),
    only("HTB", {0}, no_heat_treatment),
};
constexpr Field barlat_fourth_card[] = {
    unused("XP"),
    unused("YP"),
    unused("ZP"),  // of AOPT = 1 and 4
    direction(real("A1")),
    direction(real("A2")),
    direction(real("A3")),
    only("HTC", {0}, no_heat_treatment),
    only("HTD", {0}, no_heat_treatment),
};
constexpr Field barlat_fifth_card[] = {
    direction(real("V1")), direction(real("V2")),
    direction(real("V3")), unused("D1"),
    unused("D2"),          unused("D3"),
    real("BETA"),          only("HTFLAG", {0}, no_heat_treatment),
};
constexpr Field barlat_sixth_card[] = {
    only("USRFAIL", {0}, "there are no user's subroutines"),
    unused("LCBI"),  // of HR = 7
    unused("LCSH"),
};

void hardening_fault(const Card& card, std::string_view field, std::string_view expected, std::string why,
                     Report& report) {
  report.field_error(card.where(), {field, std::string(card.text(field)), std::string(expected),
                                    std::move(why), "hardening"});
}

void set_sheet_line(double yield_stress, double slope, model::SheetPlasticity& law) {
  law.plastic_strain = {0, end_of_line};
  law.yield_stress = {yield_stress, yield_stress + slope * end_of_line};
}

void take_sheet_line(const Card& card, model::SheetPlasticity& law, Report& report) {
  const double tangent = card.real("P1");
  const double yield = card.real("P2");
  if (card.good("P1") && card.good("E") && !(tangent < card.real("E")))
    hardening_fault(card, "P1", "a tangent modulus below E",
                    "with HR = 1 it is the slope over the whole strain", report);
  else if (card.good("P2") && !(yield > 0))
    hardening_fault(card, "P2", "a yield stress above zero", "with HR = 1 it is the yield stress", report);
  else
    set_sheet_line(yield, card.real("E") * tangent / (card.real("E") - tangent), law);
}

/// e_y of HR = 2: E0, or by SPI as SIGY of *MAT_POWER_LAW_PLASTICITY.
double sheet_yield_strain(const Card& card, const Card& second) {
  constexpr double largest_strain = 0.02;
  const double spi = second.real("SPI");
  const double strength = card.real("P1");
  const double exponent = card.real("P2");
  if (second.real("E0") > 0) return second.real("E0");
  if (spi > 0 && spi <= largest_strain) return spi;
  return spi > 0 ? std::pow(spi / strength, 1 / exponent)
                 : std::pow(card.real("E") / strength, 1 / (exponent - 1));
}

void take_sheet_power(const Card& card, const Card& second, model::SheetPlasticity& law, Report& report) {
  if (!(card.real("P1") > 0)) {
    hardening_fault(card, "P1", "a number above zero", "with HR = 2 it is the strength coefficient k",
                    report);
    return;
  }
  if (!(card.real("P2") > 0 && card.real("P2") < 1)) {
    hardening_fault(card, "P2", "a number between 0 and 1", "with HR = 2 it is the exponent n", report);
    return;
  }
  law.strength = card.real("P1");
  law.hardening_exponent = card.real("P2");
  law.yield_strain = sheet_yield_strain(card, second);
  if (!(law.yield_strain > 0 && law.yield_strain < 1))
    hardening_fault(second, "SPI", "a strain at yield up to 0.02 or a yield stress below P1",
                    fmt::format("the strain at yield comes out as {:.4g}", law.yield_strain), report);
}

/// R; LS-DYNA takes its amount where it is negative.
double anisotropy(const Card& card, Report& report) {
  const double read = card.real("R");
  if (read == 0 && card.good("R"))
    report.field_error(card.where(),
                       {"R", std::string(card.text("R")), "a number other than zero",
                        "it is the strain over the width over that through the thickness", "anisotropy"});
  if (read < 0)
    report.field_warning(card.where(), {"R", std::string(card.text("R")), "a number above zero",
                                        "its amount is taken, and the stress across the sheet, which "
                                        "LS-DYNA then has, stays zero",
                                        "sign"});
  return std::fabs(read);
}

}  // namespace

void read_mat_transversely_anisotropic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(normal_card);
    RawMaterial raw = material_of(heading, card);
    model::SheetPlasticity law;
    law.is_normal = true;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.r00 = law.r45 = law.r90 = anisotropy(card, cards.report());
    raw.hardening_curve = card.good("HLCID") ? card.integer("HLCID") : 0;
    raw.curve_where = card.where();
    set_sheet_line(1, 0, law);
    if (raw.hardening_curve == 0 && card.good("SIGY") && card.good("HLCID")) {
      if (card.real("SIGY") > 0)
        set_sheet_line(card.real("SIGY"), card.real("ETAN"), law);
      else
        hardening_fault(card, "SIGY", "a yield stress above zero, or HLCID", "there is no curve",
                        cards.report());
    }
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_barlat(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(barlat_card);
    const Card second = cards.next(barlat_second_card);
    const Card third = cards.next(barlat_third_card);
    const Card fourth = cards.next(barlat_fourth_card);
    const Card fifth = cards.next(barlat_fifth_card);
    // Further cards end with the keyword, so that only one material may have one.
    cards.next_or_default(barlat_sixth_card);
    RawMaterial raw = material_of(heading, card);
    model::SheetPlasticity law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.yield_exponent = second.real("M");
    law.r00 = second.real("R00");
    law.r45 = second.real("R45");
    law.r90 = second.real("R90");
    law.cowper_symonds_rate = third.real("C");
    law.cowper_symonds_exponent = third.real("P");
    check_rate(third, "C", "P", cards.report());
    law.axes.angle = fifth.real("BETA") * std::numbers::pi / 180;
    if (cards.placement().map.mirrors()) law.axes.angle = -law.axes.angle;
    take_direction(third, fourth, fifth, law.axes, cards.report());
    raw.curve_where = second.where();
    set_sheet_line(1, 0, law);
    const double rule = card.real("HR");
    if (rule == 1 && card.good("HR")) {
      take_sheet_line(card, law, cards.report());
    } else if (rule == 2) {
      take_sheet_power(card, second, law, cards.report());
      if (law.strength > 0) law.plastic_strain = law.yield_stress = {};
    } else if (rule == 3 && second.good("LCID")) {
      raw.hardening_curve = second.integer("LCID");
      if (raw.hardening_curve == 0)
        hardening_fault(second, "LCID", "a curve", "with HR = 3 it is the hardening", cards.report());
    }
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
