// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"

namespace crumple::app {

/// `crumple report`: writes one HTML file that shows the result of a run.
ExitCode report_results(const ReportOptions& options, const Console& console);

/// Ends a command with the report of what it has left in a folder. Returns `code`, or Output if all went well
/// but the report.
ExitCode end_with_report(const std::filesystem::path& folder, bool quiet, ExitCode code,
                         const Console& console);

/// False, and the reason on the console, if the page to put results into cannot be found: to be asked before
/// a long run.
bool report_can_be_made(const ReportOptions& options, const Console& console);

}  // namespace crumple::app
