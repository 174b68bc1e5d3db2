// SPDX-License-Identifier: BSD-3-Clause
// *DEFINE_COORDINATE_SYSTEM, _NODES, _VECTOR.
#include "deck/coordinates.hpp"

#include "deck/build.hpp"
#include "deck/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field points_card[] = {
    id("CID"),  real("XO"), real("YO"), real("ZO"),
    real("XL"), real("YL"), real("ZL"), only("CIDL", {0}, "the points are given in global axes"),
};

constexpr Field plane_card[] = {real("XP"), real("YP"), real("ZP")};

constexpr Field nodes_card[] = {
    id("CID"),
    id("N1"),
    id("N2"),
    id("N3"),
    only("FLAG", {0}, "the axes keep the directions that they have at the beginning"),
    text("DIR", 10),
};

constexpr Field vector_card[] = {
    id("CID"),  real("XX"), real("YX"), real("ZX"),
    real("XV"), real("YV"), real("ZV"), only("NID", {0}, "the axes do not turn with a node"),
};

/// Makes the length one; false if it is zero.
bool normalise(Vector& a) {
  const double length = length_of(a);
  if (!(length > 0)) return false;
  for (double& x : a) x /= length;
  return true;
}

/// The two vectors of a system that is given by three nodes; absent, with messages, if one is missing.
std::optional<std::array<Vector, 2>> vectors_of_nodes(const RawCoordinateSystem& raw, Build& build) {
  constexpr std::array<std::string_view, 3> field = {"N1", "N2", "N3"};
  std::array<Vector, 3> point{};
  bool complete = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Index node = build.find(Item::Node, {raw.node[i], field[i], raw.where});
    if (node == no_index)
      complete = false;
    else
      point[i] = build.model.nodes.position[static_cast<std::size_t>(node)];
  }
  if (!complete) return std::nullopt;
  return std::array{difference(point[1], point[0]), difference(point[2], point[0])};
}

}  // namespace

std::optional<std::array<Vector, 3>> local_axes(const Vector& first, const Vector& other) {
  Vector x = first;
  Vector z = cross(first, other);
  if (!normalise(x) || !normalise(z)) return std::nullopt;
  return std::array{x, cross(z, x), z};
}

void enter_coordinate_systems(Build& build) {
  const auto& systems = build.deck.coordinate_systems;
  for (std::size_t i = 0; i < systems.size(); ++i)
    build.enter(Item::CoordinateSystem, {systems[i].id, "CID", systems[i].where}, i);
}

std::optional<std::array<Vector, 3>> find_axes(Build& build, UserId id, std::string_view field,
                                               const Where& where) {
  const Index index = build.find(Item::CoordinateSystem, {id, field, where});
  if (index == no_index) return std::nullopt;
  const RawCoordinateSystem& raw = build.deck.coordinate_systems[static_cast<std::size_t>(index)];
  std::array<Vector, 2> vectors = {raw.first, raw.other};
  if (raw.node[0] != 0) {
    const auto of_nodes = vectors_of_nodes(raw, build);
    if (!of_nodes) return std::nullopt;
    vectors = *of_nodes;
  }
  const auto axes = local_axes(vectors[0], vectors[1]);
  if (!axes)
    build.report.field_error(raw.where, {"CID", std::to_string(raw.id), "a system with two axes",
                                         "its points or vectors lie on one line", "axes"});
  return axes;
}

void read_define_coordinate_system(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(points_card);
    const Card plane = cards.next(plane_card);
    const Vector origin = {card.real("XO"), card.real("YO"), card.real("ZO")};
    RawCoordinateSystem system;
    system.id = card.integer("CID");
    system.first = difference({card.real("XL"), card.real("YL"), card.real("ZL")}, origin);
    system.other = difference({plane.real("XP"), plane.real("YP"), plane.real("ZP")}, origin);
    system.where = card.where();
    if (card.good("CID")) deck.coordinate_systems.push_back(system);
  }
}

void read_define_coordinate_nodes(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(nodes_card);
    RawCoordinateSystem system;
    system.id = card.integer("CID");
    system.node = {card.integer("N1"), card.integer("N2"), card.integer("N3")};
    system.where = card.where();
    const std::string_view direction = card.text("DIR");
    if (!direction.empty() && direction != "X" && direction != "x" && direction != "0")
      cards.report().field_unsupported(
          card.where(), {"DIR", std::string(direction), "X", "N1 to N2 is the local x axis", "axis"});
    else if (card.good("CID") && card.good("N1") && card.good("N2") && card.good("N3"))
      deck.coordinate_systems.push_back(system);
  }
}

void read_define_coordinate_vector(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next_filled(vector_card);
    RawCoordinateSystem system;
    system.id = card.integer("CID");
    system.first = {card.real("XX"), card.real("YX"), card.real("ZX")};
    system.other = {card.real("XV"), card.real("YV"), card.real("ZV")};
    system.where = card.where();
    if (card.good("CID")) deck.coordinate_systems.push_back(system);
  }
}

}  // namespace crumple::deck
