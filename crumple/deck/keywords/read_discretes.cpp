// SPDX-License-Identifier: BSD-3-Clause
// *ELEMENT_DISCRETE, *ELEMENT_INERTIA, *SECTION_DISCRETE, *DEFINE_SD_ORIENTATION, *MAT_SPRING_, *MAT_DAMPER_.
#include <cmath>

#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field element_card[] = {
    sized(8, id("EID")),
    sized(8, id("PID")),
    sized(8, id("N1")),
    sized(8, reference("N2")),   // zero: held
    sized(8, reference("VID")),  // zero: from N1 to N2
    sized(16, real_or_default("S", 1)),
    sized(8, unused("PF")),  // of LS-DYNA's listings
    sized(16, length(real("OFFSET"))),
};

constexpr Field inertia_card[] = {
    sized(8, id("EID")),
    sized(8, id("NID")),
    sized(8, only("CSID", {0}, "the inertia is the same about all axes")),
};

constexpr std::string_view no_products = "only the same inertia about all axes is supported";

constexpr Field inertia_second_card[] = {
    real("IXX", 0, not_negative),  only("IXY", {0}, no_products), only("IXZ", {0}, no_products),
    real("IYY", 0, not_negative),  only("IYZ", {0}, no_products), real("IZZ", 0, not_negative),
    real("MASS", 0, not_negative),
};

constexpr Field section_card[] = {
    id("SECID"),
    only("DRO", {0, 1}, "0 is a force along the axis, 1 a moment about it"),
    only("KD", {0}, "stiffness by the speed is not supported; use LCR of *MAT_SPRING_NONLINEAR_ELASTIC"),
    unused("V0"),  // with KD
    only("CL", {0}, "a clearance is not supported; put it into the curve of *MAT_SPRING_NONLINEAR_ELASTIC"),
    only("FD", {0}, "failure is not supported"),
};

constexpr std::string_view no_limit =
    "limits of the deformation are not supported; put them into the curve of *MAT_SPRING_NONLINEAR_ELASTIC";

constexpr Field section_second_card[] = {only("CDL", {0}, no_limit), only("TDL", {0}, no_limit)};

constexpr Field orientation_card[] = {
    id("VID"),
    only("IOP", {0}, "0 is a fixed vector; those that move with nodes or are projected are not supported"),
    direction(real("XT")),
    direction(real("YT")),
    direction(real("ZT")),
    unused("NID1"),  // of IOP 2 and 3
    unused("NID2"),
};

constexpr Field spring_card[] = {id("MID"), real("K", 0, above_zero)};
constexpr Field damper_card[] = {id("MID"), real("DC", 0, above_zero)};
constexpr Field elastoplastic_card[] = {id("MID"), real("K", 0, above_zero), real("KT", 0, not_negative),
                                        real("FY", 0, above_zero)};
constexpr Field nonlinear_card[] = {id("MID"), id("LCD"), reference("LCR")};
constexpr Field nonlinear_damper_card[] = {id("MID"), id("LCDR")};
constexpr Field maxwell_card[] = {
    id("MID"),
    real("K0", 0, above_zero),
    real("KI", 0, not_negative),
    real("BETA", 0, not_negative),
    real_or_default("TC", 1e20, above_zero),
    real("FC"),
    only("COPT", {0}, "the stiffness relaxes from the deformation on, not by the time of the run"),
};
constexpr Field inelastic_card[] = {
    id("MID"),
    id("LCFD", IdKind::Function),
    real("KU", 0, not_negative),
    only("CTF", {0, -1, 1}, "-1 bears tension alone, 1 and 0 compression alone"),
};

/// Reads the cards of a material of one card each; `make` takes the law from it.
template <class Make>
void read_springs(Cards& cards, RawDeck& deck, Layout layout, const Make& make) {
  while (cards.more()) {
    RawSpringMaterial raw;
    raw.material.title = cards.heading().title;
    const Card card = cards.next(layout);
    raw.material.id = card.integer("MID");
    raw.where = card.where();
    make(card, raw);
    if (card.good("MID")) deck.spring_materials.push_back(std::move(raw));
  }
}

}  // namespace

void read_element_discrete(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(element_card);
    if (!card.good("EID") || !card.good("PID") || !card.good("N1") || !card.good("N2")) continue;
    RawDiscrete discrete;
    discrete.id = card.integer("EID");
    discrete.part = card.integer("PID");
    discrete.node = {card.integer("N1"), card.integer("N2")};
    discrete.orientation = card.good("VID") ? card.integer("VID") : 0;
    discrete.scale = card.real("S");
    discrete.offset = card.real("OFFSET");
    discrete.where = card.where();
    deck.discretes.push_back(discrete);
  }
}

void read_element_inertia(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Card card = cards.next_filled(inertia_card);
    const Card second = cards.next(inertia_second_card);
    if (!card.good("EID") || !card.good("NID")) continue;
    const double inertia = second.real("IXX");
    if (second.real("IYY") != inertia || second.real("IZZ") != inertia)
      cards.report().field_unsupported(
          second.where(), {"IYY", std::string(second.text("IYY")), "IXX, IYY and IZZ that are the same",
                           "nodes have one rotary inertia about all axes; IXX is taken", "value"});
    deck.masses.push_back(
        {card.integer("EID"), card.integer("NID"), false, second.real("MASS"), card.where(), inertia});
  }
}

void read_section_discrete(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    RawDiscreteSection raw;
    raw.section.title = cards.heading().title;
    const Card card = cards.next(section_card);
    cards.next_or_default(section_second_card);
    raw.section.id = card.integer("SECID");
    raw.section.torsional = card.real("DRO") == 1;
    raw.where = card.where();
    raw.order = deck.section_count();
    if (card.good("SECID")) deck.discrete_sections.push_back(std::move(raw));
  }
}

void read_define_sd_orientation(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    cards.heading();
    const Card card = cards.next(orientation_card);
    RawOrientation raw;
    raw.id = card.integer("VID");
    raw.vector = {card.real("XT"), card.real("YT"), card.real("ZT")};
    raw.where = card.where();
    const double length = std::hypot(raw.vector[0], raw.vector[1], raw.vector[2]);
    if (card.good("XT") && card.good("YT") && card.good("ZT") && card.good("IOP") && !(length > 0))
      cards.report().field_error(card.where(),
                                 {"XT", std::string(card.text("XT")), "a vector that is not zero",
                                  "springs act along XT, YT, ZT", "vector"});
    for (double& component : raw.vector) component /= length > 0 ? length : 1.0;
    if (card.good("VID")) deck.orientations.push_back(raw);
  }
}

void read_mat_spring_elastic(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, spring_card, [](const Card& card, RawSpringMaterial& raw) {
    raw.material.law = model::LinearSpring{card.real("K")};
  });
}

void read_mat_damper_viscous(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, damper_card, [](const Card& card, RawSpringMaterial& raw) {
    raw.material.law = model::LinearDamper{card.real("DC")};
  });
}

void read_mat_spring_elastoplastic(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, elastoplastic_card, [&](const Card& card, RawSpringMaterial& raw) {
    raw.material.law = model::ElastoplasticSpring{card.real("K"), card.real("KT"), card.real("FY")};
    if (card.good("KT") && card.good("K") && card.real("KT") >= card.real("K"))
      cards.report().field_error(card.where(),
                                 {"KT", std::string(card.text("KT")), "a number below K",
                                  "it is the slope of force over deformation behind yield", "tangent"});
  });
}

void read_mat_spring_nonlinear_elastic(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, nonlinear_card, [](const Card& card, RawSpringMaterial& raw) {
    raw.material.law = model::NonlinearSpring{};
    raw.curve = card.good("LCD") ? card.integer("LCD") : 0;
    raw.rate_curve = card.good("LCR") ? card.integer("LCR") : 0;
    raw.curve_field = "LCD";
    raw.rate_field = "LCR";
  });
}

void read_mat_damper_nonlinear_viscous(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, nonlinear_damper_card, [](const Card& card, RawSpringMaterial& raw) {
    raw.material.law = model::NonlinearDamper{};
    raw.curve = card.good("LCDR") ? card.integer("LCDR") : 0;
    raw.curve_field = "LCDR";
  });
}

void read_mat_spring_maxwell(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, maxwell_card, [&](const Card& card, RawSpringMaterial& raw) {
    raw.material.law = model::MaxwellSpring{.stiffness = card.real("K0"),
                                            .final_stiffness = card.real("KI"),
                                            .decay = card.real("BETA"),
                                            .cut_off = card.real("TC"),
                                            .cut_off_force = card.real("FC")};
    if (card.good("K0") && card.good("KI") && card.real("KI") > card.real("K0"))
      cards.report().field_error(card.where(), {"KI", std::string(card.text("KI")), "a number not above K0",
                                                "the stiffness falls from K0 to KI", "relaxation"});
  });
}

void read_mat_spring_inelastic(Cards& cards, RawDeck& deck) {
  read_springs(cards, deck, inelastic_card, [](const Card& card, RawSpringMaterial& raw) {
    raw.material.law =
        model::InelasticSpring{.unloading_stiffness = card.real("KU"), .tension = card.real("CTF") < 0};
    raw.curve = card.good("LCFD") ? card.integer("LCFD") : 0;
    raw.curve_field = "LCFD";
  });
}

}  // namespace crumple::deck
