// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/wall_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/to_vec3.hpp"

namespace crumple::constraints {

using math::to_vec3;
using math::Vec3;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

double or_endless(double length) {
  return length > 0 ? length : endless;
}

/// Any unit vector across another one.
Vec3 across(const Vec3& axis) {
  const Vec3 other = std::fabs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalised(cross(axis, other));
}

/// From the middle of a round shape to a node; along any direction if it is in the middle.
SurfaceGap round_gap(const Vec3& from_middle, double radius, const Vec3& fallback) {
  const double distance = norm(from_middle);
  if (distance >= radius) return {distance - radius, {}};
  return {distance - radius, distance > 0 ? (1.0 / distance) * from_middle : fallback};
}

}  // namespace

bool FlatShape::limit(const Vec3& position, const Vec3& velocity, double step, WallLimit& found) const {
  const double gap = dot(position - corner, normal);
  if (gap < -slack) return false;
  const double approach = dot(velocity, normal);
  const double slowest = -std::max(gap, 0.0) / step;
  if (approach >= slowest) return false;
  // Where the path meets the plane.
  const double time = std::max(gap, 0.0) / -approach;
  const Vec3 place = position + time * velocity - corner;
  const auto beside = [&](const Vec3& along, double extent) {
    const double distance = dot(place, along);
    return std::isfinite(extent) && (distance < 0 || distance > extent);
  };
  if (beside(edge, length) || beside(across, breadth)) return false;
  found = {normal, slowest};
  return true;
}

SurfaceGap PrismShape::gap(const Vec3& position) const {
  const Vec3 from_corner = position - corner;
  SurfaceGap nearest{-endless, {}};
  for (int k = 0; k < 3; ++k) {
    const double along = dot(from_corner, axis[k]);
    // The face through the corner, and the one opposite. An endless prism has only the front, which the last
    // axis begins at.
    const bool has_begin = k == 2 || std::isfinite(length[k]);
    if (has_begin && -along > nearest.gap) nearest = {-along, -axis[k]};
    if (along - length[k] > nearest.gap) nearest = {along - length[k], axis[k]};
  }
  return nearest;
}

SurfaceGap CylinderShape::gap(const Vec3& position) const {
  const Vec3 from_point = position - point;
  const double along = dot(from_point, axis);
  SurfaceGap nearest = round_gap(from_point - along * axis, radius, across(axis));
  if (!(length > 0)) return nearest;
  if (-along > nearest.gap) nearest = {-along, -axis};
  if (along - length > nearest.gap) nearest = {along - length, axis};
  return nearest;
}

SurfaceGap SphereShape::gap(const Vec3& position) const {
  return round_gap(position - centre, radius, {0, 0, 1});
}

WallSurface wall_surface(const model::RigidWall& wall) {
  const Vec3 point = to_vec3(wall.point);
  if (wall.shape == model::WallShape::Sphere) return SphereShape{point, wall.radius};
  const Vec3 normal = normalised(to_vec3(wall.normal));
  const Vec3 l = to_vec3(wall.edge);
  const double length = or_endless(wall.lengths[0]);
  const double breadth = or_endless(wall.lengths[1]);
  switch (wall.shape) {
    case model::WallShape::Flat: {
      const double size = std::min(length, breadth);
      // Nothing comes past the edges of an endless rectangle, so that what is behind it has gone through.
      if (!std::isfinite(size)) return PlaneShape{point, normal};
      return FlatShape{point, normal, l, cross(normal, l), length, breadth, 1e-6 * size};
    }
    case model::WallShape::Prism:
      return PrismShape{
          point, {l, cross(normal, l), -normal}, {length, breadth, or_endless(wall.lengths[2])}};
    case model::WallShape::Cylinder:
      return CylinderShape{point, normal, wall.radius, wall.lengths[0]};
    default:
      return PlaneShape{point, normal};
  }
}

}  // namespace crumple::constraints
