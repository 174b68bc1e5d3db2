// SPDX-License-Identifier: BSD-3-Clause
#include "timeloop/start_loss.hpp"

#include "math/vec3.hpp"

namespace crumple::timeloop {

StartLoss::StartLoss(const domain::Domain& domain)
    : velocity_(domain.nodes.velocity), angular_velocity_(domain.nodes.angular_velocity) {}

void StartLoss::keep_forces(const domain::Domain& domain) {
  force_.assign(domain.nodes.force.begin(), domain.nodes.force.begin() + domain.nodes.count());
}

double StartLoss::of_kick(const domain::Domain& domain, double interval) const {
  double sum = 0;
  for (Index node = 0; node < domain.nodes.count(); ++node) {
    const math::Vec3 change = domain.nodes.velocity[node] - velocity_[node];
    const math::Vec3 turn = domain.nodes.angular_velocity[node] - angular_velocity_[node];
    const domain::NodeForce& f = force_[node];
    for (int axis = 0; axis < 3; ++axis) sum += f.force[axis] * change[axis] + f.moment[axis] * turn[axis];
  }
  return 0.5 * interval * sum;
}

}  // namespace crumple::timeloop
