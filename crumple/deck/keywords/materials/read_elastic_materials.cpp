// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ORTHOTROPIC_ELASTIC, *MAT_NULL.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field orthotropic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("EA", 0, above_zero),
    real("EB", 0, above_zero),
    real("EC", 0, above_zero),
    real("PRBA"),
    real("PRCA"),
    real("PRCB"),
};

constexpr Field orthotropic_second_card[] = {
    real("GAB", 0, above_zero),
    real("GBC", 0, above_zero),
    real("GCA", 0, above_zero),
    only("AOPT", {0, 2, 3},
         "0 is along the side from N1 to N2, 2 along the vector a, 3 along v x normal of the shell"),
    unused("G"),  // damping of solids
    unused("SIGF"),
};

constexpr Field orthotropic_third_card[] = {
    unused("XP"),          unused("YP"),          unused("ZP"),  // of AOPT = 1 and 4
    direction(real("A1")), direction(real("A2")), direction(real("A3")),
    unused("MACF"),  // of solids
    unused("IHIS"),
};

constexpr Field orthotropic_fourth_card[] = {
    direction(real("V1")), direction(real("V2")),
    direction(real("V3")),
    unused("D1"),  // with a it spans a plane that the shell takes the place of
    unused("D2"),          unused("D3"),
    real("BETA"),          only("REF", {0}, "there is no reference geometry"),
};

constexpr Field null_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("PC"),  // not above zero
    real("MU", 0, not_negative),
    real("TEROD", 0, not_negative),
    real("CEROD", 0, not_negative),
    real("YM", 0, not_negative),  // of the contact stiffness of shells
    real("PR", 0, poisson),
};

}  // namespace

void take_direction(const Card& second, const Card& third, const Card& fourth, model::OrthotropicElastic& law,
                    Report& report) {
  const double option = second.real("AOPT");
  if (option == 0) return;
  const bool by_vector = option == 2;
  law.axes =
      by_vector ? model::OrthotropicElastic::Axes::Vector : model::OrthotropicElastic::Axes::CrossNormal;
  const Card& card = by_vector ? third : fourth;
  const std::string_view first = by_vector ? "A1" : "V1";
  law.direction = {card.real(first), card.real(by_vector ? "A2" : "V2"), card.real(by_vector ? "A3" : "V3")};
  const auto& v = law.direction;
  if (!(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] > 0))
    report.field_error(card.where(), {first, std::string(card.text(first)), "a vector that is not zero",
                                      fmt::format("AOPT = {} takes the axis a from it", option), "axis"});
}

bool take_stand_in(const Card& card, bool sound, model::OrthotropicElastic& law, Report& report) {
  if (!sound) return false;
  if (law.poisson_ba * law.poisson_ba * law.modulus_a < law.modulus_b) {
    set_stand_in(law);
    return true;
  }
  report.field_error(card.where(),
                     {"PRBA", std::string(card.text("PRBA")), "a ratio whose square is below EB / EA",
                      "nu_ba / E_b = nu_ab / E_a", "ratio"});
  return false;
}

void read_mat_orthotropic_elastic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(orthotropic_card);
    const Card second = cards.next(orthotropic_second_card);
    const Card third = cards.next(orthotropic_third_card);
    const Card fourth = cards.next_or_default(orthotropic_fourth_card);
    RawMaterial raw = material_of(heading, card);
    model::OrthotropicElastic law;
    law.modulus_a = card.real("EA");
    law.modulus_b = card.real("EB");
    law.modulus_c = card.real("EC");
    law.poisson_ba = card.real("PRBA");
    law.poisson_ca = card.real("PRCA");
    law.poisson_cb = card.real("PRCB");
    law.shear_ab = second.real("GAB");
    law.shear_bc = second.real("GBC");
    law.shear_ca = second.real("GCA");
    law.angle = fourth.real("BETA") * std::numbers::pi / 180;
    if (cards.placement().map.mirrors()) law.angle = -law.angle;
    take_direction(second, third, fourth, law, cards.report());
    const bool sound = card.good("EA") && card.good("EB") && card.good("PRBA") && second.good("GAB") &&
                       second.good("GBC") && second.good("GCA");
    take_stand_in(card, sound, law, cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_null(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(null_card);
    RawMaterial raw = material_of(heading, card);
    model::NullMaterial law;
    law.youngs_modulus = card.real("YM");
    law.poissons_ratio = card.real("PR");
    law.least_pressure = card.real("PC");
    law.viscosity = card.real("MU");
    law.largest_volume = card.real("TEROD");
    law.smallest_volume = card.real("CEROD");
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
