// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The spellings that one keyword may have.

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace crumple::deck {

/// `MAT_3` and `MAT_03` are MAT_003, and likewise of EOS.
inline std::string with_three_digits(std::string_view name) {
  constexpr std::string_view prefix = "MAT_";
  if (!name.starts_with(prefix) && !name.starts_with("EOS_")) return std::string(name);
  std::string_view rest = name.substr(prefix.size());
  std::size_t digits = 0;
  while (digits < rest.size() && rest[digits] >= '0' && rest[digits] <= '9') ++digits;
  if (digits == 0 || digits >= 3 || (digits < rest.size() && rest[digits] != '_')) return std::string(name);
  return fmt::format("{}{:0>3}{}", name.substr(0, prefix.size()), rest.substr(0, digits),
                     rest.substr(digits));
}

/// An option that may stand anywhere in a name, taken out.
inline std::string without_option(std::string name, std::string_view family, std::string_view option) {
  const std::size_t at = name.starts_with(family) ? name.find(option) : std::string::npos;
  const bool is_option =
      at != std::string::npos && (at + option.size() == name.size() || name[at + option.size()] == '_');
  return is_option ? name.erase(at, option.size()) : name;
}

/// The words of a name, those behind the first two sorted: options stand in any order. "NODES_TO_SURFACE" is
/// one.
inline std::vector<std::string> words_in_order(std::string_view name) {
  std::vector<std::string> words;
  bool goes_on = false;
  for (std::size_t start = 0; start <= name.size();) {
    const std::size_t end = std::min(name.find('_', start), name.size());
    const std::string word(name.substr(start, end - start));
    if (goes_on || (word == "TO" && !words.empty()))
      words.back() += "_" + word;
    else
      words.push_back(word);
    goes_on = word == "TO";
    start = end + 1;
  }
  if (words.size() > 2) std::sort(words.begin() + 2, words.end());
  return words;
}

}  // namespace crumple::deck
