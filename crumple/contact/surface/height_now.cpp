// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/height_now.hpp"

#include <cmath>

#include "contact/surface/segment_shape.hpp"

namespace crumple::contact {
namespace {

/// Distance of the mean of the solid's other nodes from the plane of the face [length].
double span_behind(const Surface& surface, const Vec3* position, Index segment) {
  const SegmentShape shape = shape_of(surface, {position, nullptr, 0}, segment);
  Vec3 sum;
  double count = 0;
  for (const Index node : surface.nodes_behind[segment]) {
    if (surface.owns(segment, node)) continue;
    sum += position[node];
    count += 1;
  }
  const Vec3 normal = area_normal(shape);
  const double size = norm(normal);
  if (count == 0 || size <= 0) return 0;
  return std::fabs(dot((1 / count) * sum - shape.centre, normal)) / size;
}

}  // namespace

double height_now(const Surface& surface, const domain::NodeFields& nodes, Index segment) {
  const double undeformed = span_behind(surface, nodes.reference.data(), segment);
  const double height = surface.height[segment];
  return undeformed > 0 ? height * span_behind(surface, nodes.position.data(), segment) / undeformed : height;
}

}  // namespace crumple::contact
