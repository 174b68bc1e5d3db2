// SPDX-License-Identifier: BSD-3-Clause
// *DAMPING_GLOBAL, *DAMPING_PART_MASS, *DAMPING_PART_STIFFNESS, *DAMPING_RELATIVE, *ELEMENT_MASS_PART: what
// goes by the masses of parts, and all damping.
#include <algorithm>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field damping_card[] = {
    reference("LCID"),
    real("VALDMP", 0, not_negative),
    axes(real("STX", 0, not_negative)),
    axes(real("STY", 0, not_negative)),
    axes(real("STZ", 0, not_negative)),
    axes(real("SRX", 0, not_negative)),
    axes(real("SRY", 0, not_negative)),
    axes(real("SRZ", 0, not_negative)),
};

IdKind kind_of_parts(const Card& card) {
  return card.where().keyword.ends_with("_SET") ? IdKind::Set : IdKind::Part;
}

constexpr Field part_damping_card[] = {
    id("PID", kind_of_parts),
    reference("LCID"),
    real_or_default("SF", 1.0),
    only("FLAG", {0, 1}, "1 is followed by a card with factors along and about the axes"),
};

constexpr Field part_damping_card_2[] = {
    axes(real("STX", 0, not_negative)), axes(real("STY", 0, not_negative)),
    axes(real("STZ", 0, not_negative)), axes(real("SRX", 0, not_negative)),
    axes(real("SRY", 0, not_negative)), axes(real("SRZ", 0, not_negative)),
};

constexpr Field part_stiffness_card[] = {
    id("PID", kind_of_parts),
    real("COEF"),
};

constexpr Field relative_card[] = {
    real("CDAMP", 0, not_negative),
    real("FREQ", 0, not_negative),
    id("PIDRB", IdKind::Part),
    id("PSID", IdKind::Set),
    only("DV2", {0}, "forces are in proportion to the velocity, not to its square"),
    reference("LCID"),
};

constexpr Field part_mass_card[] = {
    sized(8, id("PID", kind_of_parts)),
    sized(16, real("ADDMASS", 0, not_negative)),
    sized(16, real("FINMASS", 0, not_negative)),
    sized(8, only("LCID", {0}, "give the mass itself in ADDMASS")),
    sized(8, only("MWD", {0, 1}, "mass is always added in proportion to mass")),
};

void read_part_dampings(Cards& cards, RawDeck& deck, bool is_set) {
  while (cards.more()) {
    const Card card = cards.next_filled(part_damping_card);
    RawMassDamping raw;
    raw.target = card.integer("PID");
    raw.is_set = is_set;
    raw.curve = card.integer("LCID");
    raw.damping.scale = card.real("SF");
    raw.where = card.where();
    if (card.real("FLAG") == 1) {
      const Card factors = cards.next(part_damping_card_2);
      raw.damping.translation = {factors.real("STX"), factors.real("STY"), factors.real("STZ")};
      raw.damping.rotation = {factors.real("SRX"), factors.real("SRY"), factors.real("SRZ")};
    }
    if (card.good("PID") && card.good("LCID") && raw.curve != 0) deck.part_dampings.push_back(raw);
  }
}

/// Above this share LS-DYNA's manual discourages damping in proportion to stiffness.
constexpr double strong_share = 0.25;

void read_stiffness_dampings(Cards& cards, RawDeck& deck, bool is_set) {
  while (cards.more()) {
    const Card card = cards.next_filled(part_stiffness_card);
    const double coefficient = card.real("COEF");
    RawStiffnessDamping raw;
    raw.target = card.integer("PID");
    raw.is_set = is_set;
    raw.where = card.where();
    raw.damping.share = std::max(coefficient, 0.0);
    raw.damping.beta = std::max(-coefficient, 0.0);
    if (raw.damping.share > strong_share)
      cards.report().field_warning(
          card.where(),
          {"COEF", std::string(card.text("COEF")), "a share of critical damping up to 0.25",
           "it is used, but shortens the step and damps lower frequencies as well", "strong damping"});
    if (card.good("PID") && card.good("COEF") && coefficient != 0) deck.stiffness_dampings.push_back(raw);
  }
}

void read_part_masses(Cards& cards, RawDeck& deck, bool is_set) {
  while (cards.more()) {
    const Card card = cards.next_filled(part_mass_card);
    RawPartMass raw{card.integer("PID"), is_set, card.real("ADDMASS"), card.real("FINMASS"), card.where()};
    if (raw.added > 0 && raw.final_mass > 0)
      cards.report().field_error(card.where(),
                                 {"FINMASS", std::string(card.text("FINMASS")), "0",
                                  "ADDMASS is given, and says the same in another way", "mass"});
    else if (card.good("PID") && (raw.added > 0 || raw.final_mass > 0))
      deck.part_masses.push_back(raw);
  }
}

}  // namespace

void read_damping_global(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(damping_card);
  RawMassDamping raw;
  raw.damping.constant = card.real("VALDMP");
  raw.damping.translation = {card.real("STX"), card.real("STY"), card.real("STZ")};
  raw.damping.rotation = {card.real("SRX"), card.real("SRY"), card.real("SRZ")};
  // All blank means all of them.
  const std::array<double, 3> none{};
  if (raw.damping.translation == none && raw.damping.rotation == none)
    raw.damping.translation = raw.damping.rotation = {1, 1, 1};
  raw.curve = card.integer("LCID");
  raw.where = card.where();
  deck.mass_dampings.push_back(raw);
}

void read_damping_part_mass(Cards& cards, RawDeck& deck) {
  read_part_dampings(cards, deck, false);
}

void read_damping_part_mass_set(Cards& cards, RawDeck& deck) {
  read_part_dampings(cards, deck, true);
}

void read_damping_part_stiffness(Cards& cards, RawDeck& deck) {
  read_stiffness_dampings(cards, deck, false);
}

void read_damping_part_stiffness_set(Cards& cards, RawDeck& deck) {
  read_stiffness_dampings(cards, deck, true);
}

void read_damping_relative(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(relative_card);
    RawRelativeDamping raw;
    raw.damping.share = card.real("CDAMP");
    raw.damping.frequency = card.real("FREQ");
    raw.body = card.integer("PIDRB");
    raw.parts = card.integer("PSID");
    raw.curve = card.integer("LCID");
    raw.where = card.where();
    if (card.good("PIDRB") && card.good("PSID") && card.good("LCID")) deck.relative_dampings.push_back(raw);
  }
}

void read_element_mass_part(Cards& cards, RawDeck& deck) {
  read_part_masses(cards, deck, false);
}

void read_element_mass_part_set(Cards& cards, RawDeck& deck) {
  read_part_masses(cards, deck, true);
}

}  // namespace crumple::deck
