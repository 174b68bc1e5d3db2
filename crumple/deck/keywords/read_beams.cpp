// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_BEAM, *MAT_RESULTANT_PLASTICITY.
#include <utility>

#include "deck/keywords/families.hpp"
#include "deck/keywords/material_cards.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr std::string_view no_release = "released degrees of freedom are not supported; the ends are rigid";

constexpr Field beam_element_card[] = {
    sized(8, id("EID")),
    sized(8, id("PID")),
    sized(8, id("N1")),
    sized(8, id("N2")),
    sized(8, reference("N3")),
    sized(8, only("RT1", {0}, no_release)),
    sized(8, only("RR1", {0}, no_release)),
    sized(8, only("RT2", {0}, no_release)),
    sized(8, only("RR2", {0}, no_release)),
    sized(8, unused("LOCAL")),  // axes of the releases
};

constexpr Field beam_orientation_card[] = {direction(real("VX")), direction(real("VY")),
                                           direction(real("VZ"))};

constexpr Field resultant_plasticity_card[] = {
    id("MID"),
    real("RO", 0, above_zero),
    real("E", 0, above_zero),
    real("PR", 0, poisson),
    real("YIELD", 0, above_zero),
    unused("ETAN"),  // of shells
};

RawBeam beam_of(const Card& card) {
  RawBeam beam;
  beam.id = card.integer("EID");
  beam.part = card.integer("PID");
  beam.node = {card.integer("N1"), card.integer("N2")};
  beam.orientation_node = card.good("N3") ? card.integer("N3") : 0;
  beam.where = card.where();
  return beam;
}

bool has_beam_ids(const Card& card) {
  return card.good("EID") && card.good("PID") && card.good("N1") && card.good("N2");
}

}  // namespace

void read_element_beam(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(beam_element_card);
    if (has_beam_ids(card)) deck.beams.push_back(beam_of(card));
  }
}

void read_element_beam_orientation(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(beam_element_card);
    const Card vector = cards.next(beam_orientation_card);
    RawBeam beam = beam_of(card);
    beam.orientation = {vector.real("VX"), vector.real("VY"), vector.real("VZ")};
    if (has_beam_ids(card)) deck.beams.push_back(beam);
  }
}

void read_mat_resultant_plasticity(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(resultant_plasticity_card);
    RawMaterial raw = material_of(heading, card);
    raw.material.law = model::ResultantPlasticity{card.real("E"), card.real("PR"), card.real("YIELD")};
    if (card.good("MID")) deck.materials.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
