// SPDX-License-Identifier: BSD-3-Clause
#include "cellsearch/edges.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "cellsearch/error.hpp"
#include "queries/radix_sort.hpp"

namespace cellsearch {
namespace {

constexpr std::uint64_t low_half = 0xffffffffu;

void check(const Segments& segments, std::span<const std::uint8_t> active) {
  if (segments.nodes().size() % 4 != 0) {
    throw Error(ErrorKind::BadLayout, -1, "The connectivity is not a multiple of 4 node numbers.");
  }
  if (!active.empty() && active.size() != segments.count()) {
    throw Error(ErrorKind::BadLayout, -1, "The number of active flags is not the number of segments.");
  }
  const std::span<const Index> nodes = segments.nodes();
  const auto bad = std::find_if(nodes.begin(), nodes.end(), [](Index node) { return node < 0; });
  if (bad != nodes.end()) {
    const Index segment = static_cast<Index>((bad - nodes.begin()) / 4);
    throw Error(ErrorKind::BadConnectivity, segment,
                "Segment " + std::to_string(segment) + " names node " + std::to_string(*bad) + ".");
  }
}

}  // namespace

Array<Index> unique_edges(const Segments& segments, std::span<const std::uint8_t> active) {
  check(segments, active);
  Array<std::uint64_t> edges;  // the smaller node above the larger one
  edges.reserve(segments.nodes().size());
  for (std::size_t k = 0; k < segments.nodes().size(); ++k) {
    if (!active.empty() && active[k / 4] == 0) continue;
    const Index from = segments.nodes()[k];
    const Index to = segments.nodes()[k % 4 == 3 ? k - 3 : k + 1];
    if (from == to) continue;
    edges.push_back((static_cast<std::uint64_t>(std::min(from, to)) << 32) |
                    static_cast<std::uint64_t>(std::max(from, to)));
  }
  Array<std::uint64_t> scratch(edges.size());
  radix_sort(std::span(edges), std::span(scratch), [](std::uint64_t edge) { return edge; });
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Array<Index> nodes(2 * edges.size());
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    nodes[2 * edge] = static_cast<Index>(edges[edge] >> 32);
    nodes[2 * edge + 1] = static_cast<Index>(edges[edge] & low_half);
  }
  return nodes;
}

}  // namespace cellsearch
