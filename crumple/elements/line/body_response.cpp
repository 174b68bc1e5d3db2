// SPDX-License-Identifier: BSD-3-Clause
#include "elements/line/body_response.hpp"

#include <algorithm>

#include "math/rotation.hpp"
#include "math/to_vec3.hpp"

namespace crumple::elements {

using math::Vec3;

namespace {

/// The smallest principal moment that is not zero: about an axis without inertia a body does not turn.
double least_moment(const math::Matrix3& tensor) {
  const Vec3 moment = math::principal_axes(tensor).moment;
  const double largest = std::max({moment.x, moment.y, moment.z});
  constexpr double none = 1e-12;
  double least = largest;
  for (int axis = 0; axis < 3; ++axis)
    if (moment[axis] > none * largest) least = std::min(least, moment[axis]);
  return least;
}

}  // namespace

BodyResponse::Body BodyResponse::body_of(const model::RigidBody& given) const {
  Body body;
  body.first = nodes_.domain_node[given.nodes.front()];
  if (given.inertia) {
    const auto& t = given.inertia->tensor;
    body.mass = given.inertia->mass;
    body.centre = math::to_vec3(given.inertia->centre);
    body.inertia = least_moment({{Vec3{t[0], t[1], t[2]}, Vec3{t[1], t[3], t[4]}, Vec3{t[2], t[4], t[5]}}});
    return body;
  }
  Vec3 first_moment;
  for (const Index each : given.nodes) {
    const Index node = nodes_.domain_node[each];
    body.mass += nodes_.mass[node];
    first_moment += nodes_.mass[node] * nodes_.position[node];
  }
  if (!(body.mass > 0)) return body;
  body.centre = (1 / body.mass) * first_moment;
  math::Matrix3 tensor;
  for (const Index each : given.nodes) {
    const Index node = nodes_.domain_node[each];
    const Vec3 r = nodes_.position[node] - body.centre;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3& column = tensor.column[static_cast<std::size_t>(axis)];
      column -= nodes_.mass[node] * r[axis] * r;
      column[axis] += nodes_.mass[node] * dot(r, r) + nodes_.inertia[node];
    }
  }
  body.inertia = least_moment(tensor);
  return body;
}

BodyResponse::BodyResponse(const model::Model& model, const domain::Domain& domain) : nodes_(domain.nodes) {
  if (model.rigid_bodies.empty()) return;
  body_of_node_.assign(static_cast<std::size_t>(nodes_.count()), no_index);
  bodies_.reserve(model.rigid_bodies.size());
  for (const model::RigidBody& given : model.rigid_bodies) {
    for (const Index node : given.nodes)
      body_of_node_[nodes_.domain_node[node]] = static_cast<Index>(bodies_.size());
    bodies_.push_back(body_of(given));
  }
}

double BodyResponse::at(Index node, bool turning) const {
  if (body_of_node_.empty() || body_of_node_[node] == no_index) return 0;
  const Body& body = bodies_[body_of_node_[node]];
  if (!(body.mass > 0)) return 0;
  const double of_turn = body.inertia > 0 ? 1 / body.inertia : 0;
  if (turning) return of_turn;
  const Vec3 arm = nodes_.position[node] - body.centre;
  return 1 / body.mass + dot(arm, arm) * of_turn;
}

Index BodyResponse::shared_node(Index node, bool turning) const {
  const bool has_own = (turning ? nodes_.inertia : nodes_.mass)[node] > 0;
  if (has_own || body_of_node_.empty() || body_of_node_[node] == no_index) return node;
  return bodies_[body_of_node_[node]].first;
}

}  // namespace crumple::elements
