// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "report/run_survey.hpp"

namespace crumple::report {

/// The page without a result, which the viewer's build makes.
class PageTemplate {
 public:
  /// Throws Error if the file cannot be read or is no template of ours.
  explicit PageTemplate(const std::filesystem::path& file);

  /// The page with the elements of a result.
  std::string with(std::string_view payload) const;

 private:
  std::string text_;
  std::size_t place_ = 0;  ///< where the elements go
};

/// One of the pages that the viewer's build makes.
struct ViewerPage {
  const char* file;      ///< its name
  const char* variable;  ///< environment variable that names another file
  const char* subject;   ///< what it shows, for messages: "report"
};

/// Looks for a page: in its environment variable, beside the program, in share/crumple beside the folder of
/// the program, where it is built. Throws Error that says how to build it.
std::filesystem::path find_page(const ViewerPage& page);

/// The page of reports.
std::filesystem::path find_template();

/// What a report shows.
struct ReportContent {
  std::size_t frames = 0;
  std::vector<std::string> fields;  ///< names by which the page knows its fringes
};

struct Report {
  std::string page;
  ReportContent content;
};

/// Makes the report of the results in a folder, which a run may still be adding to. Throws Error.
Report make_report(const std::filesystem::path& folder, const PageTemplate& page, const Progress& progress);

/// Writes the report of the results in a folder. Throws Error, or WriteError if the file cannot be written.
ReportContent write_report(const std::filesystem::path& folder, const std::filesystem::path& template_file,
                           const std::filesystem::path& file, const Progress& progress);

}  // namespace crumple::report
