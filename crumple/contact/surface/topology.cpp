// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surface/topology.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace crumple::contact {
namespace {

/// One side of one segment. Sorting brings the sides on the same edge together.
struct Side {
  Index low = 0;   ///< the smaller node
  Index high = 0;  ///< the larger node
  Index segment = 0;
  int k = 0;
  bool ascending = false;  ///< the segment runs from low to high

  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
  bool operator<(const Side& other) const {
    return std::tie(low, high, segment, k) < std::tie(other.low, other.high, other.segment, other.k);
  }
};

std::vector<Side> sorted_sides(const std::vector<Index>& connectivity,
                               const std::vector<std::uint8_t>& active) {
  std::vector<Side> sides;
  sides.reserve(connectivity.size());
  for (Index s = 0; s < static_cast<Index>(connectivity.size() / 4); ++s) {
    if (active[s] == 0) continue;
    const Index* nodes = &connectivity[static_cast<std::size_t>(s) * 4];
    for (int k = 0; k < 4; ++k) {
      if (!has_edge(nodes, k)) continue;
      const auto [low, high] = std::minmax(nodes[k], nodes[(k + 1) % 4]);
      sides.push_back({low, high, s, k, nodes[k] == low});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Calls visit(first, last) for each run of sides on the same edge.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].same_edge(sides[first])) ++last;
    visit(first, last);
    first = last;
  }
}

/// Turns lists of (row, value), sorted by row, into the starts of the rows.
std::vector<Index> row_starts(const std::vector<std::pair<Index, Index>>& entries, Index rows) {
  std::vector<Index> first(static_cast<std::size_t>(rows) + 1, 0);
  for (const auto& entry : entries) ++first[entry.first + 1];
  for (Index row = 0; row < rows; ++row) first[row + 1] += first[row];
  return first;
}

void collect_nodes(const std::vector<Index>& connectivity, const std::vector<std::uint8_t>& active,
                   const std::vector<Index>& place, Topology& topology) {
  std::vector<std::pair<Index, Index>> entries;
  for (std::size_t i = 0; i < connectivity.size(); ++i)
    if (active[i / 4] != 0) entries.emplace_back(place[connectivity[i]], static_cast<Index>(i / 4));
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  topology.first_at_node = row_starts(entries, static_cast<Index>(topology.smooth_node.size()));
  for (const auto& entry : entries) topology.segment_at_node.push_back(entry.second);
}

/// True if stepping from segment to segment over the edges at `node` visits all its segments and closes.
bool closed_fan(const std::vector<Index>& connectivity, const Topology& topology, Index node, Index place) {
  const auto around = topology.at_node(place);
  Index segment = around.front();
  std::size_t visited = 0;
  do {
    const Index* nodes = &connectivity[static_cast<std::size_t>(segment) * 4];
    int k = 0;
    while (nodes[k] != node || !has_edge(nodes, k)) ++k;
    const Index edge = topology.edges_of[segment][k];
    if (topology.kind[edge] != EdgeKind::Shared) return false;
    const auto pair = topology.at_edge(edge);
    segment = pair[0] == segment ? pair[1] : pair[0];
    ++visited;
  } while (segment != around.front() && visited < around.size());
  return segment == around.front() && visited == around.size();
}

}  // namespace

void reverse_segment(Index* nodes) {
  if (nodes[2] == nodes[3]) {
    std::swap(nodes[1], nodes[2]);
    nodes[3] = nodes[2];
  } else {
    std::swap(nodes[1], nodes[3]);
  }
}

void orient_alike(std::vector<Index>& connectivity, const std::vector<std::uint8_t>& active,
                  const std::vector<std::uint8_t>& keep) {
  const auto segments = static_cast<Index>(connectivity.size() / 4);
  // Neighbours over edges of exactly two segments, and whether they run through the edge alike.
  std::vector<std::pair<Index, Index>> links;
  const std::vector<Side> sides = sorted_sides(connectivity, active);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first != 2) return;
    const Side& a = sides[first];
    const Side& b = sides[first + 1];
    const Index against = a.ascending == b.ascending ? 1 : 0;
    links.emplace_back(a.segment, 2 * b.segment + against);
    links.emplace_back(b.segment, 2 * a.segment + against);
  });
  std::sort(links.begin(), links.end());
  const std::vector<Index> first = row_starts(links, segments);

  std::vector<int> reversed(segments, -1);  // -1 is not yet reached
  std::vector<Index> queue;
  const auto spread = [&] {
    for (std::size_t at = 0; at < queue.size(); ++at) {
      const Index s = queue[at];
      for (Index l = first[s]; l < first[s + 1]; ++l) {
        const Index other = links[l].second / 2;
        if (reversed[other] != -1) continue;
        reversed[other] = reversed[s] ^ (links[l].second & 1);
        queue.push_back(other);
      }
    }
  };
  for (Index s = 0; s < segments; ++s)
    if (keep[s] != 0) {
      reversed[s] = 0;
      queue.push_back(s);
    }
  spread();
  for (Index start = 0; start < segments; ++start) {
    if (reversed[start] != -1) continue;
    reversed[start] = 0;
    queue.assign(1, start);
    spread();
  }
  for (Index s = 0; s < segments; ++s)
    if (reversed[s] == 1) reverse_segment(&connectivity[static_cast<std::size_t>(s) * 4]);
}

Topology build_topology(const std::vector<Index>& connectivity, const std::vector<std::uint8_t>& active,
                        const std::vector<Index>& place, Index nodes) {
  Topology topology;
  topology.edges_of.assign(connectivity.size() / 4, {no_index, no_index, no_index, no_index});
  topology.first_at_edge.assign(1, 0);
  const std::vector<Side> sides = sorted_sides(connectivity, active);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    const Index edge = topology.edges();
    for (std::size_t i = first; i < last; ++i) {
      topology.edges_of[sides[i].segment][sides[i].k] = edge;
      topology.segment_at_edge.push_back(sides[i].segment);
    }
    topology.first_at_edge.push_back(static_cast<Index>(topology.segment_at_edge.size()));
    const bool pair = last - first == 2 && sides[first].ascending != sides[first + 1].ascending &&
                      sides[first].segment != sides[first + 1].segment;
    topology.kind.push_back(last - first == 1 ? EdgeKind::Free
                            : pair            ? EdgeKind::Shared
                                              : EdgeKind::Junction);
  });
  topology.smooth_node.assign(nodes, 0);
  collect_nodes(connectivity, active, place, topology);
  for (Index node = 0; node < static_cast<Index>(place.size()); ++node)
    if (place[node] != no_index && !topology.at_node(place[node]).empty())
      topology.smooth_node[place[node]] = closed_fan(connectivity, topology, node, place[node]) ? 1 : 0;
  return topology;
}

}  // namespace crumple::contact
