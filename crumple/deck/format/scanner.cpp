// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/scanner.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "deck/format/numbers.hpp"
#include "files/input_file.hpp"

namespace crumple::deck {

namespace {

constexpr std::size_t max_depth = 64;
constexpr int max_includes = 10000;
constexpr std::size_t longest_keyword = 200;  ///< LS-DYNA's have 80 letters at most
constexpr std::size_t longest_echo = 40;      ///< of a line in a message

/// The text behind `$crumple`, or nothing if the comment is another one.
std::optional<std::string_view> crumple_setting(std::string_view comment) {
  constexpr std::string_view mark = "$CRUMPLE";
  if (comment.size() < mark.size() || upper_case(comment.substr(0, mark.size())) != mark) return std::nullopt;
  const std::string_view rest = comment.substr(mark.size());
  if (!rest.empty() && rest.front() != ' ' && rest.front() != '\t' && rest.front() != '\r')
    return std::nullopt;
  return trimmed(rest);
}

constexpr std::string_view begin_of_encrypted = "-----BEGIN PGP";
constexpr std::string_view end_of_encrypted = "-----END PGP";

/// A line with blanks before what can only be meant as a keyword: an asterisk and three capitals or more.
bool is_moved_keyword(std::string_view line) {
  if (!line.starts_with(' ') && !line.starts_with('\t')) return false;
  const std::string_view text = trimmed(line);
  constexpr std::size_t asterisk_and_three = 4;
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  return text.size() >= asterisk_and_three && text.front() == '*' &&
         std::all_of(text.begin() + 1, text.begin() + asterisk_and_three, is_capital);
}

/// Whether a text has *END as a line; what stands behind it is not read.
bool has_end(std::string_view text) {
  constexpr std::string_view end = "*END";
  for (std::size_t start = text.find('*'); start != std::string_view::npos;
       start = text.find('*', start + 1)) {
    if (start > 0 && text[start - 1] != '\n' && text[start - 1] != '\r') continue;
    const std::string_view line = text.substr(start, text.find_first_of("\r\n", start) - start);
    if (upper_case(trimmed(line)) == end) return true;
  }
  return false;
}

}  // namespace

std::uint64_t fnv1a(std::uint64_t hash, std::string_view text) {
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ULL;
  }
  return hash;
}

void Scanner::read_deck() {
  static const Placement unmoved;
  read_file(source_->deck(), {}, &unmoved);
}

void Scanner::read_file(LoadedText loaded, const Where& from, const Placement* placement) {
  const bool is_deck = open_.empty();
  if (!loaded.text) {
    if (is_deck)
      report_->error({{}, report_->add_file(loaded.name), 0, 0}, "file", loaded.fault);
    else
      report_->error(from, "file", fmt::format("cannot read \"{}\": {}", loaded.name, loaded.fault));
    return;
  }
  if (std::find(open_.begin(), open_.end(), loaded.identity) != open_.end()) {
    report_->error(from, "loop",
                   fmt::format("\"{}\" includes itself, directly or through other files; remove one of the "
                               "*INCLUDE lines",
                               loaded.name));
    return;
  }
  if (open_.size() >= max_depth || ++includes_ > max_includes) {
    report_->error(from, "too many", "too many files are included, or too deep; is there a mistake?");
    return;
  }
  bytes_ += loaded.text->size();
  if (bytes_ > most_input_bytes()) {
    report_->error(
        from, "too large",
        fmt::format("the deck with all files that it includes has more than {}, which memory does not "
                    "hold; \"{}\" is not read",
                    size_text(most_input_bytes()), loaded.name));
    return;
  }
  OpenFile file{std::move(loaded), 0, placement};
  file.number = report_->add_file(file.loaded.name);
  files_.push_back(file.loaded.path.empty() ? std::filesystem::path(file.loaded.name) : file.loaded.path);
  texts_.push_back(std::move(*file.loaded.text));
  const std::string_view text = texts_.back();
  hash_ = fnv1a(hash_, text);
  if (!is_text(text, file.number)) return;

  open_.push_back(file.loaded.identity);
  const ColumnFormat outer = format_;
  handler_->begin_file();
  read_lines(text, file);
  handler_->end_file();
  format_ = outer;
  open_.pop_back();
}

bool Scanner::is_text(std::string_view text, std::int32_t file) {
  const Where where{{}, file, 0, 0};
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    report_->error(where, "file", "the file is empty, expected LS-DYNA keywords");
    return false;
  }
  const auto control = std::find_if(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 32 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != 26;
  });
  if (control == text.end()) return true;
  if (has_end(text.substr(0, static_cast<std::size_t>(control - text.begin())))) return true;
  const bool compressed = text.starts_with("\x1f\x8b") || text.starts_with("PK");
  const bool wide = text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff");
  report_->error(where, "file",
                 fmt::format("this is not a text file (byte {} is 0x{:02x}){}", control - text.begin(),
                             static_cast<unsigned>(static_cast<unsigned char>(*control)),
                             compressed ? "; it is compressed, unpack it first"
                             : wide     ? "; it is UTF-16, save it as UTF-8 or ASCII"
                                        : ", expected LS-DYNA keywords"));
  return false;
}

void Scanner::read_lines(std::string_view text, OpenFile& file) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  // Files of old Macintosh systems have carriage returns alone.
  const char line_end = text.find('\n') == std::string_view::npos ? '\r' : '\n';
  bool is_encrypted = false;
  Where where{{}, file.number, 0, 0};
  while (!text.empty()) {
    const std::size_t end = text.find(line_end);
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    while (!line.empty() &&
           (line.back() == '\r' || line.back() == ' ' || line.back() == 26 || line.back() == '\f'))
      line.remove_suffix(1);
    ++where.line;
    if (line.starts_with(end_of_encrypted)) {
      is_encrypted = false;
    } else if (is_encrypted) {
      continue;
    } else if (line.starts_with(begin_of_encrypted)) {
      finish_block(file);
      is_encrypted = true;
      report_->error(where, "encrypted",
                     "an encrypted block begins here, which LS-DYNA alone can read; ask for what it holds as "
                     "plain text");
    } else if (line.starts_with('$')) {
      if (const auto setting = crumple_setting(line)) handler_->take_setting(*setting, where);
    } else if (line.starts_with('*') || is_moved_keyword(line)) {
      if (!line.starts_with('*')) {
        line = trimmed(line);
        report_->error(
            where, "column",
            fmt::format("\"{}\" does not begin in column 1, where LS-DYNA looks for keywords; remove "
                        "the blanks before it",
                        line.substr(0, longest_echo)));
      }
      finish_block(file);
      start_block(line, where, file.placement);
      if (block_ && block_->name == "END") break;
    } else if (block_) {
      block_->lines.push_back({line, where.line});
    } else if (!trimmed(line).empty()) {
      report_->error(where, "before",
                     fmt::format("read \"{}\" before any keyword, expected a line that starts with *",
                                 line.substr(0, longest_echo)));
    }
  }
  if (block_ && block_->name == "END") block_.reset();
  finish_block(file);
}

void Scanner::start_block(std::string_view line, const Where& where, const Placement* placement) {
  Block block;
  const std::size_t blank = line.find_first_of(" \t(,");
  std::string_view written = trimmed(line.substr(1, blank == std::string_view::npos ? blank : blank - 1));
  const bool is_too_long = written.size() > longest_keyword;
  if (is_too_long) written = written.substr(0, longest_echo);
  std::string name = upper_case(written) + (is_too_long ? "..." : "");
  std::string_view rest = blank == std::string_view::npos ? std::string_view() : trimmed(line.substr(blank));
  block.where = where;
  block.format = format_;
  block.placement = placement;
  const auto format_of = [&](char mark) {
    if (mark == '+') block.format = ColumnFormat::Long;
    if (mark == '-') block.format = ColumnFormat::Standard;
    if (mark == '%') block.format = ColumnFormat::TenDigit;
    return mark == '+' || mark == '-' || mark == '%';
  };
  while (!name.empty() && format_of(name.back())) name.pop_back();
  while (!rest.empty() && format_of(rest.front())) rest = trimmed(rest.substr(1));
  block.name = name;
  block.where.keyword = intern("*" + name);
  if (name == "KEYWORD")
    read_keyword_options(rest, block.where);
  else if (!rest.empty() && rest.front() != '(' && rest.front() != '$' && name != "COMMENT")
    report_->warning(block.where, "rest",
                     fmt::format("\"{}\" behind the keyword is not read", rest.substr(0, longest_echo)));
  block_ = std::move(block);
}

void Scanner::finish_block(OpenFile& file) {
  if (!block_) return;
  const Block block = std::move(*block_);
  block_.reset();
  if (block.name == "KEYWORD") {
    for (const Line& line : block.lines)
      if (!trimmed(line.text).empty()) {
        Where where = block.where;
        where.line = line.number;
        report_->error(
            where, "data",
            fmt::format("read \"{}\", expected another keyword", line.text.substr(0, longest_echo)));
        break;
      }
  } else if (block.name == "INCLUDE") {
    read_include(block, file);
  } else if (block.name == "INCLUDE_PATH" || block.name == "INCLUDE_PATH_RELATIVE") {
    read_include_path(block, file);
  } else if (block.name == "INCLUDE_TRANSFORM") {
    for (const Inclusion& inclusion : handler_->inclusions_of(block))
      read_file(source_->include(inclusion.name, file.loaded, folders_), inclusion.where,
                inclusion.placement);
  } else {
    handler_->take_block(block);
  }
}

void Scanner::read_keyword_options(std::string_view options, const Where& where) {
  const std::string text = upper_case(options);
  std::size_t start = 0;
  while ((start = text.find_first_not_of(" ,\t", start)) != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(" ,\t", start), text.size());
    const std::string option = text.substr(start, end - start);
    start = end;
    if (option.starts_with('$') || option.starts_with('(')) return;
    if (option == "LONG=Y" || option == "LONG=K") {
      format_ = ColumnFormat::Long;
    } else if (option == "LONG=S" || option == "LONG=N" || option == "I10=N") {
      format_ = ColumnFormat::Standard;
    } else if (option == "I10=Y") {
      format_ = ColumnFormat::TenDigit;
    } else if (option.starts_with("LONG=") || option.starts_with("I10=")) {
      report_->error(where, "format",
                     fmt::format("read \"{}\", expected LONG=Y, LONG=K, LONG=S or I10=Y", option));
    } else if (option.find('=') == std::string::npos && !parse_real(option)) {
      // Others are about LS-DYNA's memory, processors and names of files.
      report_->warning(where, "option", fmt::format("the option \"{}\" is not used", option));
    }
  }
}

std::vector<Scanner::Name> Scanner::names_of(const Block& block, std::string_view what) {
  std::vector<Name> names;
  Name name{{}, block.where};
  for (const Line& line : block.lines) {
    const std::string_view text = trimmed(line.text);
    if (text.empty()) continue;
    if (name.text.empty()) name.where.line = line.number;
    if (append_name(name.text, text)) continue;
    names.push_back(name);
    name.text.clear();
  }
  if (!name.text.empty()) report_unfinished_name(name.where, what, *report_);
  return names;
}

bool append_name(std::string& name, std::string_view text) {
  const bool goes_on = text.ends_with(" +");
  name += goes_on ? trimmed(text.substr(0, text.size() - 2)) : text;
  return goes_on;
}

void report_unfinished_name(const Where& where, std::string_view what, Report& report) {
  report.error(where, "name",
               fmt::format("the name of the {} goes on behind \" +\", but there is no other line", what));
}

void Scanner::read_include(const Block& block, const OpenFile& file) {
  const std::vector<Name> names = names_of(block, "file");
  for (const Name& name : names)
    read_file(source_->include(name.text, file.loaded, folders_), name.where, file.placement);
  if (names.empty() && std::all_of(block.lines.begin(), block.lines.end(),
                                   [](const Line& line) { return trimmed(line.text).empty(); }))
    report_->warning(block.where, "name",
                     "the name of the file is missing, expected it on the next line; nothing is included");
}

void Scanner::read_include_path(const Block& block, const OpenFile& file) {
  const bool is_relative = block.name == "INCLUDE_PATH_RELATIVE";
  const std::vector<Name> names = names_of(block, "folder");
  for (const Name& name : names) {
    const std::filesystem::path folder(with_slashes(name.text));
    if (is_relative && folder.is_absolute()) {
      report_->error(name.where, "absolute",
                     fmt::format("read \"{}\", expected a folder relative to this file; *INCLUDE_PATH takes "
                                 "absolute ones",
                                 name.text));
      continue;
    }
    // LS-DYNA takes *INCLUDE_PATH from where it runs; decks are written to be run in their own folder.
    folders_.push_back(file.loaded.path.parent_path() / folder);
    if (!is_relative && folder.is_relative() && !file.loaded.path.parent_path().empty())
      folders_.push_back(folder);
  }
  if (names.empty())
    report_->warning(
        block.where, "name",
        "the name of the folder is missing, expected it on the next line; no folder is searched");
}

}  // namespace crumple::deck
