// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/orientation.hpp"

#include <algorithm>
#include <limits>

#include "contact/surface/segment_shape.hpp"
#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// Segments that hang together by edges.
std::vector<std::vector<Index>> pieces_of(const Surface& surface) {
  std::vector<std::vector<Index>> pieces;
  std::vector<std::uint8_t> reached(surface.segment_id.size(), 0);
  for (Index start = 0; start < surface.segments(); ++start) {
    if (reached[start] != 0) continue;
    reached[start] = 1;
    std::vector<Index> piece{start};
    for (std::size_t at = 0; at < piece.size(); ++at)
      for (const Index edge : surface.topology.edges_of[piece[at]]) {
        if (edge == no_index || surface.topology.kind[edge] != EdgeKind::Shared) continue;
        for (const Index other : surface.topology.at_edge(edge)) {
          if (reached[other] != 0) continue;
          reached[other] = 1;
          piece.push_back(other);
        }
      }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// 1 or -1: the side on which the nearest node is that may touch the segment; 0 if there is none.
int side_of_nearest(const Surface& surface, const Vec3* x, Index segment) {
  const SegmentShape shape = shape_of(surface, {x, nullptr, 0}, segment);
  double nearest = std::numeric_limits<double>::max();
  Vec3 away;
  for (Index i = 0; i < surface.node_count(); ++i) {
    if (!surface.may_touch(i, segment) || surface.owns(segment, surface.nodes[i])) continue;
    const Vec3 to_node = x[surface.nodes[i]] - shape.centre;
    if (dot(to_node, to_node) >= nearest) continue;
    nearest = dot(to_node, to_node);
    away = to_node;
  }
  const double above = dot(away, area_normal(shape));
  return above > 0 ? 1 : above < 0 ? -1 : 0;
}

}  // namespace

bool face_other_side(Surface& surface, const domain::NodeFields& nodes,
                     const std::vector<std::uint8_t>& known) {
  std::vector<std::vector<Index>> pieces = pieces_of(surface);
  std::erase_if(pieces, [&](const std::vector<Index>& piece) {
    return std::any_of(piece.begin(), piece.end(), [&](Index s) { return known[s] != 0; });
  });
  if (pieces.empty()) return false;
  const std::size_t affordable =
      tolerances::most_orientation_distances / (pieces.size() * surface.nodes.size());
  const std::size_t sample = std::clamp<std::size_t>(affordable, 1, tolerances::largest_orientation_sample);
  bool changed = false;
  for (const std::vector<Index>& piece : pieces) {
    int votes = 0;
    const std::size_t stride = std::max<std::size_t>(1, piece.size() / sample);
    for (std::size_t i = 0; i < piece.size(); i += stride)
      votes += side_of_nearest(surface, nodes.reference.data(), piece[i]);
    if (votes >= 0) continue;
    for (const Index s : piece) reverse_segment(&surface.connectivity[static_cast<std::size_t>(s) * 4]);
    changed = true;
  }
  return changed;
}

}  // namespace crumple::contact
