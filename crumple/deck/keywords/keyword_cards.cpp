// SPDX-License-Identifier: BSD-3-Clause
#include "deck/keywords/keyword_cards.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "deck/format/parameters.hpp"
#include "deck/format/raw_deck.hpp"

namespace crumple::deck {

namespace {

/// Small numbers choose between the forms that a keyword's cards have.
constexpr std::string_view samples[] = {"1,1,1,1,1,1,1,1", "0,0,0,0,0,0,0,0",
                                        "2,2,2,2,2,2,2,2", "3,3,3,3,3,3,3,3",
                                        "1,3,3,3,3,3,3,3", "1,1",
                                        "9,9,9,9,9,9,9,9", "1,6",
                                        "1,1,1",           "1,1,1,1,1,1,1,-1"};
/// More than any keyword has cards, so that those which repeat do.
constexpr std::size_t sample_lines = 24;

std::vector<CardUse> uses_with(const Keyword& keyword, std::string_view sample, std::size_t lines) {
  const std::string name = fmt::format("*{}", keyword.name);
  Report report(true);
  Block block;
  block.name = keyword.name;
  block.where = {name, report.add_file("sample"), 1, 0};
  block.lines.assign(lines, {sample, 2});
  const Parameters parameters;
  RawDeck deck;
  std::vector<CardUse> uses;
  Cards cards(block, HeadingKind::None, parameters, report);
  cards.note_uses(uses);
  keyword.read(cards, deck);
  return uses;
}

bool is_same(const KeywordCard& card, const CardUse& use) {
  return card.fields.data() == use.layout.data() && card.text == use.text;
}

/// Adds what one sample shows to the cards that are known.
void merge(const Keyword& keyword, std::string_view sample, KeywordForm& form) {
  const std::vector<CardUse> uses = uses_with(keyword, sample, sample_lines);
  std::size_t place = 0;
  int number = 0;
  for (const CardUse& use : uses) {
    const bool is_first = &use != uses.data() && use.layout.data() == uses.front().layout.data() &&
                          use.text == uses.front().text;
    if (is_first) {
      form.repeats = true;
      place = 0;
      number = 0;
    }
    if (use.text.empty()) ++number;
    const auto known = std::find_if(form.cards.begin(), form.cards.end(),
                                    [&](const KeywordCard& card) { return is_same(card, use); });
    if (known == form.cards.end()) {
      KeywordCard card{use.text.empty() ? number : 0, use.layout, use.text};
      // A reader that wants a card asks for it where no line is left, too.
      const auto before = static_cast<std::size_t>(&use - uses.data());
      card.optional = before > 0 && uses_with(keyword, sample, before).size() <= before;
      form.cards.insert(form.cards.begin() + static_cast<std::ptrdiff_t>(place), card);
      ++place;
      continue;
    }
    const auto found = static_cast<std::size_t>(known - form.cards.begin());
    if (found + 1 == place) known->repeats = true;
    place = found + 1;
  }
}

}  // namespace

KeywordForm cards_of(const Keyword& keyword) {
  KeywordForm form;
  for (const std::string_view sample : samples) merge(keyword, sample, form);
  return form;
}

}  // namespace crumple::deck
