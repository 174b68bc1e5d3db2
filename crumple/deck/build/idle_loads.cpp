// SPDX-License-Identifier: BSD-3-Clause
// Loads and velocities of nodes that do not take them: they would be lost without a word.
#include <fmt/core.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// By node: whether anything gives it mass, and whether anything turns with it or holds its rotations.
struct NodeUses {
  std::vector<char> has_mass;
  std::vector<char> turns;
};

NodeUses uses_of_nodes(const Build& build) {
  const model::Model& model = build.model;
  const std::size_t count = model.nodes.id.size();
  NodeUses uses{std::vector<char>(count, 0), std::vector<char>(count, 0)};
  const auto note = [](std::vector<char>& flags, Index node) {
    if (node != no_index) flags[static_cast<std::size_t>(node)] = 1;
  };
  const auto note_both = [&](const auto& nodes) {
    for (const Index node : nodes) {
      note(uses.has_mass, node);
      note(uses.turns, node);
    }
  };
  for (const model::ShellElement& shell : model.shells) note_both(shell.node);
  for (const model::BeamElement& beam : model.beams) note_both(beam.node);
  for (const model::RigidBody& body : model.rigid_bodies) note_both(body.nodes);
  for (const model::DiscreteElement& discrete : model.discretes)
    for (const Index node : discrete.node) note(uses.turns, node);
  for (const auto& [node, connection] : connections_of_nodes(build)) note_both(std::array{node});
  for (const model::SolidElement& solid : model.solids)
    for (const Index node : solid.node) note(uses.has_mass, node);
  for (const model::LumpedMass& mass : model.lumped_masses) {
    if (mass.mass > 0) note(uses.has_mass, mass.node);
    if (mass.inertia > 0) note(uses.turns, mass.node);
  }
  return uses;
}

/// The nodes that a card loads.
std::vector<Index> loaded_nodes(const RawNodalLoad& raw, const Build& build) {
  const Index found = build.find_quietly(raw.is_set ? Item::NodeSet : Item::Node, raw.target);
  if (found == no_index) return {};
  return raw.is_set ? build.model.node_sets[static_cast<std::size_t>(found)].nodes
                    : std::vector<Index>{found};
}

double norm_of(const RawVelocity& raw) {
  return std::hypot(raw.velocity[0], raw.velocity[1], raw.velocity[2]) +
         std::hypot(raw.angular_velocity[0], raw.angular_velocity[1], raw.angular_velocity[2]);
}

/// Velocities of *INITIAL_VELOCITY_NODE; those of sets often have nodes that only orient something.
void check_velocities(const NodeUses& uses, Build& build) {
  std::size_t idle = 0;
  const RawVelocity* first = nullptr;
  for (const RawVelocity& raw : build.deck.velocities) {
    if (raw.target != RawVelocity::Target::Node || norm_of(raw) == 0) continue;
    const Index node = build.find_quietly(Item::Node, raw.id);
    if (node == no_index || uses.has_mass[static_cast<std::size_t>(node)] != 0) continue;
    if (idle++ == 0) first = &raw;
  }
  if (idle == 0) return;
  build.report.warning(
      first->where, "velocity without mass",
      fmt::format("node {}{} has no mass: no element with mass, *ELEMENT_MASS or rigid body has "
                  "it; its velocity has no effect",
                  first->id, idle > 1 ? fmt::format(", as {} more,", idle - 1) : ""));
}

}  // namespace

void check_idle_loads(Build& build) {
  if (build.deck.nodal_loads.empty() && build.deck.velocities.empty()) return;
  const NodeUses uses = uses_of_nodes(build);
  check_velocities(uses, build);
  constexpr int last_force = 4;
  for (const RawNodalLoad& raw : build.deck.nodal_loads) {
    const bool is_force = raw.direction <= last_force;
    const std::vector<char>& takes = is_force ? uses.has_mass : uses.turns;
    std::size_t idle = 0;
    Index first = no_index;
    for (const Index node : loaded_nodes(raw, build))
      if (takes[static_cast<std::size_t>(node)] == 0 && idle++ == 0) first = node;
    if (idle == 0 || raw.scale == 0) continue;
    const UserId id = build.model.nodes.id[static_cast<std::size_t>(first)];
    build.report.warning(
        raw.where, is_force ? "force without mass" : "moment without rotation",
        is_force ? fmt::format(
                       "the force acts on node {}{}, which has no mass: no element with mass, *ELEMENT_MASS "
                       "or rigid body has it; it has no effect there",
                       id, idle > 1 ? fmt::format(" and {} more", idle - 1) : "")
                 : fmt::format(
                       "the moment acts on node {}{}, which has no rotation: solids have none, and nothing "
                       "else has the node; it has no effect there; give it as a pair of forces, or add the "
                       "nodes of a face to a *CONSTRAINED_NODAL_RIGID_BODY",
                       id, idle > 1 ? fmt::format(" and {} more", idle - 1) : ""));
  }
}

}  // namespace crumple::deck
