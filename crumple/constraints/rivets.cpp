// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/rivets.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"

namespace crumple::constraints {

using math::Vec3;

namespace {

/// Velocity that an impulse of one along `direction` gives to a node.
Vec3 response(const domain::NodeFields& nodes, Index node, const Vec3& direction) {
  Vec3 velocity = (1.0 / nodes.moving_mass(node)) * direction;
  for (int axis = 0; axis < 3; ++axis)
    if ((nodes.fixed[node] & domain::fixed_translation(axis)) != 0) velocity[axis] = 0;
  return velocity;
}

/// The root nearest to zero of |a - s b| = length; zero if the nodes cannot be held by this link.
double impulse(const Vec3& a, const Vec3& b, double length) {
  const double square = dot(b, b);
  const double half = dot(a, b);
  const double rest = dot(a, a) - length * length;
  const double discriminant = half * half - square * rest;
  if (!(square > 0) || discriminant < 0) return 0;
  const double root = std::sqrt(discriminant);
  return rest / (half >= 0 ? half + root : half - root);
}

}  // namespace

Rivets::Rivets(const model::Model& model, const domain::Domain& domain) {
  links_.reserve(model.rivets.size());
  for (const model::Rivet& rivet : model.rivets) {
    const domain::NodeFields& nodes = domain.nodes;
    const Link link{nodes.domain_node[rivet.node[0]], nodes.domain_node[rivet.node[1]],
                    norm(nodes.position[nodes.domain_node[rivet.node[1]]] -
                         nodes.position[nodes.domain_node[rivet.node[0]]]),
                    rivet.failure_time};
    const std::string name = "Rivet " + std::to_string(rivet.id);
    if (!(link.length > 0)) throw Error(name + " joins two nodes at the same place.");
    if (!(nodes.mass[link.first] > 0) || !(nodes.mass[link.second] > 0))
      throw Error(name + " joins a node without mass.");
    links_.push_back(link);
  }
}

void Rivets::constrain(domain::Domain& domain, double next_step) const {
  domain::NodeFields& nodes = domain.nodes;
  for (const Link& link : links_) {
    if (domain.clock.time >= link.failure_time) continue;
    const Vec3 line = nodes.position[link.second] - nodes.position[link.first];
    const Vec3 direction = normalised(line);
    const Vec3 of_first = response(nodes, link.first, direction);
    const Vec3 of_second = response(nodes, link.second, direction);
    const Vec3 next = line + next_step * (nodes.velocity[link.second] - nodes.velocity[link.first]);
    const double pull = impulse(next, next_step * (of_first + of_second), link.length);
    nodes.velocity[link.first] += pull * of_first;
    nodes.velocity[link.second] -= pull * of_second;
  }
}

}  // namespace crumple::constraints
