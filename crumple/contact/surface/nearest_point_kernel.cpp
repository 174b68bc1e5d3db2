// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/nearest_point_kernel.hpp"

#include <cmath>

#include "base/isa_variants.hpp"

namespace crumple::contact {
namespace {

Vec3 got(const PointsInLanes& points, int lane) {
  const auto at = static_cast<std::size_t>(lane);
  return {points[0][at], points[1][at], points[2][at]};
}

}  // namespace

double PairsInLanes::distance_to_triangle(int lane) const {
  SegmentShape shape;
  for (std::size_t k = 0; k < 4; ++k) shape.corner[k] = got(corner[k], lane);
  shape.triangle = true;
  return std::sqrt(nearest_point(shape, got(point, lane)).distance_squared);
}

NearestPointKernel nearest_point_kernel(Isa isa) {
  // The plain function itself is the scalar variant.
  return visit_isa(isa, []<Isa Variant>() -> NearestPointKernel {
    if constexpr (Variant == Isa::Scalar)
      return &nearest_point;
    else
      return nearest_point_kernel<Variant>();
  });
}

DistancesKernel distances_kernel(Isa isa) {
  return visit_isa(isa, []<Isa Variant>() { return distances_kernel<Variant>(); });
}

}  // namespace crumple::contact
