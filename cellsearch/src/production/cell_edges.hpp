// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "finder.hpp"
#include "production/grid.hpp"

namespace cellsearch::production {

/// Cell edges for `nodes` nodes within `box`, chosen from a sample of the territories so that the estimated
/// time per segment is least: large cells hold many nodes in vain, small ones make many rows, and empty ones
/// cost memory. The run axis is the one along which the mesh is numbered. The same for any number of threads.
CellEdges choose_edges(const FinderInput& input, const Box& box, Index nodes);

}  // namespace cellsearch::production
