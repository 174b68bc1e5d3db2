// SPDX-License-Identifier: BSD-3-Clause
// *MAT_COMPOSITE_DAMAGE, *MAT_ENHANCED_COMPOSITE_DAMAGE.
#include <cmath>
#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view option_words =
    "0 is along the side from N1 to N2, 2 along the vector a, 3 along v x normal of the shell";

constexpr Field moduli_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("EA", 0, above_zero),
    real("EB", 0, above_zero),
    real("EC", 0, not_negative),  // default EB
    real("PRBA"),
    real("PRCA"),
    real("PRCB"),
};

constexpr Field damage_second_card[] = {
    real("GAB", 0, above_zero),
    real("GBC", 0, above_zero),
    real("GCA", 0, above_zero),
    unused("KFAIL"),  // of solids
    only("AOPT", {0, 2, 3}, option_words),
    unused("MACF"),  // of solids
    only("ATRACK", {0}, "the axes turn with the shell, they do not follow the strain"),
};

constexpr Field enhanced_second_card[] = {
    real("GAB", 0, above_zero),
    real("GBC", 0, above_zero),
    real("GCA", 0, above_zero),
    unused("KF"),  // of solids
    only("AOPT", {0, 2, 3}, option_words),
    only("2WAY", {0}, "fibres run one way; two crossed layers stand for a fabric"),
    only("TI", {0}, "it is for solids"),
};

constexpr Field damage_third_card[] = {
    unused("XP"),          unused("YP"),          unused("ZP"),
    direction(real("A1")), direction(real("A2")), direction(real("A3")),
};

constexpr Field enhanced_third_card[] = {
    unused("XP"),          unused("YP"),          unused("ZP"),   direction(real("A1")),
    direction(real("A2")), direction(real("A3")), real("MANGLE"),
};

constexpr Field damage_fourth_card[] = {
    direction(real("V1")), direction(real("V2")), direction(real("V3")), unused("D1"),
    unused("D2"),          unused("D3"),          real("BETA"),
};

constexpr Field damage_fifth_card[] = {
    real("SC", 0, above_zero),
    real("XT", 0, above_zero),
    real("YT", 0, above_zero),
    real("YC"),
    real("ALPH", 0, not_negative),
    unused("SN"),  // normal to the layers, of solids
    unused("SYZ"),
    unused("SZX"),
};

constexpr Field enhanced_fourth_card[] = {
    direction(real("V1")),
    direction(real("V2")),
    direction(real("V3")),
    unused("D1"),
    unused("D2"),
    unused("D3"),
    real("DFAILM", 0, not_negative),
    real("DFAILS", 0, not_negative),
};

constexpr Field enhanced_fifth_card[] = {
    real("TFAIL", 0,
         within(0, 0.1, "a step of shells that fail; as a ratio of steps, above 0.1, it is not supported")),
    real("ALPH", 0, not_negative),
    unused("SOFT"),  // of the crash front, which only TFAIL makes
    real("FBRT", 0, within(0, 1, "the share of XT that is left where the matrix has been crushed")),
    real_or_default("YCFAC", 2, above_zero),
    real("DFAILT", 0, not_negative),
    real("DFAILC"),
    real("EFS", 0, not_negative),
};

constexpr Field enhanced_sixth_card[] = {
    real("XC"),
    real("XT", 0, above_zero),
    real("YC"),
    real("YT", 0, above_zero),
    real("SC", 0, above_zero),
    only("CRIT", {0, 54, 55}, "54 is Chang & Chang, 55 Tsai-Wu for the matrix, 0 that of the keyword"),
    real("BETA", 0, within(0, 1, "0 is the criterion of largest stress, 1 Hashin's")),
};

constexpr Field front_card[] = {
    unused("PFL"),  // of the crash front, which only TFAIL makes
    only("EPSF", {0}, "transverse shear does no damage"),
    unused("EPSR"),
    unused("TSMD"),
    unused("SOFT2"),
};

constexpr std::string_view plateau =
    "the stress stays at its strength, which is 0 or 1; lower limits are not supported";
constexpr Field limits_card[] = {
    only("SLIMT1", {0, 1}, plateau),
    only("SLIMC1", {0, 1}, plateau),
    only("SLIMT2", {0, 1}, plateau),
    only("SLIMC2", {0, 1}, plateau),
    only("SLIMS", {0, 1}, plateau),
    unused("NCYRED"),
    unused("SOFTG"),
};

constexpr std::string_view no_rates = "strengths do not depend on the rate; give numbers";
constexpr Field rates_card[] = {
    only("LCXC", {0}, no_rates), only("LCXT", {0}, no_rates), only("LCYC", {0}, no_rates),
    only("LCYT", {0}, no_rates), only("LCSC", {0}, no_rates), unused("DT"),
};

/// Moduli and shear moduli. The axis c counts for the strain across the shell alone.
void take_moduli(const Card& card, const Card& second, model::OrthotropicElastic& law) {
  law.modulus_a = card.real("EA");
  law.modulus_b = card.real("EB");
  law.modulus_c = card.real("EC") > 0 ? card.real("EC") : law.modulus_b;
  law.poisson_ba = card.real("PRBA");
  law.poisson_ca = card.real("PRCA");
  law.poisson_cb = card.real("PRCB");
  law.shear_ab = second.real("GAB");
  law.shear_bc = second.real("GBC");
  law.shear_ca = second.real("GCA");
}

bool is_sound(const Card& card, const Card& second) {
  return card.good("EA") && card.good("EB") && card.good("PRBA") && second.good("GAB") &&
         second.good("GBC") && second.good("GCA");
}

double angle_of(const Card& card, std::string_view field, const Cards& cards) {
  return (cards.placement().map.mirrors() ? -1 : 1) * card.real(field) * std::numbers::pi / 180;
}

/// A strength in compression, which decks give with either sign.
double compression(const Card& card, std::string_view field, Report& report) {
  const double strength = std::fabs(card.real(field));
  if (card.good(field) && !(strength > 0))
    report.field_error(card.where(), {field, std::string(card.text(field)), "a number other than zero",
                                      "it is a strength, its sign does not count", "strength"});
  return strength;
}

/// Strains of failure, which CRIT = 54 has, some of them only with DFAILT.
void take_limits(const Card& fourth, const Card& fifth, model::CompositeDamage& law, Report& report) {
  const bool is_chang = law.matrix == model::CompositeDamage::Matrix::Chang;
  const auto take = [&](const Card& card, std::string_view field, bool counts, std::string_view why) {
    const double value = card.real(field);
    if (counts || value == 0) return value;
    report.field_warning(card.where(),
                         {field, std::string(card.text(field)), "0", std::string(why), "limit"});
    return 0.0;
  };
  constexpr std::string_view of_54 = "the strains of failure count with CRIT = 54 only: left out";
  constexpr std::string_view with_tension = "it counts only where DFAILT is given, too: left out";
  law.failure_tension = take(fifth, "DFAILT", is_chang, of_54);
  law.failure_effective = take(fifth, "EFS", is_chang, of_54);
  const bool limited = is_chang && law.failure_tension > 0;
  const std::string_view why = is_chang ? with_tension : of_54;
  law.failure_compression = take(fifth, "DFAILC", limited, why);
  law.failure_matrix = take(fourth, "DFAILM", limited, why);
  law.failure_shear = take(fourth, "DFAILS", limited, why);
  law.goes_by_fibre_tension = law.failure_tension == 0;
  if (law.failure_compression > 0)
    report.field_error(fifth.where(), {"DFAILC", std::string(fifth.text("DFAILC")), "a number not above zero",
                                       "it is a strain in compression", "sign"});
}

/// CRIT, or what the name of the keyword says.
model::CompositeDamage::Matrix criterion(const Card& card) {
  const double given = card.real("CRIT");
  const bool by_name = given == 0 && card.where().keyword.find("55") != std::string_view::npos;
  return given == 55 || by_name ? model::CompositeDamage::Matrix::TsaiWu
                                : model::CompositeDamage::Matrix::Chang;
}

}  // namespace

void read_mat_composite_damage(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(moduli_card);
    const Card second = cards.next(damage_second_card);
    const Card third = cards.next(damage_third_card);
    const Card fourth = cards.next(damage_fourth_card);
    const Card fifth = cards.next(damage_fifth_card);
    RawMaterial raw = material_of(heading, card);
    model::CompositeDamage law;
    take_moduli(card, second, law);
    law.angle = angle_of(fourth, "BETA", cards);
    take_direction(second, third, fourth, law, cards.report());
    law.matrix = model::CompositeDamage::Matrix::ChangShear;
    law.shear_strength = fifth.real("SC");
    law.tension_a = fifth.real("XT");
    law.tension_b = fifth.real("YT");
    law.compression_b = compression(fifth, "YC", cards.report());
    // Fibres do not fail in compression.
    law.compression_a = 1e3 * law.modulus_a;
    law.shear_softening = fifth.real("ALPH");
    law.shear_in_fibre_mode = 1;
    take_stand_in(card, is_sound(card, second), law, cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_enhanced_composite_damage(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(moduli_card);
    const Card second = cards.next(enhanced_second_card);
    const Card third = cards.next(enhanced_third_card);
    const Card fourth = cards.next(enhanced_fourth_card);
    const Card fifth = cards.next(enhanced_fifth_card);
    const Card sixth = cards.next(enhanced_sixth_card);
    if (fifth.good("TFAIL") && fifth.real("TFAIL") > 0)
      cards.report().field_warning(
          fifth.where(), {"TFAIL", std::string(fifth.text("TFAIL")), "0",
                          "shells stay that need a smaller step than that: left out", "failing step"});
    // Further cards end with the keyword, so that only one material may have them.
    cards.next_or_default(front_card);
    cards.next_or_default(limits_card);
    cards.next_or_default(rates_card);
    RawMaterial raw = material_of(heading, card);
    model::CompositeDamage law;
    take_moduli(card, second, law);
    law.angle = angle_of(third, "MANGLE", cards);
    take_direction(second, third, fourth, law, cards.report());
    law.matrix = criterion(sixth);
    law.tension_a = sixth.real("XT");
    law.compression_a = compression(sixth, "XC", cards.report());
    law.tension_b = sixth.real("YT");
    law.compression_b = compression(sixth, "YC", cards.report());
    law.shear_strength = sixth.real("SC");
    law.shear_softening = fifth.real("ALPH");
    law.shear_in_fibre_mode = sixth.real("BETA");
    law.fibre_tension_left = fifth.real("FBRT");
    law.fibre_compression_by_matrix = fifth.real("YCFAC");
    take_limits(fourth, fifth, law, cards.report());
    take_stand_in(card, is_sound(card, second), law, cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
