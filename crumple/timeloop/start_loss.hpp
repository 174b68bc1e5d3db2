// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/aligned_array.hpp"
#include "domain/domain.hpp"

namespace crumple::timeloop {

/// What element forces that follow from rates, viscous hourglass control, bulk viscosity, dampers, take from
/// initial velocities before the balance begins to count. At time zero the kinetic energy is 1/2 m v(0)^2,
/// from then on 1/2 m v(n-1/2).v(n+1/2) with the work of both forces of a step by the velocity between. The
/// first half step changes v(0) by dv = v(1/2) - v(0), half of what a whole one would: of the work of f(0) on
/// the way there, 1/2 f(0).(v(0) + v(1/2)) dt/2, the first step books f(0).v(1/2) dt/2. What is left is 1/4
/// dt f(0).dv, at all nodes (own derivation; docs/theory/energy.md).
class StartLoss {
 public:
  /// The velocities before the first kick.
  explicit StartLoss(const domain::Domain& domain);

  /// To be called when nodes.force holds the forces of elements at time zero, and no others.
  void keep_forces(const domain::Domain& domain);

  /// What is left of the kick over `interval`, half of the first step, that has been made [energy].
  double of_kick(const domain::Domain& domain, double interval) const;

 private:
  AlignedArray<math::Vec3> velocity_;          ///< v(0) [length/time]
  AlignedArray<math::Vec3> angular_velocity_;  ///< [1/time]
  AlignedArray<domain::NodeForce> force_;      ///< of elements at time zero
};

}  // namespace crumple::timeloop
