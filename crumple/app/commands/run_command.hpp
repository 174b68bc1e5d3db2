// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple run`: reads a deck, runs it and writes the results. The folder of the results is not made before
/// the deck is known to be good.
ExitCode run_deck(const Options& options, const Console& console);

}  // namespace crumple::app
