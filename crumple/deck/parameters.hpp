// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "deck/report.hpp"

namespace crumple::deck {

class Cards;

/// The values that *PARAMETER gives names to. Names are not case-sensitive.
class Parameters {
 public:
  /// Reads a *PARAMETER block. Faults go to the cards' report.
  void read(Cards& cards);

  /// True if the text is `&name`, `-&name` or `+&name`.
  static bool is_reference(std::string_view text);

  /// The text that stands for a reference, its sign included; nothing if the parameter is not defined.
  std::optional<std::string> substitute(std::string_view reference) const;

 private:
  struct Value {
    std::string text;
    Where where;
  };

  void define(std::string_view name_and_type, std::string_view text, const Where& where, Report& report);

  std::map<std::string, Value, std::less<>> values_;
};

}  // namespace crumple::deck
