// SPDX-License-Identifier: BSD-3-Clause
#include "contact/intersections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <cellsearch/segment_pairs.hpp>

#include "base/parallel.hpp"
#include "contact/search/search_calls.hpp"
#include "contact/surface/inside_outside.hpp"
#include "contact/surface/segment_shape.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(b - a, cross(c - a, d - a));
}

/// A flat part of a segment, with its normal, which is as long as twice its area.
struct Triangle {
  std::array<Vec3, 3> corner;
  Vec3 normal;
  double size = 0;  ///< of the normal

  Triangle(const Vec3& a, const Vec3& b, const Vec3& c)
      : corner{a, b, c}, normal(cross(b - a, c - a)), size(norm(normal)) {}
};

/// True if the line from a to b goes through the triangle, its rim included; not if it only touches.
bool pierces(const Vec3& a, const Vec3& b, const Triangle& triangle) {
  const std::array<Vec3, 3>& t = triangle.corner;
  const double above_a = dot(a - t[0], triangle.normal);
  const double above_b = dot(b - t[0], triangle.normal);
  if ((above_a > 0) == (above_b > 0)) return false;
  const double smallest = tolerances::in_plane * triangle.size * norm(b - a);
  if (std::min(std::fabs(above_a), std::fabs(above_b)) <= smallest) return false;
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
  const auto through = [&](const Vec3& c, const Vec3& d, const Vec3& e) {
    const Triangle t(c, d, e);
    return pierces(a, b, t) && (least == 0 || depth_through(a, b, t.corner, shape) > least);
  };
  if (shape.triangle) return through(shape.corner[0], shape.corner[1], shape.corner[2]);
  for (int k = 0; k < 4; ++k)
    if (through(shape.corner[k], shape.corner[(k + 1) % 4], shape.centre)) return true;
  return false;
}

/// A pair of segments, of which lines from corners that the other owns do not count.
struct SegmentPair {
  SegmentPair(const Surface& surface, std::span<const SegmentShape> shapes, Index one, Index other)
      : first(shapes[one]), second(shapes[other]) {
    for (int k = 0; k < 4; ++k) {
      first_counts[k] = !surface.owns(other, surface.segment(one)[k]);
      second_counts[k] = !surface.owns(one, surface.segment(other)[k]);
    }
  }

  const SegmentShape& first;
  const SegmentShape& second;
  std::array<bool, 4> first_counts{};
  std::array<bool, 4> second_counts{};
};

/// True if a plane across the line between the centres parts all lines that count from the other segment:
/// most neighbours.
bool parted(const SegmentPair& pair) {
  const Vec3 direction = pair.second.centre - pair.first.centre;
  double first_end = dot(pair.first.centre, direction);
  double second_end = dot(pair.second.centre, direction);
  double first_counted = first_end;
  double second_counted = second_end;
  for (int k = 0; k < 4; ++k) {
    const double first = dot(pair.first.corner[k], direction);
    const double second = dot(pair.second.corner[k], direction);
    first_end = std::max(first_end, first);
    second_end = std::min(second_end, second);
    if (pair.first_counts[k]) first_counted = std::max(first_counted, first);
    if (pair.second_counts[k]) second_counted = std::min(second_counted, second);
  }
  return first_counted < second_end && first_end < second_counted;
}

/// True if a line of segment `one` goes through segment `other`, deeper than `least`.
bool cuts(const Index* nodes, const SegmentShape& one, const std::array<bool, 4>& counts,
          const SegmentShape& other, double least) {
  for (int k = 0; k < 4; ++k) {
    if (!counts[k]) continue;
    const int next = (k + 1) % 4;
    if (has_edge(nodes, k) && counts[next] && pierces_segment(one.corner[k], one.corner[next], other, least))
      return true;
    if (!one.triangle && pierces_segment(one.corner[k], one.centre, other, least)) return true;
  }
  return false;
}

bool cut_each_other(const Surface& surface, std::span<const SegmentShape> shapes, CutDepth depth, Index one,
                    Index other) {
  const SegmentPair pair(surface, shapes, one, other);
  if (parted(pair)) return false;
  // Faces have no thickness: where they press, they overlap by what the penalty needs.
  double least = surface.is_face(one) && surface.is_face(other)
                     ? tolerances::pressed_faces * std::min(surface.height[one], surface.height[other])
                     : 0;
  if (depth == CutDepth::Through)
    least = std::max({least, surface.half_thickness[one], surface.half_thickness[other]});
  return cuts(surface.segment(one), pair.first, pair.first_counts, pair.second, least) ||
         cuts(surface.segment(other), pair.second, pair.second_counts, pair.first, least);
}

/// Pairs of segments whose bounding boxes have a point in common, neighbours too.
cellsearch::Pairs near_pairs(const Surface& surface, const AlignedArray<Vec3>& position, int threads) {
  cellsearch::SegmentPairSettings settings;
  settings.exclude_shared_nodes = false;
  settings.threads = threads;
  cellsearch::Scene scene;
  scene.positions = view(position);
  scene.segments = cellsearch::Segments(surface.connectivity);
  // Eroded ones may reach through the whole model.
  scene.segment_active = surface.active;
  cellsearch::SegmentPairSearch search(settings);
  try {
    search.find(scene);
  } catch (const cellsearch::Error& error) {
    rethrow(error, surface);
  }
  return search.take();
}

}  // namespace

std::vector<std::array<Index, 2>> intersecting_segments(const Surface& surface,
                                                        const AlignedArray<Vec3>& position, int threads,
                                                        CutDepth depth) {
  constexpr Index rows_per_piece = 256;
  const Configuration x{position.data(), nullptr, 0};
  std::vector<SegmentShape> shapes(surface.segment_id.size());
  for (Index s = 0; s < surface.segments(); ++s)
    if (surface.active[s] != 0) shapes[s] = shape_of(surface, x, s);
  const cellsearch::Pairs near = near_pairs(surface, position, threads);
  const Index rows = near.rows();
  std::vector<std::vector<std::array<Index, 2>>> of_piece(
      static_cast<std::size_t>(pieces(rows, rows_per_piece)));
  parallel_for(pieces(rows, rows_per_piece), threads, [&](Index piece) {
    for (Index one = piece * rows_per_piece; one < std::min((piece + 1) * rows_per_piece, rows); ++one)
      for (const Index other : near.of(one))
        if (cut_each_other(surface, shapes, depth, one, other)) of_piece[piece].push_back({one, other});
  });
  std::vector<std::array<Index, 2>> found;
  for (const auto& some : of_piece) found.insert(found.end(), some.begin(), some.end());
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

Intersections::Intersections(const Surface& surface, const domain::Domain& domain, CutDepth depth)
    : all(intersecting_segments(surface, domain.nodes.position, domain.execution.threads, depth)) {
  if (all.empty()) return;
  since_start = cut_since(
      surface, intersecting_segments(surface, domain.nodes.reference, domain.execution.threads), all);
}

void note_worst(const Intersections& found, const Surface& surface, const domain::Clock& clock,
                domain::WorstIntersections& worst) {
  const auto count = static_cast<Index>(found.since_start.size());
  if (count <= worst.count) return;
  worst.count = count;
  worst.first_segment = surface.segment_id[found.since_start.front()[0]];
  worst.second_segment = surface.segment_id[found.since_start.front()[1]];
  worst.cycle = clock.cycle;
  worst.time = clock.time;
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
