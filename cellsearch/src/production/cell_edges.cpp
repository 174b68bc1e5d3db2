// SPDX-License-Identifier: BSD-3-Clause
#include "production/cell_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace cellsearch::production {
namespace {

constexpr Index most_samples = 2048;
/// Small models are told apart by this and a quarter of their segments; more would be felt in their searches.
constexpr Index few_samples = 256;
constexpr int classes = TerritorySample::classes;
constexpr double classes_per_octave = 4.0;
/// Cells per node that are always affordable, with a grid of its own for what is crowded.
constexpr double most_cells_per_node = 5.0;

Index samples_of(Index segments) {
  return std::min({segments, most_samples, few_samples + segments / 4});
}

/// Segment `number` of `count` samples: spread evenly, but not in step with the rows of a mesh.
Index sampled_segment(Index number, Index count, Index segments) {
  const Offset stride = segments / count;
  const Offset shift = (Offset{number} * 2654435761LL) % stride;
  return static_cast<Index>(Offset{number} * segments / count / stride * stride + shift) % segments;
}

std::array<double, 3> extents_of(const Box& box) {
  return {box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]};
}

/// The axis along which nodes move most from a segment to the next.
int numbering_axis(const Scene& scene, Index samples, Index segments) {
  std::array<double, 3> moved{};
  for (Index i = 0; i < samples; ++i) {
    const Index segment = sampled_segment(i, samples, segments);
    if (segment + 1 >= segments) continue;
    const double* from = scene.positions[scene.segments[segment][0]];
    const double* to = scene.positions[scene.segments[segment + 1][0]];
    for (std::size_t axis = 0; axis < 3; ++axis) moved[axis] += std::fabs(to[axis] - from[axis]);
  }
  return static_cast<int>(std::max_element(moved.begin(), moved.end()) - moved.begin());
}

/// Nodes expected in a run through the cells of a territory, if surfaces were single.
double single_run(const TerritorySize& size, const CellEdges& edges) {
  return (size.along + edges.run) * edges.cross / (size.spacing * size.spacing);
}

double rows_of(const TerritorySize& size, const CellEdges& edges) {
  const double across = 1.0 + size.across / edges.cross;
  return across * across;
}

/// Estimated time for a segment [ns]. The constants were set by hand, from runs with given cells on one
/// machine; only the place of the minimum matters, and it is flat.
double query_cost(const TerritorySize& size, const CellEdges& edges, double layers) {
  const double across = size.across / edges.cross;
  const double rows = rows_of(size, edges);
  const double in_run = layers * single_run(size, edges);
  const double third_row = std::clamp(across - 1.0, 0.0, 1.0);
  const double wide = 1.0 - (1.0 - third_row) * (1.0 - third_row);
  const double long_run = std::clamp((in_run - 6.0) / 14.0, 0.0, 1.0);
  const double tests = rows * (1.0 + in_run / 16.0);
  double cost = 20.0 + wide * (20.0 + 2.5 * tests) + long_run * (6.0 + 5.0 * rows * in_run / 16.0);
  // Beyond what the bytes of the lattice tell apart, rows are visited one by one.
  if (across > 2.9 || size.along / edges.run > 5.0) cost += 40.0 + rows * (10.0 + 2.0 * in_run);
  return cost;
}

double cost_of(const TerritorySample& sample, const CellEdges& edges, double layers, double cells_per_node) {
  double cost = 2.0 * cells_per_node;
  for (const TerritorySize& size : sample.sizes()) cost += size.weight * query_cost(size, edges, layers);
  return cost;
}

/// Edges that make about `cells` cells, for nodes of which nothing better is known.
CellEdges edges_for(const Box& box, int run_axis, double cells) {
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, 0.5 * box.hi[axis] - 0.5 * box.lo[axis]);
  CellEdges edges{run_axis, longest / 2048.0, longest / 1024.0};
  while (cells_for(box, edges) > cells && edges.run < longest) {
    edges.run *= 1.1;
    edges.cross *= 1.1;
  }
  return edges;
}

}  // namespace

TerritorySample sample_territories(const FinderInput& input) {
  const Scene& scene = input.scene;
  const Index segments = static_cast<Index>(scene.segments.count());
  const Index samples = samples_of(segments);
  TerritorySample sample;
  sample.run_axis = numbering_axis(scene, samples, segments);
  const std::size_t run = static_cast<std::size_t>(sample.run_axis);
  struct One {
    double along;
    double across;
    double spacing;
  };
  std::array<One, most_samples> all;
  for (Index i = 0; i < samples; ++i) {
    const Index segment = sampled_segment(i, samples, segments);
    const Box box = input.test.culling_box(segment);
    const std::array<double, 3> extent = extents_of(box);
    const double across = std::max(extent[(run + 1) % 3], extent[(run + 2) % 3]);
    const double longest = std::max(across, extent[run]);
    // Expanded territories say nothing of the distance of nodes where the expansion is most of them.
    const double bare = longest - 2.0 * scene.expansion_of(segment);
    all[static_cast<std::size_t>(i)] = {extent[run], across, std::max(bare, 0.1 * longest)};
    sample.largest = std::max(sample.largest, longest);
    sample.smallest = std::min(sample.smallest, longest);
  }
  double octaves_below = 0.0;
  for (Index i = 0; i < samples; ++i) {
    const One& one = all[static_cast<std::size_t>(i)];
    const double longest = std::max(one.along, one.across);
    if (!(longest > 0.0) || !std::isfinite(sample.largest)) continue;
    const double octaves = std::log2(sample.largest / longest);
    octaves_below += octaves;
    const double place = std::min(octaves * classes_per_octave, double{classes - 1});
    TerritorySize& size = sample.of_size[static_cast<std::size_t>(place)];
    size.weight += 1.0;
    size.along += one.along;
    size.across += one.across;
    size.spacing += one.spacing;
  }
  sample.typical = sample.largest * std::exp2(-octaves_below / samples);
  for (const TerritorySize& size : sample.of_size) {
    if (!(size.weight > 0.0)) continue;
    sample.of_size[static_cast<std::size_t>(sample.found)] = {size.weight / samples, size.along / size.weight,
                                                              size.across / size.weight,
                                                              size.spacing / size.weight};
    ++sample.found;
  }
  return sample;
}

double affordable_cells(Index nodes) {
  return most_cells_per_node * nodes + 1024.0;
}

CellEdges choose_edges(const TerritorySample& sample, const Box& box, Index nodes, double layers) {
  const double affordable = affordable_cells(nodes);
  if (nodes == 0 || !(sample.largest > 0.0) || !std::isfinite(sample.largest))
    return edges_for(box, sample.run_axis, 0.25 * nodes + 1.0);
  CellEdges best;
  double least = std::numeric_limits<double>::infinity();
  // From the typical size: the largest of a sample varies from one to the next.
  for (int step = -classes / 2; step < classes / 2; ++step) {
    const double cross = sample.typical * std::exp2(-step / classes_per_octave);
    for (const double ratio : {0.4, 0.6, 0.9}) {
      const CellEdges edges{sample.run_axis, ratio * cross, cross};
      const double cells = cells_for(box, edges);
      if (cells > affordable) continue;
      const double cost = cost_of(sample, edges, layers, cells / nodes);
      if (cost < least) {
        least = cost;
        best = edges;
      }
    }
  }
  // Sparse: the nodes are few spots in a large box. Coarse cells then, each of which is divided by itself.
  if (!(least < std::numeric_limits<double>::infinity()))
    best = edges_for(box, sample.run_axis, nodes / 32.0 + 1.0);
  best.smallest_territory = sample.smallest;
  return best;
}

double measure_layers(const FinderInput& input, const TerritorySample& sample, const NodeGrid& grid,
                      const CellEdges& edges) {
  if (input.scene.participants() == 0 || input.scene.segments.count() == 0) return usual_layers;
  double expected = 0.0;
  for (const TerritorySize& size : sample.sizes())
    expected += size.weight * rows_of(size, edges) * single_run(size, edges);
  const Index segments = static_cast<Index>(input.scene.segments.count());
  const Index samples = samples_of(segments);
  Offset nodes = 0;
  Offset cells = 0;
  const auto count = [&](std::uint32_t first, std::uint32_t last) { nodes += last - first; };
  for (Index i = 0; i < samples; ++i)
    grid.visit(input.test.culling_box(sampled_segment(i, samples, segments)), cells, count);
  const double found = static_cast<double>(nodes) / samples;
  return expected > 0.0 && std::isfinite(expected) ? std::clamp(found / expected, 0.2, 20.0) : usual_layers;
}

}  // namespace cellsearch::production
