// SPDX-License-Identifier: BSD-3-Clause
#include "live/report_cache.hpp"

#include <utility>

#include "base/error.hpp"

namespace crumple::live {

ReportCache::ReportCache(std::filesystem::path folder, const std::filesystem::path& template_file)
    : folder_(std::move(folder)), template_(template_file) {}

std::shared_ptr<const std::string> ReportCache::page(const RunStatus& status,
                                                     const std::atomic<bool>& ending) {
  const std::lock_guard lock(mutex_);
  const bool ended = status.state == RunState::Ended;
  if (page_ && status.frames <= frames_ && ended == ended_) return page_;
  const auto silent = [&ending](const std::string& /*what*/, std::size_t /*done*/, std::size_t /*all*/) {
    if (ending) throw Error("The page is closed.");
  };
  report::Report made = report::make_report(folder_, template_, silent);
  page_ = std::make_shared<const std::string>(std::move(made.page));
  frames_ = static_cast<int>(made.content.frames);
  ended_ = ended;
  return page_;
}

}  // namespace crumple::live
