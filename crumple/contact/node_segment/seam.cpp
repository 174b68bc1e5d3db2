// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/seam.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/node_segment/solid_overlaps.hpp"
#include "contact/surface/crossing.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// Where a node is over a face.
struct Over {
  Vec3 normal;        ///< of the face
  double height = 0;  ///< along the normal, negative behind [length]
  double beyond = 0;  ///< distance beyond the rim, along the face [length]
  Feature feature = Feature::Face;
};

Vec3 normal_of(const NodeAt& node, Index face) {
  return normalised(area_normal(node.now->shape(face)));
}

Vec3 position_of(const NodeAt& node) {
  return node.now->x[node.now->surface->nodes[node.place]];
}

Over over(const SurfaceAt& at, Index place, Index face) {
  const SegmentShape shape = at.shape(face);
  const Vec3 p = at.x[at.surface->nodes[place]];
  const NearestPoint nearest = nearest_point(shape, p);
  const Vec3 away = p - nearest.point;
  Over found;
  found.normal = normalised(area_normal(shape));
  found.height = dot(away, found.normal);
  found.beyond = norm(away - found.height * found.normal);
  found.feature = nearest.feature;
  return found;
}

Over over(const NodeAt& node, Index face) {
  return over(*node.now, node.place, face);
}

/// True if the node was behind the plane of a face, or on it, before the step.
bool was_behind(const NodeAt& node, Index face) {
  SurfaceAt before = *node.now;
  before.x.back = node.step;
  return over(before, node.place, face).height <= tolerances::on_surface * before.surface->height[face];
}

double side_of_face(const NodeAt& node, Index face) {
  return std::sqrt(node.now->surface->area[face]);
}

/// A step from face to face that is none, whatever the depth of the node [length].
double no_step(const NodeAt& node, Index face) {
  return tolerances::beside_rim * std::min(side_of_face(node, face), node.now->surface->height[face]);
}

/// True if the node is over or behind the face or not further beyond its rim than a face holds a node, with
/// what it moved in the step, which is no more than a part of an edge.
bool is_at(const NodeAt& node, Index face, const Over& where) {
  const double side = side_of_face(node, face);
  const double moved = relative_motion(*node.now, node.now->surface->nodes[node.place], face, node.step);
  return where.beyond <=
         tolerances::lost_beyond_rim * side + std::min(moved, tolerances::motion_over_edge * side);
}

/// Calls `look(face)` for the other faces at the corners of a face, until it returns true; returns whether it
/// did.
template <class Look>
bool any_beside(const Surface& surface, Index face, const Look& look) {
  for (int k = 0; k < 4; ++k)
    for (const Index beside : surface.topology.at_node(surface.place[surface.segment(face)[k]]))
      if (beside != face && surface.is_face(beside) && look(beside)) return true;
  return false;
}

/// The node's own faces that face the body behind face `beyond`, which goes on as the node's face `own` does:
/// all of `beyond` is in front of them.
std::vector<Index> hidden_by(const NodeAt& node, Index own, Index beyond) {
  const Vec3 up = normal_of(node, own);
  const SegmentShape shape = node.now->shape(beyond);
  std::vector<Index> hidden;
  for (const Index other : node.now->surface->topology.at_node(node.place)) {
    const Vec3 normal = normal_of(node, other);
    if (dot(normal, up) > tolerances::two_walls) continue;
    if (std::ranges::all_of(shape.corner, [&](const Vec3& corner) {
          return dot(corner - position_of(node), normal) >= -no_step(node, beyond);
        }))
      hidden.push_back(other);
  }
  return hidden;
}

/// True if a face goes on beyond the seam as the node's face `own` does, without a step for what slides there
/// with a face `depth` below the node, and without the faces that this one hides the node cannot meet one
/// with the normal `front`.
bool hides_what_meets(const NodeAt& node, Index own, Index beyond, double depth, const Vec3& front) {
  const Surface& surface = *node.now->surface;
  if (!surface.is_face(beyond) || surface.active[beyond] == 0 || connected(surface, own, beyond) ||
      surface.behind_has(beyond, surface.nodes[node.place]) ||
      dot(normal_of(node, beyond), normal_of(node, own)) <= tolerances::same_surface)
    return false;
  const Over where = over(node, beyond);
  const double in_beyond = std::max(0.0, depth - where.height);
  if (where.height > in_beyond + no_step(node, beyond) || !is_at(node, beyond, where)) return false;
  return !may_enter(*node.now, node.place, front, hidden_by(node, own, beyond));
}

/// True if the node may go behind a face.
bool takes(const NodeAt& node, Index face, std::span<const Index> candidates) {
  return may_enter(*node.now, node.place, normal_of(node, face)) && !passes_front(node, face, candidates);
}

}  // namespace

bool goes_on_over_seam(const NodeAt& node, Index a, Index b) {
  const Surface& surface = *node.now->surface;
  if (!surface.is_face(a) || !surface.is_face(b) || connected(surface, a, b) ||
      dot(normal_of(node, a), normal_of(node, b)) <= tolerances::same_surface)
    return false;
  const Over over_a = over(node, a);
  const Over over_b = over(node, b);
  return is_at(node, a, over_a) && is_at(node, b, over_b) &&
         over_a.height - over_b.height <= std::max(0.0, -over_a.height) + no_step(node, b);
}

double deeper_by(const NodeAt& node, Index a, Index b) {
  return std::max(0.0, over(node, a).height - over(node, b).height);
}

bool is_taken_over_seam(const NodeAt& node, Index a, std::span<const Index> candidates) {
  return std::ranges::any_of(candidates, [&](Index b) {
    if (!goes_on_over_seam(node, a, b)) return false;
    const Over where = over(node, b);
    return where.feature == Feature::Face && where.height < 0 && takes(node, b, candidates);
  });
}

bool passes_side(const NodeAt& node, Index side, std::span<const Index> candidates,
                 std::span<const RememberedPair> remembered) {
  const Surface& surface = *node.now->surface;
  const Vec3 normal = normal_of(node, side);
  return std::ranges::any_of(remembered, [&](const RememberedPair& pair) {
    const Index a = pair.segment;
    if (pair.side <= 0 || !surface.is_face(a) || pair.gap > no_step(node, a) || connected(surface, a, side) ||
        dot(normal_of(node, a), normal) > tolerances::two_walls)
      return false;
    return any_beside(surface, side,
                      [&](Index b) { return goes_on_over_seam(node, a, b) && takes(node, b, candidates); });
  });
}

bool passes_front(const NodeAt& node, Index front, std::span<const Index> candidates) {
  const Surface& surface = *node.now->surface;
  const auto around = surface.topology.at_node(node.place);
  const Vec3 normal = normal_of(node, front);
  // The node's faces that go under a face beside, and how deep.
  return std::ranges::any_of(around, [&](Index own) {
    if (surface.of_solid[own] == 0) return false;
    const Vec3 up = normal_of(node, own);
    return any_beside(surface, front, [&](Index under) {
      if (dot(up, normal_of(node, under)) >= -tolerances::same_surface) return false;
      const Over where = over(node, under);
      if (!is_at(node, under, where) || where.height < -surface.watch(under) ||
          where.height > no_step(node, under) || !was_behind(node, under))
        return false;
      const auto hides = [&](Index beyond) {
        return hides_what_meets(node, own, beyond, -where.height, normal);
      };
      if (std::ranges::any_of(candidates, hides)) return true;
      if (surface.on_touching_sides(node.place, own)) return false;
      for (Index beyond = 0; beyond < surface.segments(); ++beyond)
        if (!surface.on_touching_sides(node.place, beyond) && hides(beyond)) return true;
      return false;
    });
  });
}

}  // namespace crumple::contact
