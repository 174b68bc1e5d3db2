// SPDX-License-Identifier: BSD-3-Clause
#include "live/folder_status.hpp"

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "report/result_folder.hpp"
#include "report/text_file.hpp"

namespace crumple::live {

RunStatus folder_status(const std::filesystem::path& folder) {
  RunStatus status;
  try {
    const report::ResultFolder results = report::open_results(folder);
    status.state = RunState::Running;
    status.frames = static_cast<int>(results.frames.size());
    status.time = results.frames.back().time;
    if (!results.has_record) return status;
    const auto record = nlohmann::json::parse(report::read_file(results.folder / "run.json"));
    status.end_time = record.at("end_time");
    status.cycle = record.at("cycles");
    if (const auto& speed = record.at("ns_per_element_cycle"); !speed.is_null())
      status.nanoseconds_per_element_cycle = speed;
    status.termination = record.at("termination");
    status.state = RunState::Ended;
  } catch (const std::exception&) {
    // A run may replace any of the files just now: what was read before holds until the next look.
    return status;
  }
  return status;
}

}  // namespace crumple::live
