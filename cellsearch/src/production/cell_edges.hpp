// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <span>

#include "finder.hpp"
#include "production/grid.hpp"
#include "production/node_grid.hpp"

namespace cellsearch::production {

/// Where nothing is known yet, see measure_layers().
inline constexpr double usual_layers = 2.0;

/// Territories of about one size.
struct TerritorySize {
  double weight = 0.0;   ///< share of the segments
  double along = 0.0;    ///< mean extent along the run axis [length]
  double across = 0.0;   ///< mean of the larger of the other extents [length]
  double spacing = 0.0;  ///< mean distance of nodes [length]
};

/// What a sample of the segments tells of the territories.
struct TerritorySample {
  static constexpr int classes = 96;

  std::array<TerritorySize, classes> of_size{};
  int found = 0;  ///< that many are not empty, and come first
  double largest = 0.0;
  double typical = 0.0;  ///< geometric mean
  double smallest = std::numeric_limits<double>::infinity();
  int run_axis = 0;  ///< along which the mesh is numbered

  std::span<const TerritorySize> sizes() const {
    return std::span(of_size).first(static_cast<std::size_t>(found));
  }
};

/// The same for any number of threads.
TerritorySample sample_territories(const FinderInput& input);

/// How many cells are always worth their memory for so many nodes.
double affordable_cells(Index nodes);

/// Cell edges for `nodes` nodes within `box`, so that the estimated time per segment is least: large cells
/// hold many nodes in vain, small ones make many rows, and empty ones cost memory. `layers`: see
/// measure_layers().
CellEdges choose_edges(const TerritorySample& sample, const Box& box, Index nodes, double layers);

/// How many times as many nodes there are around a territory as if it were part of a single flat sheet, from
/// a sample. `grid` has cells of these `edges`.
double measure_layers(const FinderInput& input, const TerritorySample& sample, const NodeGrid& grid,
                      const CellEdges& edges);

}  // namespace cellsearch::production
