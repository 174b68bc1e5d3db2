// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/lost_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "contact/tolerances.hpp"

namespace crumple::contact {
namespace {

/// True if the surface ends where the point of the segment nearest to the node is.
bool at_free_edge(const Surface& surface, Index segment, const NearestPoint& nearest) {
  const Topology& topology = surface.topology;
  const auto ends = [&](Index s, int k) {
    const Index edge = topology.edges_of[s][static_cast<std::size_t>(k)];
    return edge != no_index && topology.kind[edge] == EdgeKind::Free;
  };
  if (nearest.feature == Feature::Face) return false;
  if (nearest.feature == Feature::Edge) return ends(segment, nearest.local);
  const Index corner = surface.segment(segment)[nearest.local];
  const auto around = topology.at_node(surface.place[corner]);
  return std::any_of(around.begin(), around.end(), [&](Index s) {
    for (int k = 0; k < 4; ++k) {
      const Index* nodes = surface.segment(s);
      if ((nodes[k] == corner || nodes[(k + 1) % 4] == corner) && ends(s, k)) return true;
    }
    return false;
  });
}

/// True if the node is beyond the rim of a face where the solid's surface bends by 60 degrees or more: there,
/// as NodeSearch::hold() has it, the face loses the node. Where the surface goes on, the next face keeps it.
bool over_sharp_rim(const SurfaceAt& now, Index segment, const SegmentShape& shape, const Vec3& normal,
                    const Vec3& node) {
  const Surface& surface = *now.surface;
  const Topology& topology = surface.topology;
  const double least = tolerances::lost_beyond_rim * std::sqrt(surface.area[segment]);
  for (std::size_t k = 0; k < 4; ++k) {
    const Index edge = topology.edges_of[segment][k];
    if (edge == no_index) continue;
    const Vec3 outward = normalised(cross(shape.corner[(k + 1) % 4] - shape.corner[k], normal));
    if (dot(node - shape.corner[k], outward) < least) continue;
    const auto beside = topology.at_edge(edge);
    if (std::none_of(beside.begin(), beside.end(), [&](Index other) {
          return other != segment &&
                 dot(normalised(area_normal(now.shape(other))), normal) > tolerances::two_walls;
        }))
      return true;
  }
  return false;
}

bool released(const SurfaceAt& now, const RememberedPair& memory, const RaggedNodes& ragged) {
  const Surface& surface = *now.surface;
  if (memory.let_go != 0 || ragged.has(memory)) return true;
  const Vec3& node = now.x[surface.nodes[memory.node]];
  const SegmentShape shape = now.shape(memory.segment);
  const NearestPoint nearest = nearest_point(shape, node);
  if (at_free_edge(surface, memory.segment, nearest)) return true;
  const Vec3 away = node - nearest.point;
  const Vec3 own = normalised(area_normal(shape));
  if (surface.is_face(memory.segment) && over_sharp_rim(now, memory.segment, shape, own, node)) return true;
  // Where the surface is round, at junctions, the segment itself tells its sides apart.
  const Vec3 normal = side_normal(now, memory.segment, shape, nearest, away);
  return memory.side * dot(away, dot(normal, normal) > 0 ? normal : own) >= 0;
}

}  // namespace

void count_lost_nodes(const SurfaceAt& now, std::span<const RememberedPair> remembered,
                      std::span<const ContactPair> pairs, const RaggedNodes& ragged, long cycle,
                      domain::LostContacts& lost) {
  const Surface& surface = *now.surface;
  auto at = pairs.begin();
  Index last = no_index;
  for (const RememberedPair& memory : remembered) {
    if (memory.wrong == 0 || memory.node == last) continue;
    while (at != pairs.end() && at->node < memory.node) ++at;
    bool goes_on = false;
    // Right in front of a face beside, a node is outside of the solid: it came round a rim.
    for (auto pair = at; pair != pairs.end() && pair->node == memory.node && !goes_on; ++pair)
      goes_on = pair->segment == memory.segment || pair->heir_of == memory.segment ||
                ((pair->wrong != 0 || surface.is_face(pair->segment)) &&
                 connected(surface, pair->segment, memory.segment));
    if (goes_on || released(now, memory, ragged)) continue;
    last = memory.node;
    if (++lost.count > 1) continue;
    lost.cycle = cycle;
    lost.node = surface.node_id[memory.node];
    lost.segment = surface.segment_id[memory.segment];
  }
}

}  // namespace crumple::contact
