// SPDX-License-Identifier: BSD-3-Clause
#include "domain/round_off_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crumple::domain {

double round_off_energy(const Domain& domain) {
  constexpr double digits = 64 * std::numeric_limits<double>::epsilon();
  double extent = 0;
  double mass = 0;
  for (Index node = 0; node < domain.nodes.count(); ++node) {
    const math::Vec3& x = domain.nodes.position[node];
    extent = std::max({extent, std::fabs(x.x), std::fabs(x.y), std::fabs(x.z)});
    mass += domain.nodes.mass[node];
  }
  const double speed = domain.clock.step > 0 ? digits * extent / domain.clock.step : 0;
  return 0.5 * mass * speed * speed;
}

}  // namespace crumple::domain
