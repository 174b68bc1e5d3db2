// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "loads/segment_pressure.hpp"

namespace crumple::loads {

/// Pressures on segments that follow a curve in time and the segments' motion. A positive pressure pushes
/// against the normal (nodes 1, 2, 3, 4 counter-clockwise); the force, pressure times the vector area
/// 1/2 (x3 - x1) x (x4 - x2), is shared equally by the nodes. The load on a shell ends when that erodes.
class PressureLoads {
 public:
  /// The model must outlive the loads.
  PressureLoads(const model::Model& model, const domain::Domain& domain);

  /// Adds the forces at time n and, by the trapezoidal rule, their work since time n-1 to the ledger's
  /// external work. On entry nodes.velocity is v(n-1/2) and clock.step the step between.
  void add_forces(domain::Domain& domain);

  /// Declares what is remembered of time n-1.
  void declare(domain::StateList& list);

 private:
  struct Load {
    SegmentNodes node{};
    double pressure = 0;  ///< at a factor of one [stress]
    Index curve = no_index;
    double arrival = 0;      ///< [time]
    Index shell = no_index;  ///< in the model
    bool ended = false;      ///< its shell has eroded
    math::Vec3 previous;     ///< force on each node at time n-1
  };
  math::Vec3 force_on_nodes(const domain::Domain& domain, const Load& load) const;
  void end_with_shells(const domain::Domain& domain);

  const model::Model* model_;
  std::vector<Load> loads_;
  ErodedShells eroded_;  ///< when `ended` was set
};

}  // namespace crumple::loads
