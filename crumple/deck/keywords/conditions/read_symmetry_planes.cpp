// SPDX-License-Identifier: BSD-3-Clause
// *BOUNDARY_SPC_SYMMETRY_PLANE.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field symmetry_plane_card[] = {
    unused("IDSP"),        id("PID"),
    point(real("X")),      point(real("Y")),
    point(real("Z")),      direction(real("VX")),
    direction(real("VY")), direction(real("VZ")),
};

constexpr Field symmetry_plane_set_card[] = {
    unused("IDSP"),        id("PSID"),
    point(real("X")),      point(real("Y")),
    point(real("Z")),      direction(real("VX")),
    direction(real("VY")), direction(real("VZ")),
};

constexpr Field tolerance_card[] = {length(real("TOL", 0, not_negative))};

void read_plane(Cards& cards, RawDeck& deck, Layout layout, std::string_view target) {
  while (cards.more()) {
    const Card card = cards.next_filled(layout);
    RawSymmetryPlane raw;
    raw.target = card.integer(target);
    raw.is_set = target == "PSID";
    raw.point = {card.real("X"), card.real("Y"), card.real("Z")};
    raw.normal = {card.real("VX"), card.real("VY"), card.real("VZ")};
    raw.where = card.where();
    raw.tolerance = cards.next_or_default(tolerance_card).real("TOL");
    if (raw.normal == std::array<double, 3>{}) {
      cards.report().field_error(card.where(), {"VX", "0", "a vector that is not zero",
                                                "VX, VY and VZ are the normal of the plane", "normal"});
      continue;
    }
    if (card.good(target)) deck.symmetry_planes.push_back(raw);
  }
}

}  // namespace

void read_boundary_spc_symmetry_plane(Cards& cards, RawDeck& deck) {
  read_plane(cards, deck, symmetry_plane_card, "PID");
}

void read_boundary_spc_symmetry_plane_set(Cards& cards, RawDeck& deck) {
  read_plane(cards, deck, symmetry_plane_set_card, "PSID");
}

}  // namespace crumple::deck
