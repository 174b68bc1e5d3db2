// SPDX-License-Identifier: BSD-3-Clause
// *RIGIDWALL_PLANAR and *RIGIDWALL_GEOMETRIC.

#include <cmath>
#include <optional>

#include "deck/format/vector.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;
using model::WallShape;
constexpr Check friction_range =
    within(0, 1, "0 slides, 1 sticks; nodes that stay welded (2, 3) are not supported");

constexpr Field planar_card_1[] = {
    reference("NSID"),
    reference("NSIDEX"),
    reference("BOXID"),
    only("OFFSET", {0}, "choose the nodes with NSID or BOXID"),
    real("BIRTH", 0, not_negative),
    real_or_default("DEATH", 1e20, above_zero),
    unused("RWKSF"),  // of a penalty for rigid bodies
};

constexpr Field geometric_card_1[] = {
    reference("NSID"),
    reference("NSIDEX"),
    reference("BOXID"),
    real("BIRTH", 0, not_negative),
    real_or_default("DEATH", 1e20, above_zero),
};

constexpr Field card_2[] = {
    point(real("XT")),
    point(real("YT")),
    point(real("ZT")),
    point(real("XH")),
    point(real("YH")),
    point(real("ZH")),
    real("FRIC", 0, friction_range),
    unused("WVEL"),  // for FRIC 2 and 3
};

constexpr Field flat_card[] = {
    point(real("XHEV")),
    point(real("YHEV")),
    point(real("ZHEV")),
    length(real("LENL", 0, not_negative)),
    length(real("LENM", 0, not_negative)),
};

constexpr Field moving_card[] = {real("MASS", 0, above_zero), length(real("V0"))};

// What shows the force of the wall in LS-DYNA. SOFT spreads the stop of a node over some cycles.
constexpr Field forces_card[] = {
    harmless("SOFT", {0}, "nodes stop at the wall within a step"),
    unused("SSID"),
    unused("N1"),
    unused("N2"),
    unused("N3"),
    unused("N4"),
};

constexpr Field prism_card[] = {
    point(real("XHEV")),
    point(real("YHEV")),
    point(real("ZHEV")),
    length(real("LENL", 0, not_negative)),
    length(real("LENM", 0, not_negative)),
    length(real("LENP", 0, not_negative)),
};

constexpr Field cylinder_card[] = {
    length(real("RADCYL", 0, above_zero)),
    length(real("LENCYL", 0, not_negative)),
    only("NSEGS", {0}, "cylinders of several segments are not supported"),
};

constexpr Field sphere_card[] = {length(real("RADSPH", 0, above_zero))};

constexpr Field motion_card[] = {
    id("LCID"),           only("OPT", {0, 1}, "0 prescribes the velocity, 1 the displacement"),
    velocity(real("VX")), velocity(real("VY")),
    velocity(real("VZ")),
};

// What LS-DYNA draws the wall with.
constexpr Field display_card[] = {unused("PID"), unused("RO"), unused("E"), unused("PR")};

/// The unit vector from the tail to the head; reports one without length unless the wall has no use for it.
Vector direction(const Card& card, Report& report) {
  Vector v = {card.real("XH") - card.real("XT"), card.real("YH") - card.real("YT"),
              card.real("ZH") - card.real("ZT")};
  const double length = length_of(v);
  if (length > 0)
    for (double& component : v) component /= length;
  else if (card.good("XH"))
    report.error(card.where(), "normal",
                 "tail (XT, YT, ZT) and head (XH, YH, ZH) are the same point, expected a vector from "
                 "the wall towards the body");
  return v;
}

/// l of a rectangle or prism: from the corner to the edge's head, made square to the normal.
void take_edge(const Card& card, model::RigidWall& wall, Report& report) {
  wall.lengths[0] = card.real("LENL");
  wall.lengths[1] = card.real("LENM");
  const Vector head = {card.real("XHEV"), card.real("YHEV"), card.real("ZHEV")};
  Vector edge{};
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = head[i] - wall.point[i];
    along += edge[i] * wall.normal[i];
  }
  const double length = length_of(edge);
  for (std::size_t i = 0; i < 3; ++i) edge[i] -= along * wall.normal[i];
  const double square = length_of(edge);
  constexpr double hardly = 1e-6;
  if (!(square > hardly * length)) {
    report.field_error(card.where(), {"XHEV", std::string(card.text("XHEV")), "the head of the edge vector l",
                                      "its tail is (XT, YT, ZT); it must not be along the normal", "edge"});
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) wall.edge[i] = edge[i] / square;
}

/// Nodes, time, place, direction and friction: what the first two cards say.
RawWall take_common(const Heading& heading, const Card& first, const Card& second) {
  RawWall raw;
  raw.wall.id = heading.id;
  raw.wall.title = heading.title;
  raw.wall.point = {second.real("XT"), second.real("YT"), second.real("ZT")};
  raw.wall.friction = second.good("FRIC") ? second.real("FRIC") : 0;
  raw.wall.birth_time = first.real("BIRTH");
  raw.wall.death_time = first.real("DEATH");
  raw.node_set = first.integer("NSID");
  raw.exempt_set = first.integer("NSIDEX");
  raw.box = first.integer("BOXID");
  raw.where = first.where();
  return raw;
}

bool good(const Card& first) {
  return first.good("NSID") && first.good("NSIDEX") && first.good("BOXID");
}

bool has_option(const Cards& cards, std::string_view option) {
  return cards.where().keyword.find(option) != std::string_view::npos;
}

void take_shape(Cards& cards, RawWall& raw) {
  model::RigidWall& wall = raw.wall;
  if (has_option(cards, "_FLAT")) {
    wall.shape = WallShape::Flat;
    take_edge(cards.next(flat_card), wall, cards.report());
  } else if (has_option(cards, "_PRISM")) {
    wall.shape = WallShape::Prism;
    const Card card = cards.next(prism_card);
    take_edge(card, wall, cards.report());
    wall.lengths[2] = card.real("LENP");
  } else if (has_option(cards, "_CYLINDER")) {
    wall.shape = WallShape::Cylinder;
    const Card card = cards.next(cylinder_card);
    wall.radius = card.real("RADCYL");
    wall.lengths[0] = card.real("LENCYL");
  } else {
    wall.shape = WallShape::Sphere;
    wall.radius = cards.next(sphere_card).real("RADSPH");
  }
}

/// N1 to N4, which move with a wall in LS-DYNA to show where it is.
void warn_of_shown_nodes(const Card& card, const RawWall& raw, Report& report) {
  if (!(raw.wall.mass > 0) || card.real("N1") == 0) return;
  report.field_warning(
      card.where(),
      {"N1", std::string(card.text("N1")), "no node",
       "nodes that show the wall do not move with it: what nodout has of them is not the motion "
       "of the wall, which is in rwmotion.csv",
       "shown nodes"});
}

void take_motion(Cards& cards, RawWall& raw) {
  const Card card = cards.next(motion_card);
  raw.wall.motion.is_displacement = card.real("OPT") == 1;
  raw.wall.motion.direction = {card.real("VX"), card.real("VY"), card.real("VZ")};
  raw.motion_curve = card.good("LCID") ? card.integer("LCID") : 0;
  raw.motion_where = card.where();
  if (!(length_of(raw.wall.motion.direction) > 0))
    cards.report().field_error(card.where(),
                               {"VX", std::string(card.text("VX")), "the direction of the motion",
                                "VX, VY, VZ must not all be zero", "direction"});
}

}  // namespace

void read_rigidwall_planar(Cards& cards, RawDeck& deck) {
  do {
    const Heading heading = cards.heading();
    const Card first = cards.next(planar_card_1);
    const Card second = cards.next(card_2);
    RawWall raw = take_common(heading, first, second);
    raw.wall.normal = direction(second, cards.report());
    if (has_option(cards, "_FINITE")) {
      raw.wall.shape = WallShape::Flat;
      take_edge(cards.next(flat_card), raw.wall, cards.report());
    }
    // Its card comes after that of FINITE, whatever the order in the keyword's name.
    if (has_option(cards, "_MOVING")) {
      const Card moving = cards.next(moving_card);
      raw.wall.mass = moving.real("MASS");
      raw.wall.initial_velocity = moving.real("V0");
    }
    if (has_option(cards, "_FORCES")) warn_of_shown_nodes(cards.next(forces_card), raw, cards.report());
    if (has_option(cards, "_DISPLAY") && cards.has_line()) cards.next(display_card);
    if (good(first)) deck.walls.push_back(std::move(raw));
  } while (cards.more());
}

void read_rigidwall_geometric(Cards& cards, RawDeck& deck) {
  do {
    const Heading heading = cards.heading();
    const Card first = cards.next(geometric_card_1);
    const Card second = cards.next(card_2);
    RawWall raw = take_common(heading, first, second);
    // A sphere looks the same from all sides.
    if (!has_option(cards, "_SPHERE")) raw.wall.normal = direction(second, cards.report());
    take_shape(cards, raw);
    if (has_option(cards, "_MOTION")) take_motion(cards, raw);
    if (has_option(cards, "_DISPLAY") && cards.has_line()) cards.next(display_card);
    if (good(first)) deck.walls.push_back(std::move(raw));
  } while (cards.more());
}

}  // namespace crumple::deck
