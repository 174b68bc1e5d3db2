// SPDX-License-Identifier: BSD-3-Clause
// *EOS_LINEAR_POLYNOMIAL, *EOS_GRUNEISEN.
#include "deck/keywords/families.hpp"

namespace crumple::deck {

namespace {

using namespace row;

constexpr Field polynomial_card[] = {
    id("EOSID"), real("C0"), real("C1"), real("C2"), real("C3"), real("C4"), real("C5"), real("C6"),
};

constexpr Field polynomial_second_card[] = {
    real("E0"),
    real_or_default("V0", 1.0, above_zero),
};

constexpr Field gruneisen_card[] = {
    id("EOSID"), real("C", 0, above_zero), real("S1"), real("S2"), real("S3"), real("GAMAO"), real("A"),
    real("E0"),
};

constexpr Field gruneisen_second_card[] = {
    real_or_default("V0", 1.0, above_zero),
    unused("-"),
    only("LCID", {0}, "energy cannot be deposited over time"),
};

RawEquationOfState equation_of(const Heading& heading, const Card& card) {
  RawEquationOfState raw;
  raw.equation.id = card.integer("EOSID");
  raw.equation.title = heading.title;
  raw.where = card.where();
  return raw;
}

}  // namespace

void read_eos_linear_polynomial(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(polynomial_card);
    const Card second = cards.next_or_default(polynomial_second_card);
    RawEquationOfState raw = equation_of(heading, card);
    raw.equation.law =
        model::LinearPolynomial{{card.real("C0"), card.real("C1"), card.real("C2"), card.real("C3"),
                                 card.real("C4"), card.real("C5"), card.real("C6")}};
    raw.equation.initial_energy = second.real("E0");
    raw.equation.initial_volume = second.real("V0");
    if (card.good("EOSID")) deck.equations_of_state.push_back(std::move(raw));
  }
}

void read_eos_gruneisen(Cards& cards, RawDeck& deck) {
  while (cards.more()) {
    const Heading heading = cards.heading();
    const Card card = cards.next(gruneisen_card);
    const Card second = cards.next_or_default(gruneisen_second_card);
    RawEquationOfState raw = equation_of(heading, card);
    raw.equation.law = model::Gruneisen{card.real("C"),
                                        {card.real("S1"), card.real("S2"), card.real("S3")},
                                        card.real("GAMAO"),
                                        card.real("A")};
    raw.equation.initial_energy = card.real("E0");
    raw.equation.initial_volume = second.real("V0");
    if (card.good("EOSID")) deck.equations_of_state.push_back(std::move(raw));
  }
}

}  // namespace crumple::deck
