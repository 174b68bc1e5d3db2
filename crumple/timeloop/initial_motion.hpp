// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/aligned_array.hpp"
#include "domain/domain.hpp"

namespace crumple::timeloop {

/// How a model moves at time zero, to go back to once its dynamic relaxation has changed where it is.
class InitialMotion {
 public:
  /// Of a domain that has made no step.
  explicit InitialMotion(const domain::Domain& domain);

  /// Gives velocities, clock, stage times and an empty ledger to a domain at another place. What moved it
  /// there counts no more.
  void put_back(domain::Domain& domain) const;

 private:
  struct Body {
    math::Vec3 velocity;
    math::Vec3 angular_momentum;
    math::Vec3 angular_velocity;
    math::Vec3 spin;
    double kinetic_energy = 0;
  };

  AlignedArray<math::Vec3> velocity_;
  AlignedArray<math::Vec3> angular_velocity_;
  std::vector<Body> bodies_;
  domain::Clock clock_;
  domain::StageTimes times_;
};

}  // namespace crumple::timeloop
