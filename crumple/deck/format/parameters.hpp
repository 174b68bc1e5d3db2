// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deck/format/expression.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

class Cards;

/// A parameter with the value that counts.
struct SetParameter {
  std::string name;
  std::string value;
  bool is_preset = false;  ///< by the command line
};

/// The numbers and texts that *PARAMETER and its kin give names to. Names are not case-sensitive. A local one
/// is known in its file and in those that it includes, where it hides a global one of the same name.
class Parameters {
 public:
  /// Whether a keyword is read here.
  static bool is_keyword(std::string_view name);

  /// Local parameters that are defined from here to the end of the file go with it.
  void begin_file() { locals_.emplace_back(); }
  void end_file() { locals_.pop_back(); }

  /// Gives a name a value, whatever the deck says of it: a block that sets it later is left out with a
  /// warning. False if the name or the number is none.
  bool preset(std::string_view name, std::string_view value);

  /// Remembers that a text which is not read has references, so that its presets count as used.
  void note_references(std::string_view text);
  /// Presets that the deck did not use: an error each, with the nearest name that the deck has.
  void report_unused_presets(Report& report) const;
  /// Those that hold in the whole deck, by name, upper case.
  std::vector<SetParameter> all() const;

  /// Reads a block of this name. Faults go to the cards' report.
  void read(std::string_view keyword, Cards& cards);

  /// True if the text is `&name`, `-&name` or `+&name`, or begins so.
  static bool is_reference(std::string_view text);

  /// The text that stands for a reference, its sign included, or for what is computed of some (`&end-0.001`);
  /// nothing if a parameter is not defined.
  std::optional<std::string> substitute(std::string_view reference) const;

 private:
  struct Value {
    std::string text;
    Where where;
    bool is_whole = false;  ///< of type I
    bool is_preset = false;
    mutable bool is_used = false;  ///< a reference to it was read
    bool is_in_the_deck = false;   ///< a preset that the deck sets, too
  };

  using Values = std::map<std::string, Value, std::less<>>;

  /// A name with its type in front of it.
  struct Name {
    std::string name;
    bool is_whole = false;
    bool is_local = false;
    bool is_text = false;
  };

  /// What becomes of a parameter that is defined a second time with another value: DFLAG of
  /// *PARAMETER_DUPLICATION.
  enum class Duplicate { Refuse, WarnAndKeep, WarnAndReplace, Replace, Keep };

  void read_values(Cards& cards, bool is_local);
  void read_expressions(Cards& cards, bool is_local);
  void read_duplication(Cards& cards);
  std::optional<std::string> computed(std::string_view text) const;
  Evaluated evaluated(const std::string& expression) const;
  const Value* find(std::string_view name) const;
  /// The same in any case, for a reference.
  const Value* use(std::string_view name) const;

  static std::optional<Name> name_of(std::string_view name_and_type, const Where& where, Report& report);
  void enter(const Name& name, const std::string& text, const Where& where, Report& report);
  void define(std::string_view name_and_type, std::string_view text, bool is_local, const Where& where,
              Report& report);
  void define_by(const std::string& expression, const Name& name, const Where& where, Report& report);

  Values values_;
  std::vector<Values> locals_;  ///< of the files that are open, the deck first
  Duplicate duplicate_ = Duplicate::WarnAndKeep;
  bool is_mutable_ = false;                           ///< what is being read may replace earlier values
  mutable std::set<std::string, std::less<>> names_;  ///< that the deck sets or refers to
  std::optional<Where> duplication_;  ///< the first *PARAMETER_DUPLICATION, which alone counts
};

}  // namespace crumple::deck
