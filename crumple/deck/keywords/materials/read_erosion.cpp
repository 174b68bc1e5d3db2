// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_EROSION.
#include <fmt/core.h>

#include <cmath>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field erosion_card_1[] = {
    id("MID"),
    real("EXCL"),
    real("MXPRES"),
    real("MNEPS"),
    real("EFFEPS"),
    real("VOLEPS"),
    integer_or_default("NUMFIP", 1, within(-100, 100, "a number of points, below zero percent of all")),
    integer_or_default("NCS", 1, above_zero),
};

constexpr Field erosion_card_2[] = {
    real("MNPRES"), real("SIGP1"), real("SIGVM"),   real("MXEPS"),
    real("EPSSH"),  real("SIGTH"), real("IMPULSE"), real("FAILTM"),
};

constexpr Field erosion_card_3[] = {
    only("IDAM", {0, 1}, "0 is no damage, 1 that of *MAT_ADD_DAMAGE_GISSMO"),
    only("DMGTYP", {0, 1}, "0 adds damage up, 1 lets it act"),
    damage_failure,
    damage_instability,
    damage_exponent,
    damage_critical,
    damage_fading,
    damage_regularization,
};

constexpr Field erosion_damage_card[] = {
    only("SIZFLG", {0}, "the size of an element is that at time zero"),
    unused("REFSZ"),
    unused("NAHSV"),
    damage_rates,
    real("SHRF"),
    real("BIAXF"),
    damage_limits,
    damage_middle,
};

constexpr std::string_view no_such_criterion = "the criterion is not supported";

constexpr Field erosion_card_4[] = {
    only("LCFLD", {0}, no_such_criterion),   unused("NSFF"),
    only("EPSTHIN", {0}, no_such_criterion), only("ENGCRT", {0}, no_such_criterion),
    only("RADCRT", {0}, no_such_criterion),  only("LCEPS12", {0}, no_such_criterion),
    only("LCEPS13", {0}, no_such_criterion), only("LCEPSMX", {0}, no_such_criterion),
};

constexpr Field erosion_card_5[] = {
    only("DTEFLT", {0}, no_such_criterion),
    unused("VOLFRAC"),
    only("MXTMP", {0}, no_such_criterion),
    real("DTMIN", 0, not_negative),
};

/// Which numbers a criterion may have.
enum class Sign {
  Any,
  Positive,
  Negative,
};

/// The criteria of a card: those that are not zero and not the exclusion number.
class Criteria {
 public:
  Criteria(double exclusion, Report& report) : exclusion_(exclusion), report_(report) {}

  std::optional<double> read(const Card& card, std::string_view field, Sign sign) {
    const double value = card.real(field);
    if (!card.good(field) || value == 0 || value == exclusion_) return {};
    if (sign == Sign::Positive && value < 0)
      report_.code_unsupported(card.where(), {field, std::string(card.text(field)), "a number above zero",
                                              "one below zero names a curve or another measure", "value"});
    else if (sign == Sign::Negative && value > 0)
      report_.field_error(card.where(), {field, std::string(card.text(field)), "a number below zero",
                                         "every point would fail at once", "value"});
    else
      return value;
    return {};
  }

 private:
  double exclusion_;
  Report& report_;
};

model::ErosionCriteria criteria_of(const Card& first, const Card& second, Report& report) {
  Criteria criteria(first.real("EXCL"), report);
  model::ErosionCriteria found;
  found.largest_pressure = criteria.read(first, "MXPRES", Sign::Positive);
  found.smallest_principal_strain = criteria.read(first, "MNEPS", Sign::Negative);
  const std::optional<double> effective = criteria.read(first, "EFFEPS", Sign::Any);
  if (effective && *effective > 0) found.effective_strain = effective;
  if (effective && *effective < 0) found.effective_plastic_strain = -*effective;
  found.volumetric_strain = criteria.read(first, "VOLEPS", Sign::Any);
  found.smallest_pressure = criteria.read(second, "MNPRES", Sign::Negative);
  found.largest_principal_stress = criteria.read(second, "SIGP1", Sign::Positive);
  found.largest_equivalent_stress = criteria.read(second, "SIGVM", Sign::Positive);
  found.largest_principal_strain = criteria.read(second, "MXEPS", Sign::Positive);
  found.shear_strain = criteria.read(second, "EPSSH", Sign::Positive);
  found.threshold_stress = criteria.read(second, "SIGTH", Sign::Positive);
  found.impulse = criteria.read(second, "IMPULSE", Sign::Positive);
  found.time = criteria.read(second, "FAILTM", Sign::Positive);
  found.points = static_cast<int>(first.integer("NUMFIP"));
  found.conditions = static_cast<int>(first.integer("NCS"));
  return found;
}

/// Damage of IDAM = 1: points that fail by it count with NUMFIP, as others do.
void add_damage(const Card& first, const Card& third, const Card& fourth, Report& report, RawDeck& deck) {
  RawDamage raw = damage_of(third, fourth, report);
  raw.material = first.integer("MID");
  raw.damage.acts = third.real("DMGTYP") == 1;
  raw.damage.points = static_cast<double>(first.integer("NUMFIP"));
  raw.where = first.where();
  if (first.good("MID")) deck.damages.push_back(std::move(raw));
}

}  // namespace

void read_mat_add_erosion(Cards& cards, RawDeck& deck) {
  cards.heading();
  const Card first = cards.next(erosion_card_1);
  const Card second = cards.next_or_default(erosion_card_2);
  const Card third = cards.next_or_default(erosion_card_3);
  const bool damages = third.real("IDAM") == 1;
  if (damages) add_damage(first, third, cards.next_or_default(erosion_damage_card), cards.report(), deck);
  cards.next_or_default(erosion_card_4);
  RawErosion raw;
  raw.least_step = cards.next_or_default(erosion_card_5).real("DTMIN");
  raw.material = first.integer("MID");
  raw.criteria = criteria_of(first, second, cards.report());
  raw.damages = damages;
  raw.where = first.where();
  if (first.good("MID")) deck.erosions.push_back(raw);
}

}  // namespace crumple::deck
