// SPDX-License-Identifier: BSD-3-Clause
#include "loads/follower_loads.hpp"

namespace crumple::loads {

using math::Vec3;

namespace {

/// The unit normal of three nodes; zero if they lie on one line.
Vec3 normal_of(const domain::NodeFields& nodes, const std::array<Index, 3>& plane) {
  const Vec3& origin = nodes.position[plane[0]];
  const Vec3 first = nodes.position[plane[1]] - origin;
  const Vec3 second = nodes.position[plane[2]] - origin;
  const Vec3 normal = cross(first, second);
  constexpr double on_one_line = 1e-12;  // sine of the angle between the two
  const double length = norm(normal);
  return length > on_one_line * norm(first) * norm(second) ? (1 / length) * normal : Vec3{};
}

}  // namespace

FollowerLoads::FollowerLoads(const model::Model& model, const domain::Domain& domain) : model_(&model) {
  const auto add = [&](const auto& given, Index node, Index body) {
    if (!given.plane.given()) return;
    Load load;
    load.node = node == no_index ? no_index : domain.nodes.domain_node[node];
    load.body = body;
    for (std::size_t k = 0; k < 3; ++k) load.plane[k] = domain.nodes.domain_node[given.plane.node[k]];
    load.force = given.force[0];
    load.moment = given.moment[0];
    load.curve = given.curve;
    loads_.push_back(load);
  };
  for (const model::NodalLoad& load : model.nodal_loads) add(load, load.node, no_index);
  for (const model::RigidBodyLoad& load : model.rigid_body_loads) add(load, no_index, load.body);
  previous_.resize(loads_.size());
}

void FollowerLoads::add_forces(domain::Domain& domain) {
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    const Load& load = loads_[i];
    const double factor = load.curve == no_index ? 1.0 : model_->curves[load.curve].at(domain.clock.time);
    const Vec3 along = factor * normal_of(domain.nodes, load.plane);
    Vec3 velocity;
    Vec3 spin;
    if (load.node != no_index) {
      domain::NodeForce& sum = domain.nodes.force[load.node];
      for (int axis = 0; axis < 3; ++axis) {
        sum.force[axis] += load.force * along[axis];
        sum.moment[axis] += load.moment * along[axis];
      }
      velocity = domain.nodes.velocity[load.node];
      spin = domain.nodes.angular_velocity[load.node];
    } else {
      domain::RigidBody& body = domain.rigid_bodies[load.body];
      body.force += load.force * along;
      body.moment += load.moment * along;
      velocity = body.velocity;
      spin = body.angular_velocity;
    }
    const double rate = dot(previous_[i] + along, load.force * velocity + load.moment * spin);
    domain.energy.external_work += 0.5 * domain.clock.step * rate;
    previous_[i] = along;
  }
}

void FollowerLoads::declare(domain::StateList& list) {
  if (!loads_.empty()) list.keep_list("follower_loads", "-", domain::Entity::Run, 3, previous_);
}

}  // namespace crumple::loads
