// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "live/http_server.hpp"
#include "live/report_cache.hpp"
#include "live/run_status.hpp"

namespace crumple::live {

/// Where the results and the pages lie.
struct LiveFiles {
  std::filesystem::path folder;           ///< of the results; need not be there yet
  std::filesystem::path report_template;  ///< page of reports
  std::filesystem::path live_template;    ///< page around it, which asks for the status
};

/// A result in the browser while it grows: the page around at "/", the status at "/status", the report of the
/// frames so far at "/report". All of it happens in the server's threads; the results are only read.
class LivePage {
 public:
  /// Called by the server's threads, several at a time; must not throw.
  using StatusSource = std::function<RunStatus()>;

  /// Serves from here on; see HttpServer for the port. `token` is the first folder of all paths, so that
  /// other users of this machine, who do not know it, get nothing; without one, if it is empty, they can read
  /// along. Throws Error.
  LivePage(const LiveFiles& files, int port, const std::string& token, StatusSource status);
  /// Ends within about a second, also while a report is made.
  ~LivePage();
  LivePage(const LivePage&) = delete;
  LivePage& operator=(const LivePage&) = delete;

  /// "http://127.0.0.1:8000/0f...3a/".
  std::string address() const;

  /// Gives pages that are open the time to get the end of the run: returns when none has asked for anything
  /// for a moment, at once if none is open, and after half a minute in any case; after a second `in_haste`.
  void wait_for_readers(bool in_haste) const;

 private:
  using Clock = std::chrono::steady_clock;

  Answer answer(const std::string& path);
  bool is_allowed(std::string_view path) const;
  Answer report();
  void note_request(int begun);

  std::string root_;  ///< of all paths, with a slash at both ends
  StatusSource status_;
  std::shared_ptr<const std::string> frame_page_;
  ReportCache reports_;
  mutable std::mutex mutex_;
  Clock::time_point last_request_;
  int open_requests_ = 0;
  std::atomic<bool> ending_ = false;
  HttpServer server_;  ///< the last one: its threads use the others
};

/// 32 random hexadecimal digits. Throws Error.
std::string random_token();

/// The page around the report, as the viewer's build makes it. Throws Error that says how to build it.
std::filesystem::path find_live_template();

}  // namespace crumple::live
