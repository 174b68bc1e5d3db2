// SPDX-License-Identifier: BSD-3-Clause
// *MAT_SOIL_AND_FOAM, *MAT_VISCOUS_FOAM, *MAT_SIMPLIFIED_RUBBER/FOAM, *MAT_BILKHU/DUBOIS_FOAM.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field soil_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, above_zero),
    real("KUN", 0, above_zero),
    real("A0"),
    real("A1"),
    real("A2"),
    real("PC"),
};
constexpr Field soil_second_card[] = {
    only("VCR", {0, 1}, "0 unloads with KUN, 1 along the curve"),
    only("REF", {0}, "there is no reference geometry"),
    reference("LCID"),
};
constexpr Field soil_strain_card[] = {real("EPS1"), real("EPS2"), real("EPS3"), real("EPS4"),
                                      real("EPS5"), real("EPS6"), real("EPS7"), real("EPS8")};
constexpr Field soil_last_strain_card[] = {real("EPS9"), real("EPS10")};
constexpr Field soil_pressure_card[] = {real("P1"), real("P2"), real("P3"), real("P4"),
                                        real("P5"), real("P6"), real("P7"), real("P8")};
constexpr Field soil_last_pressure_card[] = {real("P9"), real("P10")};

constexpr Field viscous_foam_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E1", 0, above_zero),
    real("N1", 0, not_negative),
    real("V2", 0, not_negative),
    real("E2", 0, not_negative),
    real("N2", 0, not_negative),
    real("PR", 0, poisson),
};

constexpr std::string_view no_damping_of_rubber = "there is no frictional damping";
constexpr std::string_view one_curve = "only one curve is supported, which loading and unloading follow";

constexpr Field simplified_rubber_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("KM", 0, not_negative),
    real_or_default("MU", 0.1, not_negative),
    only("G", {0}, no_damping_of_rubber),
    only("SIGF", {0}, no_damping_of_rubber),
    only("REF", {0}, "there is no reference geometry"),
    only("PRTEN", {0}, "Poisson's ratio is the same in tension"),
};
constexpr Field simplified_rubber_test_card[] = {
    real("SGL", 0, above_zero),
    real("SW", 0, above_zero),
    real("ST", 0, above_zero),
    id("LC/TBID", IdKind::Function),
    unused("TENSION"),  // of a table
    unused("RTYPE"),    // the same
    unused("AVGOPT"),   // the same
    real("PR"),
};
constexpr Field simplified_rubber_unloading_card[] = {
    only("LCUNLD", {0}, one_curve),
    only("HU", {1, 0}, one_curve),
    unused("SHAPE"),  // of unloading
    unused("STOL"),   // of a check
    only("VISCO", {0}, "stresses do not relax"),
    unused("HISOUT"),
};

constexpr Field bilkhu_dubois_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("YM", 0, above_zero),
    id("LCPY", IdKind::Function),
    id("LCUYS", IdKind::Function),
    real("VC", 0, not_negative),
    real("PC", 0, not_negative),
    real("VPC", 0, not_negative),
};
constexpr Field bilkhu_dubois_second_card[] = {
    real("TSC", 0, not_negative),
    real("VTSC", 0, within(0, 1, "a share of the uniaxial yield stress in compression")),
    reference("LCRATE", IdKind::Function),
    real("PR", 0, poisson),
    only("KCON", {0},
         "the stiffness of contact follows from YM and PR; SFSA and SFSB of the contact scale it"),
    only("ISFLG", {0},
         "LCUYS has no part in tension, whose strain this would choose; give TSC, VTSC, PC or VPC"),
    only("NCYCLE", {0, 1}, "the rate is that of the step, not a mean over several"),
};

/// The numbers of two cards.
template <std::size_t First, std::size_t Last>
std::array<double, First + Last> numbers_of(const Field (&first_fields)[First], const Card& first,
                                            const Field (&last_fields)[Last], const Card& last) {
  std::array<double, First + Last> found{};
  for (std::size_t k = 0; k < First; ++k) found[k] = first.real(first_fields[k].name);
  for (std::size_t k = 0; k < Last; ++k) found[First + k] = last.real(last_fields[k].name);
  return found;
}

/// EPS1 and P1 to EPS10 and P10. A first point that is not the origin gets the origin before it.
void take_soil_points(const std::array<double, 10>& strain, const std::array<double, 10>& pressure,
                      const Where& where, model::SoilAndFoam& law, Report& report) {
  std::size_t count = 1;
  while (count < strain.size() && strain[count] != 0) ++count;
  law.compression = {0};
  law.pressure = {0};
  for (std::size_t k = strain[0] == 0 ? 1 : 0; k < count; ++k) {
    law.compression.push_back(-strain[k]);
    law.pressure.push_back(pressure[k]);
  }
  const bool deepens = std::is_sorted(law.compression.begin(), law.compression.end());
  const bool distinct =
      std::adjacent_find(law.compression.begin(), law.compression.end()) == law.compression.end();
  const bool none = count < 2 && strain[0] == 0;
  if (!none && deepens && distinct && (strain[0] != 0 || pressure[0] == 0)) return;
  report.error(where, "points",
               none ? "expected LCID, or EPS1 to EPS10 and P1 to P10 with two points at least"
                    : "EPS1 to EPS10 are natural logarithms of the relative volume, below zero in "
                      "compression, in the order of increasing compression; at zero the pressure is zero");
  // Something that needs no other message.
  law.compression = {0, 1};
  law.pressure = {0, law.unloading_modulus};
}

void read_soil(Cards& cards, const Card& card, const Card& second, RawMaterial& raw) {
  const Card strain = cards.next_or_default(soil_strain_card);
  const Card last_strain = cards.next_or_default(soil_last_strain_card);
  const Card pressure = cards.next_or_default(soil_pressure_card);
  const Card last_pressure = cards.next_or_default(soil_last_pressure_card);
  model::SoilAndFoam law;
  law.shear_modulus = card.real("G");
  law.unloading_modulus = card.real("KUN");
  law.yield = {card.real("A0"), card.real("A1"), card.real("A2")};
  law.least_pressure = card.real("PC");
  law.crushes = second.real("VCR") == 0;
  check_pressure_cut_off(card, cards.report());
  raw.hardening_curve = second.good("LCID") ? second.integer("LCID") : 0;
  raw.curve_where = second.where();
  if (raw.hardening_curve == 0 && second.good("LCID"))
    take_soil_points(numbers_of(soil_strain_card, strain, soil_last_strain_card, last_strain),
                     numbers_of(soil_pressure_card, pressure, soil_last_pressure_card, last_pressure),
                     strain.where(), law, cards.report());
  raw.material.law = law;
}

/// PR says whether it is a foam.
void take_poisson(const Card& test, const Card& card, model::SimplifiedRubber& law, Report& report) {
  const double ratio = test.real("PR");
  law.is_foam = ratio > 0;
  law.poissons_ratio = ratio;
  const std::string read(test.text("PR"));
  if (!test.good("PR")) return;
  if (ratio < 0 || ratio >= 0.5)
    report.field_unsupported(test.where(), {"PR", read, "0 of rubber, or Poisson's ratio of a foam below 0.5",
                                            "other numbers are a decay constant of rubber", "ratio"});
  else if (!law.is_foam && card.good("KM") && !(card.real("KM") > 0))
    report.field_error(card.where(), {"KM", std::string(card.text("KM")), "a number above zero",
                                      "with PR = 0 it is the bulk modulus of rubber", "modulus"});
}

}  // namespace

void read_mat_soil_and_foam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(soil_card);
    const Card second = cards.next(soil_second_card);
    RawMaterial raw = material_of(heading, card);
    read_soil(cards, card, second, raw);
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_viscous_foam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(viscous_foam_card);
    RawMaterial raw = material_of(heading, card);
    model::ViscousFoam law;
    law.youngs_modulus = std::max(card.real("E1"), card.real("E2"));
    law.poissons_ratio = card.real("PR");
    law.elastic_modulus = card.real("E1");
    law.elastic_exponent = card.real("N1");
    law.viscosity = card.real("V2");
    law.viscosity_exponent = card.real("N2");
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_bilkhu_dubois_foam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(bilkhu_dubois_card);
    const Card second = cards.next(bilkhu_dubois_second_card);
    RawMaterial raw = material_of(heading, card);
    model::BilkhuDuboisFoam law;
    law.youngs_modulus = card.real("YM");
    law.poissons_ratio = second.real("PR");
    law.tension_pressure = card.real("PC");
    law.tension_pressure_share = card.real("VPC");
    law.tension_stress = second.real("TSC");
    law.tension_stress_share = second.real("VTSC");
    law.damping = card.real("VC");
    if ((law.tension_pressure > 0 || law.tension_pressure_share > 0) &&
        (law.tension_stress > 0 || law.tension_stress_share > 0) && second.good("VTSC"))
      cards.report().warning(
          second.where(), "tension",
          "an ellipse has one strength in tension: of that by PC or VPC and that by TSC or "
          "VTSC the lower one counts");
    raw.hardening_curve = card.good("LCPY") ? card.integer("LCPY") : 0;
    raw.more_curves[0] = card.good("LCUYS") ? card.integer("LCUYS") : 0;
    raw.rate_curve = second.good("LCRATE") ? second.integer("LCRATE") : 0;
    raw.curve_where = card.where();
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_simplified_rubber(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(simplified_rubber_card);
    const Card test = cards.next(simplified_rubber_test_card);
    cards.next_or_default(simplified_rubber_unloading_card);
    RawMaterial raw = material_of(heading, card);
    model::SimplifiedRubber law;
    law.bulk_modulus = card.real("KM");
    law.damping = card.real("MU");
    take_poisson(test, card, law, cards.report());
    raw.hardening_curve = test.good("LC/TBID") ? test.integer("LC/TBID") : 0;
    raw.gauge = {test.real("SGL"), test.real("SW") * test.real("ST")};
    raw.curve_where = test.where();
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
