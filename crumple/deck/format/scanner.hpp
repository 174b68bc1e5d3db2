// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/block.hpp"
#include "deck/format/report.hpp"
#include "deck/format/text_source.hpp"

namespace crumple::deck {

/// A file that *INCLUDE_TRANSFORM names, and what its ids and coordinates become.
struct Inclusion {
  std::string name;
  Where where;
  const Placement* placement;  ///< of what stands in the file; lives as long as the scanner
};

/// What the scanner finds, in the order in which it stands in the deck.
class DeckHandler {
 public:
  virtual ~DeckHandler() = default;
  DeckHandler() = default;
  DeckHandler(const DeckHandler&) = delete;
  DeckHandler& operator=(const DeckHandler&) = delete;

  /// A keyword; its lines live as long as the scanner.
  virtual void take_block(const Block& block) = 0;
  /// The text behind `$crumple`.
  virtual void take_setting(std::string_view text, const Where& where) = 0;
  /// The files that *INCLUDE_TRANSFORM names.
  virtual std::vector<Inclusion> inclusions_of(const Block& block) = 0;
  virtual void begin_file() = 0;
  virtual void end_file() = 0;
};

/// Cuts the text of a deck into keyword blocks, in the order in which they stand, included files in place.
/// Knows comments, line ends, *KEYWORD, *INCLUDE, *INCLUDE_PATH and *END; the meaning of the rest is not its
/// business.
class Scanner {
 public:
  /// All three outlive the scanner.
  Scanner(TextSource& source, Report& report, DeckHandler& handler)
      : source_(&source), report_(&report), handler_(&handler) {}

  void read_deck();

  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// FNV-1a (64 bits) over the text of all files.
  std::uint64_t text_hash() const { return hash_; }

 private:
  struct OpenFile {
    LoadedText loaded;
    std::int32_t number = 0;
    const Placement* placement = nullptr;
  };
  /// A name that may go on over several lines, with its first line.
  struct Name {
    std::string text;
    Where where;
  };

  void read_file(LoadedText loaded, const Where& from, const Placement* placement);
  void read_lines(std::string_view text, OpenFile& file);
  bool is_text(std::string_view text, std::int32_t file);
  void start_block(std::string_view line, const Where& where, const Placement* placement);
  void finish_block(OpenFile& file);
  void read_keyword_options(std::string_view options, const Where& where);
  std::vector<Name> names_of(const Block& block, std::string_view what);
  void read_include(const Block& block, const OpenFile& file);
  void read_include_path(const Block& block, const OpenFile& file);
  std::string_view intern(std::string name) { return *names_.insert(std::move(name)).first; }

  TextSource* source_;
  Report* report_;
  DeckHandler* handler_;
  std::deque<std::string> texts_;
  std::set<std::string> names_;
  std::vector<std::string> open_;  ///< identities of the files being read, the deck first
  std::vector<std::filesystem::path> files_;
  std::vector<std::filesystem::path> folders_;
  ColumnFormat format_ = ColumnFormat::Standard;
  std::optional<Block> block_;
  int includes_ = 0;
  std::uint64_t bytes_ = 0;  ///< of all files
  std::uint64_t hash_ = 14695981039346656037ULL;
};

/// Goes on with a hash, FNV-1a of 64 bits.
std::uint64_t fnv1a(std::uint64_t hash, std::string_view text);

/// Appends a line of a file's or folder's name. True if it goes on in the next line, behind " +".
bool append_name(std::string& name, std::string_view text);

/// The error of a name that goes on where there is no next line; `what` it is the name of.
void report_unfinished_name(const Where& where, std::string_view what, Report& report);

}  // namespace crumple::deck
