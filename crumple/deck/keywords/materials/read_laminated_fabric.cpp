// SPDX-License-Identifier: BSD-3-Clause
// *MAT_LAMINATED_COMPOSITE_FABRIC.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Check laminate_share = within(0, 1, "the share of the strength that is left");

constexpr Field laminate_moduli_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("EA", 0, above_zero),
    real("EB", 0, above_zero),
    real("EC", 0, not_negative),  // default EB
    real("PRBA"),
    real("TAU1", 0, not_negative),
    real("GAMMA1", 0, not_negative),
};

constexpr Field laminate_second_card[] = {
    real("GAB", 0, above_zero),        real("GBC", 0, above_zero),        real("GCA", 0, above_zero),
    real("SLIMT1", 0, laminate_share), real("SLIMC1", 0, laminate_share), real("SLIMT2", 0, laminate_share),
    real("SLIMC2", 0, laminate_share), real("SLIMS", 0, laminate_share),
};

constexpr std::string_view no_transverse_shear_damage = "transverse shear does no damage";
constexpr Field laminate_third_card[] = {
    only("AOPT", {0, 2, 3},
         "0 is along the side from N1 to N2, 2 along the vector a, 3 along v x normal of the shell"),
    real("TSIZE", 0, not_negative),
    real("ERODS", 0, not_negative),
    unused("SOFT"),  // of the crash front, which only TSIZE makes
    only("FS", {0, -1, 1},
         "-1 has facets, 0 couples shear and the stress across, 1 both directions and shear"),
    only("EPSF", {0}, no_transverse_shear_damage),
    unused("EPSR"),  // of EPSF
    unused("TSMD"),  // the same
};

constexpr Field laminate_fourth_card[] = {
    unused("XP"),          unused("YP"),          unused("ZP"),  // of AOPT = 1 and 4
    direction(real("A1")), direction(real("A2")), direction(real("A3")), real("PRCA"), real("PRCB"),
};

constexpr Field laminate_fifth_card[] = {
    direction(real("V1")), direction(real("V2")),
    direction(real("V3")), unused("D1"),
    unused("D2"),          unused("D3"),
    real("BETA"),          only("LCDFAIL", {0}, "points fail by ERODS alone"),
};

constexpr Field laminate_strains_card[] = {real("E11C"), real("E11T"), real("E22C"), real("E22T"),
                                           real("GMS")};

constexpr Field laminate_strengths_card[] = {real("XC"), real("XT"), real("YC"), real("YT"), real("SC")};

constexpr std::string_view no_laminate_rates = "strengths do not depend on the rate; give numbers";
constexpr Field laminate_rates_card[] = {
    only("LCXC", {0}, no_laminate_rates),  only("LCXT", {0}, no_laminate_rates),
    only("LCYC", {0}, no_laminate_rates),  only("LCYT", {0}, no_laminate_rates),
    only("LCSC", {0}, no_laminate_rates),  only("LCTAU", {0}, no_laminate_rates),
    only("LCGAM", {0}, no_laminate_rates), unused("DT"),
};
constexpr std::string_view no_strain_rates = "strains at strength do not depend on the rate; give numbers";
constexpr Field laminate_strain_rates_card[] = {
    only("LCE11C", {0}, no_strain_rates),
    only("LCE11T", {0}, no_strain_rates),
    only("LCE22C", {0}, no_strain_rates),
    only("LCE22T", {0}, no_strain_rates),
    only("LCGMS", {0}, no_strain_rates),
    only("LCEFS", {0}, "ERODS does not depend on the rate; give a number"),
};

/// The cards of one material.
struct LaminateCards {
  Card first, second, third, fourth, fifth, strains, strengths;
};

/// A mode: decks give strengths and strains in compression with either sign.
model::LaminatedFabric::Mode laminate_mode(const LaminateCards& c, double modulus, std::string_view strength,
                                           std::string_view strain, std::string_view limit, Report& report) {
  model::LaminatedFabric::Mode mode{std::fabs(c.strengths.real(strength)), std::fabs(c.strains.real(strain)),
                                    c.second.real(limit)};
  if (!c.strengths.good(strength) || !c.strains.good(strain)) return mode;
  if (!(mode.strength > 0)) {
    report.field_error(c.strengths.where(),
                       {strength, std::string(c.strengths.text(strength)), "a number other than zero",
                        "it is a strength, its sign does not count in compression", "strength"});
    return mode;
  }
  if (modulus > 0 && !(mode.strain > (1 - 1e-6) * mode.strength / modulus))
    report.field_error(c.strains.where(),
                       {strain, std::string(c.strains.text(strain)),
                        fmt::format("a strain of at least {:.4g}", mode.strength / modulus),
                        fmt::format("it is the strain at {} = {:.4g}, where the modulus alone gives that",
                                    strength, mode.strength),
                        "strain"});
  return mode;
}

void take_laminate_modes(const LaminateCards& c, model::LaminatedFabric& law, Report& report) {
  const double a = c.first.good("EA") ? law.modulus_a : 0;
  const double b = c.first.good("EB") ? law.modulus_b : 0;
  law.tension_a = laminate_mode(c, a, "XT", "E11T", "SLIMT1", report);
  law.compression_a = laminate_mode(c, a, "XC", "E11C", "SLIMC1", report);
  law.tension_b = laminate_mode(c, b, "YT", "E22T", "SLIMT2", report);
  law.compression_b = laminate_mode(c, b, "YC", "E22C", "SLIMC2", report);
  law.shear = laminate_mode(c, c.second.good("GAB") ? law.shear_ab : 0, "SC", "GMS", "SLIMS", report);
}

/// TAU1 and GAMMA1, of FS = -1 alone.
void take_first_shear(const LaminateCards& c, model::LaminatedFabric& law, Report& report) {
  const double stress = c.first.real("TAU1");
  const double strain = c.first.real("GAMMA1");
  const std::string read(c.first.text("TAU1"));
  if (stress == 0 && strain == 0) return;
  if (law.surface != model::LaminatedFabric::Surface::Facets) {
    report.field_warning(c.first.where(),
                         {"TAU1", read, "0", "it counts with FS = -1 only: left out", "shear"});
    return;
  }
  const bool below = stress > 0 && stress <= law.shear.strength && strain > 0 && strain < law.shear.strain;
  if (!below || !(strain > (1 - 1e-6) * stress / law.shear_ab)) {
    report.field_error(c.first.where(),
                       {"TAU1", read, "a stress up to SC, with a strain GAMMA1 below GMS",
                        "GAMMA1 must not be below TAU1 / GAB: the shear begins with GAB", "shear"});
    return;
  }
  law.first_shear_stress = stress;
  law.first_shear_strain = strain;
}

LaminateCards laminate_cards(Cards& cards) {
  LaminateCards c{cards.next(laminate_moduli_card),   cards.next(laminate_second_card),
                  cards.next(laminate_third_card),    cards.next(laminate_fourth_card),
                  cards.next(laminate_fifth_card),    cards.next(laminate_strains_card),
                  cards.next(laminate_strengths_card)};
  // Further cards end with the keyword, so that only one material may have them.
  cards.next_or_default(laminate_rates_card);
  cards.next_or_default(laminate_strain_rates_card);
  return c;
}

}  // namespace

void read_mat_laminated_composite_fabric(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const LaminateCards c = laminate_cards(cards);
    if (c.third.good("TSIZE") && c.third.real("TSIZE") > 0)
      cards.report().field_warning(
          c.third.where(), {"TSIZE", std::string(c.third.text("TSIZE")), "0",
                            "shells stay that need a smaller step than that: left out", "failing step"});
    RawMaterial raw = material_of(heading, c.first);
    model::LaminatedFabric law;
    law.modulus_a = c.first.real("EA");
    law.modulus_b = c.first.real("EB");
    law.modulus_c = c.first.real("EC") > 0 ? c.first.real("EC") : law.modulus_b;
    law.poisson_ba = c.first.real("PRBA");
    law.poisson_ca = c.fourth.real("PRCA");
    law.poisson_cb = c.fourth.real("PRCB");
    law.shear_ab = c.second.real("GAB");
    law.shear_bc = c.second.real("GBC");
    law.shear_ca = c.second.real("GCA");
    law.angle = (cards.placement().map.mirrors() ? -1 : 1) * c.fifth.real("BETA") * std::numbers::pi / 180;
    take_direction(c.third, c.fourth, c.fifth, law, cards.report());
    using enum model::LaminatedFabric::Surface;
    const double surface = c.third.real("FS");
    law.surface = surface < 0 ? Facets : surface > 0 ? Smooth : Across;
    law.erosion_strain = failure_strain(c.third.real("ERODS"));
    take_laminate_modes(c, law, cards.report());
    if (c.third.good("FS") && law.shear.strength > 0) take_first_shear(c, law, cards.report());
    const bool is_sound = c.first.good("EA") && c.first.good("EB") && c.first.good("PRBA") &&
                          c.second.good("GAB") && c.second.good("GBC") && c.second.good("GCA");
    take_stand_in(c.first, is_sound, law, cards.report());
    raw.material.law = law;
    if (c.first.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
