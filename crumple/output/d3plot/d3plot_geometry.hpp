// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "output/d3plot/d3plot_words.hpp"
#include "output/results/view.hpp"

namespace crumple::output {

/// Numbers per state and rigid wall: force and place.
inline constexpr int d3plot_wall_values = 4;

/// What the first file of a d3plot family holds: control block, nodes and elements at time zero, the user's
/// numbers, titles. Springs are beams there. `run_time` is the date of the run in seconds since 1970. Throws
/// WriteError if a number of the user has more than 32 bits.
D3plotWords d3plot_geometry(const View& view, std::int64_t run_time);

}  // namespace crumple::output
