// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <string>

namespace crumple::live {

enum class RunState { Starting, Running, Ended };

/// How far a run is.
struct RunStatus {
  RunState state = RunState::Starting;
  std::string termination;  ///< "normal", "error" or "interrupted"; empty before the end
  long cycle = 0;
  double time = 0;                           ///< [time]
  double end_time = 0;                       ///< 0 if it is not known [time]
  int frames = 0;                            ///< that are whole and listed
  double seconds_to_go = -1;                 ///< negative if it is not known [s]
  double nanoseconds_per_element_cycle = 0;  ///< 0 if it is not known [ns]
};

/// Where the run's thread leaves its status for those that look on. Every function may be called by any
/// thread.
class StatusBoard {
 public:
  void post(const RunStatus& status);
  /// The run is over; what else was posted last stays.
  void end(const std::string& termination);
  RunStatus read() const;

 private:
  mutable std::mutex mutex_;
  RunStatus status_;
};

/// One object of JSON, which the page reads (viewer/src/live/status.ts). What is not known is null.
std::string status_json(const RunStatus& status);

}  // namespace crumple::live
