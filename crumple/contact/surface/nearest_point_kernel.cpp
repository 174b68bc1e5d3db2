// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/nearest_point_kernel.hpp"

#include <cmath>

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
  switch (isa) {
#if defined(CRUMPLE_FAST_KERNELS)
    case Isa::Avx512:
      return nearest_point_kernel<Isa::Avx512>();
    case Isa::Avx2:
      return nearest_point_kernel<Isa::Avx2>();
#endif
    case Isa::Scalar:
      return &nearest_point;
    default:
      return nearest_point_kernel<Isa::Baseline>();
  }
}

DistancesKernel distances_kernel(Isa isa) {
  switch (isa) {
#if defined(CRUMPLE_FAST_KERNELS)
    case Isa::Avx512:
      return distances_kernel<Isa::Avx512>();
    case Isa::Avx2:
      return distances_kernel<Isa::Avx2>();
#endif
    case Isa::Scalar:
      return distances_kernel<Isa::Scalar>();
    default:
      return distances_kernel<Isa::Baseline>();
  }
}

}  // namespace crumple::contact
