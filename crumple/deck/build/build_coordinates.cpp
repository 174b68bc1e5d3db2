// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

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

void enter_coordinate_systems(Build& build) {
  const auto& systems = build.deck.coordinate_systems;
  for (std::size_t i = 0; i < systems.size(); ++i)
    build.enter(Item::CoordinateSystem, {systems[i].id, "CID", systems[i].where}, i);
  const auto& vectors = build.deck.vectors;
  for (std::size_t i = 0; i < vectors.size(); ++i)
    build.enter(Item::DefinedVector, {vectors[i].id, "VID", vectors[i].where}, i);
}

std::optional<Vector> turned(Build& build, const Vector& components, UserId system, std::string_view field,
                             const Where& where) {
  if (system == 0) return components;
  const auto axes = find_axes(build, system, field, where);
  if (!axes) return std::nullopt;
  Vector sum{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += components[axis] * (*axes)[axis][i];
  return sum;
}

std::optional<Vector> find_vector(Build& build, UserId id, std::string_view field, const Where& where) {
  const Index index = build.find(Item::DefinedVector, {id, field, where});
  if (index == no_index) return std::nullopt;
  const RawVector& raw = build.deck.vectors[static_cast<std::size_t>(index)];
  auto vector = turned(build, raw.vector, raw.system, "CID", raw.where);
  if (!vector) return std::nullopt;
  const double length = length_of(*vector);
  for (double& component : *vector) component /= length;
  return vector;
}

std::array<Vector, 3> axes_along(const Vector& first) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (std::fabs(first[i]) < std::fabs(first[least])) least = i;
  Vector other{};
  other[least] = 1;
  return *local_axes(first, other);
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

Vector origin_of(const Build& build, UserId id) {
  const auto index = static_cast<std::size_t>(build.find_quietly(Item::CoordinateSystem, id));
  const RawCoordinateSystem& raw = build.deck.coordinate_systems[index];
  if (raw.node[0] == 0) return raw.origin;
  return build.model.nodes.position[static_cast<std::size_t>(build.find_quietly(Item::Node, raw.node[0]))];
}

}  // namespace crumple::deck
