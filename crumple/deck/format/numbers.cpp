// SPDX-License-Identifier: BSD-3-Clause
#include "deck/format/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace crumple::deck {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_exponent_letter(char c) {
  return c == 'e' || c == 'E' || c == 'd' || c == 'D';
}

/// Rewrites Fortran's exponents as C's. Returns the length written, or 0 if a character cannot be part of a
/// number (which also keeps out "nan", "inf" and hexadecimal).
std::size_t as_c_number(std::string_view text, std::array<char, 80>& out) {
  if (text.size() + 1 >= out.size()) return 0;
  std::size_t n = 0;
  bool has_exponent = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_exponent_letter(c)) {
      if (has_exponent) return 0;
      has_exponent = true;
      out[n++] = 'e';
    } else if (c == '+' || c == '-') {
      const bool leads = i == 0;
      if (!leads && !is_exponent_letter(text[i - 1])) {
        if (has_exponent) return 0;
        has_exponent = true;
        out[n++] = 'e';
      }
      if (!(leads && c == '+')) out[n++] = c;
    } else if (is_digit(c) || c == '.') {
      out[n++] = c;
    } else {
      return 0;
    }
  }
  return n;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string upper_case(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

std::optional<double> parse_real(std::string_view text) {
  std::array<char, 80> buffer{};
  const std::size_t length = as_c_number(text, buffer);
  if (length == 0) return std::nullopt;
  double value = 0;
  const char* end = buffer.data() + length;
  const auto [stop, fault] = std::from_chars(buffer.data(), end, value);
  if (stop != end) return std::nullopt;
  if (fault == std::errc::result_out_of_range) {
    // Too small is zero; too large is no number that a deck can mean.
    const std::string_view written(buffer.data(), length);
    return written.find("e-") != std::string_view::npos ? std::optional<double>(0.0) : std::nullopt;
  }
  if (fault != std::errc{} || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  std::int64_t value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, fault] = std::from_chars(digits.data(), end, value);
  const bool signs_agree = digits.size() == text.size() || (!digits.empty() && is_digit(digits.front()));
  if (!digits.empty() && fault == std::errc{} && stop == end && signs_agree) return value;
  const std::optional<double> real = parse_real(text);
  constexpr double exact_limit = 9007199254740992.0;  // 2^53
  if (!real || std::floor(*real) != *real || std::fabs(*real) > exact_limit) return std::nullopt;
  return static_cast<std::int64_t>(*real);
}

}  // namespace crumple::deck
