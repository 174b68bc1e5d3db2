// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "app/arguments/command_line.hpp"
#include "app/console/console.hpp"
#include "app/console/exit_code.hpp"
#include "app/session/status_line.hpp"
#include "domain/domain.hpp"
#include "live/live_page.hpp"

namespace crumple::app {

/// What the live page of a run tells. `frames`: written so far.
live::RunStatus live_status(const domain::Domain& domain, const Progress& progress, int frames);

/// Where a live page is shown on this machine.
struct LiveAddress {
  int port = 0;  ///< 0 is any free one
  bool token = true;
};

/// Starts to serve a folder, and prints where. Null, and the reason on the console, if the port is taken, or
/// the pages are missing from this build. An empty `template_file` looks for the page of the
/// build.
std::unique_ptr<live::LivePage> open_live_page(const std::filesystem::path& folder,
                                               const std::filesystem::path& template_file,
                                               const LiveAddress& address,
                                               live::LivePage::StatusSource status, const Console& console);

/// `crumple report DIR --serve`: shows a folder until Ctrl-C.
ExitCode serve_results(const ReportOptions& options, const Console& console);

}  // namespace crumple::app
