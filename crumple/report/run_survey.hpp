// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "report/quantiser.hpp"
#include "report/result_folder.hpp"
#include "report/surface.hpp"
#include "report/vtu_reader.hpp"

namespace crumple::report {

/// A scalar that the report shows on the model: a number of each cell, or the length of a vector of each
/// node.
struct Field {
  std::string name;  ///< of the array in the frames
  bool by_node = false;
  Range range;  ///< of what is drawn, over the run
};

/// What must be known of a whole run before its first frame can be written.
struct RunSurvey {
  Surface surface;
  std::vector<std::int64_t> cell_types;  ///< of the surface's cells
  std::vector<Index> cell_death;         ///< of the surface's cells: first frame in which they have failed
  std::vector<Index> node_death;  ///< of the surface's nodes: from here on they belong to failed cells only
  std::array<Range, 3> box;       ///< of the nodes of living cells, over the run [length]
  std::vector<Field> fields;
  Index all_nodes = 0;  ///< of the frames
  Index all_cells = 0;
};

/// What the report tells while it works.
using Progress = std::function<void(const std::string& what, std::size_t done, std::size_t all)>;

/// Reads all frames once. Throws Error if one cannot be read or does not fit to the first.
RunSurvey survey_run(const ResultFolder& results, const Progress& progress);

/// The values of a field where the surface has its cells or nodes; not a number where the field has none.
std::vector<float> field_values(const VtuReader& frame, const RunSurvey& survey, const Field& field);

/// The positions of the surface's nodes along an axis [length].
std::vector<float> coordinates(const std::vector<float>& positions, const Surface& surface, int axis);

}  // namespace crumple::report
