// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/report.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace crumple::deck {

namespace {

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

void Report::add(Severity severity, const Where& where, std::string_view kind, const std::string& message) {
  if (severity == Severity::Error) ++errors_;
  Entry entry{where, {severity, file_name(where.file), where.line, prefix(where, {}) + message}};
  Kind& counted = kinds_[fmt::format("{}|{}|{}", where.keyword, static_cast<int>(severity), kind)];
  if (++counted.count <= shown_per_kind)
    entries_.push_back(std::move(entry));
  else
    counted.last = std::move(entry);
}

void Report::error(const Where& where, std::string_view kind, const std::string& message) {
  add(Severity::Error, where, kind, message);
}

void Report::warning(const Where& where, std::string_view kind, const std::string& message) {
  add(Severity::Warning, where, kind, message);
}

void Report::unsupported(const Where& where, std::string_view kind, const std::string& message) {
  add(allow_unsupported_ ? Severity::Warning : Severity::Error, where, kind, message);
}

void Report::add_field(Severity severity, const Where& where, const FieldFault& fault) {
  // The field belongs between the card and the colon, so the prefix is made here.
  Where bare = where;
  bare.keyword = {};
  bare.card = 0;
  const std::string found = fault.read.empty() ? "is blank" : fmt::format("read \"{}\"", fault.read);
  std::string message = prefix(where, fault.field) + found + ", expected " + fault.expected;
  if (!fault.hint.empty()) message += "; " + fault.hint;
  const std::string kind = fmt::format("{}|{}|{}", where.keyword, fault.field, fault.kind);
  add(severity, bare, kind, message);
}

void Report::field_error(const Where& where, const FieldFault& fault) {
  add_field(Severity::Error, where, fault);
}

void Report::field_unsupported(const Where& where, const FieldFault& fault) {
  add_field(allow_unsupported_ ? Severity::Warning : Severity::Error, where, fault);
}

void Report::field_warning(const Where& where, const FieldFault& fault) {
  add_field(Severity::Warning, where, fault);
}

std::vector<Diagnostic> Report::sorted() const {
  std::vector<Entry> all = entries_;
  for (const auto& [name, kind] : kinds_) {
    if (kind.count <= shown_per_kind) continue;
    Entry rest = kind.last;
    rest.diagnostic.message +=
        fmt::format(" ({} of this kind in all, {} shown)", kind.count, shown_per_kind + 1);
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
