// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace crumple::live {

/// A request without its body, which no request that is answered has.
struct HttpRequest {
  std::string method;
  std::string path;  ///< as it was sent, up to a question mark
  std::string host;  ///< of the last Host header
  int hosts = 0;     ///< how many of those there are
};

enum class RequestState {
  Incomplete,  ///< its head has not come to its end
  Complete,
  Bad,      ///< it is none of HTTP/1
  TooLong,  ///< its head is longer than longest_head
};

/// Longest head that is read [bytes].
inline constexpr std::size_t longest_head = 8192;

struct ParsedRequest {
  RequestState state = RequestState::Incomplete;
  HttpRequest request;
};

/// Understands the head of a request of HTTP/1.0 or 1.1 (RFC 9112, 2 to 5) at the start of what has come so
/// far. For any bytes at all; time is linear in their number.
ParsedRequest parse_request(std::string_view bytes);

/// The head of an answer, with the headers that all of ours have.
std::string answer_head(int status, std::string_view type, std::size_t length);

}  // namespace crumple::live
