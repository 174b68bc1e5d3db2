// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "output/paraview/vtu_file.hpp"
#include "output/paraview/wall_mesh.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// The rigid walls that have a shape, as surfaces for ParaView at any time of a run.
class ParaviewWalls {
 public:
  explicit ParaviewWalls(const View& view);

  /// There is nothing to show.
  bool empty() const { return meshes_.empty(); }

  /// The text of a `.vtu` file with all walls where they are now; the cell array `wall` has their ids.
  std::string text(const View& view);

 private:
  std::vector<std::pair<Index, WallMesh>> meshes_;  ///< with the place of the wall in the model
  VtuPacker packer_;
  std::vector<VtuArray> topology_;  ///< connectivity, offsets, types
  VtuArray wall_id_;
  Index points_ = 0;
  Index faces_ = 0;
};

}  // namespace crumple::output
