// SPDX-License-Identifier: BSD-3-Clause
// *BOUNDARY_PRESCRIBED_MOTION, *LOAD_BODY along an axis, *LOAD_RIGID_BODY.
#include <cstdlib>
#include <string>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field motion_card[] = {
    id("NID", kind_of_target),
    axes(integer("DOF")),
    only("VAD", {0, 1, 2}, "0 is a velocity, 1 an acceleration, 2 a displacement"),
    id("LCID"),
    real_or_default("SF", 1.0),
    reference("VID"),
    real_or_default("DEATH", 1e28, above_zero),
    real("BIRTH", 0, not_negative),
};

// Behind the card of a motion round an axis (DOF 9 to 11), or of two nodes (VAD 4).
constexpr Field motion_offset_card[] = {
    real("OFFSET1"), real("OFFSET2"), unused("LRB"), unused("NODE1"), unused("NODE2"),
};

constexpr Field body_load_card[] = {
    local(axes(id("LCID"))),  // the axis is in the keyword
    real_or_default("SF", 1.0),
    reference("LCIDDR", IdKind::Function),
    unused("XC"),  // of the loads by rotation
    unused("YC"),
    unused("ZC"),
    reference("CID"),
};

constexpr Field rigid_body_load_card[] = {
    id("PID"),
    local(axes(integer("DOF"))),
    id("LCID"),
    real_or_default("SF", 1.0),
    reference("CID"),
    reference("M1", IdKind::Node),
    reference("M2", IdKind::Node),
    reference("M3", IdKind::Node),
};

constexpr std::string_view directions_of_loads =
    "1, 2, 3 are forces along x, y, z and 5, 6, 7 moments about them, 4 and 8 along and about the normal of "
    "M1, "
    "M2, M3";
constexpr std::string_view directions_of_motions =
    "1, 2, 3 are along x, y, z, 5, 6, 7 about them, 4 and 8 along and about the vector VID; "
    "nodes may also go round an axis (9 to 11)";
constexpr int first_round = 9;
constexpr int last_round = 11;

/// Of DOF from 1 to 8: whether it may be that, which must be given.
bool check_direction(const Card& card, std::string_view meaning, Report& report) {
  if (!card.good("DOF")) return false;
  const std::int64_t direction = card.integer("DOF");
  if (direction >= 1 && direction <= 8) return true;
  FieldFault fault{"DOF", std::string(card.text("DOF")), "a number from 1 to 8", std::string(meaning),
                   "direction"};
  if (direction == 0) {
    fault.hint = "it is the direction, and has no default";
    report.field_error(card.where(), fault);
  } else {
    report.field_unsupported(card.where(), fault);
  }
  return false;
}

/// The same of motions, which along vectors may have a sign.
bool check_motion_direction(const Card& card, bool of_body, Report& report) {
  const std::int64_t direction = card.integer("DOF");
  const bool along_vector = std::abs(direction) == 4 || std::abs(direction) == 8;
  if (!of_body && std::abs(direction) >= first_round && std::abs(direction) <= last_round)
    return card.good("DOF");
  if (!along_vector) return check_direction(card, directions_of_motions, report);
  const std::string text(card.text("DOF"));
  if (direction < 0 && of_body) {
    report.field_unsupported(
        card.where(),
        {"DOF", text, "4 or 8", "below zero what is across the vector is held, which is for nodes alone",
         "direction"});
    return false;
  }
  if (card.good("VID") && card.integer("VID") == 0) {
    report.field_error(card.where(), {"VID", std::string(card.text("VID")), "the number of a *DEFINE_VECTOR",
                                      "DOF " + text + " is along or about it", "vector"});
    return false;
  }
  return card.good("DOF") && card.good("VID");
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
    const int direction = static_cast<int>(card.integer("DOF"));
    const int magnitude = std::abs(direction);
    const bool by_vector = magnitude == 4 || magnitude == 8;
    raw.motion.goes_round = magnitude >= first_round && magnitude <= last_round;
    raw.motion.rotation = magnitude >= 5 && !raw.motion.goes_round;
    raw.motion.axis = by_vector ? 0 : (magnitude - 1) % 4;
    raw.motion.holds_plane = by_vector && direction < 0;
    raw.motion.keeps_radius = direction > 0;
    raw.vector = by_vector ? card.integer("VID") : 0;
    raw.motion.kind = card.real("VAD") == 0   ? Kind::Velocity
                      : card.real("VAD") == 1 ? Kind::Acceleration
                                              : Kind::Displacement;
    raw.motion.scale = card.real("SF");
    raw.motion.birth = card.real("BIRTH");
    raw.motion.death = card.real("DEATH");
    constexpr int of_two_nodes = 4;
    const bool has_second_card = raw.motion.goes_round || card.text("VAD") == std::to_string(of_two_nodes);
    if (has_second_card && cards.has_line()) {
      const Card offsets = cards.next(motion_offset_card);
      raw.motion.centre[static_cast<std::size_t>((raw.motion.axis + 1) % 3)] = offsets.real("OFFSET1");
      raw.motion.centre[static_cast<std::size_t>((raw.motion.axis + 2) % 3)] = offsets.real("OFFSET2");
    }
    raw.motion.centre = cards.placement().map.of_point(raw.motion.centre);
    const bool of_body = target == RawPrescribedMotion::Target::Body;
    if (check_motion_direction(card, of_body, cards.report()) && card.good("NID") && card.good("LCID"))
      deck.prescribed_motions.push_back(raw);
  }
}

void read_body_loads(Cards& cards, RawDeck& deck, int axis) {
  while (cards.more()) {
    const Card card = cards.next_filled(body_load_card);
    RawBodyLoad raw;
    raw.load = {axis, no_index, card.real("SF")};
    raw.curve = card.integer("LCID");
    raw.relaxation_curve = card.integer("LCIDDR");
    raw.system = card.integer("CID");
    raw.where = card.where();
    if (card.good("LCID") && card.good("LCIDDR") && card.good("CID")) deck.body_loads.push_back(raw);
  }
}

}  // namespace

bool check_followed_nodes(const Card& card, Report& report) {
  const std::int64_t direction = card.integer("DOF");
  if (direction != 4 && direction != 8) return true;
  for (const std::string_view field : {"M1", "M2", "M3"}) {
    if (!card.good(field)) return false;
    if (card.integer(field) != 0) continue;
    report.field_error(card.where(), {field, std::string(card.text(field)), "the number of a node",
                                      "DOF 4 and 8 are along and about the normal of M1, M2, M3", "plane"});
    return false;
  }
  return true;
}

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

void read_load_rigid_body(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(rigid_body_load_card);
    const bool good = check_direction(card, directions_of_loads, cards.report()) &&
                      check_followed_nodes(card, cards.report()) && card.good("PID") && card.good("LCID") &&
                      card.good("CID");
    if (good)
      deck.rigid_body_loads.push_back({card.integer("PID"),
                                       static_cast<int>(card.integer("DOF")),
                                       card.integer("LCID"),
                                       card.real("SF"),
                                       card.where(),
                                       card.integer("CID"),
                                       {card.integer("M1"), card.integer("M2"), card.integer("M3")}});
  }
}

}  // namespace crumple::deck
