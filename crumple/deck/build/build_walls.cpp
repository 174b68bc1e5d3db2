// SPDX-License-Identifier: BSD-3-Clause
// Rigid walls.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/counted.hpp"
#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

/// A plane, and a rectangle without edges.
bool holds_what_is_behind(const model::RigidWall& wall) {
  return wall.shape == model::WallShape::Plane ||
         (wall.shape == model::WallShape::Flat && !(wall.lengths[0] > 0) && !(wall.lengths[1] > 0));
}

void warn_of_nodes_behind(const model::RigidWall& wall, const Where& where, Build& build) {
  const auto& positions = build.model.nodes.position;
  std::vector<double> distances;
  distances.reserve(wall.nodes.size());
  double farthest = 0;
  for (const Index node : wall.nodes) {
    const Vector& x = positions[static_cast<std::size_t>(node)];
    double distance = 0;
    for (std::size_t i = 0; i < 3; ++i) distance += (x[i] - wall.point[i]) * wall.normal[i];
    distances.push_back(distance);
    farthest = std::max(farthest, std::fabs(distance));
  }
  constexpr double on_the_wall = 1e-6;
  const auto behind = std::count_if(distances.begin(), distances.end(),
                                    [&](double distance) { return distance < -on_the_wall * farthest; });
  if (behind > 0)
    build.report.warning(where, "behind",
                         fmt::format("{} of the wall's {} {} behind it at the start; is its normal (from "
                                     "tail to head, towards the body) right?",
                                     behind, counted(wall.nodes.size(), "node"), behind == 1 ? "is" : "are"));
}

/// The nodes that the cards name; false, with a message, if there are none to be had.
bool find_nodes(Build& build, const RawWall& raw, std::vector<Index>& nodes) {
  if (raw.node_set == 0) {
    nodes = all_nodes(build);
  } else {
    const std::vector<Index>* const set = set_nodes(build, {raw.node_set, "NSID", raw.where});
    if (!set) return false;
    nodes = *set;
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  if (raw.box != 0) {
    const Index index = build.find(Item::Box, {raw.box, "BOXID", raw.where});
    if (index == no_index) return false;
    const RawBox& box = build.deck.boxes[static_cast<std::size_t>(index)];
    std::erase_if(nodes, [&](Index node) {
      return !is_inside(box, build.model.nodes.position[static_cast<std::size_t>(node)]);
    });
  }
  if (raw.exempt_set != 0) {
    if (const std::vector<Index>* exempt = set_nodes(build, {raw.exempt_set, "NSIDEX", raw.where})) {
      const std::set<Index> out(exempt->begin(), exempt->end());
      std::erase_if(nodes, [&](Index node) { return out.count(node) > 0; });
    }
  }
  return true;
}

/// The number of a wall without one: its place in the deck, or the next that no wall has.
UserId free_id(const Build& build, std::size_t place) {
  const auto used = [&](UserId id) {
    const auto has_id = [&](const auto& wall) { return wall.id == id; };
    const auto& made = build.model.rigid_walls;
    return std::any_of(made.begin(), made.end(), has_id) ||
           std::any_of(build.deck.walls.begin(), build.deck.walls.end(),
                       [&](const RawWall& raw) { return has_id(raw.wall); });
  };
  auto id = static_cast<UserId>(place) + 1;
  while (used(id)) ++id;
  return id;
}

}  // namespace

void build_walls(Build& build) {
  for (std::size_t i = 0; i < build.deck.walls.size(); ++i) {
    const RawWall& raw = build.deck.walls[i];
    model::RigidWall wall = raw.wall;
    if (wall.id == 0) wall.id = free_id(build, i);
    build.enter(Item::Wall, {wall.id, "ID", raw.where}, build.model.rigid_walls.size());
    if (raw.motion_curve != 0)
      wall.motion.curve = build.find(Item::Curve, {raw.motion_curve, "LCID", raw.motion_where});
    if (!find_nodes(build, raw, wall.nodes)) continue;
    if (holds_what_is_behind(wall)) warn_of_nodes_behind(wall, raw.where, build);
    build.model.rigid_walls.push_back(std::move(wall));
  }
}

}  // namespace crumple::deck
