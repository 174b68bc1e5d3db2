// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "deck/format/report.hpp"

namespace crumple::deck {

enum class FieldType {
  Integer,
  Real,
  Text,
};

/// What a value must be. A blank field has its default, which is checked as well.
struct Check {
  enum class Kind {
    None,
    AboveZero,    ///< > 0, else an error
    NotNegative,  ///< >= 0, else an error
    Between,      ///< low < value < high, else an error
    Within,       ///< low <= value <= high, else an error
    Only,         ///< one of the values; another one is not supported
    Harmless,     ///< one of the values; another one is left out with a warning
  };
  Kind kind = Kind::None;
  std::array<double, 8> values{};  ///< of Only and Harmless; low and high of Between and Within
  std::size_t count = 0;
  std::string_view text;  ///< what is expected, or why another value is left out
};

/// One field of a card: a row of a keyword's table.
struct Field {
  std::string_view name;  ///< as in LS-DYNA's manual
  FieldType type = FieldType::Real;
  double fallback = 0;  ///< the value of a blank field
  Check check{};
  bool zero_is_default = false;  ///< a zero means the default as well
  int width = 10;                ///< columns in the standard format
  bool has_effect = true;        ///< false: read, but it makes no difference here
};

/// What a check finds.
struct CheckResult {
  std::optional<FieldFault> fault;  ///< absent if the value is fine
  bool is_unsupported = false;      ///< right in LS-DYNA, not supported here
  bool is_harmless = false;         ///< the value may be left out
};

/// What a field must hold, in words; empty if any number will do.
std::string expectation(const Field& field);

/// Checks a value that was read from `text`, or is the default of a blank field.
CheckResult check_field(const Field& field, double value, std::string_view text);

/// The fields of a card, from the first column on.
using Layout = std::span<const Field>;

/// At most as many fields as the widest card has.
inline constexpr std::size_t max_fields = 12;

/// Short forms for the rows of the tables.
namespace row {

constexpr Check check_of(Check::Kind kind, std::initializer_list<double> values = {},
                         std::string_view text = {}) {
  Check check;
  check.kind = kind;
  for (const double value : values) check.values[check.count++] = value;
  check.text = text;
  return check;
}

inline constexpr Check above_zero = check_of(Check::Kind::AboveZero);
inline constexpr Check not_negative = check_of(Check::Kind::NotNegative);

constexpr Check between(double low, double high, std::string_view text) {
  return check_of(Check::Kind::Between, {low, high}, text);
}

constexpr Check within(double low, double high, std::string_view text) {
  return check_of(Check::Kind::Within, {low, high}, text);
}

constexpr Field real(std::string_view name, double fallback = 0, Check check = {}) {
  return {name, FieldType::Real, fallback, check};
}

constexpr Field integer(std::string_view name, double fallback = 0, Check check = {}) {
  return {name, FieldType::Integer, fallback, check};
}

/// A number whose default also holds where the deck says zero.
constexpr Field real_or_default(std::string_view name, double fallback, Check check = {}) {
  return {name, FieldType::Real, fallback, check, true};
}

constexpr Field integer_or_default(std::string_view name, double fallback, Check check = {}) {
  return {name, FieldType::Integer, fallback, check, true};
}

/// The number of an item: must be given and above zero.
constexpr Field id(std::string_view name) {
  return {name, FieldType::Integer, 0, check_of(Check::Kind::AboveZero)};
}

/// The number of another item, or zero for none.
constexpr Field reference(std::string_view name) {
  return {name, FieldType::Integer, 0, check_of(Check::Kind::NotNegative)};
}

/// Read as a number, without influence on the result here (docs/deck.md says why).
constexpr Field unused(std::string_view name) {
  Field field{name, FieldType::Real};
  field.has_effect = false;
  return field;
}

/// Only these values are supported, the first one being the default; `text` says what they mean.
constexpr Field only(std::string_view name, std::initializer_list<double> values, std::string_view text) {
  return {name, FieldType::Real, *values.begin(), check_of(Check::Kind::Only, values, text)};
}

/// Other values than these are left out with a warning, `text` saying what happens instead.
constexpr Field harmless(std::string_view name, std::initializer_list<double> values, std::string_view text) {
  return {name, FieldType::Real, *values.begin(), check_of(Check::Kind::Harmless, values, text)};
}

constexpr Field text(std::string_view name, int width) {
  return {name, FieldType::Text, 0, {}, false, width};
}

constexpr Field sized(int width, Field field) {
  field.width = width;
  return field;
}

}  // namespace row

}  // namespace crumple::deck
