// SPDX-License-Identifier: BSD-3-Clause
// A curve without points is reported where it stands, whatever refers to it.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "deck/keywords/keyword_cards.hpp"
#include "deck/small_deck.hpp"

namespace crumple::deck::empty_curves_test {
namespace {

using namespace crumple::deck::test;

constexpr UserId curve = 9;

/// What is written in the fields that do not name a curve.
enum class Filling { Defaults, Ones, Small };

bool may_name_curve(const Field& field) {
  return field.kind == IdKind::Function || field.choose != nullptr;
}

/// A value that the check of a field accepts.
std::string value_of(const Field& field, Filling filling, int sign) {
  if (may_name_curve(field)) return std::to_string(field.type == FieldType::Real ? -curve : sign * curve);
  if (field.is_id()) return "1";
  if (field.type == FieldType::Text) return "x";
  if (field.check.kind == Check::Kind::Only || field.check.kind == Check::Kind::Harmless)
    return fmt::format("{}", field.check.values[0]);
  const bool is_free = field.check.kind == Check::Kind::None ||
                       field.check.kind == Check::Kind::NotNegative ||
                       field.check.kind == Check::Kind::AboveZero;
  if (!is_free)
    return fmt::format(
        "{}", field.fallback != 0 ? field.fallback : 0.5 * (field.check.values[0] + field.check.values[1]));
  if (filling == Filling::Defaults && field.check.kind != Check::Kind::AboveZero)
    return fmt::format("{}", field.fallback);
  return filling == Filling::Small && field.type == FieldType::Real ? "0.3" : "1";
}

/// A keyword with all its cards, of forms of one card the one for `last`.
std::string text_of(const Keyword& keyword, Filling filling, int sign, bool last) {
  std::string text = fmt::format("*{}\n", keyword.name);
  const KeywordForm form = cards_of(keyword);
  for (std::size_t i = 0; i < form.cards.size(); ++i) {
    const KeywordCard& card = form.cards[i];
    const std::size_t other = last ? i + 1 : i - 1;
    const bool is_form =
        card.number != 0 && other < form.cards.size() && form.cards[other].number == card.number;
    if (is_form) continue;
    if (card.fields.empty()) text += "text";
    for (const Field& field : card.fields) text += value_of(field, filling, sign) + ",";
    text += "\n";
  }
  return text;
}

bool names_curves(const Keyword& keyword) {
  const KeywordForm form = cards_of(keyword);
  return std::any_of(form.cards.begin(), form.cards.end(), [](const KeywordCard& card) {
    return std::any_of(card.fields.begin(), card.fields.end(), may_name_curve);
  });
}

bool starts(const Keyword& keyword, std::string_view beginning) {
  return keyword.name.starts_with(beginning);
}

/// The deck with this keyword, with shells or with a solid, and with curve 9.
std::string deck_with(const std::string& more, const Keyword& keyword, bool has_solid) {
  SmallDeck deck = has_solid ? CubeDeck() : SmallDeck();
  if (starts(keyword, "MAT_") && !starts(keyword, "MAT_ADD")) deck.material.clear();
  if (starts(keyword, "MAT_ADD")) deck.material = "*MAT_024\n1,1.,200.,.3,1.\n";
  if (starts(keyword, "CONTROL_TERMINATION")) deck.termination.clear();
  deck.more = "*SET_NODE_LIST\n1\n1,2,3\n*SET_PART_LIST\n1\n1\n*SET_SEGMENT\n1\n1,2,3,4\n" + more +
              fmt::format("*DEFINE_CURVE\n{}\n", curve);
  return deck.text();
}

/// What is said of the empty curve with this keyword, in all its fillings.
void expect_report(const Keyword& keyword) {
  for (const Filling filling : {Filling::Defaults, Filling::Ones, Filling::Small})
    for (const int sign : {1, -1})
      for (const bool last : {false, true})
        for (const bool has_solid : {false, true}) {
          const std::string text = deck_with(text_of(keyword, filling, sign, last), keyword, has_solid);
          const std::string messages = listed(read_deck_text(text).diagnostics);
          EXPECT_NE(messages.find("*DEFINE_CURVE card 1: the curve has 0 points, expected at least two"),
                    std::string::npos)
              << text << messages;
        }
}

/// One test and not one per keyword: finding their cards takes longer than most tests, and a parameter of the
/// test would be found again at each start of the program.
TEST(EmptyCurves, AreReportedAndNotUsed) {
  int tried = 0;
  for (const Keyword& keyword : keyword_table()) {
    if (!names_curves(keyword)) continue;
    expect_report(keyword);
    ++tried;
  }
  EXPECT_GE(tried, 80);
}

/// LCSR of *MAT_024: the case that was found.
TEST(EmptyCurves, OfRatesGiveOneMessage) {
  SmallDeck deck;
  deck.material = "*MAT_024\n1,7.85e-9,2.e5,.3,200.\n0,0,0,9\n";
  deck.more = "*DEFINE_CURVE\n9\n$ 0,1.\n";
  expect_one(deck, "*DEFINE_CURVE card 1: the curve has 0 points, expected at least two");
}

/// The curve on a single point has no slope either.
TEST(EmptyCurves, OfOnePointGiveOneMessage) {
  SmallDeck deck;
  deck.material = "*MAT_024\n1,7.85e-9,2.e5,.3,200.\n0,0,9\n";
  deck.more = "*DEFINE_CURVE\n9\n0,200.\n";
  expect_one(deck, "*DEFINE_CURVE card 1: the curve has 1 point, expected at least two");
}

}  // namespace
}  // namespace crumple::deck::empty_curves_test
