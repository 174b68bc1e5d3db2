// SPDX-License-Identifier: BSD-3-Clause
// *LOAD_BLAST_ENHANCED, *LOAD_BLAST_SEGMENT: charges of TNT in air and the segments that they load.
#include "deck/keywords/families.hpp"
#include "deck/keywords/mirrored.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field blast_card[] = {
    id("BID", IdKind::Other),
    real("M", 0, above_zero),
    point(real("XBO")),
    point(real("YBO")),
    point(real("ZBO")),
    real("TBO"),
    real_or_default(
        "UNIT", 2,
        check_of(Check::Kind::Only, {2, 1, 3, 4, 5, 6, 7, 8},
                 "1 ft, lb, s, psi; 2 m, kg, s, Pa; 3 in, lbf s^2/in, s, psi; 4 cm, g, us, Mbar; 5 CFM, CFL, "
                 "CFT, CFP; 6 mm, kg, ms, GPa; 7 mm, t, s, MPa; 8 mm, g, ms, MPa")),
    real_or_default("BLAST", 2,
                    check_of(Check::Kind::Only, {2, 1},
                             "2 is a spherical burst in free air, 1 a hemispherical one on the ground; 3, a "
                             "moving warhead, and 4, ground reflection with a Mach stem, are missing")),
};

constexpr Field blast_more_card[] = {
    real("CFM", 0, not_negative),
    real("CFL", 0, not_negative),
    real("CFT", 0, not_negative),
    real("CFP", 0, not_negative),
    reference("NIDBO", IdKind::Node),
    real_or_default("DEATH", 1e20),
    only("NEGPHS", {0, 1},
         "0 is a negative phase by the equation of Friedlander, 1 is none; 2 is not supported"),
};

constexpr Field blast_segment_card[] = {
    id("BID", IdKind::Other),
    id("N1"),
    id("N2"),
    id("N3"),
    reference("N4"),
    only("ALEPID", {0}, "there is no air of elements: the pressure acts on the segment"),
    unused("SFNRB"),  // of ALE elements
    real_or_default("SCALEP", 1),
};

constexpr Field blast_segment_set_card[] = {
    id("BID", IdKind::Other),
    id("SSID"),
    only("ALEPID", {0}, "there is no air of elements: the pressure acts on the segments"),
    unused("SFNRB"),  // of ALE elements
    real_or_default("SCALEP", 1),
};

/// What one unit of the deck is in kg, m, s and Pa.
struct UnitsOfDeck {
  double mass;
  double length;
  double time;
  double stress;
};

constexpr double pound = 0.45359237;       // kg
constexpr double foot = 0.3048;            // m
constexpr double psi = 6894.757293168361;  // Pa

/// By UNIT; those of 5 are on the second card. 1 is not consistent, as in LS-DYNA.
model::BlastUnits units_of(int unit, const Card& more) {
  constexpr double dozen_slugs = psi * 0.0254;  // lbf s^2/in is psi in s^2
  constexpr UnitsOfDeck known[] = {
      {pound, foot, 1, psi},          // 1: ft, lb, s, psi
      {1, 1, 1, 1},                   // 2: m, kg, s, Pa
      {dozen_slugs, 0.0254, 1, psi},  // 3: in, dozens of slugs, s, psi
      {1e-3, 1e-2, 1e-6, 1e11},       // 4: cm, g, microseconds, Mbar
      {0, 0, 0, 0},                   // 5: given
      {1, 1e-3, 1e-3, 1e9},           // 6: mm, kg, ms, GPa
      {1000, 1e-3, 1, 1e6},           // 7: mm, t, s, MPa
      {1e-3, 1e-3, 1e-3, 1e6},        // 8: mm, g, ms, MPa
  };
  if (unit == 5) return {more.real("CFM"), more.real("CFL"), more.real("CFT"), more.real("CFP")};
  const UnitsOfDeck& units = known[unit - 1];
  return {.pounds = units.mass / pound,
          .feet = units.length / foot,
          .milliseconds = 1000 * units.time,
          .psi = units.stress / psi};
}

/// Factors that UNIT = 5 needs.
bool has_factors(const Card& more, Report& report) {
  bool good = true;
  for (const std::string_view field : {"CFM", "CFL", "CFT", "CFP"}) {
    if (!more.good(field)) return false;
    if (more.real(field) > 0) continue;
    report.field_error(more.where(), {field, std::string(more.text(field)), "a number above zero",
                                      "UNIT = 5 takes the factors from this card: pounds, feet, milliseconds "
                                      "and psi in the deck's units of mass, length, time and stress",
                                      "factor"});
    good = false;
  }
  return good;
}

}  // namespace

void read_load_blast_enhanced(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(blast_card);
    const Card more = cards.next(blast_more_card);
    RawAirBlast raw;
    model::AirBlast& blast = raw.blast;
    blast.id = card.integer("BID");
    blast.mass = card.real("M");
    blast.centre = {card.real("XBO"), card.real("YBO"), card.real("ZBO")};
    blast.detonation = card.real("TBO");
    blast.burst = card.real("BLAST") == 1 ? model::AirBlast::Burst::Surface : model::AirBlast::Burst::Air;
    blast.death = more.real("DEATH");
    blast.negative_phase = more.real("NEGPHS") == 0;
    raw.units = static_cast<int>(card.real("UNIT"));
    raw.node = more.integer("NIDBO");
    raw.where = card.where();
    raw.more_where = more.where();
    const bool good = card.good("BID") && card.good("M") && card.good("UNIT") && more.good("NIDBO");
    if (!good || (raw.units == 5 && !has_factors(more, cards.report()))) continue;
    blast.units = units_of(raw.units, more);
    deck.air_blasts.push_back(raw);
  }
}

void read_load_blast_segment(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(blast_segment_card);
    RawBlastSegment raw;
    raw.blast = card.integer("BID");
    raw.node = {card.integer("N1"), card.integer("N2"), card.integer("N3"), card.integer("N4")};
    if (raw.node[3] == 0) raw.node[3] = raw.node[2];
    if (cards.placement().map.mirrors()) mirror_face(raw.node, raw.node[2] == raw.node[3]);
    raw.scale = card.real("SCALEP");
    raw.where = card.where();
    const bool nodes = card.good("N1") && card.good("N2") && card.good("N3") && card.good("N4");
    if (nodes && card.good("BID")) deck.blast_segments.push_back(raw);
  }
}

void read_load_blast_segment_set(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(blast_segment_set_card);
    RawBlastSegment raw;
    raw.blast = card.integer("BID");
    raw.segment_set = card.integer("SSID");
    raw.scale = card.real("SCALEP");
    raw.where = card.where();
    if (card.good("BID") && card.good("SSID")) deck.blast_segments.push_back(raw);
  }
}

}  // namespace crumple::deck
