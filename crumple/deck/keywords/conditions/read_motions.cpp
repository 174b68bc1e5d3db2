// SPDX-License-Identifier: BSD-3-Clause
// *BOUNDARY_PRESCRIBED_MOTION, *LOAD_BODY, *LOAD_RIGID_BODY, *DAMPING_GLOBAL.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field motion_card[] = {
    id("NID", kind_of_target),
    axes(only(
        "DOF", {0, 1, 2, 3, 5, 6, 7},
        "1, 2, 3 are along x, y, z, 5, 6, 7 about them; directions by vectors (4, 8, below zero) and with "
        "offsets (9 to 11) are not supported")),
    only("VAD", {0, 1, 2}, "0 is a velocity, 1 an acceleration, 2 a displacement"),
    id("LCID"),
    real_or_default("SF", 1.0),
    only("VID", {0}, "directions by vectors are not supported"),
    real_or_default("DEATH", 1e28, above_zero),
    real("BIRTH", 0, not_negative),
};

constexpr Field body_load_card[] = {
    axes(id("LCID")),  // the axis is in the keyword
    real_or_default("SF", 1.0),
    only("LCIDDR", {0}, "there is no dynamic relaxation before the run"),
    unused("XC"),  // of the loads by rotation
    unused("YC"),
    unused("ZC"),
    only("CID", {0}, "only global axes are supported"),
};

constexpr Field rigid_body_load_card[] = {
    id("PID"),
    axes(only("DOF", {0, 1, 2, 3, 5, 6, 7},
              "1, 2, 3 are forces along x, y, z and 5, 6, 7 moments about them; forces that follow are not "
              "supported")),
    id("LCID"),
    real_or_default("SF", 1.0),
    only("CID", {0}, "only global axes are supported"),
    unused("M1"),  // for following loads
    unused("M2"),
    unused("M3"),
};

constexpr Field damping_card[] = {
    reference("LCID"),
    real("VALDMP", 0, not_negative),
    axes(real("STX", 0, not_negative)),
    axes(real("STY", 0, not_negative)),
    axes(real("STZ", 0, not_negative)),
    axes(real("SRX", 0, not_negative)),
    axes(real("SRY", 0, not_negative)),
    axes(real("SRZ", 0, not_negative)),
};

bool check_direction(const Card& card, Report& report) {
  if (card.good("DOF") && card.real("DOF") == 0)
    report.field_error(card.where(), {"DOF", std::string(card.text("DOF")), "1, 2, 3, 5, 6 or 7",
                                      "it is the direction, and has no default", "direction"});
  return card.good("DOF") && card.real("DOF") != 0;
}

void read_motions(Cards& cards, RawDeck& deck, RawPrescribedMotion::Target target) {
  using Kind = model::PrescribedMotion::Kind;
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(motion_card);
    RawPrescribedMotion raw;
    raw.target = target;
    raw.id = card.integer("NID");
    raw.curve = card.integer("LCID");
    raw.where = card.where();
    const int direction = static_cast<int>(card.real("DOF"));
    raw.motion.rotation = direction >= 5;
    raw.motion.axis = raw.motion.rotation ? direction - 5 : direction - 1;
    raw.motion.kind = card.real("VAD") == 0   ? Kind::Velocity
                      : card.real("VAD") == 1 ? Kind::Acceleration
                                              : Kind::Displacement;
    raw.motion.scale = card.real("SF");
    raw.motion.birth = card.real("BIRTH");
    raw.motion.death = card.real("DEATH");
    if (check_direction(card, cards.report()) && card.good("NID") && card.good("LCID"))
      deck.prescribed_motions.push_back(raw);
  }
}

void read_body_loads(Cards& cards, RawDeck& deck, int axis) {
  while (cards.more()) {
    const Card card = cards.next_filled(body_load_card);
    RawBodyLoad raw;
    raw.load = {axis, no_index, card.real("SF")};
    raw.curve = card.integer("LCID");
    raw.where = card.where();
    if (card.good("LCID")) deck.body_loads.push_back(raw);
  }
}

}  // namespace

void read_boundary_prescribed_motion_node(Cards& cards, RawDeck& deck) {
  read_motions(cards, deck, RawPrescribedMotion::Target::Node);
}

void read_boundary_prescribed_motion_set(Cards& cards, RawDeck& deck) {
  read_motions(cards, deck, RawPrescribedMotion::Target::NodeSet);
}

void read_boundary_prescribed_motion_rigid(Cards& cards, RawDeck& deck) {
  read_motions(cards, deck, RawPrescribedMotion::Target::Body);
}

void read_load_body_x(Cards& cards, RawDeck& deck) {
  read_body_loads(cards, deck, 0);
}

void read_load_body_y(Cards& cards, RawDeck& deck) {
  read_body_loads(cards, deck, 1);
}

void read_load_body_z(Cards& cards, RawDeck& deck) {
  read_body_loads(cards, deck, 2);
}

void read_damping_global(Cards& cards, RawDeck& deck) {
  const Card card = cards.next(damping_card);
  RawMassDamping raw;
  raw.damping.constant = card.real("VALDMP");
  raw.damping.translation = {card.real("STX"), card.real("STY"), card.real("STZ")};
  raw.damping.rotation = {card.real("SRX"), card.real("SRY"), card.real("SRZ")};
  // All blank means all of them.
  const std::array<double, 3> none{};
  if (raw.damping.translation == none && raw.damping.rotation == none)
    raw.damping.translation = raw.damping.rotation = {1, 1, 1};
  raw.curve = card.integer("LCID");
  raw.where = card.where();
  deck.mass_dampings.push_back(raw);
}

void read_load_rigid_body(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(rigid_body_load_card);
    const bool good = check_direction(card, cards.report()) && card.good("PID") && card.good("LCID");
    if (good)
      deck.rigid_body_loads.push_back({card.integer("PID"), static_cast<int>(card.real("DOF")),
                                       card.integer("LCID"), card.real("SF"), card.where()});
  }
}

}  // namespace crumple::deck
