// SPDX-License-Identifier: BSD-3-Clause
// *MAT_POWER_LAW_PLASTICITY, *MAT_JOHNSON_COOK, *MAT_SIMPLIFIED_JOHNSON_COOK.
#include <fmt/core.h>

#include <cmath>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field power_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("K", 0, above_zero),
    real("N", 0, within(0, 1, "the hardening exponent")),
    real("SRC", 0, not_negative),
    real("SRP", 0, not_negative),
};

// Some sources have VP and EPSF the other way round: see failure_comes_first().
constexpr Field power_second_card[] = {
    real("SIGY", 0, not_negative),
    viscoplastic_value,
    real("EPSF", 0, not_negative),
};

constexpr Field johnson_cook_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, not_negative),  // with an equation of state; gives E where that is missing
    real("E", 0, not_negative),
    real("PR", 0, poisson),
    only("DTF", {0},
         "elements are not deleted by their time step; D1 to D5 erode shells, and DT2MS of *CONTROL_TIMESTEP "
         "keeps "
         "up the step"),
    viscoplastic_value,
    only("RATEOP", {0}, "0 is Johnson and Cook's own rate effect, C ln(rate / EPS0)"),
};

constexpr Field johnson_cook_second_card[] = {
    real("A", 0, above_zero),
    real("B", 0, not_negative),
    real("N", 0, not_negative),
    real("C", 0, not_negative),
    real("M", 0, not_negative),
    real("TM", 0, not_negative),
    real("TR", 0),
    real("EPS0", 0, not_negative),  // above zero where C is
};

constexpr Field johnson_cook_third_card[] = {
    real("CP", 0, not_negative),
    real("PC"),  // not above zero
    only("SPALL", {0, 1, 2, 3},
         "1 bounds the pressure, 2 makes rubble at a principal stress of -PC, 3 at the pressure PC, 0 is 2"),
    unused("IT"),  // plasticity is always iterated to the end
    real("D1"),
    real("D2"),
    real("D3"),
    real("D4"),
};

constexpr Field johnson_cook_fourth_card[] = {
    real("D5"),
    unused("C2"),  // belongs to other rate effects
    only("EROD", {0}, "a shell erodes when all its points have failed"),
    real_or_default("EFMIN", 1e-6, above_zero),
    only("NUMINT", {0}, "a shell erodes when all its points have failed"),
};

constexpr Field simplified_card[] = {
    id("MID"),          real("RO", 0, above_zero), real("E", 0, above_zero), real("PR", 0, poisson),
    viscoplastic_value,
};

constexpr Field simplified_second_card[] = {
    real("A", 0, above_zero),
    real("B", 0, not_negative),
    real("N", 0, not_negative),
    real("C", 0, not_negative),
    real_or_default("PSFAIL", 1e17, above_zero),
    real_or_default("SIGMAX", 1e28, above_zero),
    real_or_default("SIGSAT", 1e28, above_zero),
    real_or_default("EPSO", 1.0, above_zero),
};

/// Elastic strain at yield: SIGY itself if it is small, else that of the stress SIGY on the curve k e^n; and
/// without SIGY the intersection of that curve with the elastic line.
double yield_strain(const Card& card, const Card& second, Report& report) {
  constexpr double largest_strain = 0.02;
  const double sigy = second.real("SIGY");
  const double strength = card.real("K");
  const double exponent = card.real("N");
  if (sigy > 0 && sigy < largest_strain) return sigy;
  if (exponent == 0) return strength / card.real("E");
  const double strain = sigy > 0       ? std::pow(sigy / strength, 1 / exponent)
                        : exponent < 1 ? std::pow(card.real("E") / strength, 1 / (exponent - 1))
                                       : 1;
  if (!(strain > 0 && strain < 1))
    report.field_error(
        second.where(),
        {"SIGY", std::string(second.text("SIGY")), "a strain at yield below 0.02 or a yield stress below K",
         fmt::format("the strain at yield comes out as {:.4g}", strain), "yield"});
  return strain;
}

/// Whether the second field of *MAT_018's second card is EPSF and the third VP, as some sources have it. Only
/// a value that is no VP tells; where both may be either, says how they are taken.
bool failure_comes_first(const Card& second, Report& report) {
  if (!second.good("VP") || !second.good("EPSF")) return false;
  const auto is_flag = [](double value) { return value == 0 || value == 1; };
  const double middle = second.real("VP");
  const double last = second.real("EPSF");
  if (!is_flag(last)) return false;
  if (!is_flag(middle) && middle > 0) {
    report.add(
        Severity::Note, second.where(), "order",
        fmt::format("the second field, {:g}, is taken as EPSF, and the third, {:g}, as VP", middle, last));
    return true;
  }
  if (middle != last)
    report.warning(
        second.where(), "order",
        fmt::format("sources differ on whether EPSF is behind VP or before it: the second field, "
                    "{:g}, is taken as VP, and the third, {:g}, as EPSF; write a failure strain of 1 "
                    "as 0.9999 if it is one, then both orders are understood",
                    middle, last));
  return false;
}

void check_exponent(const Card& card, Report& report) {
  if (card.real("B") > 0 && card.good("N") && !(card.real("N") > 0))
    report.field_error(card.where(), {"N", std::string(card.text("N")), "a number above zero",
                                      "B switches hardening on, and it needs both", "exponent"});
}

model::Spall spall_of(double number) {
  using enum model::Spall;
  return number == 1 ? None : number == 3 ? Pressure : Stress;
}

/// The card of heat, spall and fracture.
void take_third_card(const Card& second, const Card& third, const Card& fourth, model::JohnsonCook& law,
                     Report& report) {
  law.heat_capacity = third.real("CP");
  law.thermal_exponent = second.real("M");
  law.melting_rise = second.real("TM") - second.real("TR");
  const bool heats = law.heat_capacity > 0 && law.thermal_exponent > 0 && second.real("TM") > 0;
  if (!heats) law.heat_capacity = law.melting_rise = 0;
  if (heats && !(law.melting_rise > 0))
    report.field_error(second.where(), {"TM", std::string(second.text("TM")), "a temperature above TR",
                                        "it is where the strength vanishes", "melting"});
  check_pressure_cut_off(third, report);
  law.least_pressure = third.real("PC");
  law.spall = spall_of(third.real("SPALL"));
  law.damage = {third.real("D1"), third.real("D2"), third.real("D3"), third.real("D4"), fourth.real("D5")};
  law.least_fracture_strain = fourth.real("EFMIN");
  const bool fails = third.real("D1") != 0 || third.real("D2") != 0;
  if (!fails) law.damage = {};
  if (fails && third.real("D3") > 0)
    report.warning(third.where(), "fracture",
                   fmt::format("D3 is {}: fracture comes later the more the metal is pulled, as the mean "
                               "stress in exp(D3 s) counts positive in tension; D3 of steel is about -2",
                               third.real("D3")));
}

/// A bound that is not there is a huge number in LS-DYNA, and zero here.
double bound(double read) {
  constexpr double none = 1e15;
  return read >= none ? 0 : read;
}

}  // namespace

void read_mat_power_law_plasticity(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(power_card);
    const Card second = cards.next_or_default(power_second_card);
    RawMaterial raw = material_of(heading, card);
    model::PowerLawPlasticity law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.strength = card.real("K");
    law.exponent = card.real("N");
    if (card.good("K") && card.good("N") && card.good("E") && second.good("SIGY"))
      law.yield_strain = yield_strain(card, second, cards.report());
    law.cowper_symonds_rate = card.real("SRC");
    law.cowper_symonds_exponent = card.real("SRP");
    if (failure_comes_first(second, cards.report())) {
      law.viscoplastic = second.real("EPSF") == 1;
      law.failure_strain = failure_strain(second.real("VP"));
    } else {
      law.viscoplastic = take_viscoplastic(second, law.cowper_symonds_rate, cards.report());
      law.failure_strain = failure_strain(second.real("EPSF"));
    }
    check_rate(card, "SRC", "SRP", cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_johnson_cook(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(johnson_cook_card);
    const Card second = cards.next(johnson_cook_second_card);
    const Card third = cards.next_or_default(johnson_cook_third_card);
    const Card fourth = cards.next_or_default(johnson_cook_fourth_card);
    RawMaterial raw = material_of(heading, card);
    model::JohnsonCook law;
    law.poissons_ratio = card.real("PR");
    law.youngs_modulus = card.real("E") > 0 ? card.real("E") : 2 * card.real("G") * (1 + law.poissons_ratio);
    if (card.good("E") && card.good("G") && !(law.youngs_modulus > 0))
      cards.report().field_error(card.where(), {"E", std::string(card.text("E")), "a number above zero",
                                                "shells take it, or G where E is missing", "modulus"});
    law.shear_modulus = card.real("G");
    law.yield_stress = second.real("A");
    law.hardening = second.real("B");
    law.exponent = second.real("N");
    law.rate_coefficient = second.real("C");
    if (law.rate_coefficient > 0 && second.good("EPS0") && !(second.real("EPS0") > 0))
      cards.report().field_error(second.where(),
                                 {"EPS0", std::string(second.text("EPS0")), "a number above zero",
                                  "C switches the rate effect on, and it needs both", "rate"});
    if (second.real("EPS0") > 0) law.reference_rate = second.real("EPS0");
    law.viscoplastic = take_viscoplastic(card, law.rate_coefficient, cards.report());
    check_exponent(second, cards.report());
    take_third_card(second, third, fourth, law, cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_simplified_johnson_cook(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(simplified_card);
    const Card second = cards.next(simplified_second_card);
    RawMaterial raw = material_of(heading, card);
    model::JohnsonCook law;
    law.simplified = true;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.yield_stress = second.real("A");
    law.hardening = second.real("B");
    law.exponent = second.real("N");
    law.rate_coefficient = second.real("C");
    law.failure_strain = failure_strain(second.real("PSFAIL"));
    law.largest_hardened = bound(second.real("SIGMAX"));
    law.saturation_stress = bound(second.real("SIGSAT"));
    law.reference_rate = second.real("EPSO");
    law.viscoplastic = take_viscoplastic(card, law.rate_coefficient, cards.report());
    check_exponent(second, cards.report());
    for (const std::string_view name : {"SIGMAX", "SIGSAT"}) {
      if (law.viscoplastic && bound(second.real(name)) > 0)
        cards.report().field_unsupported(second.where(), {name, std::string(second.text(name)), "none",
                                                          "with VP = 1 the stress has no bound", "bound"});
      else if (bound(second.real(name)) > 0 && second.real(name) < law.yield_stress)
        cards.report().field_error(second.where(),
                                   {name, std::string(second.text(name)), "a stress not below A",
                                    "A is the first yield stress", "bound"});
    }
    if (law.viscoplastic) law.largest_hardened = law.saturation_stress = 0;
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
