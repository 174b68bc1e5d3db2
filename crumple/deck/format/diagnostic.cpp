// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/diagnostic.hpp"

#include <fmt/core.h>

namespace crumple::deck {

namespace {

const char* word(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Note:
      return "note";
  }
  return "";
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  if (diagnostic.line <= 0)
    return fmt::format("{}: {}: {}", diagnostic.file, word(diagnostic.severity), diagnostic.message);
  return fmt::format("{}:{}: {}: {}", diagnostic.file, diagnostic.line, word(diagnostic.severity),
                     diagnostic.message);
}

}  // namespace crumple::deck
