// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <variant>

#include "math/vec3.hpp"
#include "model/conditions.hpp"

namespace crumple::constraints {

/// What a wall asks of a node's velocity in the coming step.
struct WallLimit {
  math::Vec3 normal;   ///< unit vector out of the wall where the node touches it
  double slowest = 0;  ///< least velocity along the normal that does not carry the node in [length/time]
};

/// The surfaces of walls at rest. Each answers for a node at `position` with `velocity` that moves for
/// `step`: whether the wall is in its way (else false) and what it asks for. A node that starts inside is
/// held and not thrown out.

/// An infinite plane.
struct PlaneShape {
  math::Vec3 point;
  math::Vec3 normal;
  /// Distance in front of it [length].
  double height(const math::Vec3& position) const { return dot(position - point, normal); }
  /// Most nodes that ask are not in its way: these cost no division.
  bool limit(const math::Vec3& position, const math::Vec3& velocity, double step, WallLimit& found) const {
    constexpr double almost = 1 - 1e-9;
    const double gap = height(position);
    const double approach = -dot(velocity, normal);
    if (gap > 0 && approach * step < almost * gap) return false;
    found = {normal, -std::max(gap, 0.0) / step};
    return -approach < found.slowest;
  }
};

/// A rectangle, which only stops nodes that come from the side of its normal and through it.
struct FlatShape {
  math::Vec3 corner;
  math::Vec3 normal;
  math::Vec3 edge;     ///< l, unit
  math::Vec3 across;   ///< m = normal x l
  double length = 0;   ///< along l; one of the two may be infinite [length]
  double breadth = 0;  ///< along m [length]
  double slack = 0;    ///< a node this far behind the plane is still in front of it [length]
  bool limit(const math::Vec3& position, const math::Vec3& velocity, double step, WallLimit& found) const;
};

/// The place of a point against a closed surface.
struct SurfaceGap {
  double gap = 0;     ///< distance outside, negative inside; only the sign counts outside [length]
  math::Vec3 normal;  ///< outward, at the nearest place of the surface; set inside only
};

/// A box with one corner and the edges l, m and -n; lengths may be infinite.
struct PrismShape {
  math::Vec3 corner;
  math::Vec3 axis[3];
  double length[3] = {};
  SurfaceGap gap(const math::Vec3& position) const;
};

/// A cylinder with flat ends, or an endless one.
struct CylinderShape {
  math::Vec3 point;
  math::Vec3 axis;
  double radius = 0;
  double length = 0;  ///< infinite if zero
  SurfaceGap gap(const math::Vec3& position) const;
};

struct SphereShape {
  math::Vec3 centre;
  double radius = 0;
  SurfaceGap gap(const math::Vec3& position) const;
};

using WallSurface = std::variant<PlaneShape, FlatShape, PrismShape, CylinderShape, SphereShape>;

/// The surface of a wall where it is at time zero. A rectangle without edges is a plane.
WallSurface wall_surface(const model::RigidWall& wall);

/// The limit of a closed convex surface: the node must not end inside it, or not deeper than it began. It is
/// moved to the surface along the normal nearest to where it would end.
template <class Closed>
bool closed_limit(const Closed& shape, const math::Vec3& position, const math::Vec3& velocity, double step,
                  WallLimit& found) {
  const SurfaceGap end = shape.gap(position + step * velocity);
  if (end.gap >= 0) return false;
  const double start = shape.gap(position).gap;
  const double excess = start < 0 ? start - end.gap : -end.gap;
  if (excess <= 0) return false;
  found = {end.normal, dot(velocity, end.normal) + excess / step};
  return true;
}

/// The limit of any shape.
template <class Shape>
bool limit_of(const Shape& shape, const math::Vec3& position, const math::Vec3& velocity, double step,
              WallLimit& found) {
  if constexpr (requires { shape.gap(position); })
    return closed_limit(shape, position, velocity, step, found);
  else
    return shape.limit(position, velocity, step, found);
}

}  // namespace crumple::constraints
