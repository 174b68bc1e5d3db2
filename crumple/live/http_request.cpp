// SPDX-License-Identifier: BSD-3-Clause
#include "live/http_request.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace crumple::live {

namespace {

/// The line at the start, without its end; the rest keeps what follows.
std::string_view take_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// Length of the head with the empty line at its end; 0 if that has not come.
std::size_t head_length(std::string_view bytes) {
  for (std::size_t end = bytes.find('\n'); end != std::string_view::npos; end = bytes.find('\n', end + 1)) {
    const std::string_view behind = bytes.substr(end + 1, 2);
    if (behind.starts_with('\n')) return end + 2;
    if (behind == "\r\n") return end + 3;
  }
  return 0;
}

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char letter) { return letter == ' ' || letter == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_host(std::string_view name) {
  constexpr std::string_view host = "host";
  return std::equal(name.begin(), name.end(), host.begin(), host.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char letter) { return letter > ' ' && letter < 127; });
}

/// `GET /status HTTP/1.1`.
bool read_request_line(std::string_view line, HttpRequest& request) {
  const std::size_t first = line.find(' ');
  const std::size_t second = first == std::string_view::npos ? first : line.find(' ', first + 1);
  if (second == std::string_view::npos) return false;
  const std::string_view method = line.substr(0, first);
  const std::string_view target = line.substr(first + 1, second - first - 1);
  const std::string_view version = line.substr(second + 1);
  const bool is_word = !method.empty() && std::all_of(method.begin(), method.end(), [](char letter) {
    return letter >= 'A' && letter <= 'Z';
  });
  if (!is_word || !target.starts_with('/') || !is_printable(target)) return false;
  request.method = method;
  request.path = target.substr(0, target.find('?'));
  return version == "HTTP/1.1" || version == "HTTP/1.0";
}

const char* reason_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Internal Server Error";
  }
}

}  // namespace

ParsedRequest parse_request(std::string_view bytes) {
  ParsedRequest parsed;
  const std::size_t length = head_length(bytes.substr(0, longest_head));
  if (length == 0) {
    parsed.state = bytes.size() >= longest_head ? RequestState::TooLong : RequestState::Incomplete;
    return parsed;
  }
  std::string_view head = bytes.substr(0, length);
  parsed.state = RequestState::Bad;
  if (!read_request_line(take_line(head), parsed.request)) return parsed;
  while (!head.empty()) {
    const std::string_view line = take_line(head);
    if (line.empty()) break;
    const std::size_t colon = line.find(':');
    // Lines that go on are obsolete, and a name that ends in a blank has been used to smuggle requests.
    if (colon == std::string_view::npos || !is_printable(line.substr(0, colon))) return parsed;
    if (!is_host(line.substr(0, colon))) continue;
    parsed.request.host = trimmed(line.substr(colon + 1));
    ++parsed.request.hosts;
  }
  parsed.state = RequestState::Complete;
  return parsed;
}

std::string answer_head(int status, std::string_view type, std::size_t length) {
  return fmt::format(
      "HTTP/1.1 {} {}\r\n"
      "Content-Type: {}\r\n"
      "Content-Length: {}\r\n"
      "Connection: close\r\n"
      "Cache-Control: no-store\r\n"
      "X-Content-Type-Options: nosniff\r\n"
      "Referrer-Policy: no-referrer\r\n"
      "Cross-Origin-Resource-Policy: same-origin\r\n"
      "Content-Security-Policy: frame-ancestors 'self'\r\n\r\n",
      status, reason_of(status), type, length);
}

}  // namespace crumple::live
