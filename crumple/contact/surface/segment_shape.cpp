// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/segment_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crumple::contact {
namespace {

double fraction(double part, double whole) {
  return whole > 0 ? part / whole : 0.0;
}

Barycentric nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double a_ab = dot(p - a, ab);
  const double a_ac = dot(p - a, ac);
  if (a_ab <= 0 && a_ac <= 0) return {1, 0, 0};
  const double b_ab = dot(p - b, ab);
  const double b_ac = dot(p - b, ac);
  if (b_ab >= 0 && b_ac <= b_ab) return {0, 1, 0};
  const double c_ab = dot(p - c, ab);
  const double c_ac = dot(p - c, ac);
  if (c_ac >= 0 && c_ab <= c_ac) return {0, 0, 1};

  // Areas opposite to a corner, signed: negative beyond the edge.
  const double area_c = a_ab * b_ac - b_ab * a_ac;
  if (area_c <= 0 && a_ab >= 0 && b_ab <= 0) {
    const double t = fraction(a_ab, a_ab - b_ab);
    return {1 - t, t, 0};
  }
  const double area_b = c_ab * a_ac - a_ab * c_ac;
  if (area_b <= 0 && a_ac >= 0 && c_ac <= 0) {
    const double t = fraction(a_ac, a_ac - c_ac);
    return {1 - t, 0, t};
  }
  const double area_a = b_ab * c_ac - c_ab * b_ac;
  if (area_a <= 0 && b_ac - b_ab >= 0 && c_ab - c_ac >= 0) {
    const double t = fraction(b_ac - b_ab, (b_ac - b_ab) + (c_ab - c_ac));
    return {0, 1 - t, t};
  }
  const double whole = area_a + area_b + area_c;
  const double v = area_b / whole;
  const double w = area_c / whole;
  return {1 - v - w, v, w};
}

/// Names the feature of a point on edge `k` with no part in the interior: weights a and b of its two ends.
void name_rim(NearestPoint& nearest, int k, double a, double b) {
  if (b == 0) {
    nearest.feature = Feature::Corner;
    nearest.local = k;
  } else if (a == 0) {
    nearest.feature = Feature::Corner;
    nearest.local = (k + 1) % 4;
  } else {
    nearest.feature = Feature::Edge;
    nearest.local = k;
  }
}

NearestPoint nearest_on_single(const SegmentShape& shape, const Vec3& p) {
  NearestPoint nearest;
  const Barycentric w = nearest_on_triangle(p, shape.corner[0], shape.corner[1], shape.corner[2]);
  nearest.weight = {w.a, w.b, w.c, 0};
  nearest.point = w.a * shape.corner[0] + w.b * shape.corner[1] + w.c * shape.corner[2];
  const Vec3 away = p - nearest.point;
  nearest.distance_squared = dot(away, away);
  if (w.c == 0)
    name_rim(nearest, 0, w.a, w.b);
  else if (w.a == 0)
    name_rim(nearest, 1, w.b, w.c);
  else if (w.b == 0)
    name_rim(nearest, 3, w.c, w.a);
  // The third corner is node 2 and node 3 of the segment; it is called 2.
  if (nearest.feature == Feature::Corner && nearest.local == 3) nearest.local = 2;
  return nearest;
}

}  // namespace

NearestPoint nearest_on(int k, const Barycentric& weight, const Vec3& point, double distance_squared) {
  NearestPoint nearest;
  nearest.point = point;
  nearest.distance_squared = distance_squared;
  const double quarter = 0.25 * weight.c;
  nearest.weight = {quarter, quarter, quarter, quarter};
  nearest.weight[k] += weight.a;
  nearest.weight[(k + 1) % 4] += weight.b;
  nearest.local = k;
  if (weight.c == 0) name_rim(nearest, k, weight.a, weight.b);
  return nearest;
}

NearestPoint nearest_point(const SegmentShape& shape, const Vec3& p) {
  if (shape.triangle) return nearest_on_single(shape, p);
  NearestPoint best;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    const Barycentric w = nearest_on_triangle(p, shape.corner[k], shape.corner[next], shape.centre);
    const Vec3 point = w.a * shape.corner[k] + w.b * shape.corner[next] + w.c * shape.centre;
    const Vec3 away = p - point;
    const double distance_squared = dot(away, away);
    if (k > 0 && distance_squared >= best.distance_squared) continue;
    best = nearest_on(k, w, point, distance_squared);
  }
  return best;
}

double distance_to_edges(const SegmentShape& shape, const Vec3& point) {
  double least = std::numeric_limits<double>::max();
  const int last = shape.triangle ? 2 : 3;
  for (int k = 0; k <= last; ++k) {
    const Vec3& from = shape.corner[k];
    const Vec3 along = shape.corner[k == last ? 0 : k + 1] - from;
    const double length = dot(along, along);
    if (length > 0) least = std::min(least, norm(cross(along, point - from)) / std::sqrt(length));
  }
  return least;
}

Frame frame_of(const SegmentShape& shape) {
  Frame frame;
  frame.third = normalised(area_normal(shape));
  const Vec3 along = shape.corner[1] - shape.corner[0];
  frame.first = normalised(along - dot(along, frame.third) * frame.third);
  frame.second = cross(frame.third, frame.first);
  return frame;
}

}  // namespace crumple::contact
