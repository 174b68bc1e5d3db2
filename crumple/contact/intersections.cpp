// SPDX-License-Identifier: BSD-3-Clause
#include "contact/intersections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <cellsearch/search.hpp>

#include "contact/surface/inside_outside.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(b - a, cross(c - a, d - a));
}

/// True if the line from a to b goes through the triangle, its rim included; not if it only touches.
bool pierces(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double above_a = dot(a - t[0], normal);
  const double above_b = dot(b - t[0], normal);
  const double smallest = tolerances::in_plane * norm(normal) * norm(b - a);
  if (std::min(std::fabs(above_a), std::fabs(above_b)) <= smallest || (above_a > 0) == (above_b > 0))
    return false;
  const double v0 = volume(a, b, t[0], t[1]);
  const double v1 = volume(a, b, t[1], t[2]);
  const double v2 = volume(a, b, t[2], t[0]);
  return (v0 >= 0 && v1 >= 0 && v2 >= 0) || (v0 <= 0 && v1 <= 0 && v2 <= 0);
}

/// How deep the line is through a triangle with the rim of its segment given: as its nearer end from the
/// plane and as the point where it goes through from the rim, whichever is less. Edges of blocks that press
/// on each other are hardly through, or at the rim.
double depth_through(const Vec3& a, const Vec3& b, const std::array<Vec3, 3>& t, const SegmentShape& shape) {
  const Vec3 normal = normalised(cross(t[1] - t[0], t[2] - t[0]));
  const double above_a = std::fabs(dot(a - t[0], normal));
  const double above_b = std::fabs(dot(b - t[0], normal));
  const Vec3 point = a + above_a / (above_a + above_b) * (b - a);
  return std::min({above_a, above_b, distance_to_edges(shape, point)});
}

/// True if the line from a to b goes through the segment, deeper than `least`.
bool pierces_segment(const Vec3& a, const Vec3& b, const SegmentShape& shape, double least) {
  const auto through = [&](const std::array<Vec3, 3>& t) {
    return pierces(a, b, t) && (least == 0 || depth_through(a, b, t, shape) > least);
  };
  if (shape.triangle) return through({shape.corner[0], shape.corner[1], shape.corner[2]});
  for (int k = 0; k < 4; ++k)
    if (through({shape.corner[k], shape.corner[(k + 1) % 4], shape.centre})) return true;
  return false;
}

/// True if a line of segment `one` goes through segment `other`.
bool cuts(const Surface& surface, const Configuration& x, Index one, Index other) {
  const Index* nodes = surface.segment(one);
  const SegmentShape shape = shape_of(surface, x, one);
  const SegmentShape target = shape_of(surface, x, other);
  // Faces have no thickness: where they press, they overlap by what the penalty needs.
  const double least = surface.is_face(one) && surface.is_face(other)
                           ? tolerances::pressed_faces * std::min(surface.height[one], surface.height[other])
                           : 0;
  for (int k = 0; k < 4; ++k) {
    if (surface.owns(other, nodes[k])) continue;
    const int next = (k + 1) % 4;
    if (has_edge(nodes, k) && !surface.owns(other, nodes[next]) &&
        pierces_segment(shape.corner[k], shape.corner[next], target, least))
      return true;
    if (!shape.triangle && pierces_segment(shape.corner[k], shape.centre, target, least)) return true;
  }
  return false;
}

double radius(const SegmentShape& shape) {
  double largest = 0;
  for (const Vec3& corner : shape.corner) largest = std::max(largest, norm(corner - shape.centre));
  return largest;
}

}  // namespace

std::vector<std::array<Index, 2>> intersecting_segments(const Surface& surface,
                                                        const AlignedArray<Vec3>& position, int threads) {
  const Configuration x{position.data(), nullptr, 0};
  // Two segments can cut only where the centre of one is in the box of the other, expanded by its radius.
  std::vector<double> points;
  points.reserve(3 * (position.size() + surface.segment_id.size()));
  const auto append = [&](const Vec3& a) { points.insert(points.end(), {a.x, a.y, a.z}); };
  for (const Vec3& a : position) append(a);
  double largest_radius = 0;
  std::vector<Index> centres;
  for (Index s = 0; s < surface.segments(); ++s) {
    const SegmentShape shape = shape_of(surface, x, s);
    append(shape.centre);
    // Eroded ones may reach through the whole model.
    if (surface.active[s] == 0) continue;
    largest_radius = std::max(largest_radius, radius(shape));
    centres.push_back(static_cast<Index>(position.size()) + s);
  }

  cellsearch::Scene scene;
  scene.positions = cellsearch::Positions(points);
  scene.segments = cellsearch::Segments(surface.connectivity);
  scene.segment_active = surface.active;
  scene.expansion = largest_radius;
  scene.nodes = std::span<const cellsearch::Index>(centres);
  cellsearch::Settings settings;
  settings.threads = threads;
  cellsearch::Search search(settings);
  const cellsearch::Candidates& near = search.find(scene);

  std::vector<std::array<Index, 2>> found;
  for (Index s = 0; s < near.segments(); ++s)
    for (const Index centre : near.of(s)) {
      const Index other = centre - static_cast<Index>(position.size());
      if (other > s && (cuts(surface, x, s, other) || cuts(surface, x, other, s)))
        found.push_back({s, other});
    }
  return found;
}

std::vector<std::array<Index, 2>> cut_since(const Surface& surface,
                                            std::span<const std::array<Index, 2>> initial,
                                            std::span<const std::array<Index, 2>> cut) {
  const auto beside = [&](Index one, Index other) { return one == other || connected(surface, one, other); };
  std::vector<std::array<Index, 2>> found;
  std::ranges::copy_if(cut, std::back_inserter(found), [&](const std::array<Index, 2>& pair) {
    return std::ranges::none_of(initial, [&](const std::array<Index, 2>& before) {
      return (beside(pair[0], before[0]) && beside(pair[1], before[1])) ||
             (beside(pair[0], before[1]) && beside(pair[1], before[0]));
    });
  });
  return found;
}

PenetrationSummary summarise(std::span<const Penetration> penetrations) {
  PenetrationSummary summary;
  std::vector<double> ratios;
  for (const Penetration& found : penetrations) {
    const double ratio = found.reach > 0 ? found.depth / found.reach : 1.0;
    ratios.push_back(ratio);
    if (ratio >= 1) ++summary.beyond;
    if (ratio <= summary.largest) continue;
    summary.largest = ratio;
    summary.worst_node = found.node;
    summary.worst_segment = found.segment;
  }
  summary.pairs = static_cast<Index>(ratios.size());
  if (ratios.empty()) return summary;
  std::sort(ratios.begin(), ratios.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(ratios.size())));
  summary.percentile_99 = ratios[std::max<std::size_t>(rank, 1) - 1];
  return summary;
}

}  // namespace crumple::contact
