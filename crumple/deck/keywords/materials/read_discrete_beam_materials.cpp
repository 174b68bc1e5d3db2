// SPDX-License-Identifier: BSD-3-Clause
// *MAT_LINEAR_ELASTIC_DISCRETE_BEAM, _NONLINEAR_ELASTIC_, _CABLE_, _ELASTIC_SPRING_,
// _GENERAL_NONLINEAR_6DOF_ and _GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM.
#include <array>
#include <string_view>
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field linear_beam_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("TKR", 0, not_negative),
    real("TKS", 0, not_negative),
    real("TKT", 0, not_negative),
    real("RKR", 0, not_negative),
    real("RKS", 0, not_negative),
    real("RKT", 0, not_negative),
};

constexpr Field linear_damping_card[] = {
    real("TDR", 0, not_negative), real("TDS", 0, not_negative), real("TDT", 0, not_negative),
    real("RDR", 0, not_negative), real("RDS", 0, not_negative), real("RDT", 0, not_negative),
};

constexpr Field beam_preload_card[] = {real("FOR"), real("FOS"), real("FOT"),
                                       real("MOR"), real("MOS"), real("MOT")};

constexpr Field nonlinear_beam_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    reference("LCIDTR", IdKind::Function),
    reference("LCIDTS", IdKind::Function),
    reference("LCIDTT", IdKind::Function),
    reference("LCIDRR", IdKind::Function),
    reference("LCIDRS", IdKind::Function),
    reference("LCIDRT", IdKind::Function),
};

constexpr Field beam_damping_curves_card[] = {
    reference("LCIDTDR", IdKind::Function), reference("LCIDTDS", IdKind::Function),
    reference("LCIDTDT", IdKind::Function), reference("LCIDRDR", IdKind::Function),
    reference("LCIDRDS", IdKind::Function), reference("LCIDRDT", IdKind::Function),
};

constexpr std::string_view no_beam_failure = "failure of these beams is not supported";

constexpr Field failure_force_card[] = {
    only("FFAILR", {0}, no_beam_failure), only("FFAILS", {0}, no_beam_failure),
    only("FFAILT", {0}, no_beam_failure), only("MFAILR", {0}, no_beam_failure),
    only("MFAILS", {0}, no_beam_failure), only("MFAILT", {0}, no_beam_failure),
};
constexpr Field failure_displacement_card[] = {
    only("UFAILR", {0}, no_beam_failure), only("UFAILS", {0}, no_beam_failure),
    only("UFAILT", {0}, no_beam_failure), only("TFAILR", {0}, no_beam_failure),
    only("TFAILS", {0}, no_beam_failure), only("TFAILT", {0}, no_beam_failure),
};

constexpr Field cable_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E"),  // below zero: minus the stiffness
    reference("LCID"),
    real("F0", 0, not_negative),
    only("TMAXF0", {0, 1e20}, "the initial force stays"),
    real("TRAMP", 0, not_negative),
    only("IREAD", {0}, "output and failure of cables are not supported"),
};

constexpr Field spring_beam_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("K", 0, not_negative),
    real("F0"),
    real("D", 0, not_negative),
    real("CDF", 0, not_negative),
    real("TDF", 0, not_negative),
};

constexpr std::string_view no_rate_terms = "terms of the rate besides D are not supported";

constexpr Field spring_beam_second_card[] = {
    reference("FLCID", IdKind::Function),
    only("HLCID", {0}, no_rate_terms),
    only("C1", {0}, no_rate_terms),
    only("C2", {0}, no_rate_terms),
    unused("DLE"),  // with C2
    only("GLCID", {0}, no_rate_terms),
};

constexpr std::string_view unloading_words =
    "0 follows the curve, 1 the curve of unloading, 2 a stiffness down to it, 3 a parabola";
constexpr std::string_view initial_words = "displacements begin at zero";
constexpr std::string_view stability_words =
    "no damping is added for stability: the step allows for the curves";

constexpr Field six_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("KT", 0, not_negative),
    real("KR", 0, not_negative),
    only("UNLDOPT", {0, 1, 2, 3}, unloading_words),
    real("OFFSET", 0, within(0, 0.99, "the share of the largest displacement that stays")),
    harmless("DAMPF", {0}, stability_words),
    only("IFLAG", {0}, "curves are over displacements; strains and crushing frames are not supported"),
};
constexpr Field six_unloading_card[] = {
    reference("LCIDTUR", IdKind::Function), reference("LCIDTUS", IdKind::Function),
    reference("LCIDTUT", IdKind::Function), reference("LCIDRUR", IdKind::Function),
    reference("LCIDRUS", IdKind::Function), reference("LCIDRUT", IdKind::Function),
};
constexpr Field six_factor_card[] = {
    reference("LCIDTER", IdKind::Function), reference("LCIDTES", IdKind::Function),
    reference("LCIDTET", IdKind::Function), reference("LCIDRER", IdKind::Function),
    reference("LCIDRES", IdKind::Function), reference("LCIDRET", IdKind::Function),
};
constexpr Field six_load_card[] = {
    reference("LCIDTR", IdKind::Function), reference("LCIDTS", IdKind::Function),
    reference("LCIDTT", IdKind::Function), reference("LCIDRR", IdKind::Function),
    reference("LCIDRS", IdKind::Function), reference("LCIDRT", IdKind::Function),
};
constexpr Field six_tension_card[] = {
    real("UTFAILR", 0, not_negative),
    real("UTFAILS", 0, not_negative),
    real("UTFAILT", 0, not_negative),
    real("WTFAILR", 0, not_negative),
    real("WTFAILS", 0, not_negative),
    real("WTFAILT", 0, not_negative),
    only("FCRIT", {0, 1}, "0 counts each sign by itself, 1 both together"),
};
constexpr Field six_compression_card[] = {
    real("UCFAILR", 0, not_negative), real("UCFAILS", 0, not_negative), real("UCFAILT", 0, not_negative),
    real("WCFAILR", 0, not_negative), real("WCFAILS", 0, not_negative), real("WCFAILT", 0, not_negative),
};
constexpr Field six_initial_card[] = {
    only("IUR", {0}, initial_words), only("IUS", {0}, initial_words), only("IUT", {0}, initial_words),
    only("IWR", {0}, initial_words), only("IWS", {0}, initial_words), only("IWT", {0}, initial_words),
};

constexpr Field one_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("K", 0, not_negative),
    only("UNLDOPT", {0, 1, 2, 3}, unloading_words),
    real("OFFSET", 0, within(0, 0.99, "the share of the largest displacement that stays")),
    harmless("DAMPF", {0}, stability_words),
};
constexpr Field one_curves_card[] = {
    reference("LCIDT", IdKind::Function),
    reference("LCIDTU", IdKind::Function),
    reference("LCIDTD", IdKind::Function),
    reference("LCIDTE", IdKind::Function),
};
constexpr Field one_failure_card[] = {
    real("UTFAIL", 0, not_negative),
    real("UCFAIL", 0, not_negative),
    only("IU", {0}, initial_words),
};

constexpr std::string_view names_of_load[] = {"LCIDTR", "LCIDTS", "LCIDTT", "LCIDRR", "LCIDRS", "LCIDRT"};
constexpr std::string_view names_of_damping[] = {"LCIDTDR", "LCIDTDS", "LCIDTDT",
                                                 "LCIDRDR", "LCIDRDS", "LCIDRDT"};
constexpr std::string_view names_of_preload[] = {"FOR", "FOS", "FOT", "MOR", "MOS", "MOT"};

void take_preloads(const Card& card, model::DiscreteBeamLaw& law) {
  for (std::size_t i = 0; i < law.direction.size(); ++i)
    law.direction[i].preload = card.real(names_of_preload[i]);
}

void take_curve(const Card& card, std::string_view name, RawDirectionCurve& curve) {
  if (card.good(name)) curve = {card.integer(name), name, card.where()};
}

/// UNLDOPT and OFFSET.
void take_unloading(const Card& card, model::DiscreteBeamLaw& law) {
  law.unloading = static_cast<model::DiscreteBeamLaw::Unloading>(static_cast<int>(card.real("UNLDOPT")));
  law.permanent_share = card.real("OFFSET");
}

void take_six_curves(const Card& card, Layout layout, std::array<RawDirectionCurve, 6>& curves) {
  for (std::size_t i = 0; i < curves.size(); ++i) take_curve(card, layout[i].name, curves[i]);
}

}  // namespace

void read_mat_linear_elastic_discrete_beam(Cards& cards, RawDeck& deck) {
  constexpr std::string_view stiffnesses[] = {"TKR", "TKS", "TKT", "RKR", "RKS", "RKT"};
  constexpr std::string_view dampings[] = {"TDR", "TDS", "TDT", "RDR", "RDS", "RDT"};
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(linear_beam_card);
    const Card damping = cards.next_or_default(linear_damping_card);
    RawMaterial raw = material_of(heading, card);
    model::DiscreteBeamLaw law;
    for (std::size_t i = 0; i < law.direction.size(); ++i) {
      law.direction[i].stiffness = card.real(stiffnesses[i]);
      law.direction[i].damping = damping.real(dampings[i]);
    }
    take_preloads(cards.next_or_default(beam_preload_card), law);
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_nonlinear_elastic_discrete_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(nonlinear_beam_card);
    const Card damping = cards.next_or_default(beam_damping_curves_card);
    RawMaterial raw = material_of(heading, card);
    model::DiscreteBeamLaw law;
    take_preloads(cards.next_or_default(beam_preload_card), law);
    raw.material.law = law;
    for (std::size_t i = 0; i < law.direction.size(); ++i) {
      take_curve(card, names_of_load[i], raw.direction_curves[i]);
      take_curve(damping, names_of_damping[i], raw.damping_curves[i]);
    }
    if (cards.more()) {
      cards.next(failure_force_card);
      cards.next_or_default(failure_displacement_card);
    }
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_cable_discrete_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(cable_card);
    RawMaterial raw = material_of(heading, card);
    model::DiscreteBeamLaw law;
    law.kind = model::DiscreteBeamLaw::Kind::Cable;
    law.youngs_modulus = card.real("E") > 0 ? card.real("E") : 0;
    if (card.real("E") < 0) law.direction[0].stiffness = -card.real("E");
    law.direction[0].preload = card.real("F0");
    law.ramp_time = card.real("TRAMP");
    raw.material.law = law;
    take_curve(card, "LCID", raw.direction_curves[0]);
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_elastic_spring_discrete_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(spring_beam_card);
    const Card second = cards.next_or_default(spring_beam_second_card);
    RawMaterial raw = material_of(heading, card);
    model::DiscreteBeamLaw law;
    law.kind = model::DiscreteBeamLaw::Kind::Line;
    model::DiscreteBeamDirection& line = law.direction[0];
    take_curve(second, "FLCID", raw.direction_curves[0]);
    // The curve goes before the stiffness.
    line.stiffness = raw.direction_curves[0].id != 0 ? 0 : card.real("K");
    line.preload = card.real("F0");
    line.damping = card.real("D");
    line.compressive_limit = card.real("CDF");
    line.tensile_limit = card.real("TDF");
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_general_nonlinear_6dof(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(six_card);
    RawMaterial raw = material_of(heading, card);
    model::DiscreteBeamLaw law;
    take_unloading(card, law);
    take_six_curves(cards.next(six_load_card), six_load_card, raw.direction_curves);
    take_six_curves(cards.next_or_default(six_unloading_card), six_unloading_card, raw.unloading_curves);
    take_six_curves(cards.next_or_default(beam_damping_curves_card), beam_damping_curves_card,
                    raw.damping_curves);
    take_six_curves(cards.next_or_default(six_factor_card), six_factor_card, raw.damping_factors);
    const Card tension = cards.next_or_default(six_tension_card);
    const Card compression = cards.next_or_default(six_compression_card);
    cards.next_or_default(six_initial_card);
    for (std::size_t i = 0; i < law.direction.size(); ++i) {
      model::DiscreteBeamDirection& one = law.direction[i];
      one.unloading_stiffness = card.real(i < 3 ? "KT" : "KR");
      one.tensile_limit = tension.real(six_tension_card[i].name);
      one.compressive_limit = compression.real(six_compression_card[i].name);
    }
    law.joint_failure = tension.real("FCRIT") == 1;
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

void read_mat_general_nonlinear_1dof(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(one_card);
    const Card curves = cards.next(one_curves_card);
    const Card failure = cards.next_or_default(one_failure_card);
    RawMaterial raw = material_of(heading, card);
    model::DiscreteBeamLaw law;
    law.kind = model::DiscreteBeamLaw::Kind::Line;
    take_unloading(card, law);
    take_curve(curves, "LCIDT", raw.direction_curves[0]);
    take_curve(curves, "LCIDTU", raw.unloading_curves[0]);
    take_curve(curves, "LCIDTD", raw.damping_curves[0]);
    take_curve(curves, "LCIDTE", raw.damping_factors[0]);
    model::DiscreteBeamDirection& line = law.direction[0];
    line.unloading_stiffness = card.real("K");
    line.tensile_limit = failure.real("UTFAIL");
    line.compressive_limit = failure.real("UCFAIL");
    raw.material.law = law;
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
