// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/number_scanner.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <string>

namespace crumple::compare {

namespace {

bool is_digit(char letter) {
  return letter >= '0' && letter <= '9';
}
bool is_sign(char letter) {
  return letter == '-' || letter == '+';
}

std::size_t digits_at(std::string_view text, std::size_t place) {
  std::size_t count = 0;
  while (place + count < text.size() && is_digit(text[place + count])) ++count;
  return count;
}

/// Digits with at most one point; zero if there is no digit.
std::size_t mantissa_length(std::string_view text, std::size_t place) {
  const std::size_t whole = digits_at(text, place);
  std::size_t length = whole;
  std::size_t fraction = 0;
  if (place + length < text.size() && text[place + length] == '.') {
    fraction = digits_at(text, place + length + 1);
    length += 1 + fraction;
  }
  return whole + fraction > 0 ? length : 0;
}

struct Exponent {
  std::size_t length = 0;        ///< of its text with letter and sign
  std::string_view digits = {};  ///< with the sign, if it is a minus
};

Exponent exponent_at(std::string_view text, std::size_t place, bool has_point) {
  if (place >= text.size()) return {};
  const bool letter = std::string_view("eEdD").find(text[place]) != std::string_view::npos;
  std::size_t start = place + (letter ? 1 : 0);
  const bool sign = start < text.size() && is_sign(text[start]);
  const std::size_t digits = digits_at(text, start + (sign ? 1 : 0));
  if (letter ? digits == 0 : !sign || !has_point || digits != 3) return {};
  const std::size_t end = start + (sign ? 1 : 0) + digits;
  // What goes on with a point is the next number.
  if (!letter && end < text.size() && text[end] == '.') return {};
  if (sign && text[start] == '+') ++start;
  return {end - place, text.substr(start, end - start)};
}

double value_of(std::string_view mantissa, std::string_view exponent) {
  std::string text(mantissa);
  if (!exponent.empty()) text.append("e").append(exponent);
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec == std::errc::result_out_of_range)
    return exponent.starts_with('-') ? 0.0 : std::numeric_limits<double>::infinity();
  return value;
}

}  // namespace

std::optional<double> take_number(std::string_view& text) {
  std::size_t place = 0;
  while (place < text.size() && std::isspace(static_cast<unsigned char>(text[place])) != 0) ++place;
  if (place < text.size() && text[place] == '*') {
    while (place < text.size() && text[place] == '*') ++place;
    text.remove_prefix(place);
    return std::numeric_limits<double>::quiet_NaN();
  }
  const bool sign = place < text.size() && is_sign(text[place]);
  const bool negative = sign && text[place] == '-';
  if (sign) ++place;
  const std::size_t length = mantissa_length(text, place);
  if (length == 0) return std::nullopt;
  const std::string_view mantissa = text.substr(place, length);
  const Exponent exponent = exponent_at(text, place + length, mantissa.find('.') != std::string_view::npos);
  const double size = value_of(mantissa, exponent.digits);
  text.remove_prefix(place + length + exponent.length);
  return negative ? -size : size;
}

std::vector<double> take_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (const std::optional<double> number = take_number(text)) numbers.push_back(*number);
  return numbers;
}

std::optional<double> only_number(std::string_view text) {
  const std::optional<double> number = take_number(text);
  if (!number || !trimmed(text).empty()) return std::nullopt;
  return number;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
  return text;
}

}  // namespace crumple::compare
