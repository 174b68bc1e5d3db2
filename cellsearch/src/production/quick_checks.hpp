// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "cellsearch/instruction_set.hpp"
#include "checks.hpp"

namespace cellsearch::production {

/// What check_scene() finds out about a scene without errors and filters, but for the mean edge, in a
/// fraction of the time. Nothing if there may be an error, or if the scene has more to check: check_scene()
/// then has the last word. Calls check_layout().
std::optional<SceneSummary> quick_checks(const Scene& scene, InstructionSet set, int threads);

}  // namespace cellsearch::production
