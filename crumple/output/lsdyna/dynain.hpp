// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "output/results/view.hpp"

namespace crumple::output {

/// What a dynain file is to hold.
struct DynainRequest {
  model::SpringbackRequest springback;  ///< shells and solids of these parts, and supports
  bool all = false;                     ///< of all parts, with all nodes of the model
  bool velocities = false;              ///< of these nodes, at time n

  bool wanted() const { return all || !springback.parts.empty(); }
};

/// A keyword file that begins another run with the nodes, the elements, and the stresses, plastic strains and
/// thicknesses of this one (docs/theory/initial_stress.md), and sentences on what it lacks.
struct Dynain {
  std::string text;
  std::vector<std::string> notes;
};
Dynain dynain_of(const View& view, const DynainRequest& request);

inline constexpr const char* dynain_name = "dynain";
/// What its first line begins with.
inline constexpr std::string_view dynain_mark = "$ crumple: the state";

/// A number with as many digits as fit into the columns, 17 at most.
std::string number_in_columns(double value, std::size_t columns);

}  // namespace crumple::output
