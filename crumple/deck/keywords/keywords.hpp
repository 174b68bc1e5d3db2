// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The keywords: one row for each in keyword_table(), one reader for each row, readers in one file per
// family.
//
//     *MAT_ELASTIC_TITLE                  name, found with or without _TITLE and _ID, or by number (*MAT_001)
//     $#     mid        ro         e
//              1    7.8e-9    2.1e+5      a Layout: a list of Field with name, type, default and check
//                                         |
//                            Cards::  reads a card against its layout; faults go to the report with file
//                                     and line, parameters (&name) are replaced
//                                         |
//                            Card::   values by name: card.real("RO")
//                                         |
//                                     RawDeck: what the deck says, with the place where it says so
//
// A reader follows no reference and judges one card at a time; build/ does the rest once the whole deck is
// known. Lines that no reader asks for are reported, so that nothing of a deck is lost in silence.
// ignored_table() lists the keywords that may be left out because they do not change what is computed, each
// with the reason; any other unknown one is an error, with the names nearest to it as a hint.
//
// Source: LS-DYNA Keyword User's Manual; docs/deck.md has the fields that are read and where we differ.
//
// Order of calls: find_keyword() for each block, then the reader of its row with the Cards of the block,
// then Cards::report_unread(). To add one: fields and a reader in a file of its family, a declaration in
// families.hpp, a row in keywords.cpp (of a material in material_keywords.cpp), a row in docs/deck.md.

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

/// A keyword, or all whose name begins with the words of `name` where `is_prefix`, that may be left out.
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

/// Of them the materials and equations of state.
std::span<const Keyword> material_keywords();

/// All keywords that may be left out.
std::span<const IgnoredRow> ignored_table();

/// A keyword that the scanner or the reader itself reads, with what it does; null for any other name.
const IgnoredRow* find_format_keyword(std::string_view name);

/// A name without the options that may stand anywhere and belong to no reader, numbers of materials with
/// three digits.
std::string canonical_name(std::string_view name);

/// Looks a name up (upper case, without asterisk); _TITLE and _ID are understood where the keyword has them,
/// materials may have their number with or without leading zeros, options may stand in any order.
std::optional<FoundKeyword> find_keyword(std::string_view name);

/// The row of a keyword that does not change what is computed; null for any other.
const IgnoredRow* find_ignored(std::string_view name);

}  // namespace crumple::deck
