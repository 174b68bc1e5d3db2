// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What an isolated system keeps, watched over a run.

#include <cmath>

#include "support/larger.hpp"
#include "support/run.hpp"

namespace crumple::test {

/// Moment of momentum about the origin, that of turning shell nodes included; nodes that are tied by
/// constraint count with those that carry them. With the positions of time n and the velocities of n + 1/2
/// central differences keep it to round-off if the forces do.
inline math::Vec3 moment_of_momentum(const domain::Domain& domain) {
  math::Vec3 sum;
  const domain::NodeFields& nodes = domain.nodes;
  for (Index i = 0; i < nodes.count(); ++i) {
    if (nodes.is_tied(i)) continue;
    sum += nodes.moving_mass(i) * cross(nodes.position[i], nodes.velocity[i]) +
           nodes.moving_inertia(i) * nodes.angular_velocity[i];
  }
  return sum;
}

/// Likewise: what is tied on a lever moves its mass at the lever's foot.
inline math::Vec3 carried_momentum(const domain::Domain& domain) {
  math::Vec3 sum;
  const domain::NodeFields& nodes = domain.nodes;
  for (Index i = 0; i < nodes.count(); ++i)
    if (!nodes.is_tied(i)) sum += nodes.moving_mass(i) * nodes.velocity[i];
  return sum;
}

/// Largest changes of what should stay, over what there is at the start.
class Conservation {
 public:
  void watch(const domain::Domain& domain) {
    const math::Vec3 momentum = carried_momentum(domain);
    const math::Vec3 turning = moment_of_momentum(domain);
    if (!begun_) {
      begun_ = true;
      momentum_ = momentum;
      turning_ = turning;
      const domain::NodeFields& nodes = domain.nodes;
      for (Index i = 0; i < nodes.count(); ++i) {
        const double size = nodes.mass[i] * norm(nodes.velocity[i]);
        momentum_scale_ += size;
        turning_scale_ += size * norm(nodes.position[i]);
      }
    }
    momentum_drift = larger_of(momentum_drift, norm(momentum - momentum_) / momentum_scale_);
    turning_drift = larger_of(turning_drift, norm(turning - turning_) / turning_scale_);
    worst_imbalance =
        larger_of(worst_imbalance, std::fabs(domain.energy.imbalance()) / domain.energy.initial_total);
  }

  double momentum_drift = 0;   ///< over the sum of m |v|
  double turning_drift = 0;    ///< moment of momentum, over the sum of m |x| |v|
  double worst_imbalance = 0;  ///< of energy, over the initial one

 private:
  bool begun_ = false;
  math::Vec3 momentum_;
  math::Vec3 turning_;
  double momentum_scale_ = 0;
  double turning_scale_ = 0;
};

/// Runs the model to its end and tells what was kept on the way.
inline Conservation watched_run(const model::Model& model) {
  timeloop::Simulation simulation(model, execution());
  Conservation kept;
  run(simulation, [&](const domain::Domain& now) { kept.watch(now); });
  return kept;
}

}  // namespace crumple::test
