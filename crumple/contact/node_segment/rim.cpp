// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/rim.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// True if `from_node` points over the rim of a face into it, at the edge or the corner that is nearest.
bool points_over_rim(const Index* nodes, const SegmentShape& shape, const Vec3& normal,
                     const NearestPoint& nearest, const Vec3& from_node) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Index next = nodes[(k + 1) % 4];
    const bool of_rim = nearest.feature == Feature::Edge
                            ? k == static_cast<std::size_t>(nearest.local)
                            : nodes[k] == nodes[nearest.local] || next == nodes[nearest.local];
    const Vec3 along = shape.corner[(k + 1) % 4] - shape.corner[k];
    if (of_rim && nodes[k] != next && dot(from_node, cross(normal, along)) <= 0) return false;
  }
  return true;
}

/// Where in the zone beyond the rim, in which the share fades, a point is: from 0 to 1 [-].
double place_in_fade(double beyond, double side) {
  constexpr double begin = tolerances::fades_beyond_rim;
  constexpr double end = tolerances::lost_beyond_rim;
  return std::clamp((beyond / side - begin) / (end - begin), 0.0, 1.0);
}

}  // namespace

bool reaches_over_rim(const NodeAt& node, Index face, const SegmentShape& shape,
                      const NearestPoint& nearest) {
  if (nearest.feature == Feature::Face) return true;
  const Surface& surface = *node.now->surface;
  const Vec3 p = node.now->x[surface.nodes[node.place]];
  const Vec3 normal = normalised(area_normal(shape));
  bool none_faces_it = true;
  bool any_over_rim = false;
  const auto around = surface.topology.at_node(node.place);
  for (const Index own : around) {
    const SegmentShape own_shape = node.now->shape(own);
    const bool over = points_over_rim(surface.segment(face), shape, normal, nearest, own_shape.centre - p);
    any_over_rim = any_over_rim || over;
    if (surface.of_solid[own] != 0 && dot(normalised(area_normal(own_shape)), normal) >= -tolerances::opposed)
      continue;
    none_faces_it = false;
    if (over) return true;
  }
  if (!around.empty()) return none_faces_it && any_over_rim;
  const Vec3 away = p - nearest.point;
  return norm(away - dot(away, normal) * normal) <= tolerances::on_surface * std::sqrt(surface.area[face]);
}

bool stands_at_rim(const NodeAt& node, Index segment, const SegmentShape& shape,
                   const NearestPoint& nearest) {
  const Surface& surface = *node.now->surface;
  if (!surface.is_face(segment) || nearest.feature == Feature::Face) return false;
  const Vec3 normal = normalised(area_normal(shape));
  const Vec3 away = node.now->x[surface.nodes[node.place]] - nearest.point;
  const double height = dot(away, normal);
  return height >= -tolerances::on_surface * surface.height[segment] &&
         norm(away - height * normal) <= tolerances::beside_rim * std::sqrt(surface.area[segment]) &&
         reaches_over_rim(node, segment, shape, nearest);
}

double share_beyond_rim(double beyond, double side) {
  const double u = place_in_fade(beyond, side);
  return (1 - u) * (1 - u) * (1 + 2 * u);
}

void push_off_rim(const Vec3& away, const Vec3& normal, double side, ContactPair& pair) {
  const Vec3 along = away - dot(away, normal) * normal;
  const double beyond = norm(along);
  const double u = place_in_fade(beyond, side);
  if (u <= 0 || u >= 1) return;
  // A linear spring pushes by s k d along the normal and by -ds/db k d^2 / 2 outwards.
  const double width = (tolerances::lost_beyond_rim - tolerances::fades_beyond_rim) * side;
  const double slope = 6 * u * (1 - u) / width;
  const double outwards = 0.5 * slope / share_beyond_rim(beyond, side) * std::max(0.0, pair.penetration());
  const double size = std::sqrt(1 + outwards * outwards);
  pair.share *= size;
  pair.normal = 1 / size * (normal + outwards / beyond * along);
}

}  // namespace crumple::contact
