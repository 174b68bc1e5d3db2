// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/start_loss.hpp"

#include "math/vec3.hpp"

namespace crumple::timeloop {

StartLoss::StartLoss(const domain::Domain& domain)
    : velocity_(domain.nodes.velocity), angular_velocity_(domain.nodes.angular_velocity) {}

void StartLoss::keep_inner_forces(const domain::Domain& domain) {
  inner_.assign(domain.nodes.force.begin(), domain.nodes.force.begin() + domain.nodes.count());
}

void StartLoss::keep_loads(const domain::Domain& domain) {
  all_.assign(domain.nodes.force.begin(), domain.nodes.force.begin() + domain.nodes.count());
}

StartLoss::Left StartLoss::of_kick(const domain::Domain& domain, double interval) const {
  Left left;
  for (Index node = 0; node < domain.nodes.count(); ++node) {
    const math::Vec3 change = domain.nodes.velocity[node] - velocity_[node];
    const math::Vec3 turn = domain.nodes.angular_velocity[node] - angular_velocity_[node];
    const domain::NodeForce& f = inner_[node];
    const domain::NodeForce& all = all_[node];
    for (int axis = 0; axis < 3; ++axis) {
      left.inner += f.force[axis] * change[axis] + f.moment[axis] * turn[axis];
      left.loads +=
          (all.force[axis] - f.force[axis]) * change[axis] + (all.moment[axis] - f.moment[axis]) * turn[axis];
    }
  }
  left.inner *= 0.5 * interval;
  left.loads *= 0.5 * interval;
  return left;
}

}  // namespace crumple::timeloop
