// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace crumple::compare {

/// Numbers as Fortran and C write them into columns: `1.5E+03`, `1.5D+03`, `1.5+103` (three digits of the
/// exponent leave no room for its letter), and without a space before a minus (`1.0E+00-2.0E+00`).
///
/// Takes the first number off the front of `text` after white space. Nothing, and `text` as it was, if
/// something else comes first; stars, which Fortran writes where a number has no room, are a number that is
/// none (NaN).
std::optional<double> take_number(std::string_view& text);

/// All numbers from the front on, until the end or something else.
std::vector<double> take_numbers(std::string_view text);

/// The whole text as one number, spaces around it aside.
std::optional<double> only_number(std::string_view text);

/// The next line of `text`, taken off its front, without its end (also a carriage return).
std::string_view take_line(std::string_view& text);

/// Without white space at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace crumple::compare
