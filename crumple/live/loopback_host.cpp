// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "live/http_server.hpp"

namespace crumple::live {

bool is_loopback_host(std::string_view host) {
  constexpr std::array<std::string_view, 3> names{"127.0.0.1", "localhost", "[::1]"};
  for (const std::string_view name : names) {
    if (!host.starts_with(name)) continue;
    const std::string_view port = host.substr(name.size());
    if (port.empty()) return true;
    if (port.front() != ':' || port.size() < 2 || port.size() > 6) return false;
    return std::all_of(port.begin() + 1, port.end(), [](char digit) { return digit >= '0' && digit <= '9'; });
  }
  return false;
}

}  // namespace crumple::live
