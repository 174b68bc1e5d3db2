// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/crossing.hpp"

#include <algorithm>
#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

struct Place {
  double distance = 0;
  int side = 0;
};

Place place_at(const SurfaceAt& now, Index node, Index segment, double back) {
  SurfaceAt then = now;
  then.x.back = back;
  const SegmentShape shape = then.shape(segment);
  const Vec3 p = then.x[node];
  const NearestPoint nearest = nearest_point(shape, p);
  const Vec3 away = p - nearest.point;
  Vec3 normal = side_normal(then, segment, shape, nearest, away);
  // At a free edge the plane of the segment itself tells the sides apart.
  if (dot(normal, normal) == 0) normal = area_normal(shape);
  return {std::sqrt(nearest.distance_squared), dot(away, normal) >= 0 ? 1 : -1};
}

}  // namespace

int crossed_from(const SurfaceAt& now, Index node, Index segment, double step) {
  const Place start = place_at(now, node, segment, step);
  const Place end = place_at(now, node, segment, 0);
  if (start.distance <= tolerances::starts_on_surface * end.distance) {
    // A node that starts on the mid-surface comes from no side, one on the face of a solid from outside.
    return now.surface->is_face(segment) && end.side < 0 ? 1 : 0;
  }
  if (start.side == end.side) return 0;
  double before = 0;
  double after = 1;
  Place last = end;
  for (int i = 0; i < tolerances::passage_halvings; ++i) {
    const double middle = 0.5 * (before + after);
    const Place here = place_at(now, node, segment, (1 - middle) * step);
    if (here.side == start.side) {
      before = middle;
    } else {
      after = middle;
      last = here;
    }
  }
  return last.distance <= tolerances::passage_distance * std::max(start.distance, end.distance) ? start.side
                                                                                                : 0;
}

int side_before(const SurfaceAt& now, Index node, Index segment, double step) {
  const Place start = place_at(now, node, segment, step);
  return start.distance > 0 ? start.side : 0;
}

double relative_motion(const SurfaceAt& now, Index node, Index segment, double step) {
  const Vec3* v = now.x.velocity;
  double largest = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec3 relative = v[node] - v[now.surface->segment(segment)[k]];
    largest = std::max(largest, dot(relative, relative));
  }
  return step * std::sqrt(largest);
}

}  // namespace crumple::contact
