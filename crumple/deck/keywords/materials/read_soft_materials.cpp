// SPDX-License-Identifier: BSD-3-Clause
// *MAT_LOW_DENSITY_FOAM, *MAT_FU_CHANG_FOAM, *MAT_OGDEN_RUBBER, *MAT_HYPERELASTIC_RUBBER, *MAT_VISCOELASTIC,
// *MAT_GENERAL_VISCOELASTIC.
#include <fmt/core.h>

#include <string>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view without_reference = "there is no reference geometry";

constexpr Field low_density_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    id("LCID"),
    real_or_default("TC", 1e20, not_negative),
    real_or_default("HU", 1, within(0, 1, "1 unloads as it loads")),
    harmless("BETA", {0}, "unloaded foam does not recover with time: it reloads as it has unloaded"),
    real("DAMP", 0, not_negative),
};

constexpr Field low_density_second_card[] = {
    real_or_default("SHAPE", 1, above_zero),
    only("FAIL", {0, 1}, "0 keeps the tension at TC, 1 takes it away"),
    unused("BVFLAG"),  // the bulk viscosity is that of all solids
    only("ED", {0}, "foam has no viscoelastic stress of its own"),
    unused("BETA1"),  // of ED
    real("KCON", 0, not_negative),
    only("REF", {0}, without_reference),
};

constexpr Field fu_chang_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("KCON", 0, not_negative),
    real_or_default("TC", 1e20, not_negative),
    only("FAIL", {0, 1}, "0 keeps the tension at TC, 1 takes it away"),
    real("DAMP", 0, not_negative),
    id("TBID"),
};
constexpr Field fu_chang_second_card[] = {
    unused("BVFLAG"),  // the bulk viscosity is that of all solids
    only("SFLAG", {0, 1}, "0 is the rate of the logarithmic, 1 of the engineering strain"),
    only("RFLAG", {0}, "the rate is that of the fastest principal direction"),
    only("TFLAG", {0}, "the foam is linear in tension"),
    only("PVID", {0}, "the pressure follows from the curves"),
    only("SRAF", {0}, "the rate is a running mean"),
    only("REF", {0}, without_reference),
    real("HU", 0, within(0, 1, "0 and 1 unload by the slowest curve itself")),
};
constexpr Field fu_chang_third_card[] = {
    // of the form without a table
    unused("D0"), unused("N0"), unused("N1"), unused("N2"),
    unused("N3"), unused("C0"), unused("C1"), unused("C2"),
};
constexpr Field fu_chang_fourth_card[] = {
    unused("C3"),
    unused("C4"),
    unused("C5"),
    unused("AIJ"),
    unused("SIJ"),
    only("MINR", {0}, "rates have no bounds but those of the table"),
    only("MAXR", {0}, "rates have no bounds but those of the table"),
    real_or_default("SHAPE", 1, above_zero),
};
constexpr Field fu_chang_fifth_card[] = {
    only("EXPON", {1, 0}, "the exponent of unloading is 1"),
    only("RIULD", {0}, "unloading does not depend on the rate"),
};

constexpr std::string_view no_fitting = "constants are not fitted to a test; give them, with N = 0";
constexpr std::string_view no_friction = "there is no frictional damping";

constexpr Field rubber_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("PR", 0, between(0, 0.5, "Poisson's ratio of rubber, 0.49 to 0.4995")),
    only("N", {0}, no_fitting),
    unused("NV"),  // of a fit
    only("G", {0}, no_friction),
    only("SIGF", {0}, no_friction),
    only("REF", {0}, without_reference),
};

constexpr Field ogden_moduli_card[] = {real("MU1"), real("MU2"), real("MU3"), real("MU4"),
                                       real("MU5"), real("MU6"), real("MU7"), real("MU8")};
constexpr Field ogden_exponents_card[] = {real("ALPHA1"), real("ALPHA2"), real("ALPHA3"), real("ALPHA4"),
                                          real("ALPHA5"), real("ALPHA6"), real("ALPHA7"), real("ALPHA8")};

constexpr Field polynomial_rubber_card[] = {
    real("C10"),
    real("C01"),
    real("C11"),
    real("C20"),
    real("C02"),
    real("C30"),
    only("THERML", {0}, "constants do not depend on temperature"),
};

constexpr Field rubber_relaxation_card[] = {
    real("GI", 0, not_negative),
    real("BETAI", 0, not_negative),
    only("VFLAG", {0}, "the stress that relaxes follows the rate of the strain, not of the stress at rest"),
};

constexpr Field viscoelastic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("BULK", 0, above_zero),
    real("G0", 0, above_zero),
    real("GI", 0, not_negative),
    real("BETA", 0, not_negative),
};

constexpr std::string_view no_curve = "relaxation curves are not fitted; give the terms of the series";

constexpr Field general_viscoelastic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("BULK", 0, not_negative),
    only("PCF", {0}, "tension keeps its pressure"),
    only("EF", {0}, "the layer is viscoelastic"),
    unused("TREF"),  // there is no temperature
    unused("A"),
    unused("B"),
};
constexpr Field general_viscoelastic_fit_card[] = {
    only("LCID", {0}, no_curve),  unused("NT"),  unused("BSTART"),  unused("TRAMP"),
    only("LCIDK", {0}, no_curve), unused("NTK"), unused("BSTARTK"), unused("TRAMPK"),
};
constexpr Field prony_card[] = {
    real("GI", 0, not_negative),
    real("BETAI", 0, not_negative),
    real("KI", 0, not_negative),
    real("BETAKI", 0, not_negative),
};

/// What both kinds of rubber begin and end with.
void check_rubber(const Card& constants, std::string_view field, double shear_modulus, Report& report) {
  if (shear_modulus > 0) return;
  report.field_error(constants.where(), {field, std::string(constants.text(field)),
                                         "constants that make the shear modulus at rest above zero",
                                         fmt::format("it comes out as {:.4g}", shear_modulus), "modulus"});
}

/// GI and BETAI, term after term.
std::vector<model::Relaxation> read_relaxation(Cards& cards) {
  constexpr std::size_t most_terms = 18;
  std::vector<model::Relaxation> terms;
  while (cards.more()) {
    const Card card = cards.next(rubber_relaxation_card);
    if (card.real("GI") > 0) terms.push_back({card.real("GI"), card.real("BETAI")});
    if (terms.size() == most_terms + 1)
      cards.report().error(card.where(), "terms", fmt::format("expected at most {} terms", most_terms));
  }
  return terms;
}

/// DAMP is the least linear coefficient of the bulk viscosity; the keyword manual recommends 0.05 to 0.5.
void warn_of_damping(const Card& card, Report& report) {
  constexpr double most = 0.5;
  if (!card.good("DAMP") || card.real("DAMP") <= most) return;
  report.field_warning(
      card.where(),
      {"DAMP", std::string(card.text("DAMP")), "0.05 to 0.5",
       "as much viscosity stiffens the foam with the rate and lowers the stable step", "damping"});
}

}  // namespace

void read_mat_low_density_foam(Cards& cards, RawDeck& deck) {
  constexpr double unbounded = 1e19;
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(low_density_card);
    const Card second = cards.next_or_default(low_density_second_card);
    RawMaterial raw = material_of(heading, card);
    model::LowDensityFoam law;
    law.youngs_modulus = card.real("E");
    if (card.real("TC") < unbounded) law.tensile_stress = card.real("TC");
    law.unloading_factor = card.real("HU");
    law.unloading_shape = second.real("SHAPE");
    law.damping = card.real("DAMP");
    warn_of_damping(card, cards.report());
    law.tears = second.real("FAIL") == 1;
    law.contact_modulus = second.real("KCON");
    raw.hardening_curve = card.good("LCID") ? card.integer("LCID") : 0;
    raw.curve_where = card.where();
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_fu_chang_foam(Cards& cards, RawDeck& deck) {
  constexpr double unbounded = 1e19;
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(fu_chang_card);
    const Card second = cards.next_or_default(fu_chang_second_card);
    cards.next_or_default(fu_chang_third_card);
    const Card fourth = cards.next_or_default(fu_chang_fourth_card);
    cards.next_or_default(fu_chang_fifth_card);
    RawMaterial raw = material_of(heading, card);
    model::LowDensityFoam law;
    law.youngs_modulus = card.real("E");
    if (card.real("TC") < unbounded) law.tensile_stress = card.real("TC");
    law.tears = card.real("FAIL") == 1;
    law.contact_modulus = card.real("KCON");
    law.damping = card.real("DAMP");
    law.engineering_rate = second.real("SFLAG") == 1;
    if (second.real("HU") > 0) law.unloading_factor = second.real("HU");
    law.unloading_shape = fourth.real("SHAPE");
    raw.hardening_curve = card.good("TBID") ? card.integer("TBID") : 0;
    raw.curve_where = card.where();
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_ogden_rubber(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(rubber_card);
    const Card moduli = cards.next(ogden_moduli_card);
    const Card exponents = cards.next(ogden_exponents_card);
    const std::vector<model::Relaxation> relaxing = read_relaxation(cards);
    RawMaterial raw = material_of(heading, card);
    model::OgdenRubber law;
    law.relaxing = relaxing;
    double shear_modulus = 0;
    for (std::size_t n = 0; n < law.modulus.size(); ++n) {
      law.modulus[n] = moduli.real(ogden_moduli_card[n].name);
      law.exponent[n] = exponents.real(ogden_exponents_card[n].name);
      shear_modulus += 0.5 * law.modulus[n] * law.exponent[n];
    }
    if (card.good("N")) check_rubber(moduli, "MU1", shear_modulus, cards.report());
    law.poissons_ratio = card.real("PR");
    law.youngs_modulus = 2 * shear_modulus * (1 + law.poissons_ratio);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_hyperelastic_rubber(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(rubber_card);
    const Card constants = cards.next(polynomial_rubber_card);
    const std::vector<model::Relaxation> relaxing = read_relaxation(cards);
    RawMaterial raw = material_of(heading, card);
    model::PolynomialRubber law;
    law.relaxing = relaxing;
    law.c10 = constants.real("C10");
    law.c01 = constants.real("C01");
    law.c11 = constants.real("C11");
    law.c20 = constants.real("C20");
    law.c02 = constants.real("C02");
    law.c30 = constants.real("C30");
    const double shear_modulus = 2 * (law.c10 + law.c01);
    if (card.good("N")) check_rubber(constants, "C10", shear_modulus, cards.report());
    law.poissons_ratio = card.real("PR");
    law.youngs_modulus = 2 * shear_modulus * (1 + law.poissons_ratio);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_viscoelastic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(viscoelastic_card);
    RawMaterial raw = material_of(heading, card);
    model::Viscoelastic law;
    const double stays = card.real("GI");
    const double relaxes = card.real("G0") - stays;
    if (card.good("G0") && card.good("GI") && relaxes < 0)
      cards.report().field_error(card.where(), {"GI", std::string(card.text("GI")), "a modulus not above G0",
                                                "it is what is left of G0 in the end", "modulus"});
    if (stays > 0) law.shear.push_back({stays, 0});
    if (relaxes > 0) law.shear.push_back({relaxes, card.real("BETA")});
    law.bulk = {{card.real("BULK"), 0}};
    set_instantaneous(law);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_general_viscoelastic(Cards& cards, RawDeck& deck) {
  constexpr std::size_t most_terms = 18;
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(general_viscoelastic_card);
    const Card fit = cards.next(general_viscoelastic_fit_card);
    RawMaterial raw = material_of(heading, card);
    model::Viscoelastic law;
    Where first = fit.where();
    std::size_t terms = 0;
    while (cards.more()) {
      const Card term = cards.next(prony_card);
      if (terms == 0) first = term.where();
      if (++terms > most_terms) continue;
      if (term.real("GI") > 0) law.shear.push_back({term.real("GI"), term.real("BETAI")});
      if (term.real("KI") > 0) law.bulk.push_back({term.real("KI"), term.real("BETAKI")});
    }
    if (terms > most_terms)
      cards.report().error(first, "terms", fmt::format("{} terms, expected at most {}", terms, most_terms));
    const bool curves = fit.real("LCID") != 0 || fit.real("LCIDK") != 0;
    if (law.shear.empty() && !curves)
      cards.report().error(first, "terms",
                           "expected a term with GI above zero: the shear modulus is their sum");
    // With terms of its own BULK is the stiffness of contact alone.
    if (law.bulk.empty() && card.good("BULK") && !(card.real("BULK") > 0) && !curves)
      cards.report().field_error(card.where(), {"BULK", std::string(card.text("BULK")), "a number above zero",
                                                "or give the terms KI", "modulus"});
    if (law.bulk.empty()) law.bulk = {{card.real("BULK"), 0}};
    set_instantaneous(law);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
