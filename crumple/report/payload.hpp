// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "report/result_folder.hpp"
#include "report/run_survey.hpp"

namespace crumple::report {

/// All that the page shows of a run, as elements of HTML: a JSON description (`crumple-meta`) and packed
/// arrays
/// (`crumple-data-NAME`), which the JSON names. docs/report.md has the format. Throws Error.
std::string make_payload(const ResultFolder& results, const RunSurvey& survey, const Progress& progress);

}  // namespace crumple::report
