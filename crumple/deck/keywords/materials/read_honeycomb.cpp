// SPDX-License-Identifier: BSD-3-Clause
// *MAT_HONEYCOMB and *MAT_MODIFIED_HONEYCOMB.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field honeycomb_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("SIGY", 0, above_zero),
    real("VF", 0, between(0, 1, "the relative volume of the compacted honeycomb")),
    real_or_default("MU", 0.05, not_negative),
    only("BULK", {0, 1}, "0 is a viscosity by MU, 1 the bulk viscosity of all solids"),
};

constexpr Field honeycomb_curves_card[] = {
    id("LCA", IdKind::Function),         reference("LCB", IdKind::Function),
    reference("LCC", IdKind::Function),  reference("LCS", IdKind::Function),
    reference("LCAB", IdKind::Function), reference("LCBC", IdKind::Function),
    reference("LCCA", IdKind::Function), reference("LCSR", IdKind::Function),
};

constexpr Field honeycomb_moduli_card[] = {
    real("EAAU", 0, above_zero),
    real("EBBU", 0, above_zero),
    real("ECCU", 0, above_zero),
    real("GABU", 0, above_zero),
    real("GBCU", 0, above_zero),
    real("GCAU", 0, above_zero),
    only("AOPT", {0, 1, 2}, "0 follows nodes 1, 2 and 4, 1 a point, 2 the vectors A and D"),
    only("MACF", {1, 0}, "the axes are not exchanged"),
};

constexpr Field honeycomb_axes_card[] = {
    point(real("XP")),     point(real("YP")),     point(real("ZP")),
    direction(real("A1")), direction(real("A2")), direction(real("A3")),
};

constexpr Field honeycomb_failure_card[] = {
    direction(real("D1")),
    direction(real("D2")),
    direction(real("D3")),
    real("TSEF", 0, not_negative),
    real("SSEF", 0, not_negative),
    unused("V1"),  // of AOPT = 3
    unused("V2"),
    unused("V3"),
};

// Of *MAT_MODIFIED_HONEYCOMB.
constexpr Field modified_curves_card[] = {
    signed_id("LCA", IdKind::Function),  reference("LCB", IdKind::Function),
    reference("LCC", IdKind::Function),  reference("LCS", IdKind::Function),
    reference("LCAB", IdKind::Function), reference("LCBC", IdKind::Function),
    reference("LCCA", IdKind::Function), signed_id("LCSR", IdKind::Function),
};

constexpr Field modified_failure_card[] = {
    direction(real("D1")),
    direction(real("D2")),
    direction(real("D3")),
    real("TSEF", 0, not_negative),
    real("SSEF", 0, not_negative),
    real("VREF", 0, not_negative),
    real("TREF", 0, not_negative),
    unused("SHDFLG"),  // of the damage that goes with LCA below zero
};

constexpr Field modified_vector_card[] = {
    unused("V1"),  // of AOPT = 3
    unused("V2"),
    unused("V3"),
};

constexpr Field modified_rates_card[] = {
    reference("LCSRA", IdKind::Function),  reference("LCSRB", IdKind::Function),
    reference("LCSRC", IdKind::Function),  reference("LCSRAB", IdKind::Function),
    reference("LCSRBC", IdKind::Function), reference("LCSRCA", IdKind::Function),
};

constexpr std::array<std::string_view, 6> rate_names = {"LCSRA",  "LCSRB",  "LCSRC",
                                                        "LCSRAB", "LCSRBC", "LCSRCA"};
constexpr std::array<std::string_view, 6> modulus_names = {"EAAU", "EBBU", "ECCU", "GABU", "GBCU", "GCAU"};

void require_direction(const Card& card, std::string_view first, const std::array<double, 3>& vector,
                       Report& report) {
  if (vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2] > 0) return;
  report.field_error(card.where(), {first, std::string(card.text(first)), "a vector that is not zero",
                                    "AOPT = 2 takes the material axes from A and D", "axis"});
}

void take_axes(const Card& moduli, const Card& vectors, const Card& failure, model::Honeycomb& law,
               Report& report) {
  const double option = moduli.real("AOPT");
  if (option == 1) {
    law.axes = model::Honeycomb::Axes::Point;
    law.a = {vectors.real("XP"), vectors.real("YP"), vectors.real("ZP")};
  } else if (option == 2) {
    law.axes = model::Honeycomb::Axes::Vectors;
    law.a = {vectors.real("A1"), vectors.real("A2"), vectors.real("A3")};
    law.d = {failure.real("D1"), failure.real("D2"), failure.real("D3")};
    require_direction(vectors, "A1", law.a, report);
    require_direction(failure, "D1", law.d, report);
  }
}

/// Curves of aa, bb, cc, ab, bc, ca and of the rate, with what stands in for those that are not given.
std::array<UserId, 8> curve_ids(const Card& card) {
  const auto given = [&](std::string_view name, UserId otherwise) {
    return card.good(name) && card.integer(name) > 0 ? card.integer(name) : otherwise;
  };
  const UserId a = given("LCA", 0);
  const UserId shear = given("LCS", a);
  return {a,
          given("LCB", a),
          given("LCC", a),
          given("LCAB", shear),
          given("LCBC", shear),
          given("LCCA", shear),
          given("LCSR", 0),
          0};
}

/// What both keywords say on the same cards.
model::Honeycomb honeycomb_of(const Card& card, const Card& moduli, const Card& vectors, const Card& failure,
                              Report& report) {
  model::Honeycomb law;
  law.youngs_modulus = card.real("E");
  law.poissons_ratio = card.real("PR");
  law.yield_stress = card.real("SIGY");
  law.compacted_volume = card.real("VF");
  law.viscosity = card.real("MU");
  law.standard_viscosity = card.real("BULK") == 1;
  for (std::size_t k = 0; k < law.moduli.size(); ++k) law.moduli[k] = moduli.real(modulus_names[k]);
  take_axes(moduli, vectors, failure, law, report);
  law.failure_tension = failure_strain(failure.real("TSEF"));
  law.failure_shear = failure_strain(failure.real("SSEF"));
  return law;
}

/// LCA must be a curve over the strain.
void check_first_curve(const Card& curves, Report& report) {
  if (!curves.good("LCA") || curves.integer("LCA") > 0) return;
  const std::string read(curves.text("LCA"));
  if (curves.integer("LCA") == 0)
    report.field_error(curves.where(), {"LCA", read, "the id of a curve",
                                        "the yield stress along a over the strain along it; curves that are "
                                        "not given are this one",
                                        "value"});
  else
    report.field_unsupported(
        curves.where(),
        {"LCA", read, "an id above zero",
         "below zero the yield stress depends on the angle to the axis a (the transversely isotropic "
         "surface), which is not supported; give yield stresses over the strain of each component",
         "value"});
}

/// The card of V1 to V3 stands where AOPT asks for it, and in many decks where it does not: it has three
/// numbers at most, where the first card of a material has six and those of curves have no decimal point.
void skip_vector(Cards& cards, bool rates_follow) {
  if (!cards.has_line()) return;
  const std::string_view line = cards.peek();
  constexpr std::size_t three_fields = 30;
  const bool has_commas = line.find(',') != std::string_view::npos;
  const bool is_short = has_commas ? std::count(line.begin(), line.end(), ',') <= 2
                                   : line.find_last_not_of(" \r") == std::string_view::npos ||
                                         line.find_last_not_of(" \r") < three_fields;
  const bool has_digits = line.find_first_of("123456789") != std::string_view::npos;
  // The title of the next material is short as well.
  const bool is_text = line.find_first_not_of("0123456789+-.eEdD, \t\r") != std::string_view::npos;
  if (is_short && !is_text && (!rates_follow || !has_digits || line.find('.') != std::string_view::npos))
    cards.next(modified_vector_card);
}

/// VREF and TREF make springs of elements that are crushed far.
void warn_of_springs(const Card& failure, Report& report) {
  for (const std::string_view name : {"VREF", "TREF"}) {
    if (!failure.good(name) || failure.real(name) == 0) continue;
    report.field_warning(failure.where(),
                         {name, std::string(failure.text(name)), "0",
                          "crushed elements stay elements, they do not become springs", "springs"});
    return;
  }
}

}  // namespace

void read_mat_honeycomb(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(honeycomb_card);
    const Card curves = cards.next(honeycomb_curves_card);
    const Card moduli = cards.next(honeycomb_moduli_card);
    const Card vectors = cards.next_or_default(honeycomb_axes_card);
    const Card failure = cards.next_or_default(honeycomb_failure_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = honeycomb_of(card, moduli, vectors, failure, cards.report());
    raw.more_curves = curve_ids(curves);
    raw.curve_where = curves.where();
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_modified_honeycomb(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(honeycomb_card);
    const Card curves = cards.next(modified_curves_card);
    const Card moduli = cards.next(honeycomb_moduli_card);
    const Card vectors = cards.next_or_default(honeycomb_axes_card);
    const Card failure = cards.next_or_default(modified_failure_card);
    RawMaterial raw = material_of(heading, card);
    model::Honeycomb law = honeycomb_of(card, moduli, vectors, failure, cards.report());
    law.over = model::Honeycomb::Abscissa::Strain;
    raw.material.law = law;
    check_first_curve(curves, cards.report());
    warn_of_springs(failure, cards.report());
    raw.more_curves = curve_ids(curves);
    raw.curve_where = curves.where();
    // LCSR = -1: a curve for the rate of each component.
    const bool rates_follow = curves.good("LCSR") && curves.integer("LCSR") < 0;
    skip_vector(cards, rates_follow);
    if (rates_follow) {
      const Card rates = cards.next(modified_rates_card);
      for (std::size_t k = 0; k < rate_names.size(); ++k)
        raw.rate_factors[k] = {rates.integer(rate_names[k]), rate_names[k], rates.where()};
    }
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
