// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "deck/format/cards.hpp"

namespace crumple::deck {

/// What ELFORM of *SECTION_SHELL and THEORY of *CONTROL_SHELL say: the number of a supported formulation, 0
/// for none. Another one is reported as not supported, and 0.
std::int64_t checked_formulation(const Card& card, std::string_view field, Report& report);

}  // namespace crumple::deck
