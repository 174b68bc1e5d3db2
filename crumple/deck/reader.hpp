// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The deck: from LS-DYNA's keyword text to model::Model. This folder alone knows the format, its numbers and
// its defaults; everything behind it sees the model only.
//
//     text      files, with those of *INCLUDE                        format/text_source.hpp
//      |        Scanner: keywords with their lines, $crumple lines   format/scanner.hpp
//     Block     one keyword
//      |        find_keyword(): the row of the registry              keywords/keywords.hpp
//      |        Cards: fields by their names, checked one by one     format/cards.hpp, format/field.hpp
//     RawDeck   what the cards say, in user ids                      format/raw_deck.hpp
//      |        build_model(): follows the ids, checks what belongs together
//     Model     in indices, complete; absent if there was an error   build/build.hpp
//
// The source of all fields is LS-DYNA's Keyword User's Manual. A table of fields (name, default, allowed
// values) is all that a reader needs to know of a card, and docs/keywords.md is made from the same tables.
//
// Faults never stop the reading: each becomes a Diagnostic with file, line, card and field, and all are
// reported at once (format/report.hpp). A keyword is read, or left out with a reason because it changes
// nothing that is computed (ignored_table()), or an error, unless --allow-unsupported leaves it out.
//
// Order of calls: read_deck() does all of it. read_recorded_deck() repeats it on the texts that a restart
// file holds, read_deck_text() on a text in memory.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/diagnostic.hpp"
#include "deck/format/parameters.hpp"
#include "deck/format/read_options.hpp"
#include "deck/format/recorded_source.hpp"
#include "model/model.hpp"

namespace crumple::deck {

/// Why a keyword was left out.
enum class Omission {
  Harmless,   ///< it does not change what is computed
  OnRequest,  ///< it does, and allow_unsupported leaves it out
  Refused,    ///< it does, and the deck is refused for it
};

/// A keyword that the reader left out, with the first place where it occurs.
struct IgnoredKeyword {
  std::string keyword;  ///< with its asterisk, upper case
  std::string file;
  int line = 0;
  int count = 0;  ///< how often it occurs
  Omission why = Omission::Harmless;
};

struct ReadResult {
  std::optional<model::Model> model;             ///< absent if there is any error
  std::vector<Diagnostic> diagnostics;           ///< sorted by file and line
  std::vector<std::filesystem::path> files;      ///< all files read, the deck itself first
  std::uint64_t text_hash = 0;                   ///< FNV-1a over all text, in the order it was read
  std::vector<SetParameter> parameters;          ///< that hold in the whole deck, by name
  std::vector<IgnoredKeyword> ignored_keywords;  ///< in order of first occurrence
  std::string unit_system;                       ///< guess, such as "t, mm, s"; empty if there is none
  std::vector<RecordedText> texts;               ///< of all files, if asked for
};

/// Reads an LS-DYNA keyword deck with everything it includes. Reports all faults at once and never throws
/// for the deck's content; a file that cannot be opened is a fault like any other.
ReadResult read_deck(const std::filesystem::path& deck, const ReadOptions& options = {});

/// The same for the texts of an earlier reading, whose names are those of then. `changes` names a deck of a
/// small restart, whose cards go before the earlier ones: only those that change when a run ends and what it
/// writes.
ReadResult read_recorded_deck(const std::vector<RecordedText>& texts, const ReadOptions& options,
                              const std::optional<std::filesystem::path>& changes = {});

/// The same for a deck held in memory. `included` maps the names that *INCLUDE may use to their text; the
/// file system is not touched.
ReadResult read_deck_text(std::string_view text, const ReadOptions& options = {},
                          const std::map<std::string, std::string>& included = {},
                          const std::string& name = "deck.k");

/// The text and the parameters that the command line sets: equal for equal decks. Equal to the hash of the
/// text where it sets none.
std::uint64_t hash_with_parameters(const ReadResult& deck);

/// How many errors the diagnostics stand for.
int error_count(const std::vector<Diagnostic>& diagnostics);

}  // namespace crumple::deck
