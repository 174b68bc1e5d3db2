// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple scatter`: runs a deck several times with nodes moved a little, each run in a process of its own
/// on one thread, `options.threads` of them at a time, and writes the band in which each history lies.
ExitCode scatter_deck(const Options& options, const Console& console);

}  // namespace crumple::app
