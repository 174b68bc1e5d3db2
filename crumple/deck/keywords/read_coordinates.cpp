// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_COORDINATE_SYSTEM, _NODES, _VECTOR, and *DEFINE_VECTOR.
#include "deck/format/vector.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field points_card[] = {
    id("CID"),         point(real("XO")),
    point(real("YO")), point(real("ZO")),
    point(real("XL")), point(real("YL")),
    point(real("ZL")), only("CIDL", {0}, "the points are given in global axes"),
};

constexpr Field plane_card[] = {point(real("XP")), point(real("YP")), point(real("ZP"))};

constexpr Field nodes_card[] = {
    id("CID"),
    id("N1"),
    id("N2"),
    id("N3"),
    only("FLAG", {0}, "the axes keep the directions that they have at the beginning"),
    text("DIR", 10),
};

constexpr Field vector_card[] = {
    id("CID"),
    direction(real("XX")),
    direction(real("YX")),
    direction(real("ZX")),
    direction(real("XV")),
    direction(real("YV")),
    direction(real("ZV")),
    only("NID", {0}, "the axes do not turn with a node"),
};

constexpr Field define_vector_card[] = {
    id("VID"),
    local(point(real("XT"))),
    local(point(real("YT"))),
    local(point(real("ZT"))),
    local(point(real("XH"))),
    local(point(real("YH"))),
    local(point(real("ZH"))),
    reference("CID"),
};

/// Turns of a mirrored file are those of its image; a third axis is not.
void warn_of_mirror(const Cards& cards, const Card& card) {
  if (cards.placement().map.mirrors())
    cards.report().field_warning(
        card.where(), {"CID", std::string(card.text("CID")), "a system in a file that is not mirrored",
                       "its axes stay right-handed: z, and what is given along or about it, is the opposite "
                       "of its image",
                       "mirrored"});
}

}  // namespace

void read_define_coordinate_system(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(points_card);
    const Card plane = cards.next(plane_card);
    const Vector origin = {card.real("XO"), card.real("YO"), card.real("ZO")};
    RawCoordinateSystem system;
    system.id = card.integer("CID");
    system.first = difference({card.real("XL"), card.real("YL"), card.real("ZL")}, origin);
    system.origin = origin;
    system.other = difference({plane.real("XP"), plane.real("YP"), plane.real("ZP")}, origin);
    system.where = card.where();
    warn_of_mirror(cards, card);
    if (card.good("CID")) deck.coordinate_systems.push_back(system);
  }
}

void read_define_coordinate_nodes(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(nodes_card);
    RawCoordinateSystem system;
    system.id = card.integer("CID");
    system.node = {card.integer("N1"), card.integer("N2"), card.integer("N3")};
    system.where = card.where();
    warn_of_mirror(cards, card);
    const std::string_view direction = card.text("DIR");
    if (!direction.empty() && direction != "X" && direction != "x" && direction != "0")
      cards.report().field_unsupported(
          card.where(), {"DIR", std::string(direction), "X", "N1 to N2 is the local x axis", "axis"});
    else if (card.good("CID") && card.good("N1") && card.good("N2") && card.good("N3"))
      deck.coordinate_systems.push_back(system);
  }
}

void read_define_coordinate_vector(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(vector_card);
    RawCoordinateSystem system;
    system.id = card.integer("CID");
    system.first = {card.real("XX"), card.real("YX"), card.real("ZX")};
    system.other = {card.real("XV"), card.real("YV"), card.real("ZV")};
    system.where = card.where();
    warn_of_mirror(cards, card);
    if (card.good("CID")) deck.coordinate_systems.push_back(system);
  }
}

void read_define_vector(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(define_vector_card);
    RawVector raw;
    raw.id = card.integer("VID");
    raw.vector = difference({card.real("XH"), card.real("YH"), card.real("ZH")},
                            {card.real("XT"), card.real("YT"), card.real("ZT")});
    raw.system = card.integer("CID");
    raw.where = card.where();
    const bool good = card.good("XT") && card.good("XH") && card.good("CID");
    if (good && !(length_of(raw.vector) > 0))
      cards.report().field_error(card.where(), {"XH", std::string(card.text("XH")), "the head of a vector",
                                                "XT, YT, ZT is the same point", "vector"});
    else if (good && card.good("VID"))
      deck.vectors.push_back(raw);
  }
}

}  // namespace crumple::deck
