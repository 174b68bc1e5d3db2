// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cellsearch/box.hpp"
#include "cellsearch/scene.hpp"
#include "cellsearch/search.hpp"

namespace cellsearch {

/// Throws Error(BadSetting) if a setting is out of its range. The domain is checked by CellGrid.
void check_settings(const Settings& settings);

/// Throws Error(BadSetting) if it is below 1.
void check_threads(int threads);

/// Throws Error(BadLayout) if the stride or the length does not fit. O(1).
void check_positions(const Positions& positions);

/// The error that names a node with a coordinate that is not finite.
[[noreturn]] void throw_bad_position(const Positions& positions, Index node);

/// What the checks of a scene learn on their way.
struct SceneSummary {
  Box nodes;                    ///< bounding box of the participants [length]; empty if there are none
  double mean_edge = 0.0;       ///< mean edge of the segments [length]; 0 without segments
  double largest_radius = 0.0;  ///< of the participants [length]; 0 without radii
};

/// The part of check_scene() that looks at no node and no segment: lengths of all spans, the stride, the
/// common expansion, the number of groups. O(1).
void check_layout(const Scene& scene);

/// Checks everything that ErrorKind names about a scene and throws on the first error. O(N).
SceneSummary check_scene(const Scene& scene, int threads);

}  // namespace cellsearch
