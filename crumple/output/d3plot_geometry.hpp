// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "output/d3plot_words.hpp"
#include "output/view.hpp"

namespace crumple::output {

// Numbers per element in a d3plot state.
inline constexpr int d3plot_solid_values = 7;  ///< stress, plastic strain
inline constexpr int d3plot_beam_values = 6;   ///< resultants
inline constexpr int d3plot_shell_layers = 3;  ///< middle, inner and outer surface
inline constexpr int d3plot_shell_values =
    33;  ///< 7 for each layer, 8 resultants, thickness, 2 spare, energy
/// Numbers per state and rigid wall: force and place.
inline constexpr int d3plot_wall_values = 4;

/// What the first file of a d3plot family holds: control block, nodes and elements at time zero, the user's
/// numbers, titles. Springs are beams there. `run_time` is the date of the run in seconds since 1970. Throws
/// WriteError if a number of the user has more than 32 bits.
D3plotWords d3plot_geometry(const View& view, std::int64_t run_time);

}  // namespace crumple::output
