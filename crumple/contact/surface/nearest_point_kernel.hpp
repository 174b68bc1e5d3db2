// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/isa.hpp"
#include "contact/surface/segment_shape.hpp"

namespace crumple::contact {

/// nearest_point() with all sub-triangles at once, compiled once per instruction set. Every variant gives the
/// bits of nearest_point().
using NearestPointKernel = NearestPoint (*)(const SegmentShape& shape, const Vec3& p);

/// Points by axis and lane [length].
using PointsInLanes = std::array<std::array<double, 8>, 3>;

/// Pairs of a point and a segment, one per lane, whose distances are measured together.
struct PairsInLanes {
  static constexpr int lanes = 8;
  static constexpr int alignment = 64;

  alignas(alignment) PointsInLanes point{};
  std::array<PointsInLanes, 4> corner{};
  PointsInLanes centre{};
  std::array<bool, lanes> triangle{};

  void set(int lane, const SegmentShape& shape, const Vec3& p) {
    put(point, lane, p);
    for (std::size_t k = 0; k < 4; ++k) put(corner[k], lane, shape.corner[k]);
    put(centre, lane, shape.centre);
    triangle[static_cast<std::size_t>(lane)] = shape.triangle;
  }
  /// Of a lane whose segment is a triangle [length].
  double distance_to_triangle(int lane) const;

 private:
  static void put(PointsInLanes& points, int lane, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis)
      points[static_cast<std::size_t>(axis)][static_cast<std::size_t>(lane)] = p[axis];
  }
};

/// Distances of the first `count` pairs: the bits of the root of nearest_point()'s distance_squared, with
/// every variant.
using DistancesKernel = void (*)(const PairsInLanes& pairs, int count, double* distance);

/// Defined in kernels/nearest_point.cpp, once per instruction set.
template <Isa Variant>
NearestPointKernel nearest_point_kernel();
template <Isa Variant>
DistancesKernel distances_kernel();

/// The kernels for an instruction set chosen at run time.
NearestPointKernel nearest_point_kernel(Isa isa);
DistancesKernel distances_kernel(Isa isa);

}  // namespace crumple::contact
