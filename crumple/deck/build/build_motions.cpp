// SPDX-License-Identifier: BSD-3-Clause
// Prescribed motions, and loads on rigid bodies.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

std::vector<Index> moved_nodes(const RawPrescribedMotion& raw, Build& build) {
  if (raw.target == RawPrescribedMotion::Target::Node) {
    const Index node = build.find(Item::Node, {raw.id, "NID", raw.where});
    return node == no_index ? std::vector<Index>() : std::vector<Index>{node};
  }
  const Index set = build.find(Item::NodeSet, {raw.id, "NSID", raw.where});
  return set == no_index ? std::vector<Index>() : build.model.node_sets[static_cast<std::size_t>(set)].nodes;
}

/// Gives a motion of a body its axis. A body has one system of axes along which it is held and moved, since
/// constraints along others would have to be solved together: false, with a message, where it is another.
bool choose_axis(const RawPrescribedMotion& raw, const std::optional<Vector>& along, Build& build,
                 model::PrescribedMotion& motion) {
  model::RigidBody& body = build.model.rigid_bodies[static_cast<std::size_t>(motion.body)];
  if (!along && body.held_axes == model::RigidBody{}.held_axes) return true;
  constexpr double cosine_of_same = 1 - 1e-12;
  for (std::size_t axis = 0; along && axis < 3; ++axis) {
    const double cosine = dot(*along, body.held_axes[axis]);
    if (std::fabs(cosine) < cosine_of_same) continue;
    motion.axis = static_cast<int>(axis);
    if (cosine < 0) motion.scale = -motion.scale;
    return true;
  }
  const auto& motions = build.model.prescribed_motions;
  const bool moves = std::any_of(motions.begin(), motions.end(), [&](const model::PrescribedMotion& other) {
    return other.body == motion.body;
  });
  const std::array<bool, 3> none{};
  if (along && !moves && body.fixed_translation == none && body.fixed_rotation == none) {
    body.held_axes = axes_along(*along);
    motion.axis = 0;
    return true;
  }
  build.report.field_unsupported(
      raw.where,
      {along ? "VID" : "PID", std::to_string(along ? raw.vector : raw.id),
       "a rigid body that is free or held and moved in the same axes",
       along ? fmt::format("rigid body {} is held or moved along axes that are not those of the vector",
                           body.id)
             : fmt::format(
                   "CMO of rigid body {} is -1, or it is moved along a vector, and a motion is along or "
                   "about a global axis",
                   body.id),
       "rigid"});
  return false;
}

/// What else moves the nodes of the model: each has room for one.
struct Movers {
  std::vector<Index> body_of_node;
  std::map<Index, Connection> connections;
};

/// False, with a message, if a rigid body or a connection sets the same degree of freedom of a node.
bool may_move(Index node, const RawPrescribedMotion& raw, const Movers& movers, Build& build) {
  const UserId id = build.model.nodes.id[static_cast<std::size_t>(node)];
  if (const Index body = movers.body_of_node[static_cast<std::size_t>(node)]; body != no_index) {
    build.report.error(raw.where, "rigid",
                       fmt::format("node {} belongs to the rigid body {}; move the body with "
                                   "*BOUNDARY_PRESCRIBED_MOTION_RIGID",
                                   id, build.model.rigid_bodies[static_cast<std::size_t>(body)].id));
    return false;
  }
  const auto found = movers.connections.find(node);
  if (found == movers.connections.end()) return true;
  const Connection& connection = found->second;
  const auto& moved = connection.translation;
  const bool along = raw.vector != 0 || raw.motion.goes_round
                         ? moved[0] || moved[1] || moved[2]
                         : moved[static_cast<std::size_t>(raw.motion.axis)];
  if (!connection.is_body && (raw.motion.rotation || !along)) return true;
  build.report.error(raw.where, "connection",
                     fmt::format("node {} belongs to {}, which moves it as well; move another node of what "
                                 "it joins",
                                 id, connection.name));
  return false;
}

/// Whether a motion is none, as where a deck holds by it.
bool is_rest(const model::PrescribedMotion& motion, const model::Model& model) {
  const auto& ordinates = model.curves[static_cast<std::size_t>(motion.curve)].ordinate;
  return motion.scale == 0 || std::ranges::all_of(ordinates, [](double value) { return value == 0; });
}

/// A degree of freedom cannot be held and moved.
bool is_free(const model::PrescribedMotion& motion, const RawPrescribedMotion& raw, Build& build) {
  if (is_rest(motion, build.model)) return true;
  const model::RigidBody& body = build.model.rigid_bodies[static_cast<std::size_t>(motion.body)];
  const auto axis = static_cast<std::size_t>(motion.axis);
  if (!(motion.rotation ? body.fixed_rotation : body.fixed_translation)[axis]) return true;
  build.report.error(
      raw.where, "held body",
      fmt::format("rigid body {} is held {} {} by its *MAT_RIGID or its supports, and cannot be moved in "
                  "the same direction; free it there or leave out the motion",
                  body.id, motion.rotation ? "about" : "along", "xyz"[axis]));
  return false;
}

void build_prescribed_motion(const RawPrescribedMotion& raw, const Movers& movers, Build& build) {
  model::PrescribedMotion motion = raw.motion;
  motion.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  std::optional<Vector> along;
  if (raw.vector != 0) {
    along = find_vector(build, raw.vector, "VID", raw.where);
    if (!along) return;
  }
  if (raw.target == RawPrescribedMotion::Target::Body) {
    motion.body = build.find(Item::RigidBody, {raw.id, "PID", raw.where});
    if (motion.body != no_index && motion.curve != no_index && choose_axis(raw, along, build, motion) &&
        is_free(motion, raw, build))
      build.model.prescribed_motions.push_back(motion);
    return;
  }
  if (along) motion.direction = *along;
  for (const Index node : moved_nodes(raw, build)) {
    if (!may_move(node, raw, movers, build)) continue;
    motion.node = node;
    if (motion.curve != no_index) build.model.prescribed_motions.push_back(motion);
  }
}

void build_rigid_body_load(const RawRigidBodyLoad& raw, Build& build) {
  model::RigidBodyLoad load;
  load.body = build.find(Item::RigidBody, {raw.body, "PID", raw.where});
  load.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  const auto acting = find_force(build, raw.direction, raw.scale, raw.system, raw.plane, raw.where);
  if (load.body == no_index || load.curve == no_index || !acting) return;
  load.force = acting->force;
  load.moment = acting->moment;
  load.plane = acting->plane;
  build.model.rigid_body_loads.push_back(load);
}

}  // namespace

void build_motions(Build& build) {
  const Movers movers{bodies_of_nodes(build), connections_of_nodes(build)};
  for (const RawPrescribedMotion& raw : build.deck.prescribed_motions)
    build_prescribed_motion(raw, movers, build);
  for (const RawRigidBodyLoad& raw : build.deck.rigid_body_loads) build_rigid_body_load(raw, build);
}

}  // namespace crumple::deck
