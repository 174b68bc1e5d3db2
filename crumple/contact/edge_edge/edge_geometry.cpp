// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/edge_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {

NearestOnEdges nearest_points(const EdgeShape& first, const EdgeShape& second) {
  const Vec3 u = first.along();
  const Vec3 v = second.along();
  const Vec3 between = first.start - second.start;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double uv = dot(u, v);
  const double bu = dot(u, between);
  const double bv = dot(v, between);
  NearestOnEdges found;
  auto& [s, t] = found.fraction;
  if (uu > 0 && vv > 0) {
    const double determinant = uu * vv - uv * uv;
    if (determinant > tolerances::parallel_squared * uu * vv)
      s = std::clamp((uv * bv - bu * vv) / determinant, 0.0, 1.0);
    t = (uv * s + bv) / vv;
    if (t < 0 || t > 1) {
      t = std::clamp(t, 0.0, 1.0);
      s = std::clamp((uv * t - bu) / uu, 0.0, 1.0);
    }
  } else if (uu > 0) {
    s = std::clamp(-bu / uu, 0.0, 1.0);
  } else if (vv > 0) {
    t = std::clamp(bv / vv, 0.0, 1.0);
  }
  found.away = first.at(s) - second.at(t);
  found.distance = norm(found.away);
  return found;
}

double nearest_fraction(const EdgeShape& edge, const Vec3& p) {
  const Vec3 along = edge.along();
  const double square = dot(along, along);
  return square > 0 ? std::clamp(dot(p - edge.start, along) / square, 0.0, 1.0) : 0.0;
}

double sine_between(const EdgeShape& first, const EdgeShape& second) {
  const Vec3 u = first.along();
  const Vec3 v = second.along();
  const double lengths = norm(u) * norm(v);
  return lengths > 0 ? norm(cross(u, v)) / lengths : 0.0;
}

double signed_volume(const EdgeShape& first, const EdgeShape& second) {
  return dot(first.start - second.start, cross(first.along(), second.along()));
}

Vec3 passed_from(const EdgeNodes& first, const EdgeNodes& second, const Configuration& now, double step) {
  const auto pair_at = [&](double back) {
    Configuration then = now;
    then.back = back;
    return std::array{edge_shape(first, then), edge_shape(second, then)};
  };
  const auto start = pair_at(step);
  const auto end = pair_at(0);
  const double side = signed_volume(start[0], start[1]);
  if (side == 0 || (side > 0) == (signed_volume(end[0], end[1]) > 0)) return {};
  double before = 0;
  double after = 1;
  auto last = end;
  for (int i = 0; i < tolerances::passage_halvings; ++i) {
    const double middle = 0.5 * (before + after);
    const auto here = pair_at((1 - middle) * step);
    if ((signed_volume(here[0], here[1]) > 0) == (side > 0)) {
      before = middle;
    } else {
      after = middle;
      last = here;
    }
  }
  const double longest =
      std::max(nearest_points(start[0], start[1]).distance, nearest_points(end[0], end[1]).distance);
  if (nearest_points(last[0], last[1]).distance > tolerances::passage_distance * longest) return {};
  const Vec3 across = cross(end[0].along(), end[1].along());
  const double size = norm(across);
  return size > 0 ? (side > 0 ? 1 : -1) / size * across : Vec3{};
}

double relative_motion(const EdgeNodes& first, const EdgeNodes& second, const Vec3* velocity, double step) {
  double largest = 0;
  for (const Index a : first)
    for (const Index b : second) {
      const Vec3 relative = velocity[a] - velocity[b];
      largest = std::max(largest, dot(relative, relative));
    }
  return step * std::sqrt(largest);
}

}  // namespace crumple::contact
