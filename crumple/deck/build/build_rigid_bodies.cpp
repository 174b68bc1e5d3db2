// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies: parts of rigid material, what is merged with them or tied to them, and sets of nodes.
#include <fmt/core.h>

#include <algorithm>

#include "deck/build/build.hpp"

namespace crumple::deck {

namespace {

/// Bodies under construction: each part of rigid material one, until some are merged.
class Bodies {
 public:
  explicit Bodies(Build& build) : build_(build) {}

  void take_parts();
  void merge();
  void merge(const RawRigidMerge& raw, std::string_view leading_field, std::string_view merged_field);
  void take_nodes_of_parts();
  void take_extra_nodes();
  void take_nodal_bodies();
  void finish();

 private:
  Index leading(Index body) const {
    while (merged_into_[static_cast<std::size_t>(body)] != body)
      body = merged_into_[static_cast<std::size_t>(body)];
    return body;
  }
  Index add(model::RigidBody body, const Where& where) {
    bodies_.push_back(std::move(body));
    where_.push_back(where);
    merged_into_.push_back(static_cast<Index>(bodies_.size()) - 1);
    return merged_into_.back();
  }
  void take_inertia(const RawInertia& raw, model::RigidBody& body);
  void take_held_axes(UserId system, const Where& where, model::RigidBody& body);
  void check_nodes();

  Build& build_;
  std::vector<model::RigidBody> bodies_;
  std::vector<Where> where_;
  std::vector<Index> merged_into_;
  std::vector<Index> body_of_part_;
  std::vector<Index> body_of_node_;
};

void Bodies::take_inertia(const RawInertia& raw, model::RigidBody& body) {
  body.inertia = raw.inertia;
  if (raw.centre_node == 0) return;
  const Index node = build_.find(Item::Node, {raw.centre_node, "NODEID", raw.where});
  if (node != no_index) body.inertia->centre = build_.model.nodes.position[static_cast<std::size_t>(node)];
}

void Bodies::take_held_axes(UserId system, const Where& where, model::RigidBody& body) {
  if (system == 0) return;
  if (const auto axes = find_axes(build_, system, "CON1", where)) body.held_axes = *axes;
}

void Bodies::take_parts() {
  const model::Model& model = build_.model;
  body_of_part_.assign(model.parts.size(), no_index);
  for (const RawPart& raw : build_.deck.parts) {
    const Index index = build_.find_quietly(Item::Part, raw.id);
    if (index == no_index) continue;
    const model::Part& part = model.parts[static_cast<std::size_t>(index)];
    if (part.material == no_index) continue;  // of springs
    const auto& rigid = model.materials[static_cast<std::size_t>(part.material)].rigid;
    if (!rigid) {
      if (raw.inertia)
        build_.report.warning(raw.where, "inertia",
                              fmt::format("part {} is not of rigid material: its given inertia is not used, "
                                          "as in LS-DYNA",
                                          raw.id));
      continue;
    }
    const auto place = static_cast<std::size_t>(index);
    if (build_.shells_of_part[place] == 0 && build_.solids_of_part[place] == 0 &&
        build_.lines_of_part[place] == 0)
      continue;
    model::RigidBody body;
    body.id = raw.id;
    body.title = raw.title;
    body.parts = {index};
    body.fixed_translation = rigid->fixed_translation;
    body.fixed_rotation = rigid->fixed_rotation;
    // The materials of *DEFORMABLE_TO_RIGID are not in the deck.
    if (static_cast<std::size_t>(part.material) < build_.deck.materials.size()) {
      const RawMaterial& material = build_.deck.materials[static_cast<std::size_t>(part.material)];
      take_held_axes(material.held_system, material.where, body);
    }
    if (raw.inertia) take_inertia(*raw.inertia, body);
    body_of_part_[static_cast<std::size_t>(index)] = add(std::move(body), raw.where);
  }
}

void Bodies::merge() {
  for (const RawRigidMerge& raw : build_.deck.rigid_merges) merge(raw, "PIDL", "PIDC");
  for (const RawRigidPart& raw : build_.deck.rigid_parts) {
    if (raw.leading == 0) continue;
    for (const Index part : find_parts(build_, raw.is_set, {raw.target, "PID", raw.where}))
      merge({raw.leading, build_.model.parts[static_cast<std::size_t>(part)].id, raw.where}, "LRB", "PID");
  }
}

void Bodies::merge(const RawRigidMerge& raw, std::string_view leading_field, std::string_view merged_field) {
  const auto body_of = [&](UserId id, std::string_view field) {
    const Index part = build_.find(Item::Part, {id, field, raw.where});
    if (part == no_index) return no_index;
    const Index body = body_of_part_[static_cast<std::size_t>(part)];
    if (body == no_index)
      build_.report.field_error(raw.where, {field, std::to_string(id), "a part of *MAT_RIGID",
                                            "only rigid parts with elements can be merged", "rigid"});
    return body;
  };
  const Index first = body_of(raw.leading, leading_field);
  const Index second = body_of(raw.merged, merged_field);
  if (first == no_index || second == no_index) return;
  const Index into = leading(first);
  const Index from = leading(second);
  if (into == from) return;
  merged_into_[static_cast<std::size_t>(from)] = into;
  std::vector<Index>& parts = bodies_[static_cast<std::size_t>(from)].parts;
  std::vector<Index>& target = bodies_[static_cast<std::size_t>(into)].parts;
  target.insert(target.end(), parts.begin(), parts.end());
  parts.clear();
}

void Bodies::take_nodes_of_parts() {
  const auto take = [&](const auto& element) {
    if (element.part == no_index) return;
    const Index own = body_of_part_[static_cast<std::size_t>(element.part)];
    if (own == no_index) return;
    std::vector<Index>& nodes = bodies_[static_cast<std::size_t>(leading(own))].nodes;
    for (const Index node : element.node)
      if (node != no_index) nodes.push_back(node);
  };
  for (const model::ShellElement& shell : build_.model.shells) take(shell);
  for (const model::SolidElement& solid : build_.model.solids) take(solid);
  for (const model::BeamElement& beam : build_.model.beams) take(beam);
}

void Bodies::take_extra_nodes() {
  for (const RawExtraNodes& raw : build_.deck.extra_nodes) {
    const Index part = build_.find(Item::Part, {raw.part, "PID", raw.where});
    if (part == no_index) continue;
    const Index own = body_of_part_[static_cast<std::size_t>(part)];
    if (own == no_index) {
      build_.report.field_error(raw.where, {"PID", std::to_string(raw.part), "a part of *MAT_RIGID",
                                            "nodes can be tied to rigid parts with elements only", "rigid"});
      continue;
    }
    std::vector<Index> nodes;
    if (!raw.is_set) {
      nodes.push_back(build_.find(Item::Node, {raw.target, "NID", raw.where}));
    } else if (const Index set = build_.find(Item::NodeSet, {raw.target, "NSID", raw.where});
               set != no_index) {
      nodes = build_.model.node_sets[static_cast<std::size_t>(set)].nodes;
    }
    std::erase(nodes, no_index);
    model::RigidBody& body = bodies_[static_cast<std::size_t>(leading(own))];
    body.nodes.insert(body.nodes.end(), nodes.begin(), nodes.end());
    if (raw.adds_mass) body.added_nodes.insert(body.added_nodes.end(), nodes.begin(), nodes.end());
  }
}

void Bodies::take_nodal_bodies() {
  for (const RawNodalBody& raw : build_.deck.nodal_bodies) {
    const Index set = build_.find(Item::NodeSet, {raw.node_set, "NSID", raw.where});
    if (set == no_index) continue;
    model::RigidBody body;
    body.id = raw.id;
    body.title = raw.title;
    body.fixed_translation = raw.held.fixed_translation;
    body.fixed_rotation = raw.held.fixed_rotation;
    take_held_axes(raw.held_system, raw.where, body);
    body.nodes = build_.model.node_sets[static_cast<std::size_t>(set)].nodes;
    if (raw.inertia) take_inertia(*raw.inertia, body);
    if (body.nodes.empty()) {
      build_.report.field_error(raw.where, {"NSID", std::to_string(raw.node_set), "a set with nodes",
                                            "the body would have none", "empty"});
      continue;
    }
    add(std::move(body), raw.where);
  }
}

/// Nodes that two bodies claim.
void Bodies::check_nodes() {
  body_of_node_.assign(build_.model.nodes.id.size(), no_index);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const Index node : bodies_[b].nodes) {
      Index& owner = body_of_node_[static_cast<std::size_t>(node)];
      if (owner != no_index) {
        const auto other = static_cast<std::size_t>(owner);
        build_.report.error(
            where_[b], "shared",
            fmt::format("node {} belongs to the rigid bodies {} and {} ({}); merge them with "
                        "*CONSTRAINED_RIGID_BODIES, or take the node out of one",
                        build_.model.nodes.id[static_cast<std::size_t>(node)], bodies_[other].id,
                        bodies_[b].id, build_.report.place(where_[other])));
      }
      owner = static_cast<Index>(b);
    }
}

void Bodies::finish() {
  for (model::RigidBody& body : bodies_) {
    for (std::vector<Index>* nodes : {&body.nodes, &body.added_nodes}) {
      std::sort(nodes->begin(), nodes->end());
      nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
  }
  check_nodes();
  std::vector<Index> place(bodies_.size(), no_index);
  std::vector<model::RigidBody>& result = build_.model.rigid_bodies;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (merged_into_[b] != static_cast<Index>(b)) continue;
    place[b] = static_cast<Index>(result.size());
    result.push_back(std::move(bodies_[b]));
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    build_.enter(Item::RigidBody, {bodies_[b].id, "PID", where_[b]},
                 static_cast<std::size_t>(place[static_cast<std::size_t>(leading(static_cast<Index>(b)))]));
}

/// The vector with these components along the axes.
Vector in_global_axes(const std::array<Vector, 3>& axes, const Vector& components) {
  Vector sum{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t i = 0; i < 3; ++i) sum[i] += components[axis] * axes[axis][i];
  return sum;
}

void take_initial_motions(Build& build) {
  for (const RawRigidVelocity& raw : build.deck.rigid_velocities) {
    const Index body = build.find(Item::RigidBody, {raw.body, "PID", raw.where});
    if (body == no_index) continue;
    model::RigidMotion motion = raw.motion;
    if (raw.system != 0) {
      const auto axes = find_axes(build, raw.system, "ICID", raw.where);
      if (!axes) continue;
      motion = {in_global_axes(*axes, motion.velocity), in_global_axes(*axes, motion.angular_velocity)};
    }
    build.model.rigid_bodies[static_cast<std::size_t>(body)].initial_motion = motion;
  }
}

/// A part of deformable material becomes one of a rigid material with the same density and stiffness.
void make_rigid(Build& build, Index index, const RawRigidPart& raw) {
  model::Part& part = build.model.parts[static_cast<std::size_t>(index)];
  if (part.material == no_index) {
    build.report.field_error(raw.where,
                             {"PID", std::to_string(part.id), "a part of shells, solids or beams",
                              "springs and dampers have nothing that could become rigid", "springs"});
    return;
  }
  model::Material material = build.model.materials[static_cast<std::size_t>(part.material)];
  if (material.rigid) return;
  material.rigid.emplace();
  material.erosion.reset();
  material.damage.reset();
  material.least_step = 0;
  part.material = static_cast<Index>(build.model.materials.size());
  build.model.materials.push_back(std::move(material));
}

}  // namespace

void make_parts_rigid(Build& build) {
  for (const RawRigidPart& raw : build.deck.rigid_parts)
    for (const Index part : find_parts(build, raw.is_set, {raw.target, "PID", raw.where}))
      make_rigid(build, part, raw);
}

std::vector<Index> bodies_of_nodes(const Build& build) {
  std::vector<Index> body_of_node(build.model.nodes.id.size(), no_index);
  const auto& bodies = build.model.rigid_bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (const Index node : bodies[b].nodes)
      body_of_node[static_cast<std::size_t>(node)] = static_cast<Index>(b);
  return body_of_node;
}

void build_rigid_bodies(Build& build) {
  Bodies bodies(build);
  bodies.take_parts();
  bodies.merge();
  bodies.take_nodes_of_parts();
  bodies.take_extra_nodes();
  bodies.take_nodal_bodies();
  bodies.finish();
  take_initial_motions(build);
}

}  // namespace crumple::deck
