// SPDX-License-Identifier: BSD-3-Clause
// Any text at all is an expression of *PARAMETER_EXPRESSION: a number or a sentence.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "deck/format/expression.hpp"
#include "deck/format/numbers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crumple::deck;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Evaluated result = evaluate(text, [](std::string_view name) -> std::optional<Number> {
    if (name == "A") return Number{2.5, false};
    if (name == "N") return Number{7, true};
    return std::nullopt;
  });
  // No number that is none gets through.
  if (result.fault.empty() && !(result.number.value >= -1.8e308 && result.number.value <= 1.8e308))
    std::abort();
  parse_real(text);
  parse_integer(text);
  return 0;
}
