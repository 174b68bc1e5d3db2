// SPDX-License-Identifier: BSD-3-Clause
// *MAT_RIGID, *CONSTRAINED_RIGID_BODIES, *CONSTRAINED_EXTRA_NODES, *CONSTRAINED_NODAL_RIGID_BODY,
// *INITIAL_VELOCITY_RIGID_BODY, *DEFORMABLE_TO_RIGID.
#include <array>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"
#include "deck/keywords/rigid_inertia.hpp"

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

/// CON1 is a coordinate system where CMO is -1, else a code.
IdKind kind_of_constraint(const Card& card) {
  return card.real("CMO") == -1 ? IdKind::Definition : IdKind::None;
}

constexpr Field constraint_card[] = {
    only("CMO", {0, 1, -1}, "0 is free, 1 holds global axes, -1 those of a coordinate system"),
    signed_id("CON1", kind_of_constraint),
    integer("CON2"),
};

constexpr Field output_axes_card[] = {
    unused("LCO"),  // axes of LS-DYNA's listings
    unused("A2"),  unused("A3"), unused("V1"), unused("V2"), unused("V3"),
};

IdKind kind_of_rigid_part(const Card& card) {
  const std::string_view type = card.text("PTYPE");
  return type == "PSET" || type == "pset" ? IdKind::Set : IdKind::Part;
}

constexpr Field rigid_part_card[] = {
    id("PID", kind_of_rigid_part),
    reference("LRB", IdKind::Part),
    text("PTYPE", 10),
};

constexpr Field merge_card[] = {
    id("PIDL"),
    id("PIDC"),
    only("IFLAG", {0}, "the merged body's centre, mass and inertia are those of all its parts"),
};

constexpr Field rigid_velocity_card[] = {
    id("PID"),
    local(velocity(real("VX"))),
    local(velocity(real("VY"))),
    local(velocity(real("VZ"))),
    local(spin(real("VXR"))),
    local(spin(real("VYR"))),
    local(spin(real("VZR"))),
    reference("ICID", IdKind::Definition),
};

constexpr Field extra_nodes_card[] = {
    id("PID"),
    id("NID", kind_of_target),
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
struct Held {
  model::RigidMaterial axes;
  UserId system = 0;  ///< in whose axes; 0 is the global ones
};

/// CMO = 1: codes of global axes.
void take_codes(const Card& card, Held& held, Report& report) {
  for (const std::string_view field : {"CON1", "CON2"})
    if (card.good(field) && (card.integer(field) < 0 || card.integer(field) > 7))
      report.field_error(card.where(), {field, std::string(card.text(field)), "0 to 7",
                                        "1, 2, 3 are x, y, z, 4 is xy, 5 yz, 6 zx, 7 all", "code"});
  held.axes.fixed_translation = held_axes(card.integer("CON1"));
  held.axes.fixed_rotation = held_axes(card.integer("CON2"));
}

/// CMO = -1: a coordinate system and six digits of 0 or 1.
void take_digits(const Card& card, Held& held, Report& report) {
  held.system = card.integer("CON1");
  if (card.good("CON1") && held.system <= 0)
    report.field_error(card.where(),
                       {"CON1", std::string(card.text("CON1")), "a coordinate system",
                        "CMO is -1: CON1 is the id of the system whose axes are held", "system"});
  std::int64_t digits = card.integer("CON2");
  bool good = digits >= 0;
  for (std::size_t place = 6; place-- > 0; digits /= 10) {
    good = good && digits % 10 <= 1;
    (place < 3 ? held.axes.fixed_translation : held.axes.fixed_rotation)[place % 3] = digits % 10 == 1;
  }
  if (card.good("CON2") && (!good || digits != 0))
    report.field_error(card.where(),
                       {"CON2", std::string(card.text("CON2")), "six digits of 0 or 1",
                        "CMO is -1: the digits hold x, y, z and the rotations about them, as in "
                        "110001",
                        "digits"});
}

/// Those of a coordinate system (CMO = -1) turn with the file; global ones cannot.
void warn_of_global_axes(const Card& card, const Cards& cards) {
  const auto depends = [&](std::string_view field) {
    return card.integer(field) != 0 && card.integer(field) != 7;
  };
  if (!(depends("CON1") || depends("CON2")) || cards.placement().map.is_shift()) return;
  cards.report().field_warning(
      card.where(),
      {"CMO", std::string(card.text("CMO")), "axes that turn with the file",
       "the global axes are taken, though *INCLUDE_TRANSFORM turns or scales the file", "placed"});
}

Held held_of(const Card& card, const Cards& cards) {
  Report& report = cards.report();
  Held held;
  if (card.real("CMO") == 1) {
    take_codes(card, held, report);
    warn_of_global_axes(card, cards);
  }
  if (card.real("CMO") == -1) take_digits(card, held, report);
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
    // Blank, the set has the number of the part: as the file has it, not as its own offset makes it.
    body.node_set = card.integer("NSID") != 0 ? card.integer("NSID")
                                              : cards.placement().id(IdKind::Set, card.written("PID"));
    body.where = card.where();
    if (options.constraints) {
      const Held held = held_of(cards.next(constraint_card), cards);
      body.held = held.axes;
      body.held_system = held.system;
    }
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
    const Card constraint = cards.next_or_default(constraint_card);
    cards.next_or_default(output_axes_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = model::Elastic{card.real("E"), card.real("PR")};
    const Held held = held_of(constraint, cards);
    raw.material.rigid = held.axes;
    raw.held_system = held.system;
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

void read_deformable_to_rigid(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(rigid_part_card);
    const std::string_view type = card.text("PTYPE");
    RawRigidPart raw;
    raw.target = card.integer("PID");
    raw.leading = card.integer("LRB");
    raw.is_set = kind_of_rigid_part(card) == IdKind::Set;
    raw.where = card.where();
    if (!type.empty() && type != "PART" && type != "part" && !raw.is_set)
      cards.report().field_error(card.where(), {"PTYPE", std::string(card.text("PTYPE")), "PART or PSET",
                                                "it says what PID is the number of", "type"});
    else if (card.good("PID") && card.good("LRB"))
      deck.rigid_parts.push_back(raw);
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

void read_initial_velocity_rigid_body(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(rigid_velocity_card);
    RawRigidVelocity raw;
    raw.body = card.integer("PID");
    raw.system = card.integer("ICID");
    raw.motion.velocity = {card.real("VX"), card.real("VY"), card.real("VZ")};
    raw.motion.angular_velocity = {card.real("VXR"), card.real("VYR"), card.real("VZR")};
    raw.where = card.where();
    if (card.good("PID") && card.good("ICID")) deck.rigid_velocities.push_back(raw);
  }
}

}  // namespace crumple::deck
