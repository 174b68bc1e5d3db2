// SPDX-License-Identifier: BSD-3-Clause
// *AIRBAG: control volumes.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

/// A number of a curve, or zero for none.
consteval Field curve_field(std::string_view name) {
  return reference(name, IdKind::Function);
}

constexpr Field surface_card[] = {
    id("SID"),
    only("SIDTYP", {0, 1}, "0 is a segment set, 1 a part set"),
    only("RBID", {0}, "no sensor: the volume is active from time zero on"),
    real_or_default("VSCA", 1.0, above_zero),
    real_or_default("PSCA", 1.0, above_zero),
    only("VINI", {0}, "the volume at time zero is that of the surface"),
    only("MWD", {0}, "no damping by this keyword; *DAMPING_GLOBAL damps"),
    only("SPSF", {0}, "no stagnation pressure"),
};

constexpr Field pressure_volume_card[] = {
    real("CN", 0, not_negative), real_or_default("BETA", 1.0, not_negative), reference("LCID"),
    unused("LCIDDR"),  // there is no dynamic relaxation
};

constexpr Field adiabatic_card[] = {
    real_or_default("PSF", 1.0, not_negative),
    only("LCID", {0}, "no preload by a curve"),
    real("GAMMA", 0, above_zero),
    real("P0"),
    real("PE", 0, not_negative),
    real("RO", 0, above_zero),
};

constexpr Field fluid_card[] = {
    real("BULK", 0, not_negative),
    real("RO", 0, above_zero),
    curve_field("LCINT"),
    curve_field("LCOUTT"),
    curve_field("LCOUTP"),
    curve_field("LCFIT"),
    curve_field("LCBULK"),
    only("LCID", {0}, "the pressure follows from the volume; *LOAD_SEGMENT_SET has it by a curve"),
};

constexpr Field fluid_limit_card[] = {
    real("P_LIMIT", 0, not_negative),
    curve_field("P_LIMLC"),
    only("NONULL", {0}, "the pressure acts on null shells as well"),
};

constexpr Field inflated_card[] = {
    real("CV", 0, above_zero), real("CP", 0, above_zero),   real("T", 0, not_negative),
    reference("LCID"),         real("MU", 0, not_negative), real("AREA", 0, not_negative),
    real("PE", 0, above_zero), real("RO", 0, above_zero),
};

// What follows LOU is for CV = 0, heat capacities that depend on the temperature.
constexpr Field outflow_card[] = {
    curve_field("LOU"),
    unused("TEXT"),
    unused("A"),
    unused("B"),
    unused("MW"),
    unused("GASC"),
    only("HCONV", {0}, "no heat goes through the fabric"),
};

constexpr std::string_view no_tank = "the inflow is given, and does not follow from a test with a tank";

constexpr Field wang_nefske_card_1[] = {
    real("CV", 0, above_zero),  real("CP", 0, above_zero),  real("T", 0, not_negative),
    curve_field("LCT"),         curve_field("LCMT"),        only("TVOL", {0}, no_tank),
    only("LCDT", {0}, no_tank), only("IABT", {0}, no_tank),
};

constexpr std::string_view constant_vents = "coefficients and areas of orifices and fabric are constant";

constexpr Field wang_nefske_card_2[] = {
    real("C23", 0, not_negative),  only("LCC23", {0}, constant_vents),
    real("A23", 0, not_negative),  only("LCA23", {0}, constant_vents),
    real("CP23", 0, not_negative), only("LCCP23", {0}, constant_vents),
    real("AP23", 0, not_negative), only("LCAP23", {0}, constant_vents),
};

constexpr Field wang_nefske_card_3[] = {
    real("PE", 0, above_zero),
    real("RO", 0, above_zero),
    only("GC", {1, 0}, "units are consistent: a unit of force accelerates one of mass by one"),
    only("LCEFR", {0}, "the outflow is that of the orifices"),
    only("POVER", {0}, "the pressure at time zero is the ambient one"),
    real("PPOP", 0, not_negative),
    only("OPT", {0, 1, 7},
         "0 takes CP23 times AP23, 1 the orifices of *MAT_FABRIC and 7 its curve of velocity; fabric that is "
         "covered by contact is not looked for, nor are other formulas there"),
    only("KNKDN", {0}, "the inflow goes on whatever the pressure is"),
};

RawControlVolume take_surface(Cards& cards) {
  const Heading heading = cards.heading();
  const Card card = cards.next(surface_card);
  RawControlVolume raw;
  raw.volume.id = heading.id;
  raw.volume.title = heading.title;
  raw.volume.volume_scale = card.real("VSCA");
  raw.volume.pressure_scale = card.real("PSCA");
  raw.set = card.good("SID") ? card.integer("SID") : 0;
  raw.is_parts = card.real("SIDTYP") != 0;
  raw.where = card.where();
  return raw;
}

void check_heats(const Card& card, Report& report) {
  if (card.good("CP") && card.good("CV") && !(card.real("CP") > card.real("CV")))
    report.field_error(card.where(), {"CP", std::string(card.text("CP")), "a number above CV",
                                      "their difference is the gas constant", "cp"});
}

}  // namespace

void read_airbag_simple_pressure_volume(Cards& cards, RawDeck& deck) {
  RawControlVolume raw = take_surface(cards);
  const Card card = cards.next(pressure_volume_card);
  raw.volume.filling = model::PressureOfVolume{.coefficient = card.real("CN") * card.real("BETA")};
  raw.curves[0] = card.integer("LCID");
  raw.gas_where = raw.more_where = card.where();
  deck.control_volumes.push_back(raw);
}

void read_airbag_adiabatic_gas_model(Cards& cards, RawDeck& deck) {
  RawControlVolume raw = take_surface(cards);
  const Card card = cards.next(adiabatic_card);
  raw.gas_where = raw.more_where = card.where();
  if (card.good("GAMMA") && !(card.real("GAMMA") > 1))
    cards.report().field_error(card.where(), {"GAMMA", std::string(card.text("GAMMA")), "a number above 1",
                                              "it is the ratio of the specific heats, 1.4 for air", "gamma"});
  if (card.good("P0") && card.good("PE") && card.real("P0") + card.real("PE") < 0)
    cards.report().field_error(
        card.where(), {"P0", std::string(card.text("P0")), "-PE or more",
                       "it is above the ambient pressure PE, and no absolute pressure is negative", "p0"});
  raw.volume.filling = model::AdiabaticGas{.scale = card.real("PSF"),
                                           .exponent = card.real("GAMMA"),
                                           .pressure = card.real("P0"),
                                           .ambient = card.real("PE"),
                                           .density = card.real("RO")};
  deck.control_volumes.push_back(raw);
}

void read_airbag_linear_fluid(Cards& cards, RawDeck& deck) {
  RawControlVolume raw = take_surface(cards);
  const Card card = cards.next(fluid_card);
  const Card limit = cards.next_or_default(fluid_limit_card);
  raw.gas_where = card.where();
  raw.more_where = limit.where();
  raw.volume.filling = model::LinearFluid{
      .bulk_modulus = card.real("BULK"), .density = card.real("RO"), .limit = limit.real("P_LIMIT")};
  raw.curves = {card.integer("LCINT"), card.integer("LCOUTT"), card.integer("LCOUTP"),
                card.integer("LCFIT"), card.integer("LCBULK"), limit.integer("P_LIMLC")};
  if (card.good("BULK") && card.real("BULK") == 0 && raw.curves[4] == 0)
    cards.report().field_error(card.where(), {"BULK", std::string(card.text("BULK")), "a number above zero",
                                              "or give a curve of it with LCBULK", "bulk"});
  deck.control_volumes.push_back(raw);
}

void read_airbag_simple_airbag_model(Cards& cards, RawDeck& deck) {
  RawControlVolume raw = take_surface(cards);
  const Card card = cards.next(inflated_card);
  const Card outflow = cards.next_or_default(outflow_card);
  raw.gas_where = card.where();
  raw.more_where = outflow.where();
  check_heats(card, cards.report());
  raw.volume.filling = model::InflatedGas{.heat_at_volume = card.real("CV"),
                                          .heat_at_pressure = card.real("CP"),
                                          .temperature = card.real("T"),
                                          .vent = card.real("MU") * card.real("AREA"),
                                          .ambient = card.real("PE"),
                                          .density = card.real("RO")};
  raw.curves[0] = card.integer("LCID");
  raw.curves[1] = outflow.integer("LOU");
  deck.control_volumes.push_back(raw);
}

void read_airbag_wang_nefske(Cards& cards, RawDeck& deck) {
  RawControlVolume raw = take_surface(cards);
  const Card card = cards.next(wang_nefske_card_1);
  const Card vents = cards.next(wang_nefske_card_2);
  const Card around = cards.next(wang_nefske_card_3);
  raw.gas_where = raw.more_where = card.where();
  check_heats(card, cards.report());
  raw.volume.filling =
      model::InflatedGas{.heat_at_volume = card.real("CV"),
                         .heat_at_pressure = card.real("CP"),
                         .temperature = card.real("T"),
                         // OPT puts the fabric of the materials in the place of CP23 and AP23.
                         .vent = vents.real("C23") * vents.real("A23") +
                                 (around.real("OPT") == 0 ? vents.real("CP23") * vents.real("AP23") : 0),
                         .opening_pressure = around.real("PPOP"),
                         .ambient = around.real("PE"),
                         .density = around.real("RO")};
  raw.vents_fabric = true;
  raw.fabric_venting = static_cast<int>(around.real("OPT"));
  raw.curves[0] = card.integer("LCMT");
  raw.curves[2] = card.integer("LCT");
  deck.control_volumes.push_back(raw);
}

}  // namespace crumple::deck
