// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "deck/format/report.hpp"

namespace crumple::deck {

class Cards;

/// The values that *PARAMETER and *PARAMETER_EXPRESSION give names to. Names are not case-sensitive.
class Parameters {
 public:
  /// Gives a name a value, whatever the deck says of it: a block that sets it later is left out with a
  /// warning. False if the name or the number is none.
  bool preset(std::string_view name, std::string_view value);

  /// Reads a *PARAMETER block. Faults go to the cards' report.
  void read(Cards& cards);

  /// Reads a *PARAMETER_EXPRESSION block.
  void read_expressions(Cards& cards);

  /// True if the text is `&name`, `-&name` or `+&name`.
  static bool is_reference(std::string_view text);

  /// The text that stands for a reference, its sign included; nothing if the parameter is not defined.
  std::optional<std::string> substitute(std::string_view reference) const;

 private:
  struct Value {
    std::string text;
    Where where;
    bool is_whole = false;  ///< of type I
    bool is_preset = false;
  };

  /// A name with its type in front of it.
  struct Name {
    std::string name;
    bool is_whole = false;
  };

  static std::optional<Name> name_of(std::string_view name_and_type, const Where& where, Report& report);
  void enter(const Name& name, const std::string& text, const Where& where, Report& report);
  void define(std::string_view name_and_type, std::string_view text, const Where& where, Report& report);
  void define_by(const std::string& expression, const Name& name, const Where& where, Report& report);

  std::map<std::string, Value, std::less<>> values_;
};

}  // namespace crumple::deck
