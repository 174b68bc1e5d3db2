// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "base/error.hpp"
#include "output/atomic_file.hpp"
#include "report/payload.hpp"
#include "report/text_file.hpp"

namespace crumple::report {

namespace {

constexpr std::string_view mark = "<!-- crumple-data -->";
constexpr const char* file_name = "report_template.html";

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

std::filesystem::path find_template() {
  if (const char* named = std::getenv("CRUMPLE_REPORT_TEMPLATE"); named != nullptr && *named != '\0')
    return named;
  std::error_code ignored;
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::vector<std::filesystem::path> places = {
      program / file_name, program.parent_path() / "share" / "crumple" / file_name, CRUMPLE_BUILT_TEMPLATE};
  for (const std::filesystem::path& place : places)
    if (std::filesystem::is_regular_file(place, ignored)) return place;
  throw Error(
      "The report's template is missing. In the folder of crumple's source, \"make build\" builds it (with "
      "nodejs "
      "and npm); CRUMPLE_REPORT_TEMPLATE=FILE or --template FILE names one that lies elsewhere.");
}

ReportContent write_report(const std::filesystem::path& folder, const std::filesystem::path& template_file,
                           const std::filesystem::path& file, const Progress& progress) {
  const PageTemplate page(template_file);
  const ResultFolder results = open_results(folder);
  const RunSurvey survey = survey_run(results, progress);
  output::write_atomically(file, page.with(make_payload(results, survey, progress)));
  // The page finds displacements by itself.
  ReportContent content{results.frames.size(),
                        {"displacement", "displacement_x", "displacement_y", "displacement_z"}};
  for (const Field& field : survey.fields) content.fields.push_back(field.name);
  return content;
}

}  // namespace crumple::report
