// SPDX-License-Identifier: BSD-3-Clause
// No id of any keyword is without a kind, so that *INCLUDE_TRANSFORM gives an offset to all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

#include "deck/keywords/keyword_cards.hpp"

namespace crumple::deck::id_kinds_test {
namespace {

/// Whole numbers that are no ids: counts, codes and choices. A new field of a card must be an id, or stand
/// here.
constexpr std::string_view not_ids[] = {
    "CON2",   "ICST",  "K",      "CST",    "DDOF",  "DIR",  "NDS",    "STOP",    "CYCL",   "DEPTH", "DOF",
    "DOFRX",  "DOFRY", "DOFRZ",  "DOFX",   "DOFY",  "DOFZ", "ELFORM", "ENDCYC",  "ESORT",  "INCR",  "IRCS",
    "MAXINT", "MPR",   "NEIPH",  "NCS",    "NEIPS", "NIP",  "NPLTC",  "NR",      "NUMFIP", "RC",    "SPR",
    "STYP",   "TC",    "NPLANE", "NTHICK", "NHISV", "NINT", "NSHV",   "INTFAIL",
};

bool is_listed(std::string_view name) {
  return std::find(std::begin(not_ids), std::end(not_ids), name) != std::end(not_ids);
}

/// Of the values that are read only zero goes on, which is no id, or none has an effect.
bool may_only_be_zero(const Field& field) {
  const bool one_value = field.check.kind == Check::Kind::Only || field.check.kind == Check::Kind::Harmless;
  return !field.has_effect || (one_value && field.check.count == 1 && field.check.values[0] == 0);
}

TEST(IdKinds, EveryIntegerFieldIsAnIdOrListedAsNone) {
  for (const Keyword& keyword : keyword_table())
    for (const KeywordCard& card : cards_of(keyword).cards)
      for (const Field& field : card.fields)
        if (field.type == FieldType::Integer) {
          EXPECT_NE(field.is_id(), is_listed(field.name)) << keyword.name << " " << field.name;
        }
}

TEST(IdKinds, EveryFieldWithTheNameOfAnIdIsOne) {
  for (const Keyword& keyword : keyword_table())
    for (const KeywordCard& card : cards_of(keyword).cards)
      for (const Field& field : card.fields)
        if (kind_of_name(field.name) != IdKind::None && field.type == FieldType::Integer) {
          EXPECT_TRUE(field.is_id() || may_only_be_zero(field)) << keyword.name << " " << field.name;
        }
}

TEST(IdKinds, ANameThatIsListedIsOneOfAField) {
  for (const std::string_view name : not_ids) {
    bool found = false;
    for (const Keyword& keyword : keyword_table())
      for (const KeywordCard& card : cards_of(keyword).cards)
        found = found || std::any_of(card.fields.begin(), card.fields.end(), [&](const Field& field) {
                  return field.name == name && field.type == FieldType::Integer && !field.is_id();
                });
    EXPECT_TRUE(found) << name;
  }
}

/// Points and directions are three fields one behind the other.
TEST(IdKinds, VectorsOfCardsAreComplete) {
  for (const Keyword& keyword : keyword_table())
    for (const KeywordCard& card : cards_of(keyword).cards)
      for (std::size_t i = 0; i < card.fields.size();) {
        const Geometry geometry = card.fields[i].geometry;
        const bool is_vector = geometry == Geometry::Point || geometry == Geometry::Direction ||
                               geometry == Geometry::Velocity || geometry == Geometry::Spin;
        if (!is_vector) {
          ++i;
          continue;
        }
        for (std::size_t j = 0; j < 3; ++j, ++i)
          EXPECT_TRUE(i < card.fields.size() && card.fields[i].geometry == geometry)
              << keyword.name << " " << card.fields[i - j].name;
      }
}

}  // namespace
}  // namespace crumple::deck::id_kinds_test
