// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple bench`: measures this machine in about a minute, the time step of every shell formulation and
/// every method of the contact search. Writes no file.
ExitCode bench_machine(const Options& options, const Console& console);

}  // namespace crumple::app
