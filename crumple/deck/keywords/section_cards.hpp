// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "deck/format/cards.hpp"
#include "deck/format/report.hpp"

namespace crumple::deck {

/// A dimension of a cross section that must be there and above zero: true if it is, else it is reported.
/// `hint` says what it is. Defined in read_beam_sections.cpp.
bool check_dimension(const Card& size, std::string_view name, std::string_view hint, Report& report);

}  // namespace crumple::deck
