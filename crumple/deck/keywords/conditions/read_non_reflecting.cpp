// SPDX-License-Identifier: BSD-3-Clause
// *BOUNDARY_NON_REFLECTING: faces of solids that waves leave.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field non_reflecting_card[] = {
    id("SSID", IdKind::Set),
    real("AD"),
    real("AS"),
};

}  // namespace

void read_boundary_non_reflecting(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(non_reflecting_card);
    RawViscousBoundary raw;
    raw.set = card.integer("SSID");
    raw.normal = card.real("AD") == 0;
    raw.tangential = card.real("AS") == 0;
    raw.where = card.where();
    if (card.good("SSID") && card.good("AD") && card.good("AS")) deck.viscous_boundaries.push_back(raw);
  }
}

}  // namespace crumple::deck
