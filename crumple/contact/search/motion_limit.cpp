// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/motion_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// Largest difference of the velocities of two nodes that still have a segment, along each axis: free nodes
/// that erosion has left meet nothing that they could harm in one step [length/time].
double relative_speed(const Surface& surface, const domain::Domain& domain) {
  constexpr double largest = std::numeric_limits<double>::max();
  Vec3 low{largest, largest, largest};
  Vec3 high = -low;
  for (Index i = 0; i < surface.node_count(); ++i) {
    if (!surface.bears(i)) continue;
    const Vec3& v = domain.nodes.velocity[surface.nodes[i]];
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return low.x > high.x ? 0 : norm(high - low);
}

}  // namespace

double longest_step_for_motion(const Surface& surface, const domain::Domain& domain, double step) {
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const double allowed = tolerances::motion_over_edge * surface.mean_edge;
  if (!(allowed > 0) || !std::isfinite(allowed)) return unlimited;
  const domain::Clock& clock = domain.clock;
  // No two nodes of the whole model are faster relative to each other.
  if (clock.step > 0 && clock.way * step <= allowed * clock.step) return unlimited;
  const double speed = relative_speed(surface, domain);
  return speed > 0 ? allowed / speed : unlimited;
}

}  // namespace crumple::contact
