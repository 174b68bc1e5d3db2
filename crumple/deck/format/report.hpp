// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/diagnostic.hpp"

namespace crumple::deck {

/// Where something stands in the deck. Every value and every item read carries one.
struct Where {
  std::string_view keyword;  ///< with asterisk and options, upper case; lives as long as the reading
  std::int32_t file = 0;     ///< number of the file in the report
  std::int32_t line = 0;     ///< counted from 1
  std::int32_t card = 0;     ///< data card of the keyword, counted from 1; 0 is the keyword as a whole
};

/// What is wrong with one field, in the parts of the sentence that the user reads.
struct FieldFault {
  std::string_view field;
  std::string read;         ///< the text found, without blanks around it
  std::string expected;     ///< after "expected "
  std::string hint;         ///< what to do; may be empty
  std::string_view kind{};  ///< faults of one keyword, field and kind are counted together
  std::string cause{};      ///< those of one cause are, whatever the keyword and field; empty if unknown
  bool is_code = false;     ///< the value is one of a list, and says nothing of the deck it is in
};

/// Collects everything that is to be said about a deck. Of a kind of fault that occurs more often than
/// `shown_per_kind` times the first one is shown, and how many there are. Of errors, and likewise of
/// warnings, `most_kinds` kinds are distinguished; what goes beyond that is counted and not kept, and texts
/// of the deck are cut in messages, so that no deck makes this larger than some megabytes.
class Report {
 public:
  static constexpr int shown_per_kind = 4;
  static constexpr int most_kinds = 1000;

  explicit Report(bool allow_unsupported) : allow_unsupported_(allow_unsupported) {}

  /// Registers a file and returns its number, as Where uses it.
  std::int32_t add_file(std::string name);
  const std::string& file_name(std::int32_t file) const { return files_[static_cast<std::size_t>(file)]; }

  /// Adds a message about a place; the keyword and card are put before it.
  void add(Severity severity, const Where& where, std::string_view kind, const std::string& message);
  void error(const Where& where, std::string_view kind, const std::string& message);
  void warning(const Where& where, std::string_view kind, const std::string& message);
  /// Not supported and not harmless: an error, or a warning where the user allows it.
  void unsupported(const Where& where, std::string_view kind, const std::string& message);

  void field_error(const Where& where, const FieldFault& fault);
  void field_unsupported(const Where& where, const FieldFault& fault);
  /// The same of a value that is one of a list of codes: each of them is something else that is missing.
  void code_unsupported(const Where& where, FieldFault fault);
  void field_warning(const Where& where, const FieldFault& fault);

  bool allow_unsupported() const { return allow_unsupported_; }
  bool has_errors() const { return errors_ > 0; }

  /// `file:line`, for a message that points to a second place.
  std::string place(const Where& where) const;

  /// All diagnostics by file and line, with the counts of those that were not kept.
  std::vector<Diagnostic> sorted() const;

 private:
  struct Kind {
    int count = 0;
    Where last;
    bool is_rest = false;  ///< of all kinds beyond the first `most_kinds`
  };
  struct Entry {
    Where where;
    Diagnostic diagnostic;
    const Kind* kind;
    bool is_first;  ///< of its kind
  };

  Kind& kind_of(Severity severity, std::string key);
  void add_entry(Severity severity, const Where& where, std::string_view kind, Diagnostic diagnostic);
  void add_field(Severity severity, const Where& where, const FieldFault& fault, bool is_missing = false);

  bool allow_unsupported_;
  int errors_ = 0;
  int kinds_of_severity_[3] = {};
  std::vector<std::string> files_;
  std::vector<Entry> entries_;
  std::map<std::string, Kind, std::less<>> kinds_;
};

}  // namespace crumple::deck
