// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/index.hpp"

namespace crumple::report {

/// Cells of a frame as VTK describes them, and when they fail.
struct CellList {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;  ///< end of each cell in the connectivity
  std::vector<std::int64_t> types;    ///< VTK's numbers
  std::vector<Index> death;  ///< first frame in which the cell has failed; the number of frames if none
};

/// Something to draw: a quadrilateral, a triangle (its last two nodes are the same) or a line (its last three
/// are). It shows as long as `cell` is alive and, if there is a cell `behind` it, that one has failed: a face
/// between two solids comes to light when one of them erodes.
struct Face {
  std::array<Index, 4> node{};
  Index cell = 0;
  Index behind = no_index;
};

/// What is seen of a model from outside at any time of the run.
struct Surface {
  std::vector<Face> faces;
  std::vector<Face> lines;   ///< beams and springs
  std::vector<Index> nodes;  ///< those that are drawn, ascending
  std::vector<Index> cells;  ///< those that own a face or are behind one, ascending
};

/// Shells as they are, outer faces of solids, inner ones that erosion exposes; springs without length are
/// left out. Nodes and cells of faces and lines are places in `nodes` and `cells`. `points` is the number of
/// nodes. Throws Error for cells that are none of ours.
Surface make_surface(const CellList& cells, Index points);

}  // namespace crumple::report
