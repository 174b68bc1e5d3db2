// SPDX-License-Identifier: BSD-3-Clause
// Nodes that are held: TC and RC of *NODE, *BOUNDARY_SPC.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "deck/build/build.hpp"
#include "deck/keywords/rigid_inertia.hpp"

namespace crumple::deck {

namespace {

bool are_global(const std::array<std::array<double, 3>, 3>& axes) {
  return axes == model::RigidBody().held_axes;
}

/// Degrees of freedom that are held, and how.
struct Hold {
  std::array<bool, 3> translation{};
  std::array<bool, 3> rotation{};
  std::array<Vector, 3> axes = model::RigidBody().held_axes;
  Where where;
  bool is_timed = false;
  double birth = 0;
  double death = 1e28;

  bool is_global() const { return are_global(axes) && !is_timed; }
};

bool is_held(const model::RigidBody& body) {
  const std::array<bool, 3> none{};
  return body.fixed_translation != none || body.fixed_rotation != none;
}

/// What holds a node of a rigid body holds its centre of mass, as in LS-DYNA after R11.1; before, such
/// constraints were skipped.
void hold_body(Index node, Index index, const Hold& hold, Build& build) {
  const auto& [translation, rotation, axes, where, is_timed, birth, death] = hold;
  model::RigidBody& body = build.model.rigid_bodies[static_cast<std::size_t>(index)];
  const UserId id = build.model.nodes.id[static_cast<std::size_t>(node)];
  if (is_timed) {
    build.report.unsupported(
        where, "rigid",
        fmt::format("node {} belongs to the rigid body {}, which can only be held during the "
                    "whole run",
                    id, body.id));
    return;
  }
  if (!is_held(body) && are_global(body.held_axes)) body.held_axes = axes;
  if (body.held_axes != axes) {
    build.report.unsupported(
        where, "rigid",
        fmt::format(
            "node {} belongs to the rigid body {}, which CMO = -1 holds in local axes, or another node in "
            "other axes; hold the body with CON1 and CON2 of *MAT_RIGID alone",
            id, body.id));
    return;
  }
  bool holds_more = false;
  for (std::size_t i = 0; i < 3; ++i) {
    holds_more = holds_more || (translation[i] && !body.fixed_translation[i]) ||
                 (rotation[i] && !body.fixed_rotation[i]);
    body.fixed_translation[i] = body.fixed_translation[i] || translation[i];
    body.fixed_rotation[i] = body.fixed_rotation[i] || rotation[i];
  }
  if (!holds_more) return;
  // Each body is named, however many there are in a set.
  build.report.warning(
      where, "rigid " + std::to_string(body.id),
      fmt::format(
          "node {} belongs to the rigid body {}: its degrees of freedom are held at the body's centre of "
          "mass, as in LS-DYNA after R11.1, which skipped them before; CMO, CON1 and CON2 of *MAT_RIGID "
          "say the same in all versions",
          id, body.id));
}

/// The body that a weld is does not know what holds its nodes.
void refuse_welded_node(Index node, const Connection& weld, const Where& where, Build& build) {
  build.report.unsupported(
      where, "weld",
      fmt::format("node {} belongs to {}, and degrees of freedom of its nodes cannot be held; take a free "
                  "node for the weld, or *CONSTRAINED_NODAL_RIGID_BODY_SPC",
                  build.model.nodes.id[static_cast<std::size_t>(node)], weld.name));
}

/// Holds nodes one after the other.
class Holder {
 public:
  explicit Holder(Build& build)
      : build_(build), body_of_node_(bodies_of_nodes(build)), connections_(connections_of_nodes(build)) {}

  void apply(Index node, const Hold& hold) {
    if (const Index body = body_of_node_[static_cast<std::size_t>(node)]; body != no_index)
      hold_body(node, body, hold, build_);
    else if (const auto found = connections_.find(node);
             found != connections_.end() && (found->second.is_body || !hold.is_global()))
      refuse_welded_node(node, found->second, hold.where, build_);
    else if (hold.is_global())
      hold_globally(node, hold);
    else
      build_.model.local_supports.push_back(
          {node, hold.axes, hold.translation, hold.rotation, hold.birth, hold.death});
  }

  void finish() {
    for (const auto& [node, entry] : fixed_) build_.model.fixed_nodes.push_back(entry);
  }

 private:
  void hold_globally(Index node, const Hold& hold) {
    model::FixedNode& entry = fixed_[node];
    entry.node = node;
    for (std::size_t i = 0; i < 3; ++i) {
      entry.translation[i] = entry.translation[i] || hold.translation[i];
      entry.rotation[i] = entry.rotation[i] || hold.rotation[i];
    }
  }

  Build& build_;
  std::vector<Index> body_of_node_;
  std::map<Index, Connection> connections_;
  std::map<Index, model::FixedNode> fixed_;
};

/// *CONSTRAINED_GLOBAL: nodes nearer to the plane than the tolerance, by default this share of the largest
/// extent of the model.
constexpr double plane_share = 1e-6;

void hold_plane(const RawHeldPlane& raw, Holder& holder, Build& build) {
  const auto& places = build.model.nodes.position;
  double extent = 0;
  for (std::size_t axis = 0; axis < 3 && !places.empty(); ++axis) {
    const auto [least, most] = std::minmax_element(
        places.begin(), places.end(), [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    extent = std::max(extent, (*most)[axis] - (*least)[axis]);
  }
  const double tolerance = raw.tolerance > 0 ? raw.tolerance : plane_share * extent;
  const auto along = static_cast<std::size_t>(raw.axis);
  Hold hold;
  hold.translation = held_axes(raw.translation_code);
  hold.rotation = held_axes(raw.rotation_code);
  hold.where = raw.where;
  Index held = 0;
  for (std::size_t node = 0; node < places.size(); ++node) {
    if (std::fabs(places[node][along] - raw.point[along]) > tolerance) continue;
    holder.apply(static_cast<Index>(node), hold);
    ++held;
  }
  if (held == 0)
    build.report.warning(raw.where, "empty plane", "no node lies on the plane: nothing is held by it");
}

/// In global axes where the normal is along one of them, as these are held exactly and for less.
void hold_by_symmetry(const Vector& normal, Hold& hold) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::fabs(normal[axis]) < 1) continue;
    hold.translation[axis] = true;
    hold.rotation = {axis != 0, axis != 1, axis != 2};
    return;
  }
  hold.axes = axes_along(normal);
  hold.translation = {true, false, false};
  hold.rotation = {false, true, true};
}

/// *BOUNDARY_SPC_SYMMETRY_PLANE: of shells the manual gives a default tolerance.
void hold_symmetry_plane(const RawSymmetryPlane& raw, Holder& holder, Build& build) {
  constexpr double tolerance_of_shells = 0.2;
  const std::vector<Index> parts =
      find_parts(build, raw.is_set, {raw.target, raw.is_set ? "PSID" : "PID", raw.where});
  if (parts.empty()) return;
  const bool all_shells = std::all_of(parts.begin(), parts.end(), [&](Index part) {
    return model::kind_of(build.model.parts[static_cast<std::size_t>(part)]) == ElementKind::Shell;
  });
  if (raw.tolerance == 0 && !all_shells) {
    build.report.field_error(raw.where, {"TOL", "0", "a distance above zero on card 2",
                                         "only of shells it has a default, 0.2", "tolerance"});
    return;
  }
  const double tolerance = raw.tolerance > 0 ? raw.tolerance : tolerance_of_shells;
  Vector normal = raw.normal;
  const double length = length_of(normal);
  for (double& component : normal) component /= length;
  Hold hold;
  hold.where = raw.where;
  hold_by_symmetry(normal, hold);
  Index held = 0;
  for (const Index node : nodes_of_parts(build, parts)) {
    const Vector away = difference(build.model.nodes.position[static_cast<std::size_t>(node)], raw.point);
    if (std::fabs(dot(away, normal)) > tolerance) continue;
    holder.apply(node, hold);
    ++held;
  }
  if (held == 0)
    build.report.warning(raw.where, "empty plane", "no node lies on the plane: nothing is held by it");
}

}  // namespace

void build_fixed_nodes(Build& build) {
  Holder holder(build);
  for (std::size_t i = 0; i < build.deck.nodes.size(); ++i) {
    const RawNode& raw = build.deck.nodes[i];
    if (raw.translation_code == 0 && raw.rotation_code == 0) continue;
    Hold hold;
    hold.translation = held_axes(raw.translation_code);
    hold.rotation = held_axes(raw.rotation_code);
    hold.where = raw.where;
    holder.apply(static_cast<Index>(i), hold);
  }
  for (const RawHeldPlane& raw : build.deck.held_planes) hold_plane(raw, holder, build);
  for (const RawSymmetryPlane& raw : build.deck.symmetry_planes) hold_symmetry_plane(raw, holder, build);
  for (const RawFixed& raw : build.deck.fixed) {
    Hold hold;
    hold.translation = raw.translation;
    hold.rotation = raw.rotation;
    hold.where = raw.where;
    hold.is_timed = raw.is_timed && !model::LocalSupport{.birth = raw.birth, .death = raw.death}.lasts();
    if (hold.is_timed) {
      hold.birth = raw.birth;
      hold.death = raw.death;
    }
    if (raw.system != 0) {
      const auto axes = find_axes(build, raw.system, "CID", raw.where);
      if (!axes) continue;
      hold.axes = *axes;
    }
    if (!raw.is_set) {
      const Index node = build.find(Item::Node, {raw.target, "NID", raw.where});
      if (node != no_index) holder.apply(node, hold);
    } else if (const std::vector<Index>* nodes = set_nodes(build, {raw.target, "NSID", raw.where})) {
      for (const Index node : *nodes) holder.apply(node, hold);
    }
  }
  holder.finish();
}

}  // namespace crumple::deck
