// SPDX-License-Identifier: BSD-3-Clause
// *BOUNDARY_SPC and *INITIAL_VELOCITY.
#include <cmath>

#include "deck/format/numbers.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Check fixed_or_free = within(0, 1, "0 is free, 1 fixed");

constexpr Field held_x = local(axes(integer("DOFX", 0, fixed_or_free)));
constexpr Field held_y = local(axes(integer("DOFY", 0, fixed_or_free)));
constexpr Field held_z = local(axes(integer("DOFZ", 0, fixed_or_free)));
constexpr Field held_rx = local(axes(integer("DOFRX", 0, fixed_or_free)));
constexpr Field held_ry = local(axes(integer("DOFRY", 0, fixed_or_free)));
constexpr Field held_rz = local(axes(integer("DOFRZ", 0, fixed_or_free)));

constexpr Field spc_card[] = {
    id("NID", IdKind::Node), reference("CID"), held_x, held_y, held_z, held_rx, held_ry, held_rz,
};

constexpr Field spc_set_card[] = {
    reference("NSID", IdKind::Set), reference("CID"), held_x, held_y, held_z, held_rx, held_ry, held_rz,
};

constexpr Field birth_death_card[] = {
    real("BIRTH", 0, not_negative),
    real_or_default("DEATH", 1e20, above_zero),
};

constexpr Field start_time_card[] = {
    only("STIME", {0}, "velocities are given at time zero"),
};

constexpr Field velocity_card_1[] = {
    reference("NSID"),
    reference("NSIDEX"),
    reference("BOXID"),
    only("IRIGID", {0, -1, -2},
         "-1 and -2 go before the velocities of *PART_INERTIA, 0 does not; sets of parts are not supported"),
    reference("ICID", IdKind::Definition),
};

constexpr Field velocity_card_2[] = {velocity(real("VX")), velocity(real("VY")), velocity(real("VZ")),
                                     spin(real("VXR")),    spin(real("VYR")),    spin(real("VZR"))};

constexpr Field velocity_card_3[] = {velocity(real("VXE")), velocity(real("VYE")), velocity(real("VZE")),
                                     spin(real("VXRE")),    spin(real("VYRE")),    spin(real("VZRE"))};

// The same in the axes of ICID, which turn with the file.
constexpr Field local_velocity_card_2[] = {real("VX"),  real("VY"),  real("VZ"),
                                           real("VXR"), real("VYR"), real("VZR")};

constexpr Field local_velocity_card_3[] = {real("VXE"),  real("VYE"),  real("VZE"),
                                           real("VXRE"), real("VYRE"), real("VZRE")};

constexpr Field velocity_node_card[] = {
    id("NID"),
    local(velocity(real("VX"))),
    local(velocity(real("VY"))),
    local(velocity(real("VZ"))),
    local(spin(real("VXR"))),
    local(spin(real("VYR"))),
    local(spin(real("VZR"))),
    reference("ICID", IdKind::Definition),
};

/// STYP 2 is a part, others are sets.
IdKind kind_of_generation(const Card& card) {
  return card.integer("STYP") == 2 ? IdKind::Part : IdKind::Set;
}

constexpr Field generation_card_1[] = {
    reference("ID", kind_of_generation),
    integer("STYP", 1, within(1, 3, "1 is a part set, 2 a part, 3 a node set")),
    real("OMEGA"),
    local(velocity(real("VX"))),
    local(velocity(real("VY"))),
    local(velocity(real("VZ"))),
    only("IVATN", {0, 1}, "1 is for what is tied to the rigid parts as well, 0 is not"),
    reference("ICID", IdKind::Definition),
};

constexpr Check given_velocities =
    check_of(Check::Kind::Only, {0, 1}, "1 goes before the velocities of *PART_INERTIA, 0 does not");

constexpr Field generation_card_2[] = {
    point(real("XC")),
    point(real("YC")),
    point(real("ZC")),
    spin(real("NX")),
    spin(real("NY")),
    spin(real("NZ")),
    only("PHASE", {0, 1}, "0 is with a dynamic relaxation, 1 after it"),
    real("IRIGID", 0, given_velocities),
};

// The same with the axis along those of ICID.
constexpr Field local_generation_card_2[] = {
    point(real("XC")),
    point(real("YC")),
    point(real("ZC")),
    real("NX"),
    real("NY"),
    real("NZ"),
    only("PHASE", {0, 1}, "0 is with a dynamic relaxation, 1 after it"),
    real("IRIGID", 0, given_velocities),
};

enum class SupportTimes { WholeRun, Given };

/// Reports a card of a set without its id; a row of zeros, as programs that write decks leave it, with a
/// warning alone. True, as it is left out.
bool names_no_set(const RawFixed& fixed, Report& report) {
  const std::array<bool, 3> none{};
  FieldFault fault{"NSID", "0", "the id of a set of nodes", "the card holds nothing, and is left out",
                   "no set"};
  if (fixed.translation == none && fixed.rotation == none) {
    report.field_warning(fixed.where, fault);
  } else {
    fault.hint = "";
    report.field_error(fixed.where, fault);
  }
  return true;
}

void read_spc(Cards& cards, RawDeck& deck, bool is_set, SupportTimes times = SupportTimes::WholeRun) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(is_set ? Layout(spc_set_card) : Layout(spc_card));
    const std::string_view target = is_set ? "NSID" : "NID";
    RawFixed fixed;
    fixed.target = card.integer(target);
    fixed.is_set = is_set;
    fixed.translation = {card.integer("DOFX") == 1, card.integer("DOFY") == 1, card.integer("DOFZ") == 1};
    fixed.rotation = {card.integer("DOFRX") == 1, card.integer("DOFRY") == 1, card.integer("DOFRZ") == 1};
    fixed.system = card.good("CID") ? card.integer("CID") : 0;
    fixed.where = card.where();
    if (times == SupportTimes::Given) {
      const Card second = cards.next(birth_death_card);
      fixed.is_timed = true;
      fixed.birth = second.real("BIRTH");
      fixed.death = second.real("DEATH");
    }
    if (card.good(target) && fixed.target == 0 && names_no_set(fixed, cards.report())) continue;
    if (card.good(target) && card.good("CID")) deck.fixed.push_back(fixed);
  }
}

/// The rotation axis times OMEGA, from the second card of GENERATION.
void take_rotation(const Card& card, double omega, RawVelocity& velocity, Report& report) {
  constexpr double nodes_give_axis = -999;
  std::array<double, 3> axis = {card.real("NX"), card.real("NY"), card.real("NZ")};
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (card.written_real("NX") == nodes_give_axis) {
    report.field_unsupported(card.where(), {"NX", "-999", "the direction of the axis",
                                            "an axis through two nodes is not supported", "axis"});
    return;
  }
  if (!(length > 0)) {
    report.field_error(card.where(), {"NX", std::string(card.text("NX")), "the direction of the axis",
                                      "OMEGA is not zero, so NX, NY, NZ must not all be zero", "axis"});
    return;
  }
  velocity.rotates = true;
  for (std::size_t i = 0; i < 3; ++i) velocity.spin[i] = omega * axis[i] / length;
  velocity.axis_point = {card.real("XC"), card.real("YC"), card.real("ZC")};
}

}  // namespace

void read_boundary_spc_node(Cards& cards, RawDeck& deck) {
  read_spc(cards, deck, false);
}

void read_boundary_spc_set(Cards& cards, RawDeck& deck) {
  read_spc(cards, deck, true);
}

void read_boundary_spc_node_birth_death(Cards& cards, RawDeck& deck) {
  read_spc(cards, deck, false, SupportTimes::Given);
}

void read_boundary_spc_set_birth_death(Cards& cards, RawDeck& deck) {
  read_spc(cards, deck, true, SupportTimes::Given);
}

void read_initial_velocity(Cards& cards, RawDeck& deck) {
  const Card first = cards.next(velocity_card_1);
  const bool is_local = first.integer("ICID") != 0;
  const Card second = cards.next(is_local ? Layout(local_velocity_card_2) : Layout(velocity_card_2));
  RawVelocity velocity;
  velocity.system = first.integer("ICID");
  velocity.box = first.integer("BOXID");
  velocity.id = first.integer("NSID");
  velocity.target = velocity.id == 0 ? RawVelocity::Target::All : RawVelocity::Target::NodeSet;
  velocity.velocity = {second.real("VX"), second.real("VY"), second.real("VZ")};
  velocity.angular_velocity = {second.real("VXR"), second.real("VYR"), second.real("VZR")};
  velocity.exempt_set = first.integer("NSIDEX");
  velocity.replaces_given = first.real("IRIGID") < 0;
  if (velocity.exempt_set > 0) {
    const Card third = cards.next(is_local ? Layout(local_velocity_card_3) : Layout(velocity_card_3));
    velocity.exempt_velocity = {third.real("VXE"), third.real("VYE"), third.real("VZE")};
    velocity.exempt_angular_velocity = {third.real("VXRE"), third.real("VYRE"), third.real("VZRE")};
  }
  velocity.where = first.where();
  const bool good = first.good("NSID") && first.good("NSIDEX") && first.good("BOXID") && first.good("ICID");
  if (good) deck.velocities.push_back(velocity);
}

void read_initial_velocity_node(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(velocity_node_card);
    if (!card.good("NID") || !card.good("ICID")) continue;
    RawVelocity velocity;
    velocity.target = RawVelocity::Target::Node;
    velocity.system = card.integer("ICID");
    velocity.id = card.integer("NID");
    velocity.velocity = {card.real("VX"), card.real("VY"), card.real("VZ")};
    velocity.angular_velocity = {card.real("VXR"), card.real("VYR"), card.real("VZR")};
    velocity.where = card.where();
    deck.velocities.push_back(velocity);
  }
}

void read_initial_velocity_generation(Cards& cards, RawDeck& deck) {
  do {
    const Card first = cards.next(generation_card_1);
    const bool is_local = first.integer("ICID") != 0;
    const Card second = cards.next(is_local ? Layout(local_generation_card_2) : Layout(generation_card_2));
    RawVelocity velocity;
    velocity.system = first.integer("ICID");
    velocity.id = first.integer("ID");
    constexpr std::array targets = {RawVelocity::Target::PartSet, RawVelocity::Target::Part,
                                    RawVelocity::Target::NodeSet};
    if (velocity.id > 0 && first.good("STYP"))
      velocity.target = targets[static_cast<std::size_t>(first.integer("STYP") - 1)];
    velocity.velocity = {first.real("VX"), first.real("VY"), first.real("VZ")};
    velocity.is_generation = true;
    velocity.begins_at_once = second.real("PHASE") == 0;
    velocity.replaces_given = second.real("IRIGID") == 1;
    velocity.of_whole_bodies = first.real("IVATN") == 1;
    velocity.where = first.where();
    const double omega = first.real("OMEGA");
    if (omega != 0) take_rotation(second, omega, velocity, cards.report());
    if (first.good("ID") && first.good("STYP") && first.good("ICID")) deck.velocities.push_back(velocity);
  } while (cards.more());
}

void read_initial_velocity_generation_start_time(Cards& cards, RawDeck& /*deck*/) {
  cards.next_or_default(start_time_card);
}

}  // namespace crumple::deck
