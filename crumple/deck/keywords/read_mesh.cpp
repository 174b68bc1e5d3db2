// SPDX-License-Identifier: BSD-3-Clause
// *NODE, *ELEMENT_SHELL, *ELEMENT_MASS.
#include <fmt/core.h>

#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/mirrored.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Check constraint_code = within(0, 7, "0 is free, 1-3 fix x, y, z, 4 xy, 5 yz, 6 zx, 7 all");

constexpr Field node_card[] = {
    sized(8, id("NID")),
    sized(16, point(real("X"))),
    sized(16, point(real("Y"))),
    sized(16, point(real("Z"))),
    sized(8, axes(integer("TC", 0, constraint_code))),
    sized(8, axes(integer("RC", 0, constraint_code))),
};

constexpr std::string_view four_nodes = "shells have three or four nodes";

constexpr Field shell_card[] = {
    sized(8, id("EID")),
    sized(8, id("PID")),
    sized(8, id("N1")),
    sized(8, id("N2")),
    sized(8, id("N3")),
    sized(8, reference("N4")),  // zero, or N3 again, is a triangle
    sized(8, only("N5", {0}, four_nodes)),
    sized(8, only("N6", {0}, four_nodes)),
    sized(8, only("N7", {0}, four_nodes)),
    sized(8, only("N8", {0}, four_nodes)),
};

constexpr Field thickness_card[] = {
    sized(16, real("THIC1", 0, not_negative)),
    sized(16, real("THIC2", 0, not_negative)),
    sized(16, real("THIC3", 0, not_negative)),
    sized(16, real("THIC4", 0, not_negative)),
    sized(16, real("BETA")),
};

constexpr Field thickness_mcid_card[] = {
    sized(16, real("THIC1", 0, not_negative)),        sized(16, real("THIC2", 0, not_negative)),
    sized(16, real("THIC3", 0, not_negative)),        sized(16, real("THIC4", 0, not_negative)),
    sized(16, reference("MCID", IdKind::Definition)),
};

constexpr Field offset_card[] = {
    sized(16, only("OFFSET", {0}, "NLOC of *SECTION_SHELL moves the shells of a part off their nodes")),
};

// Scalar nodes of shells that stretch through their thickness (ELFORM 25 to 27), which are refused.
constexpr Field scalar_nodes_card[] = {
    sized(8, unused("-")),   sized(8, unused("-")),   sized(8, unused("NS1")),
    sized(8, unused("NS2")), sized(8, unused("NS3")), sized(8, unused("NS4")),
};

constexpr Field mass_card[] = {
    sized(8, id("EID")), sized(8, id("NID")), sized(16, real("MASS", 0, not_negative)),
    sized(8, unused("PID")),  // for LS-DYNA's listings only
};

// Its axes turn with the three nodes in LS-DYNA; here the motion of the first one is written in global axes.
constexpr Field accelerometer_card[] = {
    id("SBACID", IdKind::Element),
    id("NID1", IdKind::Node),
    reference("NID2", IdKind::Node),
    reference("NID3", IdKind::Node),
    unused("IGRAV"),
    unused("INTOPT"),
    only("MASS", {0}, "put *ELEMENT_MASS on its nodes"),
};

constexpr Field mass_set_card[] = {
    sized(8, id("EID")),
    sized(8, id("NSID")),
    sized(16, real("MASS", 0, not_negative)),
    sized(8, unused("PID")),
};

RawShell shell_of(const Card& card, const Affine& map) {
  RawShell shell;
  shell.id = card.integer("EID");
  shell.part = card.integer("PID");
  shell.node = {card.integer("N1"), card.integer("N2"), card.integer("N3"), card.integer("N4")};
  if (shell.node[3] == 0) shell.node[3] = shell.node[2];
  if (map.mirrors()) mirror_face(shell.node, shell.node[2] == shell.node[3]);
  shell.where = card.where();
  return shell;
}

/// The thickness at the nodes, and the angle where the card has one.
void take_thickness(const Cards& cards, const Card& card, RawShell& shell) {
  shell.thickness = {card.real("THIC1"), card.real("THIC2"), card.real("THIC3"), card.real("THIC4")};
  if (cards.where().keyword.find("_MCID") == std::string_view::npos)
    shell.material_angle = card.real("BETA") * std::numbers::pi / 180;
  if (cards.placement().map.mirrors()) {
    mirror_face(shell.thickness, shell.node[2] == shell.node[3]);
    shell.material_angle = -shell.material_angle;
  }
  // Two equal nodes make a triangle; its fourth thickness is the third one's.
  if (shell.node[3] == shell.node[2]) shell.thickness[3] = shell.thickness[2];
}

/// A card whose ids could not be read has been reported; its item would only lead to more messages.
bool has_ids(const Card& card) {
  for (const std::string_view field : {"EID", "PID", "N1", "N2", "N3", "N4"})
    if (!card.good(field)) return false;
  return true;
}

}  // namespace

void read_node(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(node_card);
    if (!card.good("NID")) continue;
    RawNode node;
    node.id = card.integer("NID");
    node.position = {card.real("X"), card.real("Y"), card.real("Z")};
    if (card.good("TC")) node.translation_code = static_cast<int>(card.integer("TC"));
    if (card.good("RC")) node.rotation_code = static_cast<int>(card.integer("RC"));
    node.where = card.where();
    deck.nodes.push_back(node);
  }
}

bool read_shell(Cards& cards, RawShell& shell) {
  const Card card = cards.next_filled(shell_card);
  shell = shell_of(card, cards.placement().map);
  return has_ids(card);
}

void read_element_shell(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(shell_card);
    if (has_ids(card)) deck.shells.push_back(shell_of(card, cards.placement().map));
  }
}

void read_element_shell_thickness(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(shell_card);
    RawShell shell = shell_of(card, cards.placement().map);
    take_thickness(cards, cards.next(thickness_card), shell);
    if (has_ids(card)) deck.shells.push_back(shell);
  }
}

void read_element_shell_mcid(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(shell_card);
    RawShell shell = shell_of(card, cards.placement().map);
    const Card second = cards.next(thickness_mcid_card);
    take_thickness(cards, second, shell);
    shell.material_system = second.integer("MCID");
    if (has_ids(card)) deck.shells.push_back(shell);
  }
}

void read_element_shell_offset(Cards& cards, RawDeck& deck) {
  const std::string_view keyword = cards.where().keyword;
  const bool has_thickness =
      keyword.find("_THICKNESS") != std::string_view::npos || keyword.find("_BETA") != std::string_view::npos;
  while (cards.more()) {
    const Card card = cards.next_filled(shell_card);
    RawShell shell = shell_of(card, cards.placement().map);
    if (has_thickness) take_thickness(cards, cards.next(thickness_card), shell);
    cards.next(offset_card);
    if (has_ids(card)) deck.shells.push_back(shell);
  }
}

void read_element_shell_dof(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(shell_card);
    cards.next(scalar_nodes_card);
    if (has_ids(card)) deck.shells.push_back(shell_of(card, cards.placement().map));
  }
}

void read_element_mass(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(mass_card);
    if (!card.good("EID") || !card.good("NID")) continue;
    deck.masses.push_back({card.integer("EID"), card.integer("NID"), false, card.real("MASS"), card.where()});
  }
}

void read_element_mass_node_set(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(mass_set_card);
    if (!card.good("EID") || !card.good("NSID")) continue;
    deck.masses.push_back({card.integer("EID"), card.integer("NSID"), true, card.real("MASS"), card.where()});
  }
}

void read_element_seatbelt_accelerometer(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(accelerometer_card);
    if (card.good("NID1")) deck.histories.push_back({card.integer("NID1"), false, card.where()});
  }
}

}  // namespace crumple::deck
