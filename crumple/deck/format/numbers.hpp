// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace crumple::deck {

/// The text without blanks, tabs and carriage returns at its ends.
std::string_view trimmed(std::string_view text);

/// ASCII upper case; other bytes stay.
std::string upper_case(std::string_view text);

/// A finite number as Fortran writes it: `1.5`, `.5`, `1.5e3`, `1.5D3`, `1.5+3` (an exponent without letter).
/// Nothing for any other text, for infinities and for not-a-number.
std::optional<double> parse_real(std::string_view text);

/// A whole number; also one written with a decimal point (`2.`, `0.000E+00`), as old decks have.
std::optional<std::int64_t> parse_integer(std::string_view text);

}  // namespace crumple::deck
