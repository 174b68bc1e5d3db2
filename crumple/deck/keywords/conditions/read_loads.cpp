// SPDX-License-Identifier: BSD-3-Clause
// *LOAD_NODE, *LOAD_SEGMENT and *LOAD_SHELL.
#include "deck/keywords/families.hpp"
#include "deck/keywords/mirrored.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field loaded_node_card[] = {
    id("NID", kind_of_target),
    local(axes(
        integer("DOF", 0,
                within(1, 8,
                       "1, 2, 3 are forces along x, y, z and 5, 6, 7 moments about them, 4 and 8 along and "
                       "about the normal of M1, M2, M3")))),
    id("LCID"),
    real_or_default("SF", 1.0),
    reference("CID"),
    reference("M1", IdKind::Node),
    reference("M2", IdKind::Node),
    reference("M3", IdKind::Node),
};

constexpr Field segment_card[] = {
    id("LCID"),      real_or_default("SF", 1.0), real("AT", 0, not_negative), id("N1"), id("N2"), id("N3"),
    reference("N4"),
};

constexpr Field shell_card[] = {id("EID"), id("LCID"), real_or_default("SF", 1.0),
                                real("AT", 0, not_negative)};

constexpr Field segment_set_card[] = {id("SSID"), id("LCID"), real_or_default("SF", 1.0),
                                      real("AT", 0, not_negative)};

constexpr Field shell_set_card[] = {id("ESID"), id("LCID"), real_or_default("SF", 1.0),
                                    real("AT", 0, not_negative)};

/// Cards of an id, a curve, a factor and a time; `target` is the member that takes the id.
void read_pressures(Cards& cards, Layout layout, UserId RawPressureLoad::*target, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(layout);
    RawPressureLoad load;
    load.*target = card.integer(layout[0].name);
    load.curve = card.integer("LCID");
    load.scale = card.real("SF");
    load.arrival = card.real("AT");
    load.where = card.where();
    if (card.good(layout[0].name) && card.good("LCID")) deck.pressure_loads.push_back(load);
  }
}

void read_nodal(Cards& cards, RawDeck& deck, bool is_set) {
  while (cards.more()) {
    const Card card = cards.next_filled(loaded_node_card);
    RawNodalLoad load;
    load.target = card.integer("NID");
    load.is_set = is_set;
    load.direction = static_cast<int>(card.integer("DOF"));
    load.curve = card.integer("LCID");
    load.scale = card.real("SF");
    load.where = card.where();
    load.system = card.integer("CID");
    load.plane = {card.integer("M1"), card.integer("M2"), card.integer("M3")};
    const bool good = card.good("NID") && card.good("DOF") && card.good("LCID") && card.good("CID");
    if (check_followed_nodes(card, cards.report()) && good) deck.nodal_loads.push_back(load);
  }
}

}  // namespace

void read_load_node_point(Cards& cards, RawDeck& deck) {
  read_nodal(cards, deck, false);
}

void read_load_node_set(Cards& cards, RawDeck& deck) {
  read_nodal(cards, deck, true);
}

void read_load_segment(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(segment_card);
    RawPressureLoad load;
    load.curve = card.integer("LCID");
    load.scale = card.real("SF");
    load.arrival = card.real("AT");
    load.node = {card.integer("N1"), card.integer("N2"), card.integer("N3"), card.integer("N4")};
    if (load.node[3] == 0) load.node[3] = load.node[2];
    if (cards.placement().map.mirrors()) mirror_face(load.node, load.node[2] == load.node[3]);
    load.where = card.where();
    const bool nodes = card.good("N1") && card.good("N2") && card.good("N3") && card.good("N4");
    if (nodes && card.good("LCID")) deck.pressure_loads.push_back(load);
  }
}

void read_load_segment_set(Cards& cards, RawDeck& deck) {
  read_pressures(cards, segment_set_card, &RawPressureLoad::segment_set, deck);
}

void read_load_shell_element(Cards& cards, RawDeck& deck) {
  read_pressures(cards, shell_card, &RawPressureLoad::shell, deck);
}

void read_load_shell_set(Cards& cards, RawDeck& deck) {
  read_pressures(cards, shell_set_card, &RawPressureLoad::shell_set, deck);
}

}  // namespace crumple::deck
