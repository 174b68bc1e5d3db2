// SPDX-License-Identifier: BSD-3-Clause
// Any bytes at all come over a connection, in pieces of any size.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "live/http_request.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crumple::live;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const ParsedRequest whole = parse_request(bytes);
  // What is complete has a path that starts at the root, and no byte behind its head matters.
  if (whole.state == RequestState::Complete &&
      (!whole.request.path.starts_with('/') || whole.request.hosts < 0 || whole.request.method.empty()))
    std::abort();
  if (whole.state == RequestState::Incomplete && size >= longest_head) std::abort();
  if (size > 0) {
    const ParsedRequest before = parse_request(bytes.substr(0, size - 1));
    // An answer that was given holds, whatever comes after.
    if (before.state != RequestState::Incomplete && before.state != whole.state) std::abort();
  }
  return 0;
}
