// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// An infinite plane at rest that stops nodes: impact is perfectly plastic, the force is the momentum
/// exchanged (LS-DYNA Theory Manual, "Rigid walls"). Velocity is changed in the integrator, between the kick
/// and the drift, so that no node ever passes the plane.
class PlanarWall {
 public:
  /// `report` is the place of this wall in domain.walls.
  PlanarWall(const model::RigidWall& wall, const domain::Domain& domain, Index report);

  /// Takes from the velocities v(n+1/2) what would carry nodes through the plane within `next_step`, with
  /// Coulomb friction along it. `impulse_interval` is the time over which the forces of this step act. Adds
  /// impulse and energy to the report. `previous_velocity` is v(n-1/2).
  void stop_nodes(domain::Domain& domain, const AlignedArray<math::Vec3>& previous_velocity,
                  double impulse_interval, double next_step);

 private:
  std::vector<Index> nodes_;  ///< domain nodes, ascending
  math::Vec3 point_;
  math::Vec3 normal_;
  double friction_ = 0;
  Index report_ = 0;
};

}  // namespace crumple::constraints
