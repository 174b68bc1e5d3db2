// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/isa.hpp"
#include "domain/node_fields.hpp"

namespace crumple::timeloop {

/// A run of nodes, [first, last).
struct NodeRange {
  Index first = 0;
  Index last = 0;
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
  void (*drift)(domain::NodeFields& nodes, NodeRange range, double step);
  /// v += interval f / m, likewise the rotations; holds fixed degrees of freedom and clears the forces.
  KickSums (*kick)(domain::NodeFields& nodes, NodeRange range, const Kick& kick);
};

/// Defined in kernels/node_motion.cpp, once per instruction set.
template <Isa Variant>
NodeKernels node_kernels();

/// The kernels for an instruction set chosen at run time.
NodeKernels node_kernels(Isa isa);

}  // namespace crumple::timeloop
