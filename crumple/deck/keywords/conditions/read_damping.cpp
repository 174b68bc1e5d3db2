// SPDX-License-Identifier: BSD-3-Clause
// *DAMPING_GLOBAL, *DAMPING_PART_MASS, *ELEMENT_MASS_PART: what goes by the masses of parts.
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

void read_element_mass_part(Cards& cards, RawDeck& deck) {
  read_part_masses(cards, deck, false);
}

void read_element_mass_part_set(Cards& cards, RawDeck& deck) {
  read_part_masses(cards, deck, true);
}

}  // namespace crumple::deck
