// SPDX-License-Identifier: BSD-3-Clause
// The nearest point on the four sub-triangles of a segment, one per lane, and distances of many pairs, one
// per lane. The bits are those of nearest_point().
#include "contact/surface/nearest_point_kernel.hpp"

#include "base/isa_variants.hpp"
#include "contact/kernels/nearest_on_triangles.hpp"

namespace crumple::contact {
namespace {

using lanes_of::nearest_on_triangles;
using lanes_of::Points;
using lanes_of::Weights;
using math::Double4;

CRUMPLE_INLINE Double4 all(double a) {
  return Double4{a, a, a, a};
}
CRUMPLE_INLINE Points<Double4> all(const Vec3& a) {
  return {all(a.x), all(a.y), all(a.z)};
}
/// The next lane's number.
CRUMPLE_INLINE Double4 next_of(const Double4& a) {
  return __builtin_shufflevector(a, a, 1, 2, 3, 0);
}

NearestPoint nearest(const SegmentShape& shape, const Vec3& p) {
  if (shape.triangle) return nearest_point(shape, p);
  const auto& corner = shape.corner;
  const Points<Double4> first{Double4{corner[0].x, corner[1].x, corner[2].x, corner[3].x},
                              Double4{corner[0].y, corner[1].y, corner[2].y, corner[3].y},
                              Double4{corner[0].z, corner[1].z, corner[2].z, corner[3].z}};
  const Points<Double4> second{next_of(first.x), next_of(first.y), next_of(first.z)};
  const Points<Double4> centre = all(shape.centre);
  const Weights<Double4> w = nearest_on_triangles(all(p), first, second, centre);
  const Points<Double4> point = w.a * first + w.b * second + w.c * centre;
  const Points<Double4> away = all(p) - point;
  const Double4 distance_squared = dot(away, away);
  int k = 0;
  for (int other = 1; other < 4; ++other)
    if (!(distance_squared[other] >= distance_squared[k])) k = other;
  return nearest_on(k, {w.a[k], w.b[k], w.c[k]}, {point.x[k], point.y[k], point.z[k]}, distance_squared[k]);
}

template <class Pack>
CRUMPLE_INLINE Points<Pack> points_at(const PointsInLanes& points, int lane) {
  return {load<Pack>(&points[0][lane]), load<Pack>(&points[1][lane]), load<Pack>(&points[2][lane])};
}

/// Of width_of<Pack> pairs from a lane on, as if no segment were a triangle.
template <class Pack>
CRUMPLE_INLINE Pack distances(const PairsInLanes& pairs, int lane) {
  const Points<Pack> p = points_at<Pack>(pairs.point, lane);
  const std::array<Points<Pack>, 4> corner{
      points_at<Pack>(pairs.corner[0], lane), points_at<Pack>(pairs.corner[1], lane),
      points_at<Pack>(pairs.corner[2], lane), points_at<Pack>(pairs.corner[3], lane)};
  const Points<Pack> centre = points_at<Pack>(pairs.centre, lane);
  Pack best{};
  for (std::size_t k = 0; k < 4; ++k) {
    const Points<Pack>& first = corner[k];
    const Points<Pack>& second = corner[(k + 1) % 4];
    const Weights<Pack> w = nearest_on_triangles(p, first, second, centre);
    const Points<Pack> away = p - (w.a * first + w.b * second + w.c * centre);
    const Pack distance_squared = dot(away, away);
    best = k == 0 ? distance_squared : select<Pack>(distance_squared >= best, best, distance_squared);
  }
  return square_root<Pack>(best);
}

void measure(const PairsInLanes& pairs, int count, double* distance) {
  using Pack = NativePack<double>;
  alignas(PairsInLanes::alignment) std::array<double, PairsInLanes::lanes> found;
  for (int lane = 0; lane < count; lane += width_of<Pack>)
    store<Pack>(&found[static_cast<std::size_t>(lane)], distances<Pack>(pairs, lane));
  for (int lane = 0; lane < count; ++lane)
    distance[lane] = pairs.triangle[static_cast<std::size_t>(lane)] ? pairs.distance_to_triangle(lane)
                                                                    : found[static_cast<std::size_t>(lane)];
}

}  // namespace

template <>
NearestPointKernel nearest_point_kernel<compiled_isa>() {
  return &nearest;
}

template <>
DistancesKernel distances_kernel<compiled_isa>() {
  return &measure;
}

}  // namespace crumple::contact
