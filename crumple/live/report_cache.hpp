// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "live/run_status.hpp"
#include "report/page.hpp"

namespace crumple::live {

/// The report of a folder that a run is still writing to, made anew only when there is more to show.
class ReportCache {
 public:
  /// Throws Error if the template cannot be read.
  ReportCache(std::filesystem::path folder, const std::filesystem::path& template_file);

  /// The page of the frames so far, of which there must be one; read by the calling thread. Callers at the
  /// same time wait for one another. Given up, with an Error, soon after `ending` has become true. Throws
  /// Error.
  std::shared_ptr<const std::string> page(const RunStatus& status, const std::atomic<bool>& ending);

 private:
  std::filesystem::path folder_;
  report::PageTemplate template_;
  std::mutex mutex_;
  std::shared_ptr<const std::string> page_;
  int frames_ = 0;      ///< of which page_ knows
  bool ended_ = false;  ///< page_ is of the finished run
};

}  // namespace crumple::live
