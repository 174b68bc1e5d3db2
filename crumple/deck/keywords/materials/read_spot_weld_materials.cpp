// SPDX-License-Identifier: BSD-3-Clause
// *MAT_SPOTWELD.
#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field weld_material_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("SIGY", 0, above_zero),
    real("EH", 0, not_negative),
    real("DT", 0, not_negative),
    real_or_default("TFAIL", 1e20, above_zero),
};

constexpr Field weld_failure_card[] = {
    real("EFAIL", 0, not_negative), real("NRR", 0, not_negative),
    real("NRS", 0, not_negative),   real("NRT", 0, not_negative),
    real("MRR", 0, not_negative),   real("MSS", 0, not_negative),
    real("MTT", 0, not_negative),   harmless("NF", {0}, "the resultants of a weld are compared as they are"),
};

constexpr Field weld_damage_card[] = {
    only("RS", {0}, "welds fail at once; there is no damage before"),
    only("OPT", {0, -1}, "0 and -1 compare resultants with those of card 2; other criteria are not there"),
    unused("FVAL"),                                                         // of other OPT
    harmless("TRUE_T", {0}, "the thickness of welds is that of the mesh"),  // of solids
    unused("ASFF"),                                                         // of assemblies of solids
    only("BETA", {0}, "there is no damage"),
    unused("-"),
    only("DMGOPT", {0}, "there is no damage"),
};

void read_weld_material(Cards& cards, RawDeck& deck, bool has_third_card) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(weld_material_card);
    const Card failure = cards.next_or_default(weld_failure_card);
    if (has_third_card) cards.next_or_default(weld_damage_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = model::SpotWeldLaw{.youngs_modulus = card.real("E"),
                                          .poissons_ratio = card.real("PR"),
                                          .yield_stress = card.real("SIGY"),
                                          .hardening = card.real("EH"),
                                          .least_step = card.real("DT"),
                                          .failure_time = card.real("TFAIL"),
                                          .failure_strain = failure_strain(failure.real("EFAIL")),
                                          .tension_strength = failure.real("NRR"),
                                          .shear_strength_s = failure.real("NRS"),
                                          .shear_strength_t = failure.real("NRT"),
                                          .torsion_strength = failure.real("MRR"),
                                          .bending_strength_s = failure.real("MSS"),
                                          .bending_strength_t = failure.real("MTT")};
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace

void read_mat_spotweld(Cards& cards, RawDeck& deck) {
  read_weld_material(cards, deck, false);
}

void read_mat_spotweld_damage_failure(Cards& cards, RawDeck& deck) {
  read_weld_material(cards, deck, true);
}

}  // namespace crumple::deck
