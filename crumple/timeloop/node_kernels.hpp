// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

#include "base/isa.hpp"
#include "domain/node_fields.hpp"

namespace crumple::timeloop {

/// A run of nodes, [first, last).
struct NodeRange {
  Index first = 0;
  Index last = 0;
};

/// Smallest and largest velocity of a run of nodes, by axis [length/time].
struct VelocityRange {
  static constexpr double largest = std::numeric_limits<double>::max();

  domain::Vec3 low{largest, largest, largest};
  domain::Vec3 high{-largest, -largest, -largest};
  bool finite = true;  ///< whether all velocities are; the rest means nothing if not

  void include(const VelocityRange& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
    finite = finite && other.finite;
  }
  /// No two nodes are faster relative to each other; infinite where a velocity is not a finite number.
  double relative_speed() const {
    if (!finite) return std::numeric_limits<double>::infinity();
    return low.x > high.x ? 0 : norm(high - low);
  }
};

/// Energies of a kick, in the product form that balances trapezoidal work [energy]: 1/2 m v(n-1/2).v(n+1/2)
/// and 1/2 I omega(n-1/2).omega(n+1/2); and how fast nodes are after it.
struct KickSums {
  double translational = 0;
  double rotational = 0;
  double fastest = 0;  ///< no node is faster [length/time]
};

/// One kick: what goes in besides the node fields.
struct Kick {
  double interval = 0;                        ///< from n-1/2 to n+1/2 [time]
  domain::Vec3* previous_velocity = nullptr;  ///< gets v(n-1/2) of every node unless null
  bool keep_acceleration = false;             ///< whether NodeFields::acceleration is written
};

/// The two passes over the nodes that a step makes, compiled once per instruction set. Only plain operations
/// in a fixed order: every variant gives the same bits.
struct NodeKernels {
  /// x += step v, and the record that the elements gather from.
  VelocityRange (*drift)(domain::NodeFields& nodes, NodeRange range, double step);
  /// v += interval f / m, likewise the rotations; holds fixed degrees of freedom and clears the forces.
  KickSums (*kick)(domain::NodeFields& nodes, NodeRange range, const Kick& kick);
};

/// Defined in kernels/node_motion.cpp, once per instruction set.
template <Isa Variant>
NodeKernels node_kernels();

/// The kernels for an instruction set chosen at run time.
NodeKernels node_kernels(Isa isa);

}  // namespace crumple::timeloop
