// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "finder.hpp"
#include "production/grid.hpp"
#include "production/node_grid.hpp"

namespace cellsearch::production {

/// Where nothing is known yet, see measure_layers().
inline constexpr double usual_layers = 2.0;

/// Cell edges for `nodes` nodes within `box`, chosen from a sample of the territories so that the estimated
/// time per segment is least: large cells hold many nodes in vain, small ones make many rows, and empty ones
/// cost memory. The run axis is the one along which the mesh is numbered. `layers`: see measure_layers(). The
/// same for any number of threads.
CellEdges choose_edges(const FinderInput& input, const Box& box, Index nodes, double layers);

/// How many times as many nodes there are around a territory as if it were part of a single flat sheet, from
/// a sample. `grid` has cells of these `edges`.
double measure_layers(const FinderInput& input, const NodeGrid& grid, const CellEdges& edges);

}  // namespace cellsearch::production
