// SPDX-License-Identifier: BSD-3-Clause
// *MAT_PLASTICITY_COMPRESSION_TENSION.
#include <string>
#include <string_view>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field two_sided_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("C", 0, not_negative),
    real("P", 0, not_negative),
    real("FAIL"),
    real("TDEL", 0, not_negative),
};
constexpr Field two_sided_curve_card[] = {
    reference("LCIDC", IdKind::Function),
    reference("LCIDT", IdKind::Function),
    only("LCSRC", {0}, "rates act by C and P, in compression and tension alike"),
    only("LCSRT", {0}, "rates act by C and P, in compression and tension alike"),
    only("SRFLAG", {0, 1, 2}, "the rate is that of the plastic strain, with each of them"),
    only("LCFAIL", {0}, "failure has one plastic strain, FAIL, at any rate"),
    only("EC", {0}, "Young's modulus is the same in compression and tension"),
    unused("RPCT"),  // belongs to EC
};
constexpr Field two_sided_pressure_card[] = {
    real("PC", 0, not_negative),
    real("PT", 0, not_negative),
    unused("PCUTC"),  // belong to PCUTF
    unused("PCUTT"),
    only("PCUTF", {0}, "the pressure has no cut-off"),
    only("SCALEC", {0, 1}, "curves are not scaled; SFO of *DEFINE_CURVE does that"),
    only("SCALET", {0, 1}, "curves are not scaled; SFO of *DEFINE_CURVE does that"),
    only("SRFILT", {0}, "rates are not filtered"),
};
constexpr Field two_sided_viscous_card[] = {
    only("K", {0}, "there is no viscoelastic part beside the plasticity"),
};
constexpr Field two_sided_series_card[] = {
    only("GI", {0}, "there is no viscoelastic part beside the plasticity"),
    only("BETAI", {0}, "there is no viscoelastic part beside the plasticity"),
};

/// FAIL, which calls a subroutine of the user where it is negative.
double checked_failure(const Card& card, Report& report) {
  if (card.real("FAIL") >= 0) return failure_strain(card.real("FAIL"));
  report.field_unsupported(card.where(),
                           {"FAIL", std::string(card.text("FAIL")), "a failure strain, or 0 for no failure",
                            "a negative value calls a failure routine of the user", "failure"});
  return 0;
}

void check_curve(const Card& card, std::string_view name, Report& report) {
  if (!card.good(name) || card.integer(name) != 0) return;
  report.field_error(card.where(), {name, std::string(card.text(name)), "the id of a curve",
                                    "it has the yield stress over the plastic strain", "curve"});
}

}  // namespace

void read_mat_plasticity_compression_tension(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(two_sided_card);
    const Card curve = cards.next(two_sided_curve_card);
    const Card pressure = cards.next_or_default(two_sided_pressure_card);
    cards.next_or_default(two_sided_viscous_card);
    // As many terms as there are: one material under a keyword.
    while (cards.more()) cards.next_filled(two_sided_series_card);
    RawMaterial raw = material_of(heading, card);
    model::CompressionTension law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.cowper_symonds_rate = card.real("C");
    law.cowper_symonds_exponent = card.real("P");
    check_rate(card, "C", "P", cards.report());
    law.failure_strain = checked_failure(card, cards.report());
    raw.material.least_step = deletion_step(card.real("TDEL"));
    law.compression_pressure = pressure.real("PC");
    law.tension_pressure = pressure.real("PT");
    check_curve(curve, "LCIDC", cards.report());
    check_curve(curve, "LCIDT", cards.report());
    raw.hardening_curve = curve.integer("LCIDC");
    raw.more_curves[0] = curve.integer("LCIDT");
    raw.curve_where = curve.where();
    raw.material.law = std::move(law);
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
