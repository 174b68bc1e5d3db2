// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/command_line.hpp"
#include "app/console.hpp"
#include "app/exit_code.hpp"

namespace crumple::app {

/// `crumple report`: writes one HTML file that shows the result of a run.
ExitCode report_results(const ReportOptions& options, const Console& console);

}  // namespace crumple::app
