// SPDX-License-Identifier: BSD-3-Clause
// Prescribed motions, body loads, loads on rigid bodies, and damping.
#include <fmt/core.h>

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

/// A motion along a global axis and constraints along others would have to be solved together.
void refuse_local_axes(const RawPrescribedMotion& raw, Index index, Build& build) {
  const model::RigidBody& body = build.model.rigid_bodies[static_cast<std::size_t>(index)];
  if (body.held_axes == model::RigidBody{}.held_axes) return;
  build.report.field_unsupported(
      raw.where,
      {"PID", std::to_string(raw.id), "a rigid body that is free or held in global axes",
       fmt::format("CMO of rigid body {} is -1, and a motion is along or about a global axis", body.id),
       "rigid"});
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
  const bool along = connection.translation[static_cast<std::size_t>(raw.motion.axis)];
  if (!connection.is_body && (raw.motion.rotation || !along)) return true;
  build.report.error(raw.where, "connection",
                     fmt::format("node {} belongs to {}, which moves it as well; move another node of what "
                                 "it joins",
                                 id, connection.name));
  return false;
}

void build_prescribed_motion(const RawPrescribedMotion& raw, const Movers& movers, Build& build) {
  model::PrescribedMotion motion = raw.motion;
  motion.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  if (raw.target == RawPrescribedMotion::Target::Body) {
    motion.body = build.find(Item::RigidBody, {raw.id, "PID", raw.where});
    if (motion.body != no_index) refuse_local_axes(raw, motion.body, build);
    if (motion.body != no_index && motion.curve != no_index) build.model.prescribed_motions.push_back(motion);
    return;
  }
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
  if (load.body == no_index || load.curve == no_index) return;
  if (raw.direction <= 3)
    load.force[static_cast<std::size_t>(raw.direction - 1)] = raw.scale;
  else
    load.moment[static_cast<std::size_t>(raw.direction - 5)] = raw.scale;
  build.model.rigid_body_loads.push_back(load);
}

void build_mass_damping(Build& build) {
  if (build.deck.mass_dampings.empty()) return;
  if (build.deck.mass_dampings.size() > 1)
    build.report.error(build.deck.mass_dampings[1].where, "damping",
                       "*DAMPING_GLOBAL stands twice; the damping of the whole model is given once");
  const RawMassDamping& raw = build.deck.mass_dampings.front();
  model::MassDamping damping = raw.damping;
  if (raw.curve != 0) damping.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
  if (damping.curve != no_index || damping.constant > 0) build.model.mass_damping = damping;
}

}  // namespace

void build_motions(Build& build) {
  const Movers movers{bodies_of_nodes(build), connections_of_nodes(build)};
  for (const RawPrescribedMotion& raw : build.deck.prescribed_motions)
    build_prescribed_motion(raw, movers, build);
  for (const RawBodyLoad& raw : build.deck.body_loads) {
    model::BodyLoad load = raw.load;
    load.curve = build.find(Item::Curve, {raw.curve, "LCID", raw.where});
    if (load.curve != no_index) build.model.body_loads.push_back(load);
  }
  for (const RawRigidBodyLoad& raw : build.deck.rigid_body_loads) build_rigid_body_load(raw, build);
  build_mass_damping(build);
}

}  // namespace crumple::deck
