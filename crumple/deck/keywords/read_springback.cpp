// SPDX-License-Identifier: BSD-3-Clause
// *INTERFACE_SPRINGBACK_LSDYNA: the dynain file.
#include <string_view>
#include <utility>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field springback_card[] = {
    id("PSID"),
    integer("NSHV", 0, not_negative),
    only("FTYPE", {0, 10}, "the file is text, in fields of 16 columns"),
    unused("blank"),
    harmless("FTENSR", {0}, "laws have no tensors among their history variables"),
    harmless("NTHHSV", {0}, "there is no thermal solution"),
    harmless("RFLAG", {0}, "masses and reference coordinates are not written"),
    harmless("INTSTRN", {0}, "strains are not written"),
};

constexpr Field springback_option_card[] = {
    text("OPTC", 10),
    harmless("SLDO", {0}, "solids are written as *ELEMENT_SOLID"),
    harmless("NCYC", {0}, "there is no wear"),
    harmless("FSPLIT", {0}, "the file is one"),
    harmless("NDFLAG", {0}, "nodes of the elements are written"),
    harmless("CFLAG", {0}, "the state of contacts is not written"),
    harmless("HFLAG", {0}, "hourglass stresses are not written"),
};

constexpr Field springback_support_card[] = {
    id("NID"),
    axes(integer("TC", 0, within(0, 7, "0 is free, 1-3 fix x, y, z, 4 xy, 5 yz, 6 zx, 7 all"))),
    axes(integer("RC", 0, within(0, 7, "0 is free, 1-3 fix x, y, z, 4 xy, 5 yz, 6 zx, 7 all"))),
};

}  // namespace

void read_interface_springback_lsdyna(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(springback_card);
  RawSpringback raw;
  raw.parts = card.integer("PSID");
  raw.where = card.where();
  if (cards.more() && cards.peek().find("OPTCARD") != std::string_view::npos)
    cards.next_filled(springback_option_card);
  while (cards.more()) {
    const Card hold = cards.next_filled(springback_support_card);
    if (!hold.good("NID")) continue;
    raw.holds.push_back({.node = hold.integer("NID"),
                         .translation = static_cast<int>(hold.integer("TC")),
                         .rotation = static_cast<int>(hold.integer("RC")),
                         .where = hold.where()});
  }
  if (card.good("PSID")) deck.springbacks.push_back(std::move(raw));
}

}  // namespace crumple::deck
