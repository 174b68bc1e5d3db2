// SPDX-License-Identifier: BSD-3-Clause
// The C interface of the queries beside that for nodes near segments.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "c_handle.hpp"
#include "cellsearch/cellsearch.h"
#include "cellsearch/edges.hpp"

using cellsearch::Index;
using cellsearch::c_interface::demand;
using cellsearch::c_interface::FurtherQueries;
using cellsearch::c_interface::guarded;
using cellsearch::c_interface::Handle;

namespace {

/// Edges know nothing of segments, so that a bad one has to be found before.
void check_connectivity(const cellsearch::Scene& scene) {
  const auto nodes = static_cast<int64_t>(scene.positions.count());
  const std::span<const Index> numbers = scene.segments.nodes();
  for (std::size_t place = 0; place < numbers.size(); ++place) {
    if (numbers[place] >= 0 && numbers[place] < nodes) continue;
    const auto segment = static_cast<Index>(place / 4);
    throw cellsearch::Error(cellsearch::ErrorKind::BadConnectivity, segment,
                            "Segment " + std::to_string(segment) + " names node " +
                                std::to_string(numbers[place]) + ", which does not exist.");
  }
}

void find_edges(Handle& own, const cellsearch::Scene& scene) {
  check_connectivity(scene);
  own.further.edges = cellsearch::unique_edges(scene.segments, scene.segment_active);
}

}  // namespace

extern "C" {

int32_t cellsearch_segment_pairs(cellsearch_handle* handle, int32_t exclude_shared_nodes,
                                 const int64_t** first, const int32_t** second, int64_t* pairs) {
  return guarded(handle, [&](Handle& own) {
    const int threads = own.settings.threads;
    const bool exclude = exclude_shared_nodes != 0;
    auto& search = own.further.segment_search.with({exclude ? 1.0 : 0.0, static_cast<double>(threads)},
                                                   cellsearch::SegmentPairSettings{exclude, threads});
    const cellsearch::Pairs& found = search.find(own.scene_from_zero());
    own.further.segment_pairs.lend(found.first, found.second, own.base, threads).give(first, second, pairs);
  });
}

int32_t cellsearch_edges(cellsearch_handle* handle, const int32_t** nodes, int64_t* edges) {
  return guarded(handle, [&](Handle& own) {
    FurtherQueries& further = own.further;
    find_edges(own, own.scene_from_zero());
    cellsearch::c_interface::copy_shifted<Index>(further.edges, own.base, own.settings.threads,
                                                 further.lent_edges);
    if (nodes != nullptr) *nodes = further.lent_edges.data();
    if (edges != nullptr) *edges = static_cast<int64_t>(further.edges.size() / 2);
  });
}

int32_t cellsearch_edge_pairs(cellsearch_handle* handle, double expansion, int32_t exclude_shared_nodes,
                              const int64_t** first, const int32_t** second, int64_t* pairs) {
  return guarded(handle, [&](Handle& own) {
    const int threads = own.settings.threads;
    const bool exclude = exclude_shared_nodes != 0;
    const cellsearch::Scene from_0 = own.scene_from_zero();
    find_edges(own, from_0);
    cellsearch::EdgeScene scene;
    scene.positions = from_0.positions;
    scene.edges = cellsearch::Edges(own.further.edges);
    scene.expansion = expansion;
    auto& search = own.further.edge_search.with({exclude ? 1.0 : 0.0, static_cast<double>(threads)},
                                                cellsearch::EdgePairSettings{exclude, threads});
    const cellsearch::Pairs& found = search.find(scene);
    own.further.edge_pairs.lend(found.first, found.second, own.base, threads).give(first, second, pairs);
  });
}

int32_t cellsearch_nearest(cellsearch_handle* handle, int32_t neighbours, double largest_distance,
                           int32_t exclude_connected, cellsearch_neighbours* found) {
  return guarded(handle, [&](Handle& own) {
    demand(found != nullptr, CELLSEARCH_BAD_ARGUMENT, "The place for the nearest nodes is null.");
    *found = {nullptr, nullptr, nullptr, 0};
    const int threads = own.settings.threads;
    const bool exclude = exclude_connected != 0;
    auto& search = own.further.nearest_search.with(
        {exclude ? 1.0 : 0.0, static_cast<double>(threads), static_cast<double>(neighbours),
         largest_distance},
        cellsearch::NearestSettings{neighbours, largest_distance, exclude, threads});
    const cellsearch::NearestNodes& nearest = search.find(own.scene_from_zero());
    own.further.nearest.lend(nearest.first, nearest.node, own.base, threads)
        .give(&found->first, &found->node, &found->count);
    found->distance = nearest.distance.data();
  });
}

}  // extern "C"
