// SPDX-License-Identifier: BSD-3-Clause
// *MAT_COHESIVE_MIXED_MODE, *MAT_COHESIVE_ELASTIC.
#include <cmath>
#include <cstdlib>
#include <string>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field density_flag = only("ROFLG", {0, 1}, "0 is a density per volume, 1 one per area");
constexpr Check points_of_cohesive =
    within(-4, 4,
           "failed points at which the element goes; below zero, and with 0, which keeps it, points at the "
           "corners");

constexpr Field cohesive_mixed_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    density_flag,
    integer("INTFAIL", 0, points_of_cohesive),
    real("EN", 0, above_zero),
    real("ET", 0, above_zero),
    real("GIC", 0, above_zero),
    real("GIIC", 0, above_zero),
};
constexpr Field cohesive_mixed_second_card[] = {
    real_or_default("XMU", 1),
    real("T"),
    real("S"),
    real("UND", 0, not_negative),
    real("UTD", 0, not_negative),
    real_or_default("GAMMA", 1, above_zero),
};

constexpr Field cohesive_elastic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    density_flag,
    integer("INTFAIL", 0, points_of_cohesive),
    real("ET", 0, above_zero),
    real("EN", 0, above_zero),
    real("FN_FAIL", 0, not_negative),
    real("FT_FAIL", 0, not_negative),
};

/// What both cards have in common.
model::Cohesive cohesive_of(const Card& card) {
  model::Cohesive law;
  law.youngs_modulus = card.real("EN");
  law.shear_stiffness = card.real("ET");
  law.mass_by_area = card.real("ROFLG") == 1;
  const auto points = card.good("INTFAIL") ? static_cast<int>(card.integer("INTFAIL")) : 0;
  law.failed_points = std::abs(points);
  law.at_corners = points <= 0;
  return law;
}

/// T or S: given, or from the separation at which the traction has fallen to zero.
double strength_of(const Card& card, std::string_view name, std::string_view last, double energy,
                   Report& report) {
  const double given = card.real(name);
  const double separation = card.real(last);
  if (!card.good(name) || !card.good(last)) return 1;
  if (given > 0) return given;
  const std::string read(card.text(name));
  if (given < 0)
    report.field_unsupported(
        card.where(), {std::string(name), read, "a strength above zero",
                       "below zero it is a curve over the size of elements; there is none here", "strength"});
  else if (separation > 0)
    return 2 * energy / separation;
  else
    report.field_error(card.where(),
                       {std::string(name), read, "a strength above zero, or " + std::string(last),
                        "the separation at which the traction has fallen to zero", "strength"});
  return 1;
}

}  // namespace

void read_mat_cohesive_mixed_mode(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(cohesive_mixed_card);
    const Card second = cards.next(cohesive_mixed_second_card);
    RawMaterial raw = material_of(heading, card);
    model::Cohesive law = cohesive_of(card);
    law.normal_energy = card.real("GIC");
    law.shear_energy = card.real("GIIC");
    law.failure = second.real("XMU") < 0 ? model::Cohesive::Failure::BenzeggaghKenane
                                         : model::Cohesive::Failure::PowerLaw;
    law.exponent = std::fabs(second.real("XMU"));
    law.stiffness_exponent = second.real("GAMMA");
    law.normal_strength = strength_of(second, "T", "UND", law.normal_energy, cards.report());
    law.shear_strength = strength_of(second, "S", "UTD", law.shear_energy, cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_cohesive_elastic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(cohesive_elastic_card);
    RawMaterial raw = material_of(heading, card);
    model::Cohesive law = cohesive_of(card);
    law.failure = model::Cohesive::Failure::Brittle;
    law.normal_strength = card.real("FN_FAIL");
    law.shear_strength = card.real("FT_FAIL");
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
