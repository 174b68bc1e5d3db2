// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

/// A keyword that is read: a row of the registry.
struct Keyword {
  std::string_view name;
  KeywordReader read;
  HeadingKind heading = HeadingKind::None;  ///< what the _TITLE and _ID forms of the keyword add
  bool repeats = true;                      ///< false: a second one replaces the first, with a warning
};

/// A keyword, or all that start with `name` where `is_prefix`, that may be left out.
struct IgnoredRow {
  std::string_view name;
  bool is_prefix;
  std::string_view reason;
};

/// A registered keyword and the form in which the deck has it.
struct FoundKeyword {
  const Keyword* keyword;
  HeadingKind heading;
};

/// All keywords that are read.
std::span<const Keyword> keyword_table();

/// All keywords that may be left out.
std::span<const IgnoredRow> ignored_table();

/// Looks a name up (upper case, without asterisk); _TITLE and _ID are understood where the keyword has them,
/// materials may have their number with or without leading zeros.
std::optional<FoundKeyword> find_keyword(std::string_view name);

/// The row of a keyword that does not change what is computed; null for any other.
const IgnoredRow* find_ignored(std::string_view name);

/// Names of the supported keywords nearest to one that is not, for the hint; may be empty.
std::string related_keywords(std::string_view name);

}  // namespace crumple::deck
