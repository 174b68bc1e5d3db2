// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple check`: reads a deck and tells what it holds and what is wrong with it. Writes no file.
/// Normal if it can be run.
ExitCode check_deck(const Options& options, const Console& console);

}  // namespace crumple::app
