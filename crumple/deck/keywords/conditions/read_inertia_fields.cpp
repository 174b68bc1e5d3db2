// SPDX-License-Identifier: BSD-3-Clause
// *LOAD_BODY by rotation, along a vector, generalized and of some parts; *LOAD_GRAVITY_PART.
#include "deck/format/vector.hpp"
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field rotating_card[] = {
    axes(id("LCID")),  // the axis is in the keyword
    real_or_default("SF", 1.0), reference("LCIDDR", IdKind::Function),
    point(real("XC")),          point(real("YC")),
    point(real("ZC")),          only("CID", {0}, "the axis of rotation is along a global one"),
};

constexpr Field along_vector_card[] = {
    id("LCID"),
    real_or_default("SF", 1.0),
    reference("LCIDDR", IdKind::Function),
    unused("XC"),  // of the loads by rotation
    unused("YC"),
    unused("ZC"),
    reference("CID"),
};

constexpr Field vector_components_card[] = {direction(real("V1")), direction(real("V2")),
                                            direction(real("V3"))};
// In the axes of CID, which turn with the file.
constexpr Field local_components_card[] = {real("V1"), real("V2"), real("V3")};

constexpr Field body_parts_card[] = {id("PSID")};

/// N1 is a node, or a set of what the keyword says.
IdKind kind_of_loaded(const Card& card) {
  return card.where().keyword.find("_SET") != std::string_view::npos ? IdKind::Set : IdKind::Node;
}

constexpr Field generalized_card_1[] = {
    id("N1", kind_of_loaded),
    reference("N2", kind_of_loaded),
    id("LCID"),
    reference("DRLCID", IdKind::Function),
    point(real("XC")),
    point(real("YC")),
    point(real("ZC")),
};

constexpr Field generalized_card_2[] = {
    local(direction(real("AX"))),
    local(direction(real("AY"))),
    local(direction(real("AZ"))),
    local(spin(real("OMX"))),
    local(spin(real("OMY"))),
    local(spin(real("OMZ"))),
    reference("CID"),
    text("ANGTYP", 10),
};

IdKind kind_of_heavy(const Card& card) {
  return card.where().keyword.ends_with("_SET") ? IdKind::Set : IdKind::Part;
}

constexpr Field gravity_card[] = {
    id("PID", kind_of_heavy),
    axes(integer("DOF", 0, within(1, 3, "1, 2, 3 are x, y, z"))),
    reference("LC", IdKind::Function),  // 0: ACCEL stays
    real("ACCEL"),
    reference("LCDR", IdKind::Function),
    only("STGA", {0}, "there are no stages of construction"),
    only("STGR", {0}, "there are no stages of construction"),
};

void read_rotating(Cards& cards, RawDeck& deck, std::size_t axis) {
  while (cards.more()) {
    const Card card = cards.next_filled(rotating_card);
    RawInertiaField raw;
    raw.curve = card.integer("LCID");
    raw.relaxation_curve = card.integer("LCIDDR");
    raw.field.spin[axis] = card.real("SF");
    raw.field.centre = {card.real("XC"), card.real("YC"), card.real("ZC")};
    raw.where = card.where();
    if (card.good("LCID") && card.good("CID")) deck.inertia_fields.push_back(raw);
  }
}

void read_generalized(Cards& cards, RawDeck& deck, RawInertiaField::On on) {
  while (cards.more()) {
    const Card first = cards.next_filled(generalized_card_1);
    const Card second = cards.next(generalized_card_2);
    RawInertiaField raw;
    raw.on = on;
    raw.target = first.integer("N1");
    raw.last = first.integer("N2");
    raw.curve = first.integer("LCID");
    raw.relaxation_curve = first.integer("DRLCID");
    raw.field.centre = {first.real("XC"), first.real("YC"), first.real("ZC")};
    raw.field.acceleration = {second.real("AX"), second.real("AY"), second.real("AZ")};
    raw.field.spin = {second.real("OMX"), second.real("OMY"), second.real("OMZ")};
    raw.system = second.integer("CID");
    raw.where = first.where();
    const std::string_view kind = second.text("ANGTYP");
    if (!kind.empty() && kind != "CENT" && kind != "cent")
      cards.report().field_unsupported(
          second.where(), {"ANGTYP", std::string(kind), "CENT",
                           "forces of Coriolis and of angular acceleration are not supported", "inertia"});
    else if (first.good("N1") && first.good("N2") && first.good("LCID") && second.good("CID"))
      deck.inertia_fields.push_back(raw);
  }
}

void read_gravity(Cards& cards, RawDeck& deck, RawInertiaField::On on) {
  while (cards.more()) {
    const Card card = cards.next_filled(gravity_card);
    if (!card.good("PID") || !card.good("DOF") || !card.good("LC")) continue;
    RawInertiaField raw;
    raw.on = on;
    raw.target = card.integer("PID");
    raw.curve = card.integer("LC");
    raw.relaxation_curve = card.integer("LCDR");
    raw.field.acceleration[static_cast<std::size_t>(card.integer("DOF") - 1)] = card.real("ACCEL");
    raw.where = card.where();
    deck.inertia_fields.push_back(raw);
  }
}

}  // namespace

void read_load_body_rx(Cards& cards, RawDeck& deck) {
  read_rotating(cards, deck, 0);
}

void read_load_body_ry(Cards& cards, RawDeck& deck) {
  read_rotating(cards, deck, 1);
}

void read_load_body_rz(Cards& cards, RawDeck& deck) {
  read_rotating(cards, deck, 2);
}

void read_load_body_vector(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(along_vector_card);
    const bool is_local = card.integer("CID") != 0;
    const Card second = cards.next(is_local ? Layout(local_components_card) : Layout(vector_components_card));
    const Vector given = {second.real("V1"), second.real("V2"), second.real("V3")};
    RawInertiaField raw;
    raw.curve = card.integer("LCID");
    raw.relaxation_curve = card.integer("LCIDDR");
    raw.system = card.integer("CID");
    raw.where = card.where();
    const double length = length_of(given);
    if (second.good("V1") && !(length > 0)) {
      cards.report().field_error(second.where(), {"V1", std::string(second.text("V1")), "a direction",
                                                  "V1, V2, V3 must not all be zero", "vector"});
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) raw.field.acceleration[i] = card.real("SF") * given[i] / length;
    if (card.good("LCID") && card.good("CID")) deck.inertia_fields.push_back(raw);
  }
}

void read_load_body_parts(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(body_parts_card);
    if (card.good("PSID")) deck.body_load_parts.push_back({card.integer("PSID"), card.where()});
  }
}

void read_load_body_generalized(Cards& cards, RawDeck& deck) {
  read_generalized(cards, deck, RawInertiaField::On::NodeRange);
}

void read_load_body_generalized_set_node(Cards& cards, RawDeck& deck) {
  read_generalized(cards, deck, RawInertiaField::On::NodeSet);
}

void read_load_body_generalized_set_part(Cards& cards, RawDeck& deck) {
  read_generalized(cards, deck, RawInertiaField::On::PartSet);
}

void read_load_gravity_part(Cards& cards, RawDeck& deck) {
  read_gravity(cards, deck, RawInertiaField::On::Part);
}

void read_load_gravity_part_set(Cards& cards, RawDeck& deck) {
  read_gravity(cards, deck, RawInertiaField::On::PartSet);
}

}  // namespace crumple::deck
