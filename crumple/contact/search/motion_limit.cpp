// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/motion_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crumple::contact {
namespace {

/// Largest relative motion in a step over the mean edge: half of the default margin of the territories. It is
/// independent of the expansion that the user sets, because the expansion must not change the result.
constexpr double motion_over_edge = 0.2;

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
  const double allowed = motion_over_edge * surface.mean_edge;
  if (!(allowed > 0) || !std::isfinite(allowed)) return unlimited;
  const domain::Clock& clock = domain.clock;
  // No two nodes of the whole model are faster relative to each other.
  if (clock.step > 0 && clock.way * step <= allowed * clock.step) return unlimited;
  const double speed = relative_speed(surface, domain);
  return speed > 0 ? allowed / speed : unlimited;
}

}  // namespace crumple::contact
