// SPDX-License-Identifier: BSD-3-Clause
// *MAT_CSCM, *MAT_CSCM_CONCRETE.
#include <fmt/core.h>

#include <array>
#include <string>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field cscm_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    unused("NPLOT"),  // what LS-DYNA writes as plastic strain
    unused("INCRE"),  // the return to the yield surface needs no smaller increments
    only("IRATE", {0, 1}, "1 switches the rate effects on"),
    real("ERODE"),
    real("RECOV", 0, not_negative),
    only("ITRETRC", {0}, "the cap does not retract"),
};
constexpr Field cscm_damage_card[] = {real("PRED", 0, not_negative)};

constexpr Field cscm_concrete_card[] = {
    real_or_default("FPC", 0, not_negative),
    real_or_default("DAGG", 0, not_negative),
    only("UNITS", {0, 1, 2, 3, 4},
         "0: GPa, mm, ms; 1: MPa, mm, ms; 2: MPa, mm, s; 3: psi, inch, s; 4: Pa, m, s"),
};

constexpr Field cscm_strength_card[] = {
    real("G", 0, above_zero),
    real("K", 0, above_zero),
    real("ALPHA", 0, above_zero),
    real("THETA", 0, not_negative),
    real("LAMDA", 0, not_negative),
    real("BETA", 0, not_negative),
    only("NH", {0, 1},
         "the yield surface does not move up to the failure surface, it is there from the start"),
    only("CH", {0}, "the yield surface does not move up to the failure surface, it is there from the start"),
};
constexpr Field cscm_ratio_card[] = {
    real("ALPHA1"),
    real("THETA1", 0, not_negative),
    real("LAMDA1", 0, not_negative),
    real("BETA1", 0, not_negative),
    real("ALPHA2"),
    real("THETA2", 0, not_negative),
    real("LAMDA2", 0, not_negative),
    real("BETA2", 0, not_negative),
};
constexpr Field cscm_cap_card[] = {
    real("R", 0, above_zero),    real("X0", 0, above_zero),   real("W", 0, not_negative),
    real("D1", 0, not_negative), real("D2", 0, not_negative),
};
constexpr Field cscm_energy_card[] = {
    real("B", 0, above_zero),      real("GFC", 0, above_zero),    real("D", 0, above_zero),
    real("GFT", 0, above_zero),    real("GFS", 0, above_zero),    real("PWRC", 0, not_negative),
    real("PWRT", 0, not_negative), real("PMOD", 0, not_negative),
};
constexpr Field cscm_rate_card[] = {
    real("ETA0C", 0, not_negative), real("NC", 0, within(0, 1, "an exponent of the rate")),
    real("ETA0T", 0, not_negative), real("NT", 0, within(0, 1, "an exponent of the rate")),
    real("OVERC", 0, not_negative), real("OVERT", 0, not_negative),
    real("SRATE", 0, not_negative), real("REPOW", 0, not_negative),
};

/// FPC and DAGG of zero [MPa, mm].
constexpr double default_strength = 30;
constexpr double default_aggregate = 19;

constexpr std::array<model::ConcreteUnits, 5> concrete_units = {{
    {1000, 1, 1e-3},
    {1, 1, 1e-3},
    {1, 1, 1},
    {0.00689475729, 25.4, 1},
    {1e-6, 1000, 1},
}};

/// What stands on the first two cards, of both keywords.
void take_options(const Card& card, const Card& damage, model::CapConcrete& law, Report& report) {
  law.has_rate_effects = card.real("IRATE") == 1;
  const double erode = card.real("ERODE");
  law.erodes = erode >= 1;
  law.erosion_strain = law.erodes ? erode - 1 : 0;
  law.first_damage = damage.real("PRED");
  if (damage.good("PRED") && law.first_damage >= 1)
    report.field_error(damage.where(), {"PRED", std::string(damage.text("PRED")), "a damage below 1",
                                        "nothing would be left of the concrete", "damage"});
  double recovery = card.real("RECOV");
  law.recovers_by_volume = recovery >= 10;
  if (law.recovers_by_volume) recovery -= 10;
  law.kept_damage = recovery;
  if (card.good("RECOV") && recovery > 1)
    report.field_error(card.where(), {"RECOV", std::string(card.text("RECOV")), "0 to 1 or 10 to 11",
                                      "the share of brittle damage that stays under pressure", "recovery"});
}

/// Says where the fits of strength and aggregate are not backed by tests; false where they have no meaning.
bool check_fit(const Card& card, double strength, double aggregate, Report& report) {
  if (strength < 5 || strength > 120 || aggregate < 1 || aggregate > 100) {
    report.error(card.where(), "strength",
                 fmt::format("FPC is {:.4g} MPa and DAGG {:.4g} mm in these UNITS, which is no concrete: the "
                             "default parameters hold from 20 to 58 MPa and from 8 to 32 mm",
                             strength, aggregate));
    return false;
  }
  if (strength < 20 || strength > 58 || aggregate < 8 || aggregate > 32)
    report.warning(
        card.where(), "strength",
        fmt::format("FPC is {:.4g} MPa and DAGG {:.4g} mm: the default parameters have been fitted "
                    "from 20 to 58 MPa and from 8 to 32 mm",
                    strength, aggregate));
  return true;
}

model::CapConcrete default_concrete(const Card& card, Report& report) {
  const bool good = card.good("FPC") && card.good("DAGG") && card.good("UNITS");
  const auto units = concrete_units[good ? static_cast<std::size_t>(card.real("UNITS")) : 0];
  double strength = card.real("FPC") * units.stress;
  double aggregate = card.real("DAGG") * units.length;
  if (!(strength > 0)) strength = default_strength;
  if (!(aggregate > 0)) aggregate = default_aggregate;
  if (!good || !check_fit(card, strength, aggregate, report))
    return model::normal_strength_concrete(default_strength, default_aggregate, units);
  return model::normal_strength_concrete(strength, aggregate, units);
}

void take_strength(const Card& strength, const Card& ratios, model::CapConcrete& law) {
  law.shear_modulus = strength.real("G");
  law.bulk_modulus = strength.real("K");
  law.compression = {strength.real("ALPHA"), strength.real("THETA"), strength.real("LAMDA"),
                     strength.real("BETA")};
  law.torsion = {ratios.real("ALPHA1"), ratios.real("THETA1"), ratios.real("LAMDA1"), ratios.real("BETA1")};
  law.extension = {ratios.real("ALPHA2"), ratios.real("THETA2"), ratios.real("LAMDA2"), ratios.real("BETA2")};
  model::set_elastic(law);
}

void take_damage(const Card& cap, const Card& energy, const Card& rate, model::CapConcrete& law) {
  law.cap_ratio = cap.real("R");
  law.cap_start = cap.real("X0");
  law.crush_volume = cap.real("W");
  law.crush_linear = cap.real("D1");
  law.crush_quadratic = cap.real("D2");
  law.ductile_shape = energy.real("B");
  law.compression_energy = energy.real("GFC");
  law.brittle_shape = energy.real("D");
  law.tension_energy = energy.real("GFT");
  law.shear_energy = energy.real("GFS");
  law.compression_power = energy.real("PWRC");
  law.tension_power = energy.real("PWRT");
  law.pressure_power = energy.real("PMOD");
  law.compression_rate = {rate.real("ETA0C"), rate.real("NC"), rate.real("OVERC")};
  law.tension_rate = {rate.real("ETA0T"), rate.real("NT"), rate.real("OVERT")};
  law.shear_fluidity = rate.real("SRATE");
  law.energy_power = rate.real("REPOW");
}

}  // namespace

void read_mat_cscm(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(cscm_card);
    const Card damage = cards.next(cscm_damage_card);
    const Card strength = cards.next(cscm_strength_card);
    const Card ratios = cards.next(cscm_ratio_card);
    const Card cap = cards.next(cscm_cap_card);
    const Card energy = cards.next(cscm_energy_card);
    const Card rate = cards.next(cscm_rate_card);
    RawMaterial raw = material_of(heading, card);
    model::CapConcrete law;
    take_options(card, damage, law, cards.report());
    take_strength(strength, ratios, law);
    take_damage(cap, energy, rate, law);
    if (strength.good("LAMDA") && !(law.compression.constant > law.compression.nonlinear))
      cards.report().field_error(strength.where(),
                                 {"LAMDA", std::string(strength.text("LAMDA")), "a number below ALPHA",
                                  "the strength without pressure is ALPHA - LAMDA", "strength"});
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_cscm_concrete(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(cscm_card);
    const Card damage = cards.next(cscm_damage_card);
    const Card concrete = cards.next(cscm_concrete_card);
    RawMaterial raw = material_of(heading, card);
    model::CapConcrete law = default_concrete(concrete, cards.report());
    take_options(card, damage, law, cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
