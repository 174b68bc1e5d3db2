// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "deck/format/cards.hpp"

namespace crumple::deck {

inline constexpr std::string_view supported_formulations =
    "0, 1, 2, 4, 5, 6, 9, 10 or 16, the only values supported";
inline constexpr std::string_view meaning_of_formulations =
    "1 is Hughes-Liu, 2 Belytschko-Tsay, 4 the C0 triangle, 5 the Belytschko-Tsay membrane, "
    "6 Hughes-Liu selectively reduced, 9 the fully integrated membrane, 10 "
    "Belytschko-Wong-Chiang, 16 fully integrated, 0 of sections what *CONTROL_SHELL says";

/// True for the numbers that supported_formulations names.
bool is_shell_formulation(double number);

/// What ELFORM of *SECTION_SHELL says: the number of a supported formulation, 0
/// for none. Another one is reported as not supported, and 0.
std::int64_t checked_formulation(const Card& card, std::string_view field, Report& report);

}  // namespace crumple::deck
