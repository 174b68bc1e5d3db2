// SPDX-License-Identifier: BSD-3-Clause
// What --allow-unsupported leaves out, and the guess of the units.
#include <algorithm>

#include "small_deck.hpp"

namespace crumple::deck::test::unsupported_test {
namespace {

TEST(Unsupported, LeftOutOnlyWhereTheUserAllowsIt) {
  SmallDeck deck;
  deck.more = "*LOAD_THERMAL_CONSTANT\n1,0\n300\n*CONTROL_SHELL\n20,0,-1,0,2,7\n";
  EXPECT_FALSE(read_deck_text(deck.text()).model);
  ReadOptions options;
  options.allow_unsupported = true;
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_FALSE(result.model->control.thickness_change);
  EXPECT_EQ(result.ignored_keywords.at(0).why, Omission::OnRequest);
  EXPECT_EQ(std::count_if(result.diagnostics.begin(), result.diagnostics.end(),
                          [](const Diagnostic& d) { return d.severity == Severity::Warning; }),
            2);
}

TEST(Unsupported, CasesAreSaidToBeReadTogether) {
  SmallDeck deck;
  deck.more = "*CASE\n1\n*CASE_BEGIN_1\n*CASE_END_1\n";
  ReadOptions options;
  options.allow_unsupported = true;
  for (const std::string& message : messages_in(deck, options))
    EXPECT_NE(
        message.find("this keyword is not supported, and is left out; without it, the cards of all cases "
                     "are read together"),
        std::string::npos)
        << message;
  EXPECT_EQ(messages_in(deck, options).size(), 3U);
  EXPECT_FALSE(read_deck_text(deck.text()).model.has_value());
}

TEST(Unsupported, PartsOfUnsupportedMaterialsAreLeftOutWithTheirShells) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\n2,1,2\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.more = "*MAT_WOOD\n2,7.83E-6,207,0.3\n";
  EXPECT_FALSE(read_deck_text(deck.text()).model);
  ReadOptions options;
  options.allow_unsupported = true;
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_EQ(result.model->shells.size(), 1U);
  EXPECT_EQ(result.model->parts.size(), 1U);
}

/// Histories of what is left out point to the reason instead of saying that there is no such element.
TEST(Unsupported, WhatNamesAnElementThatIsLeftOutSaysSo) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\n2,1,2\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.more = "*MAT_WOOD\n2,7.83E-6,207,0.3\n*DATABASE_HISTORY_SHELL\n11,12\n";
  const std::string refused = listed(read_deck_text(deck.text()).diagnostics);
  EXPECT_EQ(refused.find("DATABASE_HISTORY_SHELL"), std::string::npos) << refused;
  ReadOptions options;
  options.allow_unsupported = true;
  const ReadResult result = read_deck_text(deck.text(), options);
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_EQ(result.model->output.history_shells, (std::vector<Index>{0}));
  EXPECT_NE(listed(result.diagnostics).find("shell 12 is left out, see the message at it or at its part"),
            std::string::npos)
      << listed(result.diagnostics);
  deck.more = "*DATABASE_HISTORY_SHELL\n13\n";
  EXPECT_NE(listed(read_deck_text(deck.text()).diagnostics).find("the deck has no shell 13"),
            std::string::npos);
}

TEST(Units, GuessedFromSteel) {
  const auto units = [](const std::string& density, const std::string& modulus) {
    SmallDeck deck;
    deck.material = "*MAT_ELASTIC\n1," + density + "," + modulus + ",0.3\n";
    return read_deck_text(deck.text()).unit_system;
  };
  EXPECT_EQ(units("7.83E-6", "207"), "kg, mm, ms");
  EXPECT_EQ(units("7.83E-9", "2.07E5"), "t, mm, s");
  EXPECT_EQ(units("7.83E-3", "2.07E5"), "g, mm, ms");
  EXPECT_EQ(units("7830", "2.07E11"), "kg, m, s");
  EXPECT_EQ(units("2700", "7.0E10"), "kg, m, s");
  EXPECT_EQ(units("1.0", "1.0"), "");
}

}  // namespace
}  // namespace crumple::deck::test::unsupported_test
