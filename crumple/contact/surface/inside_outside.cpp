// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/inside_outside.hpp"

#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// Whether the surface comes nearer along `ray`, from a point to which the node is `away`.
bool comes_nearer(const Vec3& away, const Vec3& ray) {
  const double along = dot(away, ray);
  return along > 0 && along > tolerances::comes_nearer * norm(away) * norm(ray);
}

Vec3 unit_or_zero(const Vec3& a, double smallest = 0) {
  const double length = norm(a);
  return length > smallest ? (1.0 / length) * a : Vec3{};
}

/// The sub-triangle at an edge: unit normal, and unit direction from the edge inwards.
struct Flank {
  Vec3 normal;
  Vec3 inward;
};

Vec3 flank_normal(const SegmentShape& shape, int k) {
  return unit_or_zero(cross(shape.corner[(k + 1) % 4] - shape.corner[k], shape.centre - shape.corner[k]));
}

Vec3 inward(const SegmentShape& shape, int k, const Vec3& normal) {
  return unit_or_zero(cross(normal, shape.corner[(k + 1) % 4] - shape.corner[k]));
}

Flank flank(const SegmentShape& shape, int k) {
  const Vec3 normal = flank_normal(shape, k);
  return {normal, inward(shape, k, normal)};
}

/// The segment on the other side of a shared edge, and the number that the edge has there.
struct Neighbour {
  Index segment = no_index;
  int k = 0;
};

Neighbour neighbour_at(const Surface& surface, Index segment, int k) {
  const Index edge = surface.topology.edges_of[segment][k];
  if (edge == no_index || surface.topology.kind[edge] != EdgeKind::Shared) return {};
  const auto pair = surface.topology.at_edge(edge);
  Neighbour found;
  found.segment = pair[0] == segment ? pair[1] : pair[0];
  while (surface.topology.edges_of[found.segment][found.k] != edge) ++found.k;
  return found;
}

int corner_of(const Surface& surface, Index segment, Index node) {
  int k = 0;
  while (surface.segment(segment)[k] != node) ++k;
  return k;
}

bool nearer_beyond_edge(const SurfaceAt& at, Index node, Index segment, const NearestPoint& nearest,
                        const Vec3& away) {
  const Surface& surface = *at.surface;
  const Index edge = surface.topology.edges_of[segment][nearest.local];
  const Vec3 foot = nearest.point;
  for (const Index other : surface.topology.at_edge(edge)) {
    if (other == segment) continue;
    if (surface.owns(other, node)) return true;
    if (!surface.on_touching_sides(surface.place[node], other)) continue;
    // `away` is perpendicular to the edge, so that any vector from the edge into the triangle will do.
    const Vec3 into = at.shape(other).centre - foot;
    if (comes_nearer(away, into)) return true;
  }
  return false;
}

bool nearer_around_corner(const SurfaceAt& at, Index node, Index segment, const NearestPoint& nearest,
                          const Vec3& away) {
  const Surface& surface = *at.surface;
  const Index corner = surface.segment(segment)[nearest.local];
  for (const Index other : surface.topology.at_node(surface.place[corner])) {
    if (other == segment) continue;
    if (surface.owns(other, node)) return true;
    if (!surface.on_touching_sides(surface.place[node], other)) continue;
    const SegmentShape shape = at.shape(other);
    const int k = corner_of(surface, other, corner);
    const int last = shape.triangle ? 2 : 3;
    const Vec3 rays[3] = {shape.corner[k == last ? 0 : k + 1] - shape.corner[k],
                          shape.corner[k == 0 ? last : k - 1] - shape.corner[k],
                          shape.centre - shape.corner[k]};
    for (const Vec3& ray : rays)
      if (comes_nearer(away, ray)) return true;
  }
  return false;
}

}  // namespace

Vec3 mesh_normal(const SurfaceAt& at, Index segment, const SegmentShape& shape, int k) {
  const Vec3 own = flank_normal(shape, k);
  const Neighbour next = neighbour_at(*at.surface, segment, k);
  if (next.segment == no_index) return own;
  const SegmentShape next_shape = at.shape(next.segment);
  const Vec3 other = flank_normal(next_shape, next.k);
  if (dot(own, other) >= 0) return unit_or_zero(own + other);
  const Vec3 next_inward = inward(next_shape, next.k, other);
  const Vec3 into_fold = unit_or_zero(inward(shape, k, own) + next_inward);
  return dot(own, next_inward) > 0 ? into_fold : -into_fold;
}

double inner_side(const SurfaceAt& at, Index segment, int k, const Vec3& p) {
  const Neighbour next = neighbour_at(*at.surface, segment, k);
  if (next.segment == no_index) return 0;
  // Everything is taken in the order of the segments' numbers, so that both see the same bits.
  const bool lower = segment < next.segment;
  const Index first = lower ? segment : next.segment;
  const SegmentShape shape = at.shape(first);
  const int first_k = lower ? k : next.k;
  const Flank a = flank(shape, first_k);
  const Flank b = flank(at.shape(lower ? next.segment : segment), lower ? next.k : k);
  const Vec3 across = unit_or_zero(a.inward - b.inward, tolerances::degenerate_bisector);
  const double side = dot(p - shape.corner[first_k], across);
  return lower ? side : -side;
}

bool inside(const SurfaceAt& at, Index segment, const Vec3& p) {
  for (int k = 0; k < 4; ++k)
    if (inner_side(at, segment, k, p) < 0) return false;
  return true;
}

Vec3 side_normal(const SurfaceAt& at, Index segment, const SegmentShape& shape, const NearestPoint& nearest,
                 const Vec3& away) {
  const Surface& surface = *at.surface;
  if (nearest.feature == Feature::Face) return flank_normal(shape, nearest.local);
  if (nearest.feature == Feature::Edge) {
    const Index edge = surface.topology.edges_of[segment][nearest.local];
    return surface.topology.kind[edge] == EdgeKind::Shared ? mesh_normal(at, segment, shape, nearest.local)
                                                           : Vec3{};
  }
  const Index corner = surface.segment(segment)[nearest.local];
  const Index place = surface.place[corner];
  if (surface.topology.smooth_node[place] == 0) return {};
  Vec3 best;
  double squarest = -1;
  for (const Index other : surface.topology.at_node(place)) {
    const SegmentShape around = at.shape(other);
    const int k = corner_of(surface, other, corner);
    for (const int edge : {k, around.triangle && k == 0 ? 3 : (k + 3) % 4}) {
      const Vec3 normal = flank_normal(around, edge);
      const double square = std::fabs(dot(normal, away));
      if (square <= squarest) continue;
      squarest = square;
      best = normal;
    }
  }
  return best;
}

Vec3 corner_normal(const SurfaceAt& at, Index node, const Vec3& side) {
  Vec3 sum;
  for (const Index around : at.surface->topology.at_node(at.surface->place[node])) {
    const Vec3 normal = normalised(area_normal(at.shape(around)));
    sum += dot(normal, side) < 0 ? -normal : normal;
  }
  return normalised(sum);
}

bool nearest_around(const SurfaceAt& at, Index node, Index segment, const NearestPoint& nearest) {
  const Vec3 away = at.x[node] - nearest.point;
  if (nearest.feature == Feature::Edge) return !nearer_beyond_edge(at, node, segment, nearest, away);
  if (nearest.feature == Feature::Corner) return !nearer_around_corner(at, node, segment, nearest, away);
  return true;
}

bool connected(const Surface& surface, Index a, Index b) {
  const Index* nodes = surface.segment(a);
  return surface.owns(b, nodes[0]) || surface.owns(b, nodes[1]) || surface.owns(b, nodes[2]) ||
         surface.owns(b, nodes[3]);
}

bool same_sides(const Surface& surface, Index a, Index b) {
  for (int k = 0; k < 4; ++k) {
    if (neighbour_at(surface, a, k).segment == b) return true;
    const Index node = surface.segment(a)[k];
    if (surface.topology.smooth_node[surface.place[node]] != 0 && surface.owns(b, node)) return true;
  }
  return false;
}

bool owns_first(const SurfaceAt& at, Index a, Index b, const Vec3& p, double distance_a, double distance_b) {
  for (int k = 0; k < 4; ++k) {
    if (neighbour_at(*at.surface, a, k).segment != b) continue;
    const double side = inner_side(at, a, k, p);
    if (side != 0) return side > 0;
  }
  if (distance_a != distance_b) return distance_a < distance_b;
  return a < b;
}

}  // namespace crumple::contact
