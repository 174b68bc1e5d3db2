// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED, _TRANSLATIONAL: what resists the motion that joints leave free.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

consteval Field curve(std::string_view name) {
  return reference(name, IdKind::Function);
}

/// A limit of friction, or minus the number of its curve over the position.
constexpr Field limit(std::string_view name) {
  return real_or_id(name, IdKind::Function);
}

consteval Field joint_of_stiffness(std::string_view name) {
  Field field = reference(name, IdKind::Other);
  field.has_effect = false;
  return field;
}

constexpr Field bodies_card[] = {
    id("JSID", IdKind::Other),
    id("PIDA", IdKind::Part),
    id("PIDB", IdKind::Part),
    id("CIDA", IdKind::Definition),
    reference("CIDB", IdKind::Definition),
    joint_of_stiffness("JID"),
};

constexpr Field angle_curves_card[] = {
    curve("LCIDPH"), curve("LCIDT"), curve("LCIDPS"), curve("DLCIDPH"), curve("DLCIDT"), curve("DLCIDPS"),
};

constexpr Field angle_friction_card[] = {
    real("ESPH", 0, not_negative), limit("FMPH"), real("EST", 0, not_negative), limit("FMT"),
    real("ESPS", 0, not_negative), limit("FMPS"),
};

constexpr Field angle_stops_card[] = {
    real("NSAPH"), real("PSAPH"), real("NSAT"), real("PSAT"), real("NSAPS"), real("PSAPS"),
};

constexpr Field way_curves_card[] = {
    curve("LCIDX"), curve("LCIDY"), curve("LCIDZ"), curve("DLCIDX"), curve("DLCIDY"), curve("DLCIDZ"),
};

constexpr Field way_friction_card[] = {
    real("ESX", 0, not_negative), limit("FFX"), real("ESY", 0, not_negative), limit("FFY"),
    real("ESZ", 0, not_negative), limit("FFZ"),
};

constexpr Field way_stops_card[] = {
    length(real("NSDX")), length(real("PSDX")), length(real("NSDY")),
    length(real("PSDY")), length(real("NSDZ")), length(real("PSDZ")),
};

/// The cards of an option, and what the unit of its stops is in radians or lengths.
struct StiffnessCards {
  Layout curves;
  Layout friction;
  Layout stops;
  double unit;
};

void read_joint_stiffness(Cards& cards, RawDeck& deck, const StiffnessCards& layout) {
  while (cards.more()) {
    cards.heading();
    const Card bodies = cards.next(bodies_card);
    const Card curves = cards.next(layout.curves);
    const Card friction = cards.next(layout.friction);
    const Card stops = cards.next(layout.stops);
    RawJointStiffness raw;
    raw.where = bodies.where();
    raw.curves_where = curves.where();
    raw.friction_where = friction.where();
    if (!bodies.good("JSID") || !bodies.good("PIDA") || !bodies.good("PIDB") || !bodies.good("CIDA") ||
        !bodies.good("CIDB"))
      continue;
    raw.stiffness.id = bodies.integer("JSID");
    raw.body = {bodies.integer("PIDA"), bodies.integer("PIDB")};
    raw.system = {bodies.integer("CIDA"), bodies.integer("CIDB")};
    if (raw.system[1] == 0) raw.system[1] = raw.system[0];
    for (std::size_t i = 0; i < 3; ++i) {
      raw.curve[i] = curves.good(i) ? curves.integer(i) : 0;
      raw.damping_curve[i] = curves.good(i + 3) ? curves.integer(i + 3) : 0;
      model::JointResistance& resistance = raw.stiffness.resistance[i];
      resistance.stiffness = friction.real(layout.friction[2 * i].name);
      const double limit = friction.real(layout.friction[2 * i + 1].name);
      resistance.friction = std::max(limit, 0.0);
      raw.friction_curve[i] = limit < 0 ? std::llround(-limit) : 0;
      const double negative = stops.real(layout.stops[2 * i].name);
      const double positive = stops.real(layout.stops[2 * i + 1].name);
      if (negative != 0) resistance.negative_stop = -layout.unit * std::fabs(negative);
      if (positive != 0) resistance.positive_stop = layout.unit * std::fabs(positive);
    }
    raw.stiffness.is_translational = layout.unit == 1;
    deck.joint_stiffnesses.push_back(raw);
  }
}

}  // namespace

void read_constrained_joint_stiffness_generalized(Cards& cards, RawDeck& deck) {
  read_joint_stiffness(cards, deck,
                       {angle_curves_card, angle_friction_card, angle_stops_card, std::numbers::pi / 180});
}

void read_constrained_joint_stiffness_translational(Cards& cards, RawDeck& deck) {
  read_joint_stiffness(cards, deck, {way_curves_card, way_friction_card, way_stops_card, 1});
}

}  // namespace crumple::deck
