// SPDX-License-Identifier: BSD-3-Clause
#include "app/report_command.hpp"

#include <fmt/ostream.h>

#include <ostream>

#include "base/error.hpp"
#include "output/write_error.hpp"
#include "report/page.hpp"

namespace crumple::app {

namespace {

/// One line that is written over on a terminal; nothing elsewhere.
report::Progress progress_on(const Console& console, bool quiet) {
  return [&console, quiet](const std::string& what, std::size_t done, std::size_t all) {
    if (quiet || !console.terminal) return;
    fmt::print(console.out, "\r{}: frame {} of {}\x1b[K{}", what, done, all, done == all ? "\r\x1b[K" : "");
    console.out.flush();
  };
}

std::filesystem::path page_of(const ReportOptions& options) {
  return options.template_file.empty() ? report::find_template() : options.template_file;
}

}  // namespace

bool report_can_be_made(const ReportOptions& options, const Console& console) {
  try {
    const report::PageTemplate page(page_of(options));
    return true;
  } catch (const Error& fault) {
    fmt::print(console.err, "crumple: error: {}\n", fault.what());
    return false;
  }
}

ExitCode report_results(const ReportOptions& options, const Console& console) {
  const std::filesystem::path file = options.file.empty() ? options.folder / "report.html" : options.file;
  try {
    report::write_report(options.folder, page_of(options), file, progress_on(console, options.quiet));
    if (!options.quiet)
      fmt::print(console.out, "{}   {:.1f} MB, open in a browser\n", file.string(),
                 static_cast<double>(std::filesystem::file_size(file)) / 1e6);
    return ExitCode::Normal;
  } catch (const output::WriteError& fault) {
    fmt::print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Output;
  } catch (const Error& fault) {
    fmt::print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Input;
  }
}

}  // namespace crumple::app
