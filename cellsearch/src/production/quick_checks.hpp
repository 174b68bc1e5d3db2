// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cellsearch/instruction_set.hpp"
#include "checks.hpp"

namespace cellsearch::production {

/// True if all is well with a scene but for its coordinates, which are not looked at, in a fraction of the
/// time of check_scene(). False if there may be an error, or if the scene has more to check: check_scene()
/// then has the last word. Calls check_layout().
bool quick_checks(const Scene& scene, InstructionSet set, int threads);

}  // namespace cellsearch::production
