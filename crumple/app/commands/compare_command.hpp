// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/arguments/compare_options.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple compare`: rates the histories of two results against each other.
ExitCode compare_results(const CompareOptions& options, const Console& console);

}  // namespace crumple::app
