// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"
#include "timeloop/node_kernels.hpp"

namespace crumple::timeloop {

/// Central differences over all nodes. Each function works in fixed pieces of nodes whose sums are added in
/// order, so that results are bitwise the same for any number of threads.

/// x(n+1) = x(n) + step v(n+1/2); writes the node records. Returns the range of the velocities.
VelocityRange move_nodes(domain::Domain& domain, double step);

/// v(n+1/2) = v(n-1/2) + interval f(n) / m, likewise the rotations; holds fixed degrees of freedom and clears
/// the forces. Nodes of rigid bodies stay as they are. Returns the kinetic energy of time n.
KickSums accelerate_nodes(domain::Domain& domain, const Kick& kick);

/// 1/2 m v(n-1/2).v(n+1/2) of the nodes that no rigid body moves, where something has changed velocities
/// after the kick [energy].
double kinetic_energy(const domain::Domain& domain, const AlignedArray<math::Vec3>& previous_velocity,
                      const AlignedArray<math::Vec3>& velocity);

/// 1/2 I omega.omega of the same nodes at the present angular velocities [energy].
double rotational_energy(const domain::Domain& domain);

}  // namespace crumple::timeloop
