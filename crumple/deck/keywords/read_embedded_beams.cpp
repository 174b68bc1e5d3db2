// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_BEAM_IN_SOLID, *CONSTRAINED_LAGRANGE_IN_SOLID.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view part_or_set = "0 is a part set, 1 a part";

IdKind kind_of_embedded_beams(const Card& card) {
  return card.real("BSTYP") == 1 ? IdKind::Part : IdKind::Set;
}

/// SSID of the one keyword, SLAVE of the other.
IdKind kind_by_sstyp(const Card& card) {
  return card.real("SSTYP") == 1 ? IdKind::Part : IdKind::Set;
}

IdKind kind_of_master(const Card& card) {
  return card.real("MSTYP") == 1 ? IdKind::Part : IdKind::Set;
}

constexpr Field beam_in_solid_card[] = {
    id("BSIDE", kind_of_embedded_beams),
    id("SSID", kind_by_sstyp),
    only("BSTYP", {0, 1}, part_or_set),
    only("SSTYP", {0, 1}, part_or_set),
    unused("-"),
    unused("-"),
    real("NCOUP", 0, not_negative),
    only("CDIR", {0}, "beams do not slide in solids: their nodes move with these along the beam, too"),
};

constexpr std::string_view from_the_start =
    "nodes of beams move with solids from the beginning of the run on";

constexpr Field beam_in_solid_card_2[] = {
    only("START", {0}, from_the_start),
    real_or_default("END", 1e20, above_zero),
    unused("-"),
    only("AXFOR", {0}, "there is no law of the bond: beams do not slip in solids"),
    unused("-"),
    unused("PSSF"),  // of springs
    unused("-"),
    real("XINT", 0, not_negative),
};

constexpr Field lagrange_card[] = {
    id("SLAVE", kind_by_sstyp),
    id("MASTER", kind_of_master),
    only("SSTYP", {0, 1}, "0 is a part set, 1 a part; segments of a set are not coupled"),
    only("MSTYP", {0, 1}, part_or_set),
    unused("NQUAD"),
    only("CTYPE", {2, 0}, "2 couples beams with Lagrangian solids by constraint; there are no fluids"),
    unused("DIREC"),  // of penalty coupling
    unused("MCOUP"),
};

constexpr Field lagrange_card_2[] = {
    only("START", {0}, from_the_start),
    real_or_default("END", 1e20, above_zero),
    unused("PFAC"),  // of penalty coupling
    unused("FRIC"),
    unused("FRCMIN"),
    unused("NORM"),
    unused("NORMTYP"),
    unused("DAMP"),
};

constexpr Field lagrange_card_3[] = {
    unused("CQ"),    unused("HMIN"),    unused("HMAX"),  unused("ILEAK"),
    unused("PLEAK"), unused("LCIDPOR"), unused("NVENT"), unused("BLOCKAGE"),
};

constexpr Field lagrange_card_4[] = {
    only("IBOXID", {0}, "all solids of MASTER hold beams, not those in a box alone"),
    unused("IPENCHK"),
    unused("INTFORC"),
    unused("IALESOF"),
    unused("LAGMUL"),
    unused("PFACMM"),
    unused("THKF"),
};

bool is_set(const Card& card, std::string_view type) {
  return card.real(type) != 1;
}

}  // namespace

void read_constrained_beam_in_solid(Cards& cards, RawDeck& deck) {
  const Heading heading = cards.heading();
  const Card card = cards.next(beam_in_solid_card);
  const Card times = cards.next_or_default(beam_in_solid_card_2);
  RawEmbeddedBeams raw;
  raw.id = heading.id;
  raw.beams = {card.integer("BSIDE"), is_set(card, "BSTYP"), "BSIDE"};
  raw.solids = {card.integer("SSID"), is_set(card, "SSTYP"), "SSID"};
  raw.end_time = times.real("END");
  raw.between_nodes = card.real("NCOUP") > 0 || times.real("XINT") > 0;
  raw.where = card.where();
  if (card.good("BSIDE") && card.good("SSID") && card.good("BSTYP") && card.good("SSTYP"))
    deck.embedded_beams.push_back(raw);
}

void read_constrained_beam_in_solid_penalty(Cards& cards, RawDeck& deck) {
  read_constrained_beam_in_solid(cards, deck);
  cards.report().warning(cards.where(), "penalty",
                         "the nodes of the beams move exactly with the solids, instead of being held by "
                         "springs of a stiffness by PSSF");
}

void read_constrained_lagrange_in_solid(Cards& cards, RawDeck& deck) {
  const Heading heading = cards.heading();
  const Card card = cards.next(lagrange_card);
  const Card times = cards.next_or_default(lagrange_card_2);
  cards.next_or_default(lagrange_card_3);
  cards.next_or_default(lagrange_card_4);
  RawEmbeddedBeams raw;
  raw.id = heading.id;
  raw.beams = {card.integer("SLAVE"), card.real("SSTYP") == 0, "SLAVE"};
  raw.solids = {card.integer("MASTER"), is_set(card, "MSTYP"), "MASTER"};
  raw.end_time = times.real("END");
  raw.where = card.where();
  if (card.good("SLAVE") && card.good("MASTER") && card.good("SSTYP") && card.good("MSTYP") &&
      card.good("CTYPE"))
    deck.embedded_beams.push_back(raw);
}

}  // namespace crumple::deck
