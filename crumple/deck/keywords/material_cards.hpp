// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "deck/format/cards.hpp"
#include "deck/format/raw_deck.hpp"

namespace crumple::deck {

/// What the cards of several materials have in common.
namespace row {

inline constexpr Check poisson = between(-1, 0.5, "Poisson's ratio of an elastic solid");
inline constexpr Field viscoplastic_field =
    only("VP", {0, 1}, "0 scales the yield stress by the total strain rate, 1 is viscoplastic");

}  // namespace row

/// Number, title, density and place of a material whose first card this is.
RawMaterial material_of(const Heading& heading, const Card& card);

/// LS-DYNA's default for "never" is a huge strain; here it is zero.
double failure_strain(double read);

/// Reports a PC above zero.
void check_pressure_cut_off(const Card& card, Report& report);

/// Reports a Cowper-Symonds rate without its exponent.
void check_rate(const Card& card, std::string_view rate, std::string_view exponent, Report& report);

}  // namespace crumple::deck
