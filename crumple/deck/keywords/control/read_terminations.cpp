// SPDX-License-Identifier: BSD-3-Clause
// *TERMINATION_NODE, _BODY, _CONTACT, _DELETED_SHELLS, _DELETED_SOLIDS: what ends a run before its end time.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;
using Kind = model::Termination::Kind;

constexpr Field ended_node_card[] = {
    id("NID"),
    axes(integer("STOP", 1, within(1, 4, "1, 2, 3 bound its place along x, y, z, 4 ends at a contact"))),
    real("MAXC"),
    real("MINC"),
};

constexpr Field body_card[] = {
    id("PID"),
    axes(integer("STOP", 1, within(1, 4, "1, 2, 3 bound its displacement along x, y, z, 4 the size of it"))),
    real("MAXC"),
    real("MINC"),
};

constexpr Field contact_card[] = {
    id("CID", IdKind::Other),
    real("ACTIM", 0, not_negative),
    real("DUR", 0, not_negative),
    real("THRES", 0, not_negative),
    axes(integer("DOF", 0, within(0, 3, "0 is the size of the force, 1, 2, 3 its part along x, y, z"))),
};

constexpr Field deleted_card[] = {
    id("PID"),
    integer_or_default("NDS", 1, above_zero),
};

constexpr Field deleted_set_card[] = {
    id("PSID"),
    integer_or_default("NDS", 1, above_zero),
};

/// Bounds that a card gives; `zero_is_none` tells whether zero is no bound.
void take_bounds(const Card& card, bool zero_is_none, model::Termination& termination) {
  const auto given = [&](std::string_view name) {
    return !card.text(name).empty() && (!zero_is_none || card.real(name) != 0);
  };
  if (given("MAXC")) termination.most = card.real("MAXC");
  if (given("MINC")) termination.least = card.real("MINC");
}

void read_bounded(Cards& cards, RawDeck& deck, bool is_node) {
  const std::string_view name = is_node ? "NID" : "PID";
  while (cards.more()) {
    const Card card = is_node ? cards.next_filled(ended_node_card) : cards.next_filled(body_card);
    RawTermination raw;
    model::Termination& termination = raw.termination;
    const auto stop = card.integer("STOP");
    constexpr std::int64_t other = 4;
    if (stop == other)
      termination.kind = is_node ? Kind::Touch : Kind::Distance;
    else
      termination.kind = is_node ? Kind::Place : Kind::Displacement;
    termination.id = card.integer(name);
    termination.axis = stop == other ? 0 : static_cast<int>(stop) - 1;
    take_bounds(card, !is_node, termination);
    raw.where = card.where();
    if (card.good(name) && card.good("STOP")) deck.terminations.push_back(raw);
  }
}

void read_deleted(Cards& cards, RawDeck& deck, bool is_set) {
  while (cards.more()) {
    const Card card = is_set ? cards.next_filled(deleted_set_card) : cards.next_filled(deleted_card);
    const std::string_view name = is_set ? "PSID" : "PID";
    RawTermination raw;
    raw.termination.kind = Kind::Deleted;
    raw.termination.id = card.integer(name);
    raw.termination.count = card.integer("NDS");
    raw.is_set = is_set;
    raw.where = card.where();
    if (card.good(name) && card.good("NDS")) deck.terminations.push_back(raw);
  }
}

}  // namespace

void read_termination_node(Cards& cards, RawDeck& deck) {
  read_bounded(cards, deck, true);
}

void read_termination_body(Cards& cards, RawDeck& deck) {
  read_bounded(cards, deck, false);
}

void read_termination_contact(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(contact_card);
    RawTermination raw;
    raw.termination.kind = Kind::NoContact;
    raw.termination.id = card.integer("CID");
    raw.termination.activation = card.real("ACTIM");
    raw.termination.duration = card.real("DUR");
    raw.termination.threshold = card.real("THRES");
    raw.termination.axis = static_cast<int>(card.integer("DOF")) - 1;
    raw.where = card.where();
    if (card.good("CID") && card.good("DOF")) deck.terminations.push_back(raw);
  }
}

void read_termination_deleted(Cards& cards, RawDeck& deck) {
  read_deleted(cards, deck, false);
}

void read_termination_deleted_set(Cards& cards, RawDeck& deck) {
  read_deleted(cards, deck, true);
}

}  // namespace crumple::deck
