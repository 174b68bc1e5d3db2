// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/report.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace crumple::deck {

namespace {

/// Longest message, and longest text of the deck in it [bytes].
constexpr std::size_t longest_message = 1000;
constexpr std::size_t longest_read = 100;

std::string shortened(std::string text, std::size_t longest) {
  if (text.size() <= longest) return text;
  // Not within a letter of several bytes.
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xc0U) == 0x80U) --longest;
  text.resize(longest);
  return text + "...";
}

std::string prefix(const Where& where, std::string_view field) {
  std::string text(where.keyword);
  if (where.card > 0) text += fmt::format(" card {}", where.card);
  if (!field.empty()) text += fmt::format(" field {}", field);
  if (!text.empty()) text += ": ";
  return text;
}

}  // namespace

std::int32_t Report::add_file(std::string name) {
  files_.push_back(std::move(name));
  return static_cast<std::int32_t>(files_.size()) - 1;
}

std::string Report::place(const Where& where) const {
  return fmt::format("{}:{}", file_name(where.file), where.line);
}

Report::Kind& Report::kind_of(Severity severity, std::string key) {
  const auto known = kinds_.find(key);
  if (known != kinds_.end()) return known->second;
  int& kinds = kinds_of_severity_[static_cast<int>(severity)];
  if (kinds < most_kinds) {
    ++kinds;
    return kinds_[std::move(key)];
  }
  Kind& rest = kinds_[fmt::format("|{}|", static_cast<int>(severity))];
  rest.is_rest = true;
  return rest;
}

void Report::add_entry(Severity severity, const Where& where, std::string_view kind, Diagnostic diagnostic) {
  if (severity == Severity::Error) ++errors_;
  Kind& counted = kind_of(severity, fmt::format("{}|{}|{}", where.keyword, static_cast<int>(severity), kind));
  counted.last = where;
  if (++counted.count > shown_per_kind) return;
  diagnostic.message = shortened(std::move(diagnostic.message), longest_message);
  diagnostic.severity = severity;
  if (diagnostic.keyword.empty()) {
    diagnostic.keyword = where.keyword;
    diagnostic.card = where.card;
  }
  diagnostic.file = file_name(where.file);
  diagnostic.line = where.line;
  entries_.push_back({where, std::move(diagnostic), &counted, counted.count == 1});
}

void Report::add(Severity severity, const Where& where, std::string_view kind, const std::string& message) {
  Diagnostic diagnostic;
  diagnostic.message = prefix(where, {}) + message;
  add_entry(severity, where, kind, std::move(diagnostic));
}

void Report::error(const Where& where, std::string_view kind, const std::string& message) {
  add(Severity::Error, where, kind, message);
}

void Report::warning(const Where& where, std::string_view kind, const std::string& message) {
  add(Severity::Warning, where, kind, message);
}

void Report::unsupported(const Where& where, std::string_view kind, const std::string& message) {
  Diagnostic diagnostic;
  diagnostic.message = prefix(where, {}) + message;
  diagnostic.missing =
      kind == "keyword" ? std::string(where.keyword) : fmt::format("{} ({})", where.keyword, kind);
  add_entry(allow_unsupported_ ? Severity::Warning : Severity::Error, where, kind, std::move(diagnostic));
}

void Report::add_field(Severity severity, const Where& where, const FieldFault& fault, bool is_missing) {
  // The field belongs between the card and the colon, so the prefix is made here.
  Where bare = where;
  bare.keyword = {};
  bare.card = 0;
  const std::string found =
      fault.read.empty() ? "is blank" : fmt::format("read \"{}\"", shortened(fault.read, longest_read));
  std::string message = prefix(where, fault.field) + found + ", expected " + fault.expected;
  if (!fault.hint.empty()) message += "; " + fault.hint;
  std::string kind =
      fault.cause.empty() ? fmt::format("{}|{}|{}", where.keyword, fault.field, fault.kind) : fault.cause;
  // Each code that is not supported is something else that is missing; a parameter's name is one of the deck.
  const std::string code = fault.is_code && fault.read.find('&') == std::string::npos
                               ? " " + shortened(fault.read, longest_read)
                               : "";
  kind += code;
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  diagnostic.keyword = where.keyword;
  diagnostic.card = where.card;
  diagnostic.field = fault.field;
  if (is_missing) diagnostic.missing = fmt::format("{} {}{}", where.keyword, fault.field, code);
  add_entry(severity, bare, kind, std::move(diagnostic));
}

void Report::field_error(const Where& where, const FieldFault& fault) {
  add_field(Severity::Error, where, fault);
}

void Report::field_unsupported(const Where& where, const FieldFault& fault) {
  add_field(allow_unsupported_ ? Severity::Warning : Severity::Error, where, fault, true);
}

void Report::code_unsupported(const Where& where, FieldFault fault) {
  fault.is_code = true;
  field_unsupported(where, fault);
}

void Report::field_warning(const Where& where, const FieldFault& fault) {
  add_field(Severity::Warning, where, fault);
}

std::vector<Diagnostic> Report::sorted() const {
  std::vector<Entry> all;
  for (const Entry& entry : entries_) {
    const Kind& kind = *entry.kind;
    const bool is_many = kind.count > shown_per_kind;
    if (is_many && !entry.is_first) continue;
    all.push_back(entry);
    if (!is_many) continue;
    Entry rest = entry;
    rest.diagnostic.count = kind.count - 1;
    rest.diagnostic.message = fmt::format("and {} more {}, last at {}", kind.count - 1,
                                          kind.is_rest ? "of other kinds" : "of this kind", place(kind.last));
    all.push_back(std::move(rest));
  }
  std::stable_sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) {
    return a.where.file != b.where.file ? a.where.file < b.where.file : a.where.line < b.where.line;
  });
  std::vector<Diagnostic> result;
  result.reserve(all.size());
  for (Entry& entry : all) result.push_back(std::move(entry.diagnostic));
  return result;
}

}  // namespace crumple::deck
