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
    only("VP", {0, 1}, "0 multiplies the yield stress, 1 adds to it where the law tells them apart");

/// The same of laws whose rates are all on the card: take_viscoplastic() checks its value.
inline constexpr Field viscoplastic_value = real("VP");

// Of damage, on the cards of *MAT_ADD_DAMAGE_GISSMO and, with IDAM = 1, of *MAT_ADD_EROSION.
inline constexpr Field damage_failure = signed_id("LCSDG", IdKind::Function);
inline constexpr Field damage_instability = real_or_id("ECRIT", IdKind::Function);
inline constexpr Field damage_exponent = real_or_default("DMGEXP", 1, above_zero);
inline constexpr Field damage_critical = real("DCRIT", 0, within(0, 1, "a damage"));
inline constexpr Field damage_fading = real_or_id("FADEXP", IdKind::Function);
inline constexpr Field damage_regularization = signed_id("LCREGD", IdKind::Function);
inline constexpr Field damage_rates = signed_id("LCSRS", IdKind::Function);
inline constexpr Field damage_limits = only("LCDLIM", {0}, "damage goes up to one");
inline constexpr Field damage_middle =
    only("MIDFAIL", {0}, "every point is checked, not that of the mid-surface first");

}  // namespace row

/// Number, title, density and place of a material whose first card this is.
RawMaterial material_of(const Heading& heading, const Card& card);

/// LS-DYNA's default for "never" is a huge strain; here it is zero.
double failure_strain(double read);

/// A time step of deletion, for whose "never" decks have a huge number; here it is zero.
double deletion_step(double read);

/// The direction that AOPT of a card calls for: of the card with A1 to A3, or of that with V1 to V3.
void take_direction(const Card& second, const Card& third, const Card& fourth, model::OrthotropicElastic& law,
                    Report& report);

/// Gives an orthotropic law its isotropic stand-in; `card` has PRBA. False if the numbers are not sound, or,
/// with a message, not those of a material.
bool take_stand_in(const Card& card, bool sound, model::OrthotropicElastic& law, Report& report);

/// What LCSDG and the fields behind it say of damage, and those from LCSRS on; material, DTYP and NUMFIP
/// stand elsewhere.
RawDamage damage_of(const Card& curves, const Card& more, Report& report);

/// Reports a PC above zero.
void check_pressure_cut_off(const Card& card, Report& report);

/// Reports a Cowper-Symonds rate without its exponent.
void check_rate(const Card& card, std::string_view rate, std::string_view exponent, Report& report);

/// Whether VP says viscoplastic, where `rate` switches the rate effect on. Without one any VP passes, those
/// that mean nothing with a warning.
bool take_viscoplastic(const Card& card, double rate, Report& report);

}  // namespace crumple::deck
