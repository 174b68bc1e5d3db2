// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/core.h>

#include <ostream>
#include <utility>

namespace crumple::app {

/// As fmt::print to a stream, whose header has every file that includes it compile all of the formatting
/// anew.
template <class... Arguments>
void print(std::ostream& out, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  out << fmt::format(text, std::forward<Arguments>(arguments)...);
}

}  // namespace crumple::app
