// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// The whole program. `arguments` are those behind the program's name. Throws nothing: faults are told on
/// `console.err`.
ExitCode run_program(const std::vector<std::string>& arguments, const Console& console);

}  // namespace crumple::app
