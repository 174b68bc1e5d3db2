// SPDX-License-Identifier: BSD-3-Clause
// *MAT_FABRIC.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field fabric_card[] = {
    id("MID"),    real("RO", 0, above_zero), real("EA", 0, above_zero), real("EB", 0, not_negative),
    unused("EC"),  // of older manuals
    real("PRBA"),
    real("PRAB"),  // that follows from PRBA
};

constexpr Field fabric_second_card[] = {
    real("GAB", 0, not_negative),
    unused("GBC"),  // of older manuals: membranes have no shear across
    unused("GCA"),
    only("CSE", {0, 1}, "1 leaves no pressure in the fabric"),
    real("EL", 0, not_negative),
    real("PRL", 0, poisson),
    real("LRATIO", 0, within(0, 1, "the liner's share of the thickness")),
    real("DAMP", 0, within(0, 1, "a share of the critical damping")),
};

constexpr Field fabric_third_card[] = {
    only("AOPT", {0, 2, 3},
         "0 is along the side from N1 to N2, 2 along the vector a, 3 along v x normal of the shell"),
    real_or_id("FLC", IdKind::Function),
    real_or_id("FAC", IdKind::Function),
    unused("ELA"),  // of blocked fabric
    only("LNRC", {0}, "the liner bears pressure from the beginning on"),
    only(
        "FORM", {0, 1},
        "0 and 1 add up strains in the axes of the yarns, which stay perpendicular; large strains, axes that "
        "do not stay perpendicular and curves of stress are not supported"),
    only("FVOPT", {0, 1, 2, 7, 8},
         "1 is orifices, 7 a curve of velocity, 2 and 8 the same where fabric is covered by contact; other "
         "formulas "
         "there are not"),
    only("TSRFAC", {0}, "stress is not reduced"),
};

constexpr Field fabric_fourth_card[] = {
    unused("-"),
    unused("RGBRTH"),  // of a reference geometry, which there is none of
    unused("A0REF"),
    direction(real("A1")),
    direction(real("A2")),
    direction(real("A3")),
    only("X0", {0}, "the area of leakage does not depend on the stretch"),
    only("X1", {0}, "the area of leakage does not depend on the stretch"),
};

constexpr Field fabric_fifth_card[] = {
    direction(real("V1")), direction(real("V2")), direction(real("V3")), unused("-"),
    unused("-"),           unused("-"),           real("BETA"),          unused("ISREFG"),  // of FORM = 12
};

/// Curves, read where FORM has them, so that the next material begins in its place.
constexpr Field fabric_curve_card[] = {
    unused("LCA"),  unused("LCB"),   unused("LCAB"), unused("LCUA"),
    unused("LCUB"), unused("LCUAB"), unused("RL"),   unused("-"),
};

/// The moduli in the plane; without EB and GAB the fabric is isotropic.
void take_moduli(const Card& card, const Card& second, model::OrthotropicElastic& sheet, Report& report) {
  sheet.modulus_a = card.real("EA");
  sheet.modulus_b = card.real("EB") > 0 ? card.real("EB") : sheet.modulus_a;
  sheet.poisson_ba = card.real("PRBA");
  sheet.shear_ab = second.real("GAB");
  if (second.good("GAB") && sheet.shear_ab == 0) {
    if (card.real("EB") > 0)
      report.field_error(second.where(),
                         {"GAB", std::string(second.text("GAB")), "a number above zero",
                          "EB and GAB are zero together, for an isotropic fabric", "modulus"});
    sheet.shear_ab = 0.5 * sheet.modulus_a / (1 + sheet.poisson_ba);
  }
  const double other = sheet.poisson_ba * sheet.modulus_a / sheet.modulus_b;
  if (card.good("PRAB") && card.real("PRAB") != 0 &&
      std::fabs(card.real("PRAB") - other) > 0.01 * std::fabs(other))
    report.field_warning(card.where(), {"PRAB", std::string(card.text("PRAB")), fmt::format("{:.4g}", other),
                                        "PRBA counts: PRAB / EA = PRBA / EB", "ratio"});
}

/// The vector that AOPT calls for.
void take_yarns(const Card& third, const Card& fourth, const Card& fifth, model::OrthotropicElastic& sheet,
                Report& report) {
  const double option = third.real("AOPT");
  if (option == 0) return;
  const bool by_vector = option == 2;
  using Axes = model::OrthotropicElastic::Axes;
  sheet.axes = by_vector ? Axes::Vector : Axes::CrossNormal;
  const Card& card = by_vector ? fourth : fifth;
  const std::string_view first = by_vector ? "A1" : "V1";
  sheet.direction = {card.real(first), card.real(by_vector ? "A2" : "V2"),
                     card.real(by_vector ? "A3" : "V3")};
  const auto& v = sheet.direction;
  if (!(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > 0))
    report.field_error(card.where(), {first, std::string(card.text(first)), "a vector that is not zero",
                                      fmt::format("AOPT = {} takes the axis a from it", option), "axis"});
}

/// FLC and FAC, each a number or, negative, a curve.
void take_leakage(const Card& third, model::Fabric& law, RawMaterial& raw, Report& report) {
  const auto curve = [&](std::string_view field) {
    return third.good(field) && third.real(field) < 0 ? static_cast<UserId>(-third.real(field)) : 0;
  };
  raw.leakage_curves = {curve("FLC"), curve("FAC")};
  law.leakage.coefficient = std::max(0.0, third.real("FLC"));
  law.leakage.area = std::max(0.0, third.real("FAC"));
  law.leakage.venting = static_cast<int>(third.real("FVOPT"));
  if (const int open = law.leakage.venting; open == 2 || open == 8) {
    report.field_warning(third.where(),
                         {"FVOPT", std::string(third.text("FVOPT")), "1 or 7",
                          "fabric that is covered by contact leaks as if it were not", "covered"});
    law.leakage.venting = open - 1;
  }
  if (law.leakage.venting == 7 && law.leakage.area > 0)
    report.field_error(third.where(),
                       {"FAC", std::string(third.text("FAC")), "minus the number of a curve",
                        "with FVOPT = 7 it has the velocity of the gas over the pressure", "velocity"});
  raw.curve_where = third.where();
}

void take_liner(const Card& second, model::Fabric& law, Report& report) {
  law.liner_share = second.real("LRATIO");
  if (!(law.liner_share > 0)) return;
  law.liner_modulus = second.real("EL");
  law.liner_ratio = second.real("PRL");
  if (second.good("EL") && !(law.liner_modulus > 0))
    report.field_error(second.where(), {"EL", std::string(second.text("EL")), "a number above zero",
                                        "LRATIO gives the fabric a liner", "modulus"});
}

}  // namespace

void read_mat_fabric(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(fabric_card);
    const Card second = cards.next(fabric_second_card);
    const Card third = cards.next_or_default(fabric_third_card);
    const Card fourth = cards.next_or_default(fabric_fourth_card);
    const Card fifth = cards.next_or_default(fabric_fifth_card);
    const double form = std::strtod(std::string(third.text("FORM")).c_str(), nullptr);
    if (form == 4 || form == 14 || form == -14 || form == 24) cards.next_or_default(fabric_curve_card);
    if (form == -14) cards.next_or_default(fabric_curve_card);
    RawMaterial raw = material_of(heading, card);
    model::Fabric law;
    take_moduli(card, second, law.sheet, cards.report());
    take_yarns(third, fourth, fifth, law.sheet, cards.report());
    law.sheet.angle = fifth.real("BETA") * std::numbers::pi / 180;
    if (cards.placement().map.mirrors()) law.sheet.angle = -law.sheet.angle;
    law.wrinkles = second.real("CSE") == 1;
    law.damping = second.real("DAMP");
    take_liner(second, law, cards.report());
    take_leakage(third, law, raw, cards.report());
    const model::OrthotropicElastic& sheet = law.sheet;
    const bool sound = card.good("EA") && card.good("EB") && card.good("PRBA") && second.good("GAB");
    if (sound && !(sheet.poisson_ba * sheet.poisson_ba * sheet.modulus_a < sheet.modulus_b))
      cards.report().field_error(
          card.where(), {"PRBA", std::string(card.text("PRBA")), "a ratio whose square is below EB / EA",
                         "nu_ba / E_b = nu_ab / E_a", "ratio"});
    else if (sound)
      set_stand_in(law);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
