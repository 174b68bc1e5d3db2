// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_SPOTWELD, *CONSTRAINED_GENERALIZED_WELD_SPOT, *CONSTRAINED_RIVET, *CONSTRAINED_NODE_SET,
// *CONSTRAINED_LINEAR_GLOBAL, *CONSTRAINED_ADAPTIVITY.
#include "deck/keywords/families.hpp"
#include "deck/keywords/rigid_inertia.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_filter = "the forces of a weld are compared as they are";

constexpr Field spotweld_card[] = {
    id("N1"),
    id("N2"),
    real("SN", 0, not_negative),
    real("SS", 0, not_negative),
    real_or_default("N", 1, above_zero),
    real_or_default("M", 1, above_zero),
    real_or_default("TF", 1e20, above_zero),
    real_or_default("EP", 1e20, above_zero),
};

constexpr Field generalized_card[] = {
    id("NSID"),
    harmless("CID", {0}, "the axes of LS-DYNA's listings"),
    harmless("FILTER", {0, 1}, no_filter),
    unused("WINDOW"),  // of the filter
    unused("NPR"),     // listings
    unused("NPRT"),
};

constexpr Field generalized_spot_card[] = {
    real_or_default("TFAIL", 1e20, above_zero),
    real_or_default("EPSF", 1e20, above_zero),
    real("SN", 0, not_negative),
    real("SS", 0, not_negative),
    real_or_default("N", 1, above_zero),
    real_or_default("M", 1, above_zero),
};

constexpr Field rivet_card[] = {
    id("N1"),
    id("N2"),
    real_or_default("TF", 1e20, above_zero),
};

constexpr Field node_set_card[] = {
    id("NSID"),
    axes(integer("DOF", 0, within(1, 7, "1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all"))),
    real_or_default("TF", 1e20, above_zero),
};

constexpr Field linear_card[] = {reference("LCID", IdKind::Other)};

constexpr Field linear_term_card[] = {
    id("NID"),
    axes(integer("DOF", 1, within(1, 6, "1, 2, 3 move along x, y, z, 4, 5, 6 turn about them"))),
    real("COEF"),
};

constexpr Field adaptivity_card[] = {
    id("DNID", IdKind::Node),
    id("NID1", IdKind::Node),
    id("NID2", IdKind::Node),
};

/// Strength, exponents and limits, whose names but two both kinds of cards share.
model::SpotWeld limits_of(const Card& card, std::string_view time, std::string_view strain) {
  constexpr double never = 1e10;
  model::SpotWeld weld;
  weld.normal_strength = card.real("SN");
  weld.shear_strength = card.real("SS");
  weld.normal_exponent = card.real("N");
  weld.shear_exponent = card.real("M");
  weld.failure_time = card.real(time);
  weld.failure_strain = card.real(strain) < never ? card.real(strain) : 0;
  return weld;
}

}  // namespace

void read_constrained_spotweld(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(spotweld_card);
    RawWeld raw;
    raw.weld = limits_of(card, "TF", "EP");
    raw.weld.id = heading.id;
    raw.node = {card.integer("N1"), card.integer("N2")};
    raw.where = card.where();
    if (card.good("N1") && card.good("N2")) deck.welds.push_back(std::move(raw));
  }
}

void read_constrained_generalized_weld_spot(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(generalized_card);
    const Card second = cards.next(generalized_spot_card);
    RawWeld raw;
    raw.weld = limits_of(second, "TFAIL", "EPSF");
    raw.weld.id = heading.id;
    raw.node_set = card.integer("NSID");
    raw.where = card.where();
    raw.limits_where = second.where();
    if (card.good("NSID")) deck.welds.push_back(std::move(raw));
  }
}

void read_constrained_rivet(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(rivet_card);
    if (card.good("N1") && card.good("N2"))
      deck.rivets.push_back(
          {heading.id, {card.integer("N1"), card.integer("N2")}, card.real("TF"), card.where()});
  }
}

void read_constrained_node_set(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(node_set_card);
    if (!card.good("NSID") || !card.good("DOF")) continue;
    deck.constrained_sets.push_back(
        {card.integer("NSID"), held_axes(card.integer("DOF")), card.real("TF"), card.where()});
  }
}

void read_constrained_linear_global(Cards& cards, RawDeck& deck) {
  const Card first = cards.next(linear_card);
  RawEquation raw;
  raw.id = first.integer("LCID");
  raw.where = first.where();
  bool good = first.good("LCID");
  while (cards.more()) {
    const Card card = cards.next_filled(linear_term_card);
    good = good && card.good("NID") && card.good("DOF") && card.good("COEF");
    raw.terms.push_back(
        {card.integer("NID"), static_cast<int>(card.integer("DOF")) - 1, card.real("COEF"), card.where()});
  }
  if (good) deck.equations.push_back(std::move(raw));
}

void read_constrained_adaptivity(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(adaptivity_card);
    if (card.good("DNID") && card.good("NID1") && card.good("NID2"))
      deck.mid_nodes.push_back(
          {{card.integer("DNID"), card.integer("NID1"), card.integer("NID2")}, card.where()});
  }
}

}  // namespace crumple::deck
