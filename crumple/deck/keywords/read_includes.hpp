// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <vector>

#include "deck/format/cards.hpp"
#include "deck/format/raw_deck.hpp"
#include "deck/format/scanner.hpp"

namespace crumple::deck {

/// Reads *INCLUDE_TRANSFORM. What the ids and coordinates of each file become goes behind `placements`, which
/// outlive the scanner; the transformations must be in the deck already.
std::vector<Inclusion> read_include_transform(Cards& cards, const RawDeck& deck,
                                              std::deque<Placement>& placements);

}  // namespace crumple::deck
