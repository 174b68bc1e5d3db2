// SPDX-License-Identifier: BSD-3-Clause
#include "app/commands/report_command.hpp"

#include <algorithm>
#include <ostream>

#include "app/commands/report_pictures.hpp"
#include "app/console/print.hpp"
#include "app/session/live_pages.hpp"
#include "base/error.hpp"
#include "output/files/write_error.hpp"
#include "report/page.hpp"

namespace crumple::app {

namespace {

/// One line that is written over on a terminal; nothing elsewhere.
report::Progress progress_on(const Console& console, bool quiet) {
  return [&console, quiet](const std::string& what, std::size_t done, std::size_t all) {
    if (quiet || !console.terminal) return;
    print(console.out, "\r{}: frame {} of {}\x1b[K{}", what, done, all, done == all ? "\r\x1b[K" : "");
    console.out.flush();
  };
}

std::filesystem::path page_of(const ReportOptions& options) {
  return options.template_file.empty() ? report::find_template() : options.template_file;
}

ExitCode draw(const std::filesystem::path& file, const ReportOptions& options,
              const report::ReportContent& content, const Console& console) {
  PictureOptions pictures = options.pictures;
  if (pictures.field == "none") pictures.field = "";
  const auto& known = content.fields;
  if (pictures.field && !pictures.field->empty() &&
      std::find(known.begin(), known.end(), *pictures.field) == known.end()) {
    std::string names = "none";
    for (const std::string& name : known) names += ", " + name;
    print(console.err, "crumple: error: There is no field {}; there are {}.\n", *pictures.field, names);
    return ExitCode::Usage;
  }
  for (const std::filesystem::path& picture : draw_pictures(file, pictures))
    if (!options.quiet) print(console.out, "{}\n", picture.string());
  return ExitCode::Normal;
}

}  // namespace

bool report_can_be_made(const ReportOptions& options, const Console& console) {
  try {
    const report::PageTemplate page(page_of(options));
    return true;
  } catch (const Error& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return false;
  }
}

ExitCode end_with_report(const std::filesystem::path& folder, bool quiet, ExitCode code,
                         const Console& console) {
  ReportOptions report;
  report.folder = folder;
  report.quiet = quiet;
  const bool written = report_results(report, console) == ExitCode::Normal;
  return written || code != ExitCode::Normal ? code : ExitCode::Output;
}

ExitCode report_results(const ReportOptions& options, const Console& console) {
  if (options.serve) return serve_results(options, console);
  const std::filesystem::path file = options.file.empty() ? options.folder / "report.html" : options.file;
  try {
    if (options.pictures.wanted) find_browser();
    const report::ReportContent content =
        report::write_report(options.folder, page_of(options), file, progress_on(console, options.quiet));
    if (!options.quiet)
      print(console.out, "{}   {:.1f} MB, open in a browser\n", file.string(),
            static_cast<double>(std::filesystem::file_size(file)) / 1e6);
    return options.pictures.wanted ? draw(file, options, content, console) : ExitCode::Normal;
  } catch (const output::WriteError& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Output;
  } catch (const Error& fault) {
    print(console.err, "crumple: error: {}\n", fault.what());
    return ExitCode::Input;
  }
}

}  // namespace crumple::app
