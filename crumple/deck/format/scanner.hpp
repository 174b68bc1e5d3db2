// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/block.hpp"
#include "deck/format/report.hpp"
#include "deck/format/text_source.hpp"

namespace crumple::deck {

/// Cuts the text of a deck into keyword blocks, in the order in which they stand, included files in place.
/// Knows comments, line ends, *KEYWORD, *INCLUDE and *END; the meaning of the rest is not its business.
class Scanner {
 public:
  /// `on_block` is called for every other keyword; its lines live as long as the scanner.
  /// `on_setting` is called with the text behind `$crumple` and its place.
  Scanner(TextSource& source, Report& report, std::function<void(const Block&)> on_block,
          std::function<void(std::string_view, const Where&)> on_setting);

  void read_deck();

  const std::vector<std::filesystem::path>& files() const { return files_; }
  /// FNV-1a (64 bits) over the text of all files.
  std::uint64_t text_hash() const { return hash_; }

 private:
  struct OpenFile {
    LoadedText loaded;
    std::int32_t number = 0;
  };

  void read_file(LoadedText loaded, const Where& from);
  void read_lines(std::string_view text, OpenFile& file);
  bool is_text(std::string_view text, std::int32_t file);
  void start_block(std::string_view line, const Where& where);
  void finish_block(OpenFile& file);
  void read_keyword_options(std::string_view options, const Where& where);
  void read_include(const Block& block, const OpenFile& file);
  std::string_view intern(std::string name) { return *names_.insert(std::move(name)).first; }

  TextSource* source_;
  Report* report_;
  std::function<void(const Block&)> on_block_;
  std::function<void(std::string_view, const Where&)> on_setting_;
  std::deque<std::string> texts_;
  std::set<std::string> names_;
  std::vector<std::string> open_;  ///< identities of the files being read, the deck first
  std::vector<std::filesystem::path> files_;
  ColumnFormat format_ = ColumnFormat::Standard;
  std::optional<Block> block_;
  int includes_ = 0;
  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace crumple::deck
