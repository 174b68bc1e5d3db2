// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "deck/format/id_kind.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

enum class FieldType {
  Integer,
  Real,
  Text,
};

class Card;

/// The kind of an id that depends on the keyword or on another field of the card.
using ChooseKind = IdKind (*)(const Card& card);

/// What the transformation of a file does to a value.
enum class Geometry {
  None,
  Point,      ///< one of three fields that are a point
  Direction,  ///< likewise a direction, or the difference of two points
  Velocity,   ///< likewise a velocity: turned, with a warning
  Spin,       ///< likewise an angular velocity
  Length,     ///< refused where the transformation changes lengths
  Axes,       ///< numbers of global axes: they stay, with a warning, where the transformation turns
  Fixed,      ///< refused where the transformation does more than move
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
  std::array<double, 12> values{};  ///< of Only and Harmless; low and high of Between and Within
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
  IdKind kind = IdKind::None;    ///< of an id; *INCLUDE_TRANSFORM adds the offset of its kind. A real field
                                 ///< is an id where it is negative
  ChooseKind choose = nullptr;   ///< where the kind depends on the keyword or on other fields
  Geometry geometry = Geometry::None;
  bool is_local = false;  ///< in the axes that CID or ICID of the card names, if it does: they turn, not this

  bool is_id() const { return kind != IdKind::None || choose != nullptr; }
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

/// A whole number that is no id.
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

constexpr Field integer_of(std::string_view name, Check::Kind check, IdKind kind, ChooseKind choose) {
  Field field{name, FieldType::Integer, 0, check_of(check)};
  field.kind = kind;
  field.choose = choose;
  return field;
}

/// The kind that goes with the name; a name that says nothing does not compile.
consteval IdKind required_kind(std::string_view name) {
  const IdKind kind = kind_of_name(name);
  if (kind == IdKind::None) throw "the name does not say what it is the id of: give its kind";
  return kind;
}

/// The number of an item: must be given and above zero.
consteval Field id(std::string_view name) {
  return integer_of(name, Check::Kind::AboveZero, required_kind(name), nullptr);
}

consteval Field id(std::string_view name, IdKind kind) {
  return integer_of(name, Check::Kind::AboveZero, kind, nullptr);
}

consteval Field id(std::string_view name, ChooseKind choose) {
  return integer_of(name, Check::Kind::AboveZero, IdKind::None, choose);
}

/// The number of another item, or zero for none.
consteval Field reference(std::string_view name) {
  return integer_of(name, Check::Kind::NotNegative, required_kind(name), nullptr);
}

consteval Field reference(std::string_view name, IdKind kind) {
  return integer_of(name, Check::Kind::NotNegative, kind, nullptr);
}

consteval Field reference(std::string_view name, ChooseKind choose) {
  return integer_of(name, Check::Kind::NotNegative, IdKind::None, choose);
}

/// The number of another item whose sign means something.
consteval Field signed_id(std::string_view name, IdKind kind) {
  return integer_of(name, Check::Kind::None, kind, nullptr);
}

consteval Field signed_id(std::string_view name, ChooseKind choose) {
  return integer_of(name, Check::Kind::None, IdKind::None, choose);
}

/// A number that, where it is negative, is the number of another item.
constexpr Field real_or_id(std::string_view name, IdKind kind) {
  Field field{name, FieldType::Real};
  field.kind = kind;
  return field;
}

constexpr Field placed(Geometry geometry, Field field) {
  field.geometry = geometry;
  return field;
}

constexpr Field point(Field field) {
  return placed(Geometry::Point, field);
}

constexpr Field direction(Field field) {
  return placed(Geometry::Direction, field);
}

constexpr Field velocity(Field field) {
  return placed(Geometry::Velocity, field);
}

constexpr Field spin(Field field) {
  return placed(Geometry::Spin, field);
}

constexpr Field length(Field field) {
  return placed(Geometry::Length, field);
}

constexpr Field axes(Field field) {
  return placed(Geometry::Axes, field);
}

constexpr Field fixed(Field field) {
  return placed(Geometry::Fixed, field);
}

/// Along the axes of the coordinate system that the card names, if it does.
constexpr Field local(Field field) {
  field.is_local = true;
  return field;
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
