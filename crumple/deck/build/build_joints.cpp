// SPDX-License-Identifier: BSD-3-Clause
// Joints between rigid bodies.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "deck/build/build.hpp"
#include "deck/format/vector.hpp"

namespace crumple::deck {

namespace {

using model::JointKind;

constexpr std::array<std::string_view, 6> node_field = {"N1", "N2", "N3", "N4", "N5", "N6"};

/// Sine of the smallest angle between two lines that are to span a plane.
constexpr double least_sine = 1e-3;

/// Nodes that should coincide are further apart than numbers in a deck are exact, over the largest
/// coordinate.
constexpr double coincidence = 1e-5;

class JointBuilder {
 public:
  explicit JointBuilder(Build& build) : build_(build), body_of_node_(bodies_of_nodes(build)) {}

  void add(const RawJoint& raw, std::size_t place) {
    model::Joint joint = raw.joint;
    if (joint.id == 0)
      joint.id = static_cast<UserId>(place) + 1;
    else
      build_.enter(Item::Joint, {joint.id, "JID", raw.where}, build_.model.joints.size());
    if (!find_nodes(raw, joint) || !check_bodies(raw, joint) || !check_directions(raw, joint)) return;
    check_coincidence(raw, joint);
    build_.model.joints.push_back(joint);
  }

 private:
  void fault(const RawJoint& raw, std::size_t node, std::string_view expected, std::string hint) const {
    build_.report.field_error(raw.where, {node_field[node], std::to_string(raw.node[node]),
                                          std::string(expected), std::move(hint), "joint"});
  }

  bool find_nodes(const RawJoint& raw, model::Joint& joint) const {
    bool found = true;
    for (std::size_t i = 0; i < model::node_count(joint.kind); ++i) {
      joint.node[i] = build_.find(Item::Node, {raw.node[i], node_field[i], raw.where});
      found = found && joint.node[i] != no_index;
    }
    return found;
  }

  Index body_of(const model::Joint& joint, std::size_t node) const {
    return body_of_node_[static_cast<std::size_t>(joint.node[node])];
  }

  bool check_bodies(const RawJoint& raw, const model::Joint& joint) const {
    for (std::size_t i = 0; i < model::node_count(joint.kind); ++i) {
      const Index own = body_of(joint, i);
      if (own == no_index) {
        fault(
            raw, i, "a node of a rigid body",
            "joints are between rigid bodies; tie the node to one with *CONSTRAINED_EXTRA_NODES_NODE or make "
            "one of its neighbours with *CONSTRAINED_NODAL_RIGID_BODY");
        return false;
      }
      if (i < 2) continue;
      if (own == body_of(joint, i % 2)) continue;
      fault(raw, i, fmt::format("a node of the same rigid body as {}", node_field[i % 2]),
            "N1, N3 and N5 belong to one body, N2, N4 and N6 to the other");
      return false;
    }
    if (body_of(joint, 0) != body_of(joint, 1)) return true;
    fault(raw, 1, "a node of another rigid body than N1",
          fmt::format("both belong to rigid body {}",
                      build_.model.rigid_bodies[static_cast<std::size_t>(body_of(joint, 0))].id));
    return false;
  }

  Vector position(const model::Joint& joint, std::size_t node) const {
    return build_.model.nodes.position[static_cast<std::size_t>(joint.node[node])];
  }

  /// Whether the lines from N1 to two nodes, or from N1 and N2 to one each, span a plane.
  static bool spans_plane(const Vector& first, const Vector& second) {
    return length_of(cross(first, second)) > least_sine * length_of(first) * length_of(second);
  }

  bool check_directions(const RawJoint& raw, const model::Joint& joint) const {
    if (model::node_count(joint.kind) == 2) return true;
    const Vector axis = difference(position(joint, 2), position(joint, 0));
    if (!(length_of(axis) > 0)) {
      fault(raw, 2, "a node apart from N1", "the axis of the joint is the line from N1 to N3");
      return false;
    }
    if (joint.kind == JointKind::Universal) {
      const Vector other = difference(position(joint, 3), position(joint, 1));
      if (length_of(other) > 0 && spans_plane(axis, other)) return true;
      fault(raw, 3, "a node across the line from N1 to N3",
            "the axes of a universal joint, N1 to N3 and N2 to N4, are at right angles");
      return false;
    }
    if (model::node_count(joint.kind) < 6) return true;
    const Vector side = difference(position(joint, 4), position(joint, 0));
    if (length_of(side) > 0 && spans_plane(axis, side)) return true;
    fault(raw, 4, "a node off the line from N1 to N3", "it holds the rotation about that line");
    return false;
  }

  /// Distance of a node from where it should be: another node's place, the axis, or a plane through it.
  double distance(const model::Joint& joint, std::size_t node) const {
    const bool slides = joint.kind == JointKind::Cylindrical || joint.kind == JointKind::Translational;
    const Vector away = difference(position(joint, node), position(joint, slides ? 0 : node - 1));
    if (!slides) return length_of(away);
    const Vector axis = difference(position(joint, 2), position(joint, 0));
    if (node != 5) return length_of(cross(axis, away)) / length_of(axis);
    const Vector normal = cross(axis, difference(position(joint, 4), position(joint, 0)));
    return std::fabs(dot(normal, away)) / length_of(normal);
  }

  void check_coincidence(const RawJoint& raw, const model::Joint& joint) const {
    const std::size_t pairs = joint.kind == JointKind::Universal ? 2 : model::node_count(joint.kind);
    const bool slides = joint.kind == JointKind::Cylindrical || joint.kind == JointKind::Translational;
    for (std::size_t node = 1; node < pairs; node += 2) {
      double largest = 0;
      for (const double coordinate : position(joint, node))
        largest = std::max(largest, std::fabs(coordinate));
      const double away = distance(joint, node);
      if (away <= coincidence * largest) continue;
      build_.report.field_warning(
          raw.where,
          {node_field[node], std::to_string(raw.node[node]),
           slides ? (node == 5 ? "a node in the plane of N1, N3 and N5" : "a node on the line from N1 to N3")
                  : fmt::format("a node at the place of {}", node_field[node - 1]),
           fmt::format("it is {:.3g} away; the joint holds the place where it should be", away), "distance"});
    }
  }

  Build& build_;
  std::vector<Index> body_of_node_;
};

}  // namespace

void build_joints(Build& build) {
  if (build.deck.joints.empty()) return;
  JointBuilder builder(build);
  for (std::size_t i = 0; i < build.deck.joints.size(); ++i) builder.add(build.deck.joints[i], i);
}

}  // namespace crumple::deck
