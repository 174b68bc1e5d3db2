// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/live_pages.hpp"

#include <chrono>
#include <ostream>
#include <system_error>
#include <thread>
#include <utility>

#include "app/console/print.hpp"
#include "app/session/stop_signals.hpp"
#include "base/error.hpp"
#include "live/folder_status.hpp"
#include "output/run_record.hpp"

namespace crumple::app {

live::RunStatus live_status(const domain::Domain& domain, const Progress& progress, int frames) {
  live::RunStatus status;
  status.state = live::RunState::Running;
  status.cycle = domain.clock.cycle;
  status.time = domain.clock.time;
  status.end_time = progress.end_time;
  status.frames = frames;
  if (progress.seconds_to_go >= 0) status.seconds_to_go = progress.seconds_to_go;
  status.nanoseconds_per_element_cycle = output::nanoseconds_per_element_cycle(domain, progress.seconds);
  return status;
}

std::unique_ptr<live::LivePage> open_live_page(const std::filesystem::path& folder,
                                               const std::filesystem::path& template_file,
                                               const LiveAddress& address,
                                               live::LivePage::StatusSource status, const Console& console) {
  try {
    const std::string token = address.token ? live::random_token() : std::string();
    const live::LiveFiles files{folder, template_file.empty() ? report::find_template() : template_file,
                                live::find_live_template()};
    auto page = std::make_unique<live::LivePage>(files, address.port, token, std::move(status));
    // Also when quiet: nobody knows port 0 otherwise.
    print(console.out, "Live page: {}\n", page->address());
    console.out.flush();
    return page;
  } catch (const Error& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return nullptr;
  }
}

ExitCode serve_results(const ReportOptions& options, const Console& console) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(options.folder, ignored)) {
    print(console.err, "crumple: error: {} is no folder; name that of a run's results.\n",
          options.folder.string());
    return ExitCode::Input;
  }
  const StopSignals signals;
  const auto status = [&options] { return live::folder_status(options.folder); };
  const auto page =
      open_live_page(options.folder, options.template_file, {*options.serve, options.token}, status, console);
  if (!page) return ExitCode::Usage;
  while (signals.received() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return ExitCode::Normal;
}

}  // namespace crumple::app
