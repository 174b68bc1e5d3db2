// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "domain/domain.hpp"
#include "model/model.hpp"

namespace crumple::constraints {

/// Bounds of the motion of rigid bodies (*CONSTRAINED_RIGID_BODY_STOPPERS). A body that would pass one in the
/// next step gets the velocity that brings its centre onto it: it stops without bouncing, stays there while
/// it is pushed, and moves with a bound that moves. One that is beyond when the stopper begins to act goes no
/// further than the bound moves, and is not thrown back. Axes that the material fixes stay fixed. The impulse
/// is that of a prescribed motion, and its work is external work (docs/theory/prescribed_motion.md).
class RigidBodyStoppers {
 public:
  /// The model must outlive the stoppers. domain.rigid_bodies must be at time zero. Throws Error where a body
  /// is beyond a bound that acts from time zero.
  RigidBodyStoppers(const model::Model& model, const domain::Domain& domain);

  bool empty() const { return stoppers_.empty(); }

  /// Bounds the velocities of n+1/2, after the kick and prescribed motions, before the drift over
  /// `next_step`.
  void impose(domain::Domain& domain, double next_step) const;

 private:
  struct Stopper {
    model::RigidBodyStopper given;
    int axis = 0;      ///< of the body's held_axes
    double sign = 1;   ///< of the direction along that axis
    double start = 0;  ///< coordinate of the centre along the direction at time zero [length]
  };

  using Bound = model::RigidBodyStopper::Bound;

  double bound_at(const Stopper& stopper, const Bound& bound, double time) const;
  void check_start(const Stopper& stopper, const Bound& bound, int side) const;

  const model::Model* model_;
  std::vector<Stopper> stoppers_;
};

}  // namespace crumple::constraints
