// SPDX-License-Identifier: BSD-3-Clause
#include "contact/node_segment/lost_nodes.hpp"

#include <algorithm>

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

bool released(const SurfaceAt& now, const RememberedPair& memory, const RaggedNodes& ragged) {
  const Surface& surface = *now.surface;
  if (memory.let_go != 0 || ragged.has(memory)) return true;
  const Vec3& node = now.x[surface.nodes[memory.node]];
  const SegmentShape shape = now.shape(memory.segment);
  const NearestPoint nearest = nearest_point(shape, node);
  if (at_free_edge(surface, memory.segment, nearest)) return true;
  const Vec3 away = node - nearest.point;
  return memory.side * dot(away, side_normal(now, memory.segment, shape, nearest, away)) >= 0;
}

}  // namespace

void count_lost_nodes(const SurfaceAt& now, std::span<const RememberedPair> remembered,
                      std::span<const ContactPair> pairs, const RaggedNodes& ragged, long cycle,
                      domain::LostNodes& lost) {
  const Surface& surface = *now.surface;
  auto at = pairs.begin();
  for (const RememberedPair& memory : remembered) {
    if (memory.wrong == 0) continue;
    while (at != pairs.end() && at->node < memory.node) ++at;
    bool goes_on = false;
    for (auto pair = at; pair != pairs.end() && pair->node == memory.node && !goes_on; ++pair)
      goes_on = pair->segment == memory.segment || connected(surface, pair->segment, memory.segment);
    if (goes_on || released(now, memory, ragged)) continue;
    if (++lost.count > 1) continue;
    lost.cycle = cycle;
    lost.node = surface.node_id[memory.node];
    lost.segment = surface.segment_id[memory.segment];
  }
}

}  // namespace crumple::contact
