// SPDX-License-Identifier: BSD-3-Clause
// *MAT_JOHNSON_HOLMQUIST_CERAMICS, *MAT_JOHNSON_HOLMQUIST_CONCRETE.
#include <string>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field jh_ceramic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, above_zero),
    real("A", 0, above_zero),
    real("B", 0, not_negative),
    real("C", 0, not_negative),
    real("M", 0, not_negative),
    real("N", 0, not_negative),
};
constexpr Field jh_ceramic_limit_card[] = {
    real("EPS0", 0, not_negative),  real("T", 0, above_zero),
    real("SFMAX", 0, not_negative), real("HEL", 0, above_zero),
    real("PHEL", 0, above_zero),    real("BETA", 0, within(0, 1, "a share of energy")),
};
constexpr Field jh_pressure_card[] = {
    real("D1", 0, not_negative),
    real("D2", 0, not_negative),
    real("K1", 0, above_zero),
    real("K2"),
    real("K3"),
    real("FS"),
};

constexpr Field jh_concrete_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, above_zero),
    real("A", 0, not_negative),
    real("B", 0, not_negative),
    real("C", 0, not_negative),
    real("N", 0, not_negative),
    real("FC", 0, above_zero),
};
constexpr Field jh_concrete_limit_card[] = {
    real("T", 0, above_zero),       real("EPS0", 0, not_negative), real("EFMIN", 0, not_negative),
    real("SFMAX", 0, not_negative), real("PC", 0, above_zero),     real("UC", 0, above_zero),
    real("PL", 0, above_zero),      real("UL", 0, above_zero),
};

/// The reference rate; an error where it is missing and needed.
double reference_rate(const Card& of, double coefficient, Report& report) {
  const double rate = of.real("EPS0");
  if (rate > 0) return rate;
  if (of.good("EPS0") && coefficient > 0)
    report.field_error(of.where(), {"EPS0", std::string(of.text("EPS0")), "a number above zero",
                                    "the rate that C belongs to", "reference rate"});
  return 1;
}

/// SFMAX of a huge number is none, as zero is.
double largest_strength(double read) {
  return read < 1e15 ? read : 0;
}

/// The fields of both laws whose meaning is one.
void take_common(const Card& card, const Card& limit, const Card& pressure, model::BrittleSolid& law) {
  law.shear_modulus = card.real("G");
  law.rate_coefficient = card.real("C");
  law.tension = limit.real("T");
  law.fracture_factor = pressure.real("D1");
  law.fracture_power = pressure.real("D2");
  law.bulk_modulus = pressure.real("K1");
  law.bulk_quadratic = pressure.real("K2");
  law.bulk_cubic = pressure.real("K3");
}

}  // namespace

void read_mat_johnson_holmquist_ceramics(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(jh_ceramic_card);
    const Card limit = cards.next(jh_ceramic_limit_card);
    const Card pressure = cards.next(jh_pressure_card);
    RawMaterial raw = material_of(heading, card);
    model::HolmquistCeramic law;
    take_common(card, limit, pressure, law);
    law.intact_factor = card.real("A");
    law.fractured_factor = card.real("B");
    law.fractured_power = card.real("M");
    law.intact_power = card.real("N");
    law.reference_rate = reference_rate(limit, law.rate_coefficient, cards.report());
    law.largest_fractured = largest_strength(limit.real("SFMAX"));
    law.elastic_limit = limit.real("HEL");
    law.limit_pressure = limit.real("PHEL");
    law.bulking = limit.real("BETA");
    const double failure = pressure.real("FS");
    law.erosion = {failure<0, false, failure> 0 ? failure : 0};
    model::set_elastic(law);
    if (limit.good("HEL") && limit.good("PHEL") && !(law.elastic_limit > law.limit_pressure))
      cards.report().field_error(limit.where(),
                                 {"PHEL", std::string(limit.text("PHEL")), "a number below HEL",
                                  "the pressure at the Hugoniot elastic limit", "limit"});
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_johnson_holmquist_concrete(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(jh_concrete_card);
    const Card limit = cards.next(jh_concrete_limit_card);
    const Card pressure = cards.next(jh_pressure_card);
    RawMaterial raw = material_of(heading, card);
    model::HolmquistConcrete law;
    take_common(card, limit, pressure, law);
    law.cohesion = card.real("A");
    law.pressure_factor = card.real("B");
    law.pressure_power = card.real("N");
    law.strength = card.real("FC");
    law.reference_rate = reference_rate(limit, law.rate_coefficient, cards.report());
    law.least_fracture = limit.real("EFMIN");
    law.largest_strength = largest_strength(limit.real("SFMAX"));
    law.crush_pressure = limit.real("PC");
    law.crush_volume = limit.real("UC");
    law.lock_pressure = limit.real("PL");
    law.lock_volume = limit.real("UL");
    const double failure = pressure.real("FS");
    law.erosion = {failure <= 0, failure<0, failure> 0 ? failure : 0};
    model::set_elastic(law);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
