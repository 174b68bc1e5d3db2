// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/format/cards.hpp"

namespace crumple::deck {

/// What the id of a side is: a part where the type is 3, else a set.
inline IdKind kind_of_first_side(const Card& card) {
  return card.real("SSTYP") == 3 ? IdKind::Part : IdKind::Set;
}
inline IdKind kind_of_second_side(const Card& card) {
  return card.real("MSTYP") == 3 ? IdKind::Part : IdKind::Set;
}

/// Reads over the cards that _MPP puts before card 1 of a *CONTACT, if the keyword has it. They are about
/// LS-DYNA's search.
void skip_mpp_cards(Cards& cards);

}  // namespace crumple::deck
