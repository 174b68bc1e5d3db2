// SPDX-License-Identifier: BSD-3-Clause
#include "live/live_page.hpp"

#include <fmt/core.h>
#include <sys/random.h>

#include <array>
#include <cstdint>
#include <exception>
#include <thread>
#include <utility>

#include "base/error.hpp"
#include "report/text_file.hpp"

namespace crumple::live {

namespace {

using std::chrono::milliseconds;

/// A page asks about once a second.
constexpr milliseconds still_open{2500};
constexpr milliseconds longest_wait{30000};
constexpr milliseconds longest_haste{800};

Answer text_answer(int status, std::string text) {
  return {status, "text/plain; charset=utf-8", std::make_shared<const std::string>(std::move(text))};
}

}  // namespace

LivePage::LivePage(const LiveFiles& files, int port, const std::string& token, StatusSource status)
    : root_(token.empty() ? "/" : "/" + token + "/"),
      status_(std::move(status)),
      frame_page_(std::make_shared<const std::string>(report::read_file(files.live_template))),
      reports_(files.folder, files.report_template),
      last_request_(Clock::now() - still_open),
      server_(port, [this](const std::string& path) {
        if (!is_allowed(path))
          return text_answer(403, "The address of the page is the one that crumple has printed.\n");
        note_request(+1);
        Answer made = answer(path.substr(root_.size() - 1));
        note_request(-1);
        return made;
      }) {}

LivePage::~LivePage() {
  ending_ = true;
}

std::string LivePage::address() const {
  return fmt::format("http://127.0.0.1:{}{}", server_.port(), root_);
}

/// The time that this takes does not tell how much of a token is right.
bool LivePage::is_allowed(std::string_view path) const {
  if (path.size() < root_.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < root_.size(); ++i)
    difference |=
        static_cast<unsigned char>(path[i]) ^ static_cast<unsigned>(static_cast<unsigned char>(root_[i]));
  return difference == 0;
}

void LivePage::note_request(int begun) {
  const std::lock_guard lock(mutex_);
  last_request_ = Clock::now();
  open_requests_ += begun;
}

Answer LivePage::answer(const std::string& path) {
  if (path == "/") return {200, "text/html; charset=utf-8", frame_page_};
  if (path == "/status")
    return {200, "application/json", std::make_shared<const std::string>(status_json(status_()))};
  if (path == "/report") return report();
  return text_answer(404, "There are /, /status and /report.\n");
}

Answer LivePage::report() {
  const RunStatus status = status_();
  if (status.frames == 0) return text_answer(503, "There is no frame yet.\n");
  try {
    return {200, "text/html; charset=utf-8", reports_.page(status, ending_)};
  } catch (const std::exception& fault) {
    return text_answer(500, std::string(fault.what()) + "\n");
  }
}

void LivePage::wait_for_readers(bool in_haste) const {
  const auto has_readers = [this] {
    const std::lock_guard lock(mutex_);
    return open_requests_ > 0 || Clock::now() - last_request_ < still_open;
  };
  const Clock::time_point start = Clock::now();
  const milliseconds longest = in_haste ? longest_haste : longest_wait;
  while (has_readers() && Clock::now() - start < longest) std::this_thread::sleep_for(milliseconds(20));
}

std::string random_token() {
  std::array<std::uint8_t, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw Error("There are no random numbers for the address of the live page.");
  std::string token;
  for (const std::uint8_t byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

std::filesystem::path find_live_template() {
  return report::find_page({"live_template.html", "CRUMPLE_LIVE_TEMPLATE", "live page"});
}

}  // namespace crumple::live
