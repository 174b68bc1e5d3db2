// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "deck/format/cards.hpp"
#include "deck/keywords/keywords.hpp"

namespace crumple::deck {

/// A card of a keyword, or a line of text.
struct KeywordCard {
  int number = 0;         ///< counted from 1; cards of the same number are forms of one; 0 is a line of text
  Layout fields;          ///< empty of a line of text
  std::string_view text;  ///< what that is for
  bool repeats = false;   ///< comes as often as the deck likes
  bool optional = false;  ///< may be left out, with all that follow
};

/// What stands below a keyword.
struct KeywordForm {
  std::vector<KeywordCard> cards;
  bool repeats = false;  ///< all of them may come again, for another item
};

/// Finds the cards of a keyword by having its reader read samples: what the deck reader itself uses, so that
/// it cannot differ from that. Cards that only come with values which no sample has are missing. Headings
/// (_TITLE, _ID) are not among them.
KeywordForm cards_of(const Keyword& keyword);

}  // namespace crumple::deck
