// SPDX-License-Identifier: BSD-3-Clause
// Any bytes at all are a deck: the reader must answer with a model or with errors, and never crash.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>

#include "deck/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crumple;
  const std::string text(reinterpret_cast<const char*>(data), size);
  // The first byte chooses the options; the second half of the text is also a file to include.
  deck::ReadOptions options;
  options.allow_unsupported = size > 0 && (data[0] & 1U) != 0;
  options.automatic_contact = size > 0 && (data[0] & 2U) != 0;
  const std::map<std::string, std::string> included = {{"a.k", text.substr(text.size() / 2)}};
  const deck::ReadResult result = deck::read_deck_text(text, options, included);
  const bool has_errors = deck::error_count(result.diagnostics) > 0;
  // Exactly one of the two, and a model that keeps its promises.
  if (result.model.has_value() == has_errors) std::abort();
  if (result.model && !model::faults(*result.model).empty()) std::abort();
  return 0;
}
