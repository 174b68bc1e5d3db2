// SPDX-License-Identifier: BSD-3-Clause
// *MAT_HONEYCOMB.
#include <fmt/core.h>

#include <array>
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
    return card.good(name) && card.integer(name) != 0 ? card.integer(name) : otherwise;
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
    model::Honeycomb law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.yield_stress = card.real("SIGY");
    law.compacted_volume = card.real("VF");
    law.viscosity = card.real("MU");
    law.standard_viscosity = card.real("BULK") == 1;
    for (std::size_t k = 0; k < law.moduli.size(); ++k) law.moduli[k] = moduli.real(modulus_names[k]);
    take_axes(moduli, vectors, failure, law, cards.report());
    law.failure_tension = failure_strain(failure.real("TSEF"));
    law.failure_shear = failure_strain(failure.real("SSEF"));
    raw.more_curves = curve_ids(curves);
    raw.curve_where = curves.where();
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
