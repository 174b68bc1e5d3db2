// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "domain/domain.hpp"

namespace crumple::timeloop {

/// Central differences over all nodes. Each function works in fixed pieces of nodes whose sums are added in
/// order, so that results are bitwise the same for any number of threads.

/// x(n+1) = x(n) + step v(n+1/2); writes the node records.
void move_nodes(domain::Domain& domain, double step);

/// v(n+1/2) = v(n-1/2) + interval f(n) / m, likewise the rotations; holds fixed degrees of freedom, leaves
/// v(n-1/2) in `previous_velocity`, accelerations in the node fields, and clears the forces. Returns the
/// rotational energy 1/2 I omega(n-1/2).omega(n+1/2) [energy].
double accelerate_nodes(domain::Domain& domain, AlignedArray<math::Vec3>& previous_velocity, double interval);

/// 1/2 m v(n-1/2).v(n+1/2), the kinetic energy that balances trapezoidal work [energy].
double kinetic_energy(const domain::Domain& domain, const AlignedArray<math::Vec3>& previous_velocity,
                      const AlignedArray<math::Vec3>& velocity);

/// 1/2 I omega.omega at the present angular velocities [energy].
double rotational_energy(const domain::Domain& domain);

}  // namespace crumple::timeloop
