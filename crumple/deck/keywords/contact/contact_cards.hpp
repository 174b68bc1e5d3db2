// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/format/cards.hpp"

namespace crumple::deck {

/// Reads over the cards that _MPP puts before card 1 of a *CONTACT, if the keyword has it. They are about
/// LS-DYNA's search.
void skip_mpp_cards(Cards& cards);

}  // namespace crumple::deck
