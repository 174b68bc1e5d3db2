// SPDX-License-Identifier: BSD-3-Clause
// What the deck reader says of its own keywords is what it reads.
#include "deck/keywords/keyword_cards.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace crumple::deck::keyword_cards_test {
namespace {

KeywordForm form_of(std::string_view name) {
  const auto found = find_keyword(name);
  return found ? cards_of(*found->keyword) : KeywordForm{};
}

std::string names_of(const KeywordCard& card) {
  std::string names;
  for (const Field& field : card.fields) names += std::string(field.name) + " ";
  return names;
}

TEST(KeywordCards, OneCardOfEachItem) {
  const KeywordForm form = form_of("MAT_ELASTIC");
  ASSERT_EQ(form.cards.size(), 1U);
  EXPECT_TRUE(form.repeats);
  EXPECT_EQ(names_of(form.cards[0]), "MID RO E PR DA DB K ");
  EXPECT_EQ(form.cards[0].number, 1);
  EXPECT_FALSE(form.cards[0].optional);
}

TEST(KeywordCards, LinesOfTextHaveNoNumber) {
  const KeywordForm form = form_of("PART");
  ASSERT_EQ(form.cards.size(), 2U);
  EXPECT_EQ(form.cards[0].number, 0);
  EXPECT_EQ(form.cards[0].text, "the title of a part");
  EXPECT_EQ(form.cards[1].number, 1);
}

TEST(KeywordCards, ListsRepeatTheirLastCard) {
  const KeywordForm form = form_of("DEFINE_CURVE");
  ASSERT_EQ(form.cards.size(), 2U);
  EXPECT_FALSE(form.repeats);
  EXPECT_FALSE(form.cards[0].repeats);
  EXPECT_TRUE(form.cards[1].repeats);
}

TEST(KeywordCards, FormsOfACardShareItsNumber) {
  const KeywordForm form = form_of("SECTION_BEAM");
  ASSERT_EQ(form.cards.size(), 6U);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(form.cards[i].number, 2) << i;
}

TEST(KeywordCards, OptionalCardsMayBeLeftOut) {
  const KeywordForm form = form_of("CONTACT_AUTOMATIC_SINGLE_SURFACE");
  ASSERT_EQ(form.cards.size(), 9U);
  for (const KeywordCard& card : form.cards) EXPECT_EQ(card.optional, card.number > 3) << card.number;
}

TEST(KeywordCards, OptionsOfTheNameCount) {
  EXPECT_EQ(form_of("RIGIDWALL_PLANAR").cards.size(), 2U);
  EXPECT_EQ(form_of("RIGIDWALL_PLANAR_FINITE").cards.size(), 3U);
  EXPECT_EQ(form_of("RIGIDWALL_PLANAR_FINITE_MOVING").cards.size(), 4U);
}

TEST(KeywordCards, EveryKeywordHasSome) {
  for (const Keyword& keyword : keyword_table())
    EXPECT_FALSE(cards_of(keyword).cards.empty()) << keyword.name;
}

}  // namespace
}  // namespace crumple::deck::keyword_cards_test
