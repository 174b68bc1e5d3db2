// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ELASTIC_PLASTIC_HYDRO, *MAT_ELASTIC_PLASTIC_HYDRO_SPALL.
#include <array>
#include <string>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field hydro_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("G", 0, above_zero),
    real("SIGY", 0, not_negative),
    real("EH", 0, not_negative),
    real("PC"),  // not above zero
    real("FS", 0, not_negative),
    unused("CHARL"),  // of elements in two dimensions
};
constexpr Field hydro_spall_card[] = {
    real("A1"),
    real("A2"),
    only("SPALL", {0, 1, 2, 3},
         "1 bounds the pressure, 2 makes rubble at a principal stress of -PC, 3 at the pressure PC, 0 is 1"),
};
constexpr Field hydro_strain_card[] = {
    real("EPS1", 0, not_negative), real("EPS2", 0, not_negative), real("EPS3", 0, not_negative),
    real("EPS4", 0, not_negative), real("EPS5", 0, not_negative), real("EPS6", 0, not_negative),
    real("EPS7", 0, not_negative), real("EPS8", 0, not_negative),
};
constexpr Field hydro_more_strain_card[] = {
    real("EPS9", 0, not_negative),  real("EPS10", 0, not_negative), real("EPS11", 0, not_negative),
    real("EPS12", 0, not_negative), real("EPS13", 0, not_negative), real("EPS14", 0, not_negative),
    real("EPS15", 0, not_negative), real("EPS16", 0, not_negative),
};
constexpr Field hydro_stress_card[] = {
    real("ES1", 0, not_negative), real("ES2", 0, not_negative), real("ES3", 0, not_negative),
    real("ES4", 0, not_negative), real("ES5", 0, not_negative), real("ES6", 0, not_negative),
    real("ES7", 0, not_negative), real("ES8", 0, not_negative),
};
constexpr Field hydro_more_stress_card[] = {
    real("ES9", 0, not_negative),  real("ES10", 0, not_negative), real("ES11", 0, not_negative),
    real("ES12", 0, not_negative), real("ES13", 0, not_negative), real("ES14", 0, not_negative),
    real("ES15", 0, not_negative), real("ES16", 0, not_negative),
};

constexpr std::size_t per_card = std::size(hydro_strain_card);
constexpr std::size_t most_points = 2 * per_card;

struct HydroCards {
  Card first, spall;
  std::array<Card, 2> strain, stress;
};

/// A value of EPS or ES as its card has it.
struct Entry {
  const Card* card;
  std::string_view name;

  double value() const { return card->real(name); }
  bool good() const { return card->good(name); }
  void fail(Report& report, const char* expected, const char* hint, std::string_view kind) const {
    report.field_error(card->where(), {name, std::string(card->text(name)), expected, hint, kind});
  }
};
Entry strain_entry(const HydroCards& cards, std::size_t i) {
  if (i < per_card) return {&cards.strain[0], hydro_strain_card[i].name};
  return {&cards.strain[1], hydro_more_strain_card[i - per_card].name};
}
Entry stress_entry(const HydroCards& cards, std::size_t i) {
  if (i < per_card) return {&cards.stress[0], hydro_stress_card[i].name};
  return {&cards.stress[1], hydro_more_stress_card[i - per_card].name};
}

/// EPS and ES up to the last pair that is not zero.
void take_points(const HydroCards& cards, std::size_t count, model::HydroPlasticity& law, Report& report) {
  for (std::size_t i = 0; i < count; ++i) {
    const Entry strain = strain_entry(cards, i);
    const Entry stress = stress_entry(cards, i);
    if (!strain.good() || !stress.good()) continue;
    if (i == 0 && strain.value() > 0)
      strain.fail(report, "0", "the curve starts with the first yield stress", "start");
    if (i > 0 && !(strain.value() > strain_entry(cards, i - 1).value()))
      strain.fail(report, "a strain above the one before it", "plastic strains ascend", "order");
    if (!(stress.value() > 0))
      stress.fail(report, "a yield stress above zero", "every EPS needs its ES", "stress");
    law.plastic_strain.push_back(strain.value());
    law.yield_stress.push_back(stress.value());
  }
  if (count == 1)
    report.error(cards.strain[0].where(), "points",
                 "one point of EPS and ES is given, expected none or at least two");
  else if (law.yield_stress.size() == count && law.yield_stress[count - 1] < law.yield_stress[count - 2])
    stress_entry(cards, count - 1)
        .fail(report, "a yield stress not below the one before it",
              "the slope of the last piece goes on beyond it, and would lead below zero", "softening");
}

std::size_t count_points(const HydroCards& cards) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < most_points; ++i)
    if (strain_entry(cards, i).value() != 0 || stress_entry(cards, i).value() != 0) count = i + 1;
  return count;
}

/// The points where there are some, else SIGY and EH with A1 and A2.
void take_strength(const HydroCards& cards, bool has_spall, model::HydroPlasticity& law, Report& report) {
  const std::size_t count = count_points(cards);
  if (count > 0) {
    take_points(cards, count, law, report);
    for (const std::string_view name : {"A1", "A2"})
      if (has_spall && cards.spall.real(name) != 0)
        report.field_warning(
            cards.spall.where(),
            {name, std::string(cards.spall.text(name)), "0",
             "it acts on the yield stress of SIGY and EH alone, not on that of EPS and ES", "pressure"});
    return;
  }
  law.plastic_strain = {0};
  law.yield_stress = {cards.first.real("SIGY")};
  law.hardening = cards.first.real("EH");
  if (has_spall) {
    law.pressure_factor = cards.spall.real("A1");
    law.pressure_square = cards.spall.real("A2");
  }
  const bool rises = law.pressure_factor > 0 || law.pressure_square > 0;
  if (cards.first.good("SIGY") && !(law.yield_stress[0] > 0) && !rises)
    report.field_error(cards.first.where(),
                       {"SIGY", std::string(cards.first.text("SIGY")), "a number above zero",
                        "or give the yield stress with EPS and ES, or with A1 and A2", "yield"});
}

/// Zero is 1 here, and 2 with *MAT_JOHNSON_COOK.
model::Spall hydro_spall(double number) {
  using enum model::Spall;
  return number == 2 ? Stress : number == 3 ? Pressure : None;
}

void read_hydro(Cards& cards, RawDeck& deck, bool has_spall) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    HydroCards read;
    read.first = cards.next(hydro_card);
    if (has_spall) read.spall = cards.next(hydro_spall_card);
    read.strain = {cards.next_or_default(hydro_strain_card), cards.next_or_default(hydro_more_strain_card)};
    read.stress = {cards.next_or_default(hydro_stress_card), cards.next_or_default(hydro_more_stress_card)};
    RawMaterial raw = material_of(heading, read.first);
    model::HydroPlasticity law;
    law.shear_modulus = read.first.real("G");
    law.youngs_modulus = 2 * law.shear_modulus * (1 + law.poissons_ratio);
    take_strength(read, has_spall, law, cards.report());
    check_pressure_cut_off(read.first, cards.report());
    law.least_pressure = read.first.real("PC");
    if (has_spall) law.spall = hydro_spall(read.spall.real("SPALL"));
    law.failure_strain = failure_strain(read.first.real("FS"));
    raw.material.law = std::move(law);
    if (read.first.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace

void read_mat_elastic_plastic_hydro(Cards& cards, RawDeck& deck) {
  read_hydro(cards, deck, false);
}

void read_mat_elastic_plastic_hydro_spall(Cards& cards, RawDeck& deck) {
  read_hydro(cards, deck, true);
}

}  // namespace crumple::deck
