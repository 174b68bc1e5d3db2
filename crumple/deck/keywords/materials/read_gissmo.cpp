// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_DAMAGE_GISSMO.
#include <fmt/core.h>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field gissmo_card_1[] = {
    id("MID"),
    unused("-"),
    only("DTYP", {0, 1},
         "0 adds damage up, 1 lets it act; another history variable than the plastic strain does not drive "
         "it"),
    unused("REFSZ"),
    real_or_default("NUMFIP", 1, within(-100, 100, "a number of points, below zero percent of the layers")),
};

constexpr Field gissmo_card_2[] = {
    damage_failure,
    damage_instability,
    damage_exponent,
    damage_critical,
    damage_fading,
    damage_regularization,
    only("INSTF", {0, 1}, "the instability grows with the plastic strain, it does not jump"),
};

constexpr Field gissmo_card_3[] = {
    damage_rates,
    real("SHRF"),
    real("BIAXF"),
    damage_limits,
    damage_middle,
    only("HISVN", {0}, "the failure strain depends on no history variable"),
    only("SOFT", {0}, "elements beside those that have failed are as strong as the others"),
    only("LP2BI", {0}, "tables are over Lode's parameter"),
};

constexpr Field gissmo_card_4[] = {
    only("RGTR1", {0}, "SHRF and BIAXF act on either side of uniaxial tension"),
    only("RGTR2", {0}, "SHRF and BIAXF act on either side of uniaxial tension"),
};

/// SHRF or BIAXF.
double reduction(const Card& card, std::string_view field, Report& report) {
  const double value = card.real(field);
  if (card.good(field) && (value < 0 || value > 1))
    report.field_unsupported(card.where(), {field, std::string(card.text(field)), "0 to 1",
                                            "0 regularizes as in uniaxial tension, 1 not at all", "range"});
  return value;
}

}  // namespace

RawDamage damage_of(const Card& curves, const Card& more, Report& report) {
  RawDamage raw;
  raw.curves_where = curves.where();
  raw.more_where = more.where();
  raw.failure = curves.integer("LCSDG");
  raw.critical = curves.real("ECRIT");
  raw.damage.exponent = curves.real("DMGEXP");
  raw.damage.critical_damage = curves.real("DCRIT");
  raw.fading = curves.real("FADEXP");
  raw.regularization = curves.integer("LCREGD");
  raw.rates = more.integer("LCSRS");
  raw.damage.shear_reduction = reduction(more, "SHRF", report);
  raw.damage.biaxial_reduction = reduction(more, "BIAXF", report);
  return raw;
}

void read_mat_add_damage_gissmo(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card first = cards.next(gissmo_card_1);
  const Card second = cards.next(gissmo_card_2);
  const Card third = cards.next_or_default(gissmo_card_3);
  if (cards.has_line()) cards.next(gissmo_card_4);
  RawDamage raw = damage_of(second, third, cards.report());
  raw.material = first.integer("MID");
  raw.damage.acts = first.real("DTYP") == 1;
  raw.damage.points = first.real("NUMFIP");
  raw.where = first.where();
  if (first.good("MID")) deck.damages.push_back(std::move(raw));
}

}  // namespace crumple::deck
