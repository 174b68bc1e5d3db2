// SPDX-License-Identifier: BSD-3-Clause
// *CONSTRAINED_JOINT: joints between two rigid bodies.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

/// A node that this kind of joint does not need.
consteval Field idle_node(std::string_view name) {
  Field field = reference(name);
  field.has_effect = false;
  return field;
}

constexpr Field relative_stiffness = real_or_default("RPS", 1, above_zero);
constexpr Field damping_factor = real_or_default("DAMP", 1, not_negative);

constexpr Field two_nodes_card[] = {
    id("N1"),        id("N2"),        idle_node("N3"),    idle_node("N4"),
    idle_node("N5"), idle_node("N6"), relative_stiffness, damping_factor,
};

constexpr Field four_nodes_card[] = {
    id("N1"),        id("N2"),        id("N3"),           id("N4"),
    idle_node("N5"), idle_node("N6"), relative_stiffness, damping_factor,
};

constexpr Field six_nodes_card[] = {
    id("N1"), id("N2"), id("N3"), id("N4"), id("N5"), id("N6"), relative_stiffness, damping_factor,
};

// The axes in which LS-DYNA writes its forces.
constexpr Field local_card[] = {unused("RAID"), unused("LST")};

Layout layout_of(model::JointKind kind) {
  switch (model::node_count(kind)) {
    case 2:
      return two_nodes_card;
    case 4:
      return four_nodes_card;
    default:
      return six_nodes_card;
  }
}

}  // namespace

void read_constrained_joint(Cards& cards, RawDeck& deck, model::JointKind kind) {
  constexpr std::string_view name[] = {"N1", "N2", "N3", "N4", "N5", "N6"};
  constexpr double no_damping = 0.01;  // up to here DAMP asks for none
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(layout_of(kind));
    if (cards.where().keyword.find("_LOCAL") != std::string_view::npos) cards.next(local_card);
    RawJoint raw;
    raw.joint.id = heading.id;
    raw.joint.kind = kind;
    raw.joint.stiffness_scale = card.real("RPS");
    raw.joint.damping = card.real("DAMP") > no_damping ? card.real("DAMP") : 0;
    raw.where = card.where();
    bool good = true;
    for (std::size_t i = 0; i < model::node_count(kind); ++i) {
      good = good && card.good(name[i]);
      if (good) raw.node[i] = card.integer(name[i]);
    }
    if (good) deck.joints.push_back(raw);
  }
}

}  // namespace crumple::deck
