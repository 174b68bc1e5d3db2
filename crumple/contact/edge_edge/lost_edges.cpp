// SPDX-License-Identifier: BSD-3-Clause
#include "contact/edge_edge/lost_edges.hpp"

#include <array>
#include <cstddef>

namespace crumple::contact {
namespace {

/// True if a pair of now, of these edges or of their neighbours, keeps the first edge on its side.
bool goes_on(const EdgeView& view, std::span<const EdgePair> present, const RememberedEdgePair& memory) {
  bool found = false;
  visit_connected(view, present, memory.key, [&](const EdgePair& pair, double sign) {
    found = found || pair.key == memory.key || sign * dot(pair.side, memory.side) > 0;
  });
  return found;
}

bool released(const EdgeView& view, const RememberedEdgePair& memory) {
  const std::array<Index, 2> edge{memory.key.first, memory.key.second};
  const NearestOnEdges nearest = nearest_points(view.shape(edge[0]), view.shape(edge[1]));
  for (int i = 0; i < 2; ++i) {
    if (nearest.inside(i)) continue;
    const Index end = view.edges->ends(edge[static_cast<std::size_t>(i)])[nearest.fraction[i] == 0 ? 0 : 1];
    if (view.edges->at_node(view.surface->place[end]).size() < 2) return true;
  }
  return dot(nearest.away, memory.side) >= 0;
}

}  // namespace

void count_lost_edges(const EdgeView& view, std::span<const EdgePair> present, long cycle,
                      domain::LostContacts& lost) {
  for (const RememberedEdgePair& memory : view.remembered) {
    // Without a share of the force the nodes hold the contact, and count what they lose.
    if (memory.wrong == 0 || memory.share == 0) continue;
    if (goes_on(view, present, memory) || released(view, memory)) continue;
    if (++lost.count > 1) continue;
    lost.cycle = cycle;
    lost.node = view.surface->node_id[view.surface->place[view.edges->ends(memory.key.first)[0]]];
    lost.segment = view.edges->id[memory.key.second];
  }
}

}  // namespace crumple::contact
