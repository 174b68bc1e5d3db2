// SPDX-License-Identifier: BSD-3-Clause
#include "live/run_status.hpp"

#include <nlohmann/json.hpp>

namespace crumple::live {

namespace {

using Json = nlohmann::ordered_json;

const char* state_name(RunState state) {
  switch (state) {
    case RunState::Starting:
      return "starting";
    case RunState::Running:
      return "running";
    case RunState::Ended:
      break;
  }
  return "ended";
}

Json known(bool is_known, double value) {
  return is_known ? Json(value) : Json();
}

}  // namespace

void StatusBoard::post(const RunStatus& status) {
  const std::lock_guard lock(mutex_);
  status_ = status;
}

void StatusBoard::end(const std::string& termination) {
  const std::lock_guard lock(mutex_);
  status_.state = RunState::Ended;
  status_.termination = termination;
}

RunStatus StatusBoard::read() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::string status_json(const RunStatus& status) {
  const Json json = {{"state", state_name(status.state)},
                     {"termination", status.termination.empty() ? Json() : Json(status.termination)},
                     {"cycle", status.cycle},
                     {"time", status.time},
                     {"end_time", known(status.end_time > 0, status.end_time)},
                     {"frames", status.frames},
                     {"seconds_to_go", known(status.seconds_to_go >= 0, status.seconds_to_go)},
                     {"ns_per_element_cycle",
                      known(status.nanoseconds_per_element_cycle > 0, status.nanoseconds_per_element_cycle)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace crumple::live
