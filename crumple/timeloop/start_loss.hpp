// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/aligned_array.hpp"
#include "domain/domain.hpp"

namespace crumple::timeloop {

/// What forces at time zero do before the balance begins to count: those that follow from rates, viscous
/// hourglass control, bulk viscosity, dampers, take from initial velocities, and loads begin at once. At time
/// zero the kinetic energy is 1/2 m v(0)^2, from then on 1/2 m v(n-1/2).v(n+1/2) with the work of both forces
/// of a step by the velocity between. The first half step changes v(0) by dv = v(1/2) - v(0), half of what a
/// whole one would: of the work of f(0) on the way there, 1/2 f(0).(v(0) + v(1/2)) dt/2, the first step books
/// f(0).v(1/2) dt/2. What is left is 1/4 dt f(0).dv, at all nodes (own derivation;
/// docs/theory/time_integration.md): of loads too much work, of the other forces what they took.
class StartLoss {
 public:
  /// The velocities before the first kick.
  explicit StartLoss(const domain::Domain& domain);

  /// To be called when nodes.force holds the forces at time zero without any load, then with all loads.
  void keep_inner_forces(const domain::Domain& domain);
  void keep_loads(const domain::Domain& domain);

  struct Left {
    double inner = 0;  ///< of forces in the model [energy]
    double loads = 0;  ///< [energy]
  };
  /// What is left of the kick over `interval`, half of the first step, that has been made.
  Left of_kick(const domain::Domain& domain, double interval) const;

 private:
  AlignedArray<math::Vec3> velocity_;          ///< v(0) [length/time]
  AlignedArray<math::Vec3> angular_velocity_;  ///< [1/time]
  AlignedArray<domain::NodeForce> inner_;      ///< at time zero, without loads
  AlignedArray<domain::NodeForce> all_;        ///< the same with loads
};

}  // namespace crumple::timeloop
