// SPDX-License-Identifier: BSD-3-Clause
// *DATABASE_CROSS_SECTION: cuts whose force *DATABASE_SECFORC writes.
#include "deck/format/vector.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view global_axes = "forces are along global axes";

constexpr Field set_card[] = {
    id("NSID"),
    reference("HSID"),
    reference("BSID"),
    reference("SSID"),
    only("TSID", {0}, "there are no thick shells"),
    reference("DSID"),
    harmless("ID", {0}, global_axes),
    unused("ITYPE"),
};

constexpr Field plane_card_1[] = {
    reference("PSID"),  point(real("XCT")), point(real("YCT")), point(real("ZCT")),
    point(real("XCH")), point(real("YCH")), point(real("ZCH")), length(real("RADIUS", 0, not_negative)),
};

constexpr Field plane_card_2[] = {
    point(real("XHEV")),
    point(real("YHEV")),
    point(real("ZHEV")),
    length(real("LENL", 0, not_negative)),
    length(real("LENM", 0, not_negative)),
    harmless("ID", {0}, global_axes),
    unused("ITYPE"),
};

Vector vector_of(const Card& card, std::string_view x, std::string_view y, std::string_view z) {
  return {card.real(x), card.real(y), card.real(z)};
}

/// Number and title; sections without a number of their own are counted.
RawCrossSection begin_section(Cards& cards, const RawDeck& deck) {
  const Heading heading = cards.heading();
  RawCrossSection section;
  section.id = heading.id != 0 ? heading.id : static_cast<UserId>(deck.cross_sections.size()) + 1;
  section.title = heading.title;
  return section;
}

}  // namespace

void read_database_cross_section_set(Cards& cards, RawDeck& deck) {
  do {
    RawCrossSection section = begin_section(cards, deck);
    const Card card = cards.next(set_card);
    section.where = card.where();
    section.nodes = card.integer("NSID");
    section.solids = card.integer("HSID");
    section.beams = card.integer("BSID");
    section.shells = card.integer("SSID");
    section.discretes = card.integer("DSID");
    if (card.good("NSID")) deck.cross_sections.push_back(std::move(section));
  } while (cards.more());
}

void read_database_cross_section_plane(Cards& cards, RawDeck& deck) {
  do {
    RawCrossSection section = begin_section(cards, deck);
    const Card first = cards.next(plane_card_1);
    const Card second = cards.next(plane_card_2);
    section.where = first.where();
    RawCutPlane& plane = section.plane.emplace();
    plane.part_set = first.integer("PSID");
    plane.point = vector_of(first, "XCT", "YCT", "ZCT");
    plane.normal = difference(vector_of(first, "XCH", "YCH", "ZCH"), plane.point);
    plane.radius = first.real("RADIUS");
    plane.edge = difference(vector_of(second, "XHEV", "YHEV", "ZHEV"), plane.point);
    plane.length = second.real("LENL");
    plane.width = second.real("LENM");
    plane.edge_where = second.where();
    deck.cross_sections.push_back(std::move(section));
  } while (cards.more());
}

}  // namespace crumple::deck
