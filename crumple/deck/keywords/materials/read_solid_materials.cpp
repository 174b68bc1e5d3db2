// SPDX-License-Identifier: BSD-3-Clause
// *MAT_BLATZ-KO_RUBBER, *MAT_MOONEY-RIVLIN_RUBBER, *MAT_CRUSHABLE_FOAM.
#include <fmt/core.h>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_reference_geometry = "there is no reference geometry";

constexpr Field blatz_ko_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, above_zero),
    only("REF", {0}, no_reference_geometry),
};

constexpr Field mooney_rivlin_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("PR", 0, between(0, 0.5, "Poisson's ratio of rubber, 0.49 to 0.4995")),
    real("A"),
    real("B"),
    only("REF", {0}, no_reference_geometry),
};

constexpr std::string_view no_fit = "A and B are not fitted to a test; give them";

constexpr Field mooney_rivlin_second_card[] = {
    only("SGL", {0}, no_fit),
    only("SW", {0}, no_fit),
    only("ST", {0}, no_fit),
    only("LCID", {0}, no_fit),
};

constexpr Field foam_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    id("LCID"),
    real("TSC", 0, not_negative),
    real_or_default("DAMP", 0.1, not_negative),
    only("MODEL", {0}, "0 is the foam whose principal stresses are bounded one by one"),
};

}  // namespace

void read_mat_blatz_ko_rubber(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(blatz_ko_card);
    RawMaterial raw = material_of(heading, card);
    constexpr double poissons_ratio = 0.463;
    raw.material.law = model::BlatzKo{2 * card.real("G") * (1 + poissons_ratio), poissons_ratio};
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_mooney_rivlin_rubber(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(mooney_rivlin_card);
    const Card second = cards.next_or_default(mooney_rivlin_second_card);
    RawMaterial raw = material_of(heading, card);
    model::MooneyRivlin law;
    law.first = card.real("A");
    law.second = card.real("B");
    law.poissons_ratio = card.real("PR");
    law.youngs_modulus = 4 * (law.first + law.second) * (1 + law.poissons_ratio);
    const bool fits = second.real("SGL") != 0 || second.real("LCID") != 0;
    if (!fits && card.good("A") && card.good("B") && !(law.first + law.second > 0))
      cards.report().field_error(card.where(),
                                 {"A", std::string(card.text("A")), "a number that makes A + B above zero",
                                  "the shear modulus is 2 (A + B)", "modulus"});
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_crushable_foam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(foam_card);
    RawMaterial raw = material_of(heading, card);
    model::CrushableFoam law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.tensile_stress = card.real("TSC");
    law.damping = card.real("DAMP");
    raw.hardening_curve = card.good("LCID") ? card.integer("LCID") : 0;
    raw.curve_where = card.where();
    if (card.good("TSC") && law.tensile_stress == 0)
      cards.report().field_warning(card.where(),
                                   {"TSC", std::string(card.text("TSC")), "a stress above zero",
                                    "without it the foam has no strength in tension", "tension"});
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
