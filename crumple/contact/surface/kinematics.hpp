// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <span>

#include "domain/domain.hpp"
#include "math/vec3.hpp"

namespace crumple::contact {

using math::Vec3;

/// Where the nodes are when contact looks at them, and how they got there. All arrays by domain node; owned
/// by the caller.
struct Kinematics {
  std::span<const Vec3> position;   ///< [length]
  std::span<const Vec3> velocity;   ///< of the step that led there [length/time]
  std::span<const Vec3> reference;  ///< at time zero [length]
  double step = 0;                  ///< the length of that step; zero before the first [time]
  long cycle = 0;
  int threads = 1;
  Isa isa = Isa::Scalar;
  /// No two nodes moved further relative to each other in that step, but for rounding [length].
  double way = std::numeric_limits<double>::infinity();
};

/// The present state: x(n), v(n-1/2).
inline Kinematics present(const domain::Domain& domain) {
  const domain::NodeFields& nodes = domain.nodes;
  return {{nodes.position.data(), nodes.position.size()},
          {nodes.velocity.data(), nodes.velocity.size()},
          {nodes.reference.data(), nodes.reference.size()},
          domain.clock.step,
          domain.clock.cycle,
          domain.execution.threads,
          domain.execution.isa,
          domain.clock.way};
}

}  // namespace crumple::contact
