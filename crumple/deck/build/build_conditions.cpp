// SPDX-License-Identifier: BSD-3-Clause
// Masses, fixed nodes and initial velocities.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/counted.hpp"
#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"
#include "deck/keywords/rigid_inertia.hpp"

namespace crumple::deck {

namespace {

std::vector<Index> velocity_nodes(Build& build, const RawVelocity& raw) {
  const Reference reference{raw.id, raw.is_generation ? "ID" : "NSID", raw.where};
  switch (raw.target) {
    case RawVelocity::Target::All:
      return all_nodes(build);
    case RawVelocity::Target::NodeSet: {
      const std::vector<Index>* nodes = set_nodes(build, reference);
      return nodes ? *nodes : std::vector<Index>();
    }
    case RawVelocity::Target::Node: {
      const Index node = build.find(Item::Node, {raw.id, "NID", raw.where});
      return node == no_index ? std::vector<Index>() : std::vector<Index>{node};
    }
    case RawVelocity::Target::Part: {
      const Index part = build.find(Item::Part, reference);
      return part == no_index ? std::vector<Index>() : nodes_of_parts(build, {part});
    }
    case RawVelocity::Target::PartSet: {
      const Index set = build.find(Item::PartSet, reference);
      if (set == no_index) return {};
      return nodes_of_parts(build, build.model.part_sets[static_cast<std::size_t>(set)].parts);
    }
  }
  return {};
}

/// Translation plus rotation about the axis, v = v0 + spin x (r - point).
model::InitialVelocity velocity_at(const RawVelocity& raw, Index node, const Vector& position) {
  model::InitialVelocity result{node, raw.velocity, raw.angular_velocity};
  if (!raw.rotates) return result;
  const Vector& w = raw.spin;
  const Vector r = {position[0] - raw.axis_point[0], position[1] - raw.axis_point[1],
                    position[2] - raw.axis_point[2]};
  result.velocity[0] += w[1] * r[2] - w[2] * r[1];
  result.velocity[1] += w[2] * r[0] - w[0] * r[2];
  result.velocity[2] += w[0] * r[1] - w[1] * r[0];
  for (std::size_t i = 0; i < 3; ++i) result.angular_velocity[i] += w[i];
  return result;
}

bool are_global(const std::array<std::array<double, 3>, 3>& axes) {
  return axes == model::RigidBody().held_axes;
}

/// What holds a node of a rigid body holds its centre of mass, as in LS-DYNA after R11.1; before, such
/// constraints were skipped.
void hold_body(Index node, Index index, const std::array<bool, 3>& translation,
               const std::array<bool, 3>& rotation, const Where& where, Build& build) {
  model::RigidBody& body = build.model.rigid_bodies[static_cast<std::size_t>(index)];
  const UserId id = build.model.nodes.id[static_cast<std::size_t>(node)];
  if (!are_global(body.held_axes)) {
    build.report.unsupported(
        where, "rigid",
        fmt::format("node {} belongs to the rigid body {}, which CMO = -1 holds in local axes; hold the body "
                    "with CON1 and CON2 of *MAT_RIGID alone",
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

/// The nodes with all others of the rigid bodies that have some of them, ascending.
std::vector<Index> with_whole_bodies(const Build& build, const std::vector<Index>& nodes,
                                     const std::vector<Index>& body_of_node) {
  std::vector<Index> all = nodes;
  std::vector<char> taken(build.model.rigid_bodies.size(), 0);
  for (const Index node : nodes) {
    const Index body = body_of_node[static_cast<std::size_t>(node)];
    if (body == no_index || taken[static_cast<std::size_t>(body)]) continue;
    taken[static_cast<std::size_t>(body)] = 1;
    const std::vector<Index>& more = build.model.rigid_bodies[static_cast<std::size_t>(body)].nodes;
    all.insert(all.end(), more.begin(), more.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The given velocities of the bodies that have some of the nodes no longer count.
void replace_given_velocities(Build& build, const std::vector<Index>& nodes,
                              const std::vector<Index>& body_of_node) {
  for (const Index node : nodes) {
    const Index body = body_of_node[static_cast<std::size_t>(node)];
    if (body == no_index) continue;
    auto& inertia = build.model.rigid_bodies[static_cast<std::size_t>(body)].inertia;
    if (inertia) inertia->velocity_from_nodes = true;
  }
}

void warn_of_mixed_velocities(Build& build) {
  const auto& raws = build.deck.velocities;
  const auto generation =
      std::find_if(raws.begin(), raws.end(), [](const RawVelocity& v) { return v.is_generation; });
  const auto other =
      std::find_if(raws.begin(), raws.end(), [](const RawVelocity& v) { return !v.is_generation; });
  if (generation != raws.end() && other != raws.end())
    build.report.warning(
        generation->where, "mixed",
        fmt::format("{} at {} gives velocities too, which LS-DYNA does not allow together; here "
                    "the later keyword counts, *INITIAL_VELOCITY_NODE last",
                    other->where.keyword, build.report.place(other->where)));
}

}  // namespace

const std::vector<Index>* set_nodes(Build& build, const Reference& set) {
  const Index index = build.find(Item::NodeSet, set);
  return index == no_index ? nullptr : &build.model.node_sets[static_cast<std::size_t>(index)].nodes;
}

std::vector<Index> all_nodes(const Build& build) {
  std::vector<Index> nodes(build.model.nodes.id.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = static_cast<Index>(i);
  return nodes;
}

std::vector<Index> nodes_of_parts(const Build& build, const std::vector<Index>& parts) {
  std::vector<char> wanted(build.model.parts.size(), 0);
  for (const Index part : parts) wanted[static_cast<std::size_t>(part)] = 1;
  std::vector<char> taken(build.model.nodes.id.size(), 0);
  const auto take = [&](const auto& element) {
    if (element.part == no_index || !wanted[static_cast<std::size_t>(element.part)]) return;
    for (const Index node : element.node)
      if (node != no_index) taken[static_cast<std::size_t>(node)] = 1;
  };
  for (const model::ShellElement& shell : build.model.shells) take(shell);
  for (const model::SolidElement& solid : build.model.solids) take(solid);
  for (const model::BeamElement& beam : build.model.beams) take(beam);
  for (const model::DiscreteElement& discrete : build.model.discretes) take(discrete);
  std::vector<Index> nodes;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i]) nodes.push_back(static_cast<Index>(i));
  return nodes;
}

void build_masses(Build& build) {
  for (const RawMass& raw : build.deck.masses) {
    build.enter(Item::Mass, {raw.id, "EID", raw.where},
                static_cast<std::size_t>(&raw - build.deck.masses.data()));
    if (!raw.is_set) {
      const Index node = build.find(Item::Node, {raw.target, "NID", raw.where});
      if (node != no_index) build.model.lumped_masses.push_back({raw.id, node, raw.mass, raw.inertia});
    } else if (const std::vector<Index>* nodes = set_nodes(build, {raw.target, "NSID", raw.where})) {
      // Every node of the set gets the whole mass, as in LS-DYNA.
      for (const Index node : *nodes)
        build.model.lumped_masses.push_back({raw.id, node, raw.mass, raw.inertia});
    }
  }
}

void build_fixed_nodes(Build& build) {
  std::map<Index, model::FixedNode> fixed;
  const std::vector<Index> body_of_node = bodies_of_nodes(build);
  const std::map<Index, Connection> connections = connections_of_nodes(build);
  const auto fix = [&](Index node, const std::array<bool, 3>& translation,
                       const std::array<bool, 3>& rotation, const Where& where) {
    if (const Index body = body_of_node[static_cast<std::size_t>(node)]; body != no_index) {
      hold_body(node, body, translation, rotation, where, build);
      return;
    }
    if (const auto weld = connections.find(node); weld != connections.end() && weld->second.is_body) {
      refuse_welded_node(node, weld->second, where, build);
      return;
    }
    model::FixedNode& entry = fixed[node];
    entry.node = node;
    for (std::size_t i = 0; i < 3; ++i) {
      entry.translation[i] = entry.translation[i] || translation[i];
      entry.rotation[i] = entry.rotation[i] || rotation[i];
    }
  };
  for (std::size_t i = 0; i < build.deck.nodes.size(); ++i) {
    const RawNode& raw = build.deck.nodes[i];
    if (raw.translation_code != 0 || raw.rotation_code != 0)
      fix(static_cast<Index>(i), held_axes(raw.translation_code), held_axes(raw.rotation_code), raw.where);
  }
  for (const RawFixed& raw : build.deck.fixed) {
    if (!raw.is_set) {
      const Index node = build.find(Item::Node, {raw.target, "NID", raw.where});
      if (node != no_index) fix(node, raw.translation, raw.rotation, raw.where);
    } else if (const std::vector<Index>* nodes = set_nodes(build, {raw.target, "NSID", raw.where})) {
      for (const Index node : *nodes) fix(node, raw.translation, raw.rotation, raw.where);
    }
  }
  for (const auto& [node, entry] : fixed) build.model.fixed_nodes.push_back(entry);
}

void build_velocities(Build& build) {
  std::vector<model::InitialVelocity> at_node(build.model.nodes.id.size());
  const std::vector<Index> body_of_node = bodies_of_nodes(build);
  const auto set = [&](const model::InitialVelocity& velocity) {
    at_node[static_cast<std::size_t>(velocity.node)] = velocity;
  };
  const auto apply = [&](const RawVelocity& raw) {
    std::vector<Index> nodes = velocity_nodes(build, raw);
    if (raw.of_whole_bodies) nodes = with_whole_bodies(build, nodes, body_of_node);
    if (raw.replaces_given) replace_given_velocities(build, nodes, body_of_node);
    for (const Index node : nodes)
      set(velocity_at(raw, node, build.model.nodes.position[static_cast<std::size_t>(node)]));
    if (raw.exempt_set == 0) return;
    if (const std::vector<Index>* exempt = set_nodes(build, {raw.exempt_set, "NSIDEX", raw.where}))
      for (const Index node : *exempt) set({node, raw.exempt_velocity, raw.exempt_angular_velocity});
  };
  warn_of_mixed_velocities(build);
  for (const RawVelocity& raw : build.deck.velocities)
    if (raw.target != RawVelocity::Target::Node) apply(raw);
  for (const RawVelocity& raw : build.deck.velocities)
    if (raw.target == RawVelocity::Target::Node) apply(raw);
  for (const model::InitialVelocity& velocity : at_node)
    if (velocity.node != no_index) build.model.initial_velocities.push_back(velocity);
}

}  // namespace crumple::deck
