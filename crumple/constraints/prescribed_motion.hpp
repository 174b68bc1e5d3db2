// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "constraints/kinetic_change.hpp"
#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// The moment of a kick: time n, from n-1/2 to n+1/2, and from n to n+1 [time].
struct MotionTimes {
  double time = 0;
  double interval = 0;
  double next_step = 0;
};

/// The velocity of n+1/2 that a motion asks for where that of n-1/2 is `before`. Displacements are met
/// exactly at n+1.
double prescribed_velocity(const model::PrescribedMotion& motion, const model::Curve& curve,
                           const MotionTimes& times, double before);

/// Which nodes of the model have a support in axes of their own, or a motion along a vector or round an axis,
/// so that LocalConstraints alone holds and moves them.
std::vector<char> nodes_with_local_constraints(const model::Model& model);

/// Velocities of nodes and rigid bodies that follow curves. They replace what the kick has made of them; the
/// impulse that this takes is the reaction, and its work is external work, to round-off
/// (docs/theory/prescribed_motion.md).
class PrescribedMotions {
 public:
  /// The model must outlive the motions. Throws Error for a node that a rigid body moves.
  PrescribedMotions(const model::Model& model, const domain::Domain& domain);

  bool empty() const { return motions_.empty(); }

  /// Keeps the velocities of n-1/2. Before the kick of the nodes.
  void remember(const domain::Domain& domain);

  /// Sets the velocities of n+1/2, after the kick of the nodes over `interval` and before the drift over
  /// `next_step`. Returns what the kinetic energy of the nodes at time n changes by; bodies book their own.
  KineticChange impose(domain::Domain& domain, double interval, double next_step);

  void declare(domain::StateList& list);

 private:
  struct Motion {
    model::PrescribedMotion given;
    Index node = no_index;  ///< of the domain
    double before = 0;      ///< v(n-1/2)
  };
  double impose_on_node(domain::Domain& domain, std::size_t place, double target);

  const model::Model* model_;
  std::vector<Motion> motions_;
  std::vector<double> deferred_;  ///< of each motion: half of its work, which the energy of n+1 shows
};

}  // namespace crumple::constraints
