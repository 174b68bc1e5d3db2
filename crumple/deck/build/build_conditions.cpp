// SPDX-License-Identifier: BSD-3-Clause
// Masses and initial velocities.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/counted.hpp"
#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

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

/// Only those in the box that the card names, if it does.
void keep_inside(Build& build, const RawVelocity& raw, std::vector<Index>& nodes) {
  if (raw.box == 0) return;
  const Index index = build.find(Item::Box, {raw.box, "BOXID", raw.where});
  if (index == no_index) return;
  const RawBox& box = build.deck.boxes[static_cast<std::size_t>(index)];
  const auto outside = [&](Index node) {
    return !is_inside(box, build.model.nodes.position[static_cast<std::size_t>(node)]);
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), outside), nodes.end());
}

/// With all vectors in global axes; absent, with a message, if the coordinate system is missing.
std::optional<RawVelocity> in_global_axes(Build& build, RawVelocity raw) {
  if (raw.system == 0) return raw;
  for (Vector* vector : {&raw.velocity, &raw.angular_velocity, &raw.spin, &raw.exempt_velocity,
                         &raw.exempt_angular_velocity}) {
    const auto global = turned(build, *vector, raw.system, "ICID", raw.where);
    if (!global) return std::nullopt;
    *vector = *global;
  }
  return raw;
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

void build_part_masses(Build& build) {
  for (const RawPartMass& raw : build.deck.part_masses) {
    const std::vector<Index> parts = find_parts(build, raw.is_set, {raw.target, "PID", raw.where});
    if (!parts.empty()) build.model.part_masses.push_back({parts, raw.added, raw.final_mass});
  }
}

void build_velocities(Build& build) {
  std::vector<model::InitialVelocity> at_node(build.model.nodes.id.size());
  const std::vector<Index> body_of_node = bodies_of_nodes(build);
  const auto set = [&](const model::InitialVelocity& velocity) {
    at_node[static_cast<std::size_t>(velocity.node)] = velocity;
  };
  const auto apply = [&](const RawVelocity& given) {
    const std::optional<RawVelocity> global = in_global_axes(build, given);
    if (!global) return;
    const RawVelocity& raw = *global;
    std::vector<Index> nodes = velocity_nodes(build, raw);
    keep_inside(build, raw, nodes);
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
