// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ELASTIC, *MAT_PLASTIC_KINEMATIC, *MAT_ISOTROPIC_ELASTIC_PLASTIC, *MAT_ISOTROPIC_ELASTIC_FAILURE,
// *MAT_PIECEWISE_LINEAR_PLASTICITY, its modified form and *MAT_PLASTICITY_WITH_DAMAGE.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"
#include "model/elastic_moduli.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field elastic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    only("DA", {0}, "damping of beams is not supported"),
    only("DB", {0}, "damping of beams is not supported"),
    only("K", {0}, "fluids are not supported"),
};

constexpr Field plastic_kinematic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("SIGY", 0, above_zero),
    real("ETAN", 0, not_negative),
    real("BETA", 0, within(0, 1, "0 is kinematic, 1 isotropic hardening")),
};

constexpr Field plastic_kinematic_rate_card[] = {
    real("SRC", 0, not_negative),
    real("SRP", 0, not_negative),
    real("FS", 0, not_negative),
    viscoplastic_value,
};

constexpr Field isotropic_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, above_zero),
    real("SIGY", 0, above_zero),
    real("ETAN", 0, not_negative),
    real("BULK", 0, above_zero),
};

constexpr Field isotropic_failure_card[] = {
    real("EPF", 0, not_negative),
    real("PRF"),  // not above zero
    real("REM"),  // anything but zero keeps failed elements
    real("TREM", 0, not_negative),
};

constexpr Field piecewise_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("SIGY", 0, not_negative),  // above zero unless a curve or points are given
    real("ETAN", 0, not_negative),
    real("FAIL"),
    real("TDEL", 0, not_negative),
};

constexpr Field piecewise_rate_card[] = {
    real("C", 0, not_negative), real("P", 0, not_negative), reference("LCSS"),
    reference("LCSR"),          viscoplastic_field,
};

constexpr Field modified_rate_card[] = {
    real("C", 0, not_negative),
    real("P", 0, not_negative),
    reference("LCSS"),
    reference("LCSR"),
    viscoplastic_field,
    real("EPSTHIN", 0, not_negative),
    real("EPSMAJ"),  // below zero: filtered, not supported
    real("NUMINT"),  // below zero: a share
};

constexpr Field damaged_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("SIGY", 0, not_negative),
    real("ETAN", 0, not_negative),
    real("EPPF", 0, not_negative),  // zero is never, unless there is LCDM
    real("TDEL", 0, not_negative),
};

constexpr Field damaged_rate_card[] = {
    real("C", 0, not_negative),
    real("P", 0, not_negative),
    reference("LCSS"),
    reference("LCSR"),
    real("EPPFR", 0, not_negative),
    viscoplastic_field,
    reference("LCDM", IdKind::Function),
    real("NUMINT"),
};

constexpr Field strain_card[] = {real("EPS1", 0, not_negative), real("EPS2", 0, not_negative),
                                 real("EPS3", 0, not_negative), real("EPS4", 0, not_negative),
                                 real("EPS5", 0, not_negative), real("EPS6", 0, not_negative),
                                 real("EPS7", 0, not_negative), real("EPS8", 0, not_negative)};

constexpr Field stress_card[] = {real("ES1", 0, not_negative), real("ES2", 0, not_negative),
                                 real("ES3", 0, not_negative), real("ES4", 0, not_negative),
                                 real("ES5", 0, not_negative), real("ES6", 0, not_negative),
                                 real("ES7", 0, not_negative), real("ES8", 0, not_negative)};

/// FAIL, which calls a subroutine of the user where it is negative.
double checked_failure_strain(const Card& card, Report& report) {
  if (card.real("FAIL") >= 0) return failure_strain(card.real("FAIL"));
  report.field_unsupported(card.where(),
                           {"FAIL", std::string(card.text("FAIL")), "a failure strain, or 0 for no failure",
                            "a negative value calls a failure routine of the user", "failure"});
  return 0;
}

void take_failed_points(const Card& card, model::PiecewiseLinearPlasticity& law, Report& report) {
  const double count = card.real("NUMINT");
  constexpr double percent = 100;
  if (count < -percent || (count > 0 && std::floor(count) != count))
    report.field_error(card.where(), {"NUMINT", std::string(card.text("NUMINT")),
                                      "a number of points, or minus a percentage of them",
                                      "so many failed points make the element fail", "points"});
  else if (count < 0)
    law.failed_share = -count / percent;
  else
    law.failed_points = static_cast<int>(std::min(count, percent));
}

/// EPSTHIN and EPSMAJ.
void take_strain_limits(const Card& card, model::PiecewiseLinearPlasticity& law, Report& report) {
  law.failure_thinning = failure_strain(card.real("EPSTHIN"));
  if (card.real("EPSMAJ") < 0)
    report.field_unsupported(card.where(),
                             {"EPSMAJ", std::string(card.text("EPSMAJ")), "a strain not below zero",
                              "the mean of the last twelve values is not taken", "filter"});
  else
    law.failure_major = failure_strain(card.real("EPSMAJ"));
}

/// EPPF, EPPFR and LCDM, whose points are looked up when the model is built.
void take_damage(const Card& card, const Card& rate, model::PiecewiseLinearPlasticity& law, RawMaterial& raw,
                 Report& report) {
  const double begin = failure_strain(card.real("EPPF"));
  const double end = failure_strain(rate.real("EPPFR"));
  law.failure_strain = end;
  if (rate.good("LCDM") && rate.integer("LCDM") != 0) {
    raw.more_curves[0] = rate.integer("LCDM");
    law.damage_strain = {begin};
    law.damage = {0};
    return;
  }
  if (!(end > 0)) return;
  if (begin == 0)
    report.field_warning(card.where(),
                         {"EPPF", std::string(card.text("EPPF")), "the plastic strain where softening begins",
                          "zero is never, so the stress stays whole up to EPPFR", "softening"});
  const bool fades = begin > 0 && begin < end;
  law.damage_strain = fades ? std::vector<double>{0, begin, end} : std::vector<double>{0};
  law.damage = fades ? std::vector<double>{0, 0, 1} : std::vector<double>{0};
}

void check_tangent(const Card& card, Report& report) {
  if (card.good("ETAN") && card.good("E") && card.real("ETAN") >= card.real("E"))
    report.field_error(card.where(), {"ETAN", std::string(card.text("ETAN")), "a number below E",
                                      "it is the slope of stress over total strain behind yield", "tangent"});
}

/// EPS1-8 and ES1-8 up to the last pair that is not zero; none, with a warning, if all strains are zero.
void take_points(const Card& strain, const Card& stress, model::PiecewiseLinearPlasticity& law,
                 Report& report) {
  std::size_t count = 0;
  bool has_strain = false;
  for (std::size_t i = 0; i < std::size(strain_card); ++i) {
    has_strain = has_strain || strain.real(strain_card[i].name) != 0 || !strain.good(strain_card[i].name);
    if (strain.real(strain_card[i].name) != 0 || stress.real(stress_card[i].name) != 0) count = i + 1;
  }
  if (count > 0 && !has_strain) {
    report.warning(stress.where(), "no strains",
                   "EPS1 to EPS8 are all zero, so that ES1 to ES8 are no curve: SIGY and ETAN are taken");
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view eps = strain_card[i].name;
    const std::string_view es = stress_card[i].name;
    if (!strain.good(eps) || !stress.good(es)) continue;
    if (i > 0 && strain.real(eps) <= strain.real(strain_card[i - 1].name))
      report.field_error(strain.where(),
                         {eps, std::string(strain.text(eps)), "a strain above the one before it",
                          "plastic strains ascend", "order"});
    if (!(stress.real(es) > 0))
      report.field_error(stress.where(), {es, std::string(stress.text(es)), "a yield stress above zero",
                                          "every EPS needs its ES", "stress"});
    law.plastic_strain.push_back(strain.real(eps));
    law.yield_stress.push_back(stress.real(es));
  }
  if (count == 1)
    report.error(strain.where(), "points", "one point of EPS and ES is given, expected none or at least two");
}

/// SIGY and ETAN as the first point and the plastic modulus behind it.
void take_line(const Card& card, model::PiecewiseLinearPlasticity& law, Report& report) {
  const double yield = card.real("SIGY");
  const double young = card.real("E");
  const double tangent = card.real("ETAN");
  if (card.good("SIGY") && !(yield > 0))
    report.field_error(card.where(), {"SIGY", std::string(card.text("SIGY")), "a number above zero",
                                      "or give the hardening with LCSS or with EPS1-8 and ES1-8", "yield"});
  check_tangent(card, report);
  const double plastic_modulus = tangent < young ? young * tangent / (young - tangent) : 0;
  constexpr double far_strain = 10;  // no metal gets there
  law.plastic_strain = {0, far_strain};
  law.yield_stress = {yield, yield + plastic_modulus * far_strain};
}

}  // namespace

RawMaterial material_of(const Heading& heading, const Card& card) {
  RawMaterial raw;
  raw.material.id = card.integer("MID");
  raw.material.title = heading.title;
  raw.material.density = card.real("RO");
  raw.where = card.where();
  return raw;
}

void check_pressure_cut_off(const Card& card, Report& report) {
  if (card.good("PC") && card.real("PC") > 0)
    report.field_error(card.where(), {"PC", std::string(card.text("PC")), "a pressure not above zero",
                                      "it is the lower bound of the pressure, tension is below zero; 0 is no "
                                      "bound",
                                      "cut-off"});
}

double failure_strain(double read) {
  constexpr double never = 1e5;
  return read >= never ? 0 : read;
}

double deletion_step(double read) {
  constexpr double never = 1e20;
  return read < never ? read : 0;
}

void check_rate(const Card& card, std::string_view rate, std::string_view exponent, Report& report) {
  if (card.real(rate) > 0 && card.good(exponent) && !(card.real(exponent) > 0))
    report.field_error(card.where(),
                       {exponent, std::string(card.text(exponent)), "a number above zero",
                        fmt::format("{} switches the rate effect on, and it needs both", rate), "rate"});
}

bool take_viscoplastic(const Card& card, double rate, Report& report) {
  const double read = card.real("VP");
  if (!card.good("VP") || read == 0 || read == 1) return read == 1;
  FieldFault fault{"VP", std::string(card.text("VP")), "0 or 1",
                   "0 multiplies the yield stress, 1 adds to it where the law tells them apart",
                   "viscoplastic"};
  if (rate > 0) {
    report.field_unsupported(card.where(), fault);
  } else {
    fault.hint = "it has no effect, as there is no rate effect";
    report.field_warning(card.where(), fault);
  }
  return false;
}

void read_mat_elastic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(elastic_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = model::Elastic{card.real("E"), card.real("PR")};
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_plastic_kinematic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(plastic_kinematic_card);
    const Card rate = cards.next_or_default(plastic_kinematic_rate_card);
    RawMaterial raw = material_of(heading, card);
    model::PlasticKinematic law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.yield_stress = card.real("SIGY");
    law.tangent_modulus = card.real("ETAN");
    law.isotropic_fraction = card.real("BETA");
    law.cowper_symonds_rate = rate.real("SRC");
    law.cowper_symonds_exponent = rate.real("SRP");
    law.failure_strain = failure_strain(rate.real("FS"));
    law.viscoplastic = take_viscoplastic(rate, law.cowper_symonds_rate, cards.report());
    check_tangent(card, cards.report());
    check_rate(rate, "SRC", "SRP", cards.report());
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

namespace {

/// E and Poisson's ratio of G and BULK.
template <class Law>
void take_moduli(const Card& card, Law& law, Report& report) {
  const double shear = card.good("G") ? card.real("G") : 1;
  const double bulk = card.good("BULK") ? card.real("BULK") : shear;
  model::set_moduli(law, bulk, shear);
  if (law.poissons_ratio < 0)
    report.field_error(card.where(),
                       {"BULK", std::string(card.text("BULK")), "at least two thirds of G",
                        fmt::format("Poisson's ratio comes out as {:.4g}", law.poissons_ratio), "poisson"});
}

/// PRF, of which zero is taken as none.
double failure_pressure(const Card& card, Report& report) {
  constexpr double never = -1e15;
  const double read = card.real("PRF");
  if (read > 0)
    report.field_error(card.where(),
                       {"PRF", std::string(card.text("PRF")), "a pressure not above zero",
                        "it is the lower bound of the pressure, tension is below zero", "failure"});
  else if (card.good("PRF") && read == 0)
    report.field_warning(card.where(),
                         {"PRF", std::string(card.text("PRF")), "a pressure below zero",
                          "sources do not say whether zero is failure in any tension; it is taken as none, "
                          "as -1e20 is",
                          "failure"});
  return read > never && read < 0 ? read : 0;
}

}  // namespace

/// The law of *MAT_PLASTIC_KINEMATIC with BETA = 1. ETAN is the slope over the plastic strain, as the Keyword
/// Manual, Volume II, calls it.
void read_mat_isotropic_elastic_plastic(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(isotropic_card);
    RawMaterial raw = material_of(heading, card);
    const double hardening = card.real("ETAN");
    model::PlasticKinematic law;
    take_moduli(card, law, cards.report());
    law.yield_stress = card.real("SIGY");
    law.tangent_modulus = law.youngs_modulus * hardening / (law.youngs_modulus + hardening);
    law.isotropic_fraction = 1;
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

/// With TREM the time step alone deletes, as the Keyword Manual has it.
void read_mat_isotropic_elastic_failure(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(isotropic_card);
    const Card failure = cards.next(isotropic_failure_card);
    RawMaterial raw = material_of(heading, card);
    model::FailingSolid law;
    take_moduli(card, law, cards.report());
    law.yield_stress = card.real("SIGY");
    law.hardening = card.real("ETAN");
    law.failure_strain = failure_strain(failure.real("EPF"));
    law.failure_pressure = failure_pressure(failure, cards.report());
    raw.material.least_step = deletion_step(failure.real("TREM"));
    law.keeps_failed = failure.real("REM") != 0 || raw.material.least_step > 0;
    if (failure.real("REM") == 0 && law.keeps_failed)
      cards.report().add(Severity::Note, failure.where(), "removal",
                         "TREM goes before REM: failed elements stay, without tension and shear, until "
                         "their time step is below TREM");
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

namespace {

/// What a form of the law has beside hardening.
enum class Failure { Strain, StrainLimits, Damage };

void take_failure(Failure failure, const Card& card, const Card& rate, model::PiecewiseLinearPlasticity& law,
                  RawMaterial& raw, Report& report) {
  if (failure == Failure::Damage)
    take_damage(card, rate, law, raw, report);
  else
    law.failure_strain = checked_failure_strain(card, report);
  if (failure == Failure::StrainLimits) take_strain_limits(rate, law, report);
  const bool counts = failure == Failure::StrainLimits || has_damage(law);
  if (counts) take_failed_points(rate, law, report);
}

/// `first_fields` and `rate_fields` are those of the first two cards.
void read_piecewise(Cards& cards, RawDeck& deck, Layout first_fields, Layout rate_fields, Failure failure) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(first_fields);
    const Card rate = cards.next_or_default(rate_fields);
    const Card strain = cards.next_or_default(strain_card);
    const Card stress = cards.next_or_default(stress_card);
    RawMaterial raw = material_of(heading, card);
    model::PiecewiseLinearPlasticity law;
    law.youngs_modulus = card.real("E");
    law.poissons_ratio = card.real("PR");
    law.cowper_symonds_rate = rate.real("C");
    law.cowper_symonds_exponent = rate.real("P");
    law.viscoplastic = rate.real("VP") == 1;
    law.viscoplastic_base = card.real("SIGY");
    take_failure(failure, card, rate, law, raw, cards.report());
    check_rate(rate, "C", "P", cards.report());
    raw.rate_curve = rate.good("LCSR") ? rate.integer("LCSR") : 0;
    raw.hardening_curve = rate.good("LCSS") ? rate.integer("LCSS") : 0;
    if (raw.hardening_curve == 0) take_points(strain, stress, law, cards.report());
    if (raw.hardening_curve == 0 && law.plastic_strain.empty()) take_line(card, law, cards.report());
    raw.material.law = law;
    raw.material.least_step = deletion_step(card.real("TDEL"));
    raw.curve_where = rate.where();
    raw.by_log_of_rates = card.where().keyword.find("LOG_INTERPOLATION") != std::string_view::npos;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace

void read_mat_piecewise_linear_plasticity(Cards& cards, RawDeck& deck) {
  read_piecewise(cards, deck, piecewise_card, piecewise_rate_card, Failure::Strain);
}

void read_mat_modified_piecewise_linear_plasticity(Cards& cards, RawDeck& deck) {
  read_piecewise(cards, deck, piecewise_card, modified_rate_card, Failure::StrainLimits);
}

void read_mat_plasticity_with_damage(Cards& cards, RawDeck& deck) {
  read_piecewise(cards, deck, damaged_card, damaged_rate_card, Failure::Damage);
}

}  // namespace crumple::deck
