// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/field.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace crumple::deck {

namespace {

std::string list_of_values(const Check& check) {
  std::string values;
  for (std::size_t i = 0; i < check.count; ++i)
    values += fmt::format("{}{}", i == 0 ? "" : (i + 1 == check.count ? " or " : ", "), check.values[i]);
  return values;
}

bool holds(const Check& check, double value) {
  const auto end = check.values.begin() + static_cast<std::ptrdiff_t>(check.count);
  switch (check.kind) {
    case Check::Kind::None:
      return true;
    case Check::Kind::AboveZero:
      return value > 0;
    case Check::Kind::NotNegative:
      return value >= 0;
    case Check::Kind::Between:
      return value > check.values[0] && value < check.values[1];
    case Check::Kind::Within:
      return value >= check.values[0] && value <= check.values[1];
    case Check::Kind::Only:
    case Check::Kind::Harmless:
      return std::find(check.values.begin(), end, value) != end;
  }
  return true;
}

}  // namespace

std::string expectation(const Field& field) {
  const Check& check = field.check;
  switch (check.kind) {
    case Check::Kind::None:
      return {};
    case Check::Kind::AboveZero:
      return field.type == FieldType::Integer ? "a whole number above zero" : "a number above zero";
    case Check::Kind::NotNegative:
      return "a number that is not negative";
    case Check::Kind::Between:
      return fmt::format("a number above {} and below {}", check.values[0], check.values[1]);
    case Check::Kind::Within:
      return fmt::format("a number from {} to {}", check.values[0], check.values[1]);
    case Check::Kind::Only:
      return fmt::format("{}, the only value{} supported", list_of_values(check), check.count > 1 ? "s" : "");
    case Check::Kind::Harmless:
      return list_of_values(check);
  }
  return {};
}

CheckResult check_field(const Field& field, double value, std::string_view text) {
  CheckResult result;
  if (holds(field.check, value)) return result;
  result.fault =
      FieldFault{field.name, std::string(text), expectation(field), std::string(field.check.text), "value"};
  result.is_unsupported = field.check.kind == Check::Kind::Only;
  result.fault->is_code = result.is_unsupported && field.check.count > 1;
  result.is_harmless = field.check.kind == Check::Kind::Harmless;
  return result;
}

}  // namespace crumple::deck
