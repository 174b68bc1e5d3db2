// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "app/arguments/compare_options.hpp"

namespace crumple::app {

/// Adds the arguments of the command to `command`, which writes them to `options`.
void add_compare_arguments(CLI::App& command, CompareOptions& options);

}  // namespace crumple::app
