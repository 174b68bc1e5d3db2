// SPDX-License-Identifier: BSD-3-Clause
// *MAT_CONCRETE_DAMAGE_REL3.
#include <fmt/core.h>

#include <cmath>
#include <string>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field rel3_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("PR", 0, poisson),
};
constexpr Field rel3_strength_card[] = {
    real("FT", 0, not_negative),
    real("A0"),
    real("A1", 0, not_negative),
    real("A2", 0, not_negative),
    real("B1"),
    real("OMEGA", 0, within(0, 1, "a share of the normal plastic volume")),
    real("A1F", 0, not_negative),
};
/// -1 asks for the factors of the strength.
IdKind kind_of_rates(const Card& card) {
  return card.integer("LCRATE") == -1 ? IdKind::None : IdKind::Function;
}

constexpr Field rel3_option_card[] = {
    unused("SLAMBDA"),
    unused("NOUT"),
    only("EDROP", {0, 1}, "behind the maximum the dilatancy falls as the strength does"),
    real("RSIZE", 0, not_negative),
    real("UCF", 0, not_negative),
    signed_id("LCRATE", kind_of_rates),
    real("LOCWIDTH", 0, not_negative),
    only("NPTS", {0, 13}, "the table of damage has 13 points"),
};
constexpr Field rel3_damage_card[] = {
    real("LAMBDA01"), real("LAMBDA02"), real("LAMBDA03"), real("LAMBDA04"),
    real("LAMBDA05"), real("LAMBDA06"), real("LAMBDA07"), real("LAMBDA08"),
};
constexpr Field rel3_more_damage_card[] = {
    real("LAMBDA09"),
    real("LAMBDA10"),
    real("LAMBDA11"),
    real("LAMBDA12"),
    real("LAMBDA13"),
    real("B3"),
    real("A0Y", 0, not_negative),
    real("A1Y", 0, not_negative),
};
constexpr Field rel3_share_card[] = {
    real("ETA01"), real("ETA02"), real("ETA03"), real("ETA04"),
    real("ETA05"), real("ETA06"), real("ETA07"), real("ETA08"),
};
constexpr Field rel3_more_share_card[] = {
    real("ETA09"),
    real("ETA10"),
    real("ETA11"),
    real("ETA12"),
    real("ETA13"),
    real("B2"),
    real("A2F", 0, not_negative),
    real("A2Y", 0, not_negative),
};

struct Rel3Cards {
  Card first, strength, option, damage, more_damage, share, more_share;
};

/// Numbers that are given, go before those that follow from the strength.
void take_given(const Rel3Cards& cards, model::ThreeSurfaceConcrete& law) {
  const auto take = [](const Card& card, const char* field, double& to) {
    if (card.real(field) != 0) to = card.real(field);
  };
  take(cards.strength, "FT", law.tensile_strength);
  take(cards.strength, "B1", law.compression_power);
  take(cards.strength, "OMEGA", law.dilatancy);
  take(cards.more_share, "B2", law.tension_power);
  take(cards.more_damage, "B3", law.opening_damage);
  take(cards.option, "LOCWIDTH", law.width);
}

model::ThreeSurfaceConcrete concrete_by_strength(const Rel3Cards& cards, Report& report) {
  constexpr double mild_strength = 4000;  // psi
  const double strength = -cards.strength.real("A0");
  double psi = cards.option.real("UCF");
  double inches = cards.option.real("RSIZE");
  const double in_psi = strength * psi;
  const bool good = cards.option.good("UCF") && cards.option.good("RSIZE") && cards.strength.good("A0");
  if (good && !(psi > 0 && inches > 0))
    report.error(
        cards.option.where(), "units",
        "RSIZE (inches in the unit of length) and UCF (psi in the unit of stress) must be above zero "
        "where A0 below zero asks for the parameters of a strength");
  else if (good && (in_psi < 1000 || in_psi > 30000))
    report.error(
        cards.strength.where(), "strength",
        fmt::format("-A0 is {:.4g} psi by UCF, which is no concrete: 1000 to 30000 are taken", in_psi));
  if (!(in_psi >= 1000 && in_psi <= 30000)) psi = mild_strength / strength;
  if (!(inches > 0)) inches = 1;
  model::ThreeSurfaceConcrete law =
      model::three_surface_concrete(strength, cards.first.real("PR"), psi, inches);
  take_given(cards, law);
  return law;
}

/// The table of damage, which a blank end leaves short; an error where its points do not rise.
void take_table(const Rel3Cards& cards, model::ThreeSurfaceConcrete& law, Report& report) {
  bool blank = false;
  for (int k = 1; k <= 13; ++k) {
    const Card& damages = k <= 8 ? cards.damage : cards.more_damage;
    const Card& shares = k <= 8 ? cards.share : cards.more_share;
    const std::string place = fmt::format("{:02}", k);
    const std::string name = "LAMBDA" + place;
    const double damage = damages.real(name);
    blank = blank || (k > 1 && damage == 0);
    if (blank && damage == 0) continue;
    if (blank || (k > 1 && !(damage > law.damage.back()))) {
      if (damages.good(name))
        report.field_error(damages.where(),
                           {name, std::string(damages.text(name)), "a number above that of the point before",
                            "the damage at a point of the table", "table"});
      return;
    }
    law.damage.push_back(damage);
    law.share.push_back(shares.real("ETA" + place));
  }
}

model::ThreeSurfaceConcrete given_concrete(const Rel3Cards& cards, Report& report) {
  model::ThreeSurfaceConcrete law;
  law.poissons_ratio = cards.first.real("PR");
  law.maximum = {cards.strength.real("A0"), cards.strength.real("A1"), cards.strength.real("A2")};
  law.yield = {cards.more_damage.real("A0Y"), cards.more_damage.real("A1Y"), cards.more_share.real("A2Y")};
  law.residual = {0, cards.strength.real("A1F"), cards.more_share.real("A2F")};
  take_given(cards, law);
  take_table(cards, law, report);
  const double strength = model::unconfined_strength(law.maximum);
  const double psi = cards.option.real("UCF");
  if (!cards.strength.good("A0") || !cards.option.good("UCF")) return law;
  if (!(psi > 0) || !(strength > 0))
    report.error(
        cards.strength.where(), "strength",
        "the bulk modulus follows from the strength of A0, A1 and A2 and from UCF (psi in the unit of "
        "stress), which must be above zero");
  else
    model::set_compaction(law, 57000 * std::sqrt(strength * psi) / psi / (3 * (1 - 2 * law.poissons_ratio)));
  return law;
}

/// Seconds in the unit of time, for which no field asks: by the density, which is near 2400 kg/m3. Zero for
/// one that is none of s, ms and us.
double seconds_by_density(const Rel3Cards& cards) {
  constexpr double usual_density = 2400;
  constexpr double inch = 0.0254;
  constexpr double psi = 6894.757;
  const double length = inch * cards.option.real("RSIZE");
  const double stress = psi * cards.option.real("UCF");
  const double square = usual_density / cards.first.real("RO") * length * length / stress;
  for (const double unit : {1.0, 1e-3, 1e-6}) {
    const double off = square / (unit * unit);
    if (off > 0.4 && off < 2.5) return unit;
  }
  return 0;
}

void take_rates(const Rel3Cards& cards, model::ThreeSurfaceConcrete& law, Report& report) {
  const std::int64_t curve = cards.option.integer("LCRATE");
  const std::string text(cards.option.text("LCRATE"));
  if (!cards.option.good("LCRATE") || curve >= 0) return;
  if (curve < -1) {
    report.field_error(cards.option.where(),
                       {"LCRATE", text, "a curve, 0 or -1", "-1 takes the factors of the strength", "rate"});
    return;
  }
  const double given = cards.strength.real("A0");
  const double strength = given < 0 ? -given : model::unconfined_strength(law.maximum);
  const double seconds = seconds_by_density(cards);
  if (strength > 0 && seconds > 0) {
    model::set_rate_factors(law, strength, cards.option.real("UCF"), seconds);
    return;
  }
  report.field_error(
      cards.option.where(),
      {"LCRATE", text, "a curve, or units of s, ms or us by RO, RSIZE and UCF",
       "the factors of -1 are given per second, and RO is far from that of concrete in these units", "rate"});
}

}  // namespace

void read_mat_concrete_damage_rel3(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card first = cards.next(rel3_card);
    const Card strength = cards.next(rel3_strength_card);
    const Card option = cards.next(rel3_option_card);
    const Card damage = cards.next_or_default(rel3_damage_card);
    const Card more_damage = cards.next_or_default(rel3_more_damage_card);
    const Card share = cards.next_or_default(rel3_share_card);
    const Card more_share = cards.next_or_default(rel3_more_share_card);
    const Rel3Cards all{first, strength, option, damage, more_damage, share, more_share};
    RawMaterial raw = material_of(heading, first);
    model::ThreeSurfaceConcrete law = strength.real("A0") < 0 ? concrete_by_strength(all, cards.report())
                                                              : given_concrete(all, cards.report());
    take_rates(all, law, cards.report());
    raw.material.law = std::move(law);
    if (option.good("LCRATE") && option.integer("LCRATE") > 0) raw.more_curves[0] = option.integer("LCRATE");
    raw.curve_where = option.where();
    if (first.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
