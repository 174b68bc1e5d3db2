// SPDX-License-Identifier: BSD-3-Clause
// *MAT_RIGID, *CONSTRAINED_RIGID_BODIES, *CONSTRAINED_EXTRA_NODES, *CONSTRAINED_NODAL_RIGID_BODY.
#include <array>

#include "deck/families.hpp"
#include "deck/material_cards.hpp"
#include "deck/rigid_inertia.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_coupling = "coupling to other programs is not supported";

constexpr Field rigid_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),  // of the contact stiffness
    real("PR", 0, poisson),
    only("N", {0}, no_coupling),
    only("COUPLE", {0}, no_coupling),
    unused("M"),  // a number in the other program
    only("ALIAS", {0}, no_coupling),
};

constexpr Field constraint_card[] = {
    only("CMO", {0, 1}, "0 is free, 1 holds global axes; constraints in local axes are not supported"),
    integer("CON1", 0, within(0, 7, "1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all")),
    integer("CON2", 0, within(0, 7, "1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all")),
};

constexpr Field output_axes_card[] = {
    unused("LCO"),  // axes of LS-DYNA's listings
    unused("A2"),  unused("A3"), unused("V1"), unused("V2"), unused("V3"),
};

constexpr Field merge_card[] = {
    id("PIDL"),
    id("PIDC"),
    only("IFLAG", {0}, "the merged body's centre, mass and inertia are those of all its parts"),
};

constexpr Field extra_nodes_card[] = {
    id("PID"),
    id("NID"),
    only("IFLAG", {0, 1}, "1 adds the masses of the nodes to those of *PART_INERTIA, 0 does not"),
};

constexpr Field nodal_body_card[] = {
    id("PID"),
    harmless("CID", {0}, "the axes of LS-DYNA's listings"),
    reference("NSID"),
    harmless("PNODE", {0}, "a node for LS-DYNA's post-processing"),
    harmless("IPRT", {0}, "it is about LS-DYNA's listings"),
    only("DRFLAG", {0}, "released degrees of freedom are not supported"),
    only("RRFLAG", {0}, "released degrees of freedom are not supported"),
};

void read_extra_nodes(Cards& cards, RawDeck& deck, bool is_set) {
  while (cards.more()) {
    const Card card = cards.next_filled(extra_nodes_card);
    if (!card.good("PID") || !card.good("NID")) continue;
    deck.extra_nodes.push_back(
        {card.integer("PID"), card.integer("NID"), is_set, card.real("IFLAG") == 1, card.where()});
  }
}

/// What a card with CMO, CON1 and CON2 holds.
model::RigidMaterial held_of(const Card& card) {
  model::RigidMaterial held;
  if (card.real("CMO") != 1) return held;
  held.fixed_translation = held_axes(card.integer("CON1"));
  held.fixed_rotation = held_axes(card.integer("CON2"));
  return held;
}

/// Which cards the options of a nodal rigid body add, in this order.
struct NodalBodyOptions {
  bool constraints = false;  ///< SPC
  bool inertia = false;      ///< INERTIA
};

void read_nodal_bodies(Cards& cards, RawDeck& deck, const NodalBodyOptions& options) {
  while (cards.more()) {
    RawNodalBody body;
    body.title = cards.heading().title;
    const Card card = cards.next(nodal_body_card);
    body.id = card.integer("PID");
    body.node_set = card.integer("NSID") != 0 ? card.integer("NSID") : body.id;
    body.where = card.where();
    if (options.constraints) body.held = held_of(cards.next(constraint_card));
    if (options.inertia) body.inertia = read_inertia(cards);
    if (card.good("PID") && card.good("NSID")) deck.nodal_bodies.push_back(std::move(body));
  }
}

}  // namespace

std::array<bool, 3> held_axes(std::int64_t code) {
  return {code == 1 || code == 4 || code == 6 || code == 7, code == 2 || code == 4 || code == 5 || code == 7,
          code == 3 || code == 5 || code == 6 || code == 7};
}

void read_mat_rigid(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(rigid_card);
    const Card constraint = cards.next(constraint_card);
    cards.next(output_axes_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = model::Elastic{card.real("E"), card.real("PR")};
    raw.material.rigid = held_of(constraint);
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_constrained_rigid_bodies(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(merge_card);
    if (card.good("PIDL") && card.good("PIDC"))
      deck.rigid_merges.push_back({card.integer("PIDL"), card.integer("PIDC"), card.where()});
  }
}

void read_constrained_extra_nodes_node(Cards& cards, RawDeck& deck) {
  read_extra_nodes(cards, deck, false);
}

void read_constrained_extra_nodes_set(Cards& cards, RawDeck& deck) {
  read_extra_nodes(cards, deck, true);
}

void read_constrained_nodal_rigid_body(Cards& cards, RawDeck& deck) {
  read_nodal_bodies(cards, deck, {});
}

void read_constrained_nodal_rigid_body_inertia(Cards& cards, RawDeck& deck) {
  read_nodal_bodies(cards, deck, {.constraints = false, .inertia = true});
}

void read_constrained_nodal_rigid_body_spc(Cards& cards, RawDeck& deck) {
  read_nodal_bodies(cards, deck, {.constraints = true, .inertia = false});
}

void read_constrained_nodal_rigid_body_spc_inertia(Cards& cards, RawDeck& deck) {
  read_nodal_bodies(cards, deck, {.constraints = true, .inertia = true});
}

}  // namespace crumple::deck
