// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/initial_motion.hpp"

namespace crumple::timeloop {

InitialMotion::InitialMotion(const domain::Domain& domain)
    : velocity_(domain.nodes.velocity),
      angular_velocity_(domain.nodes.angular_velocity),
      clock_(domain.clock),
      times_(domain.times) {
  for (const domain::RigidBody& body : domain.rigid_bodies)
    bodies_.push_back(
        {body.velocity, body.angular_momentum, body.angular_velocity, body.spin, body.kinetic_energy});
}

void InitialMotion::put_back(domain::Domain& domain) const {
  domain.nodes.velocity = velocity_;
  domain.nodes.angular_velocity = angular_velocity_;
  domain.clock = clock_;
  domain.times = times_;
  domain.energy = {};
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    domain::RigidBody& body = domain.rigid_bodies[i];
    body.velocity = bodies_[i].velocity;
    body.angular_momentum = bodies_[i].angular_momentum;
    body.angular_velocity = bodies_[i].angular_velocity;
    body.spin = bodies_[i].spin;
    body.kinetic_energy = bodies_[i].kinetic_energy;
    body.next_turn = body.turn;
    body.reaction = body.reaction_moment = {};
    body.deferred_work = 0;
  }
}

}  // namespace crumple::timeloop
