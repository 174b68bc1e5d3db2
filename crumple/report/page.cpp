// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "output/files/atomic_file.hpp"
#include "report/payload.hpp"
#include "report/text_file.hpp"

namespace crumple::report {

namespace {

constexpr std::string_view mark = "<!-- crumple-data -->";

}  // namespace

PageTemplate::PageTemplate(const std::filesystem::path& file)
    : text_(read_file(file)), place_(text_.find(mark)) {
  if (place_ == std::string::npos || text_.find(mark, place_ + 1) != std::string::npos)
    throw Error(fmt::format("{} is no template of a report: it must hold {} once.", file.string(), mark));
}

std::string PageTemplate::with(std::string_view payload) const {
  std::string page;
  page.reserve(text_.size() + payload.size());
  page.append(text_, 0, place_).append(payload).append(text_, place_ + mark.size());
  return page;
}

std::filesystem::path find_page(const ViewerPage& page) {
  if (const char* named = std::getenv(page.variable); named != nullptr && *named != '\0') return named;
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::vector<std::filesystem::path> places = {program / page.file,
                                                     program.parent_path() / "share" / "crumple" / page.file,
                                                     std::filesystem::path(CRUMPLE_BUILT_PAGES) / page.file};
  for (const std::filesystem::path& place : places)
    if (std::filesystem::is_regular_file(place, ignored)) return place;
  throw Error(
      fmt::format("The {}'s template is missing. In the folder of crumple's source, \"make build\" builds it "
                  "(with nodejs and npm); {}=FILE or --template FILE names one that lies elsewhere.",
                  page.subject, page.variable));
}

std::filesystem::path find_template() {
  return find_page({"report_template.html", "CRUMPLE_REPORT_TEMPLATE", "report"});
}

Report make_report(const std::filesystem::path& folder, const PageTemplate& page, const Progress& progress) {
  const ResultFolder results = open_results(folder);
  const RunSurvey survey = survey_run(results, progress);
  // The page finds displacements by itself.
  Report report{
      page.with(make_payload(results, survey, progress)),
      {results.frames.size(), {"displacement", "displacement_x", "displacement_y", "displacement_z"}}};
  for (const Field& field : survey.fields) report.content.fields.push_back(field.name);
  return report;
}

ReportContent write_report(const std::filesystem::path& folder, const std::filesystem::path& template_file,
                           const std::filesystem::path& file, const Progress& progress) {
  Report report = make_report(folder, PageTemplate(template_file), progress);
  output::write_atomically(file, report.page);
  return std::move(report.content);
}

}  // namespace crumple::report
