// SPDX-License-Identifier: BSD-3-Clause
// One mistake is one message: what follows a card out of its place is read again as it was meant.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::resynchronise_test {
namespace {

std::vector<std::string> errors_of(const SmallDeck& deck) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity == Severity::Error) messages.push_back(to_string(diagnostic));
  return messages;
}

TEST(Resynchronise, BehindALineTooMany) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1\nsecond\na remark\n2,1,1\nthird\n3,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,3,2,5,6,3\n";
  const std::vector<std::string> errors = errors_of(deck);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("*PART card 2 field PID: read \"a remark\", expected a whole number"),
            std::string::npos)
      << errors[0];
}

TEST(Resynchronise, BehindAMissingCard) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\nsecond\n2,1,1\nthird\n3,1,1\n";
  // Part 1 is missing, but that follows from the same mistake.
  const std::vector<std::string> errors = errors_of(deck);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("read \"second\""), std::string::npos) << errors[0];
}

TEST(Resynchronise, ATitleThatIsMissing) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL_TITLE\n         1         2\n       0.1\n";
  EXPECT_EQ(errors_of(deck).size(), 1U);
}

TEST(Resynchronise, ACardWithShiftedColumnsIsOneError) {
  SmallDeck deck;
  deck.material = "*MAT_ELASTIC\n   1 7.83E-6 207.0 0.3 0.0 0.0 0.0 0.0 0.0 0.0 0.0\n";
  const std::vector<std::string> errors = errors_of(deck);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("columns"), std::string::npos) << errors[0];
}

TEST(Resynchronise, ManyOfAKindAreTwoLines) {
  SmallDeck deck;
  deck.shells.clear();
  for (int i = 1; i <= 882; ++i) deck.shells += "*ELEMENT_SHELL\n" + std::to_string(i) + ",1,1,2,3,99\n";
  const ReadResult result = read_deck_text(deck.text());
  EXPECT_EQ(error_count(result.diagnostics), 882);
  const std::vector<std::string> errors = errors_of(deck);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NE(errors[0].find("deck.k:12: error: *ELEMENT_SHELL card 1 field N4: read \"99\""),
            std::string::npos)
      << errors[0];
  EXPECT_EQ(errors[1], "deck.k:12: error: and 881 more of this kind, last at deck.k:1774");
}

TEST(Resynchronise, AParameterThatIsNotDefinedIsTwoLinesWhereverItStands) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1         2\n&thick,&thick,&thick,&thick\n";
  deck.more = "*CONTROL_TIMESTEP\n0.0,&thick\n";
  const std::vector<std::string> errors = errors_of(deck);
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_NE(errors[0].find("field T1: read \"&thick\""), std::string::npos) << errors[0];
  EXPECT_NE(errors[1].find("and 4 more of this kind"), std::string::npos) << errors[1];
}

TEST(MissingCards, AtTheEndOfAMaterialAreDefaults) {
  for (const char* material :
       {"*MAT_PLASTIC_KINEMATIC\n1,7.83E-6,207.0,0.3,0.2\n",
        "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.83E-6,207.0,0.3,0.2\n",
        "*MAT_POWER_LAW_PLASTICITY\n1,7.83E-6,207.0,0.3,0.5,0.2\n", "*MAT_RIGID\n1,7.83E-6,207.0,0.3\n"}) {
    const std::vector<std::string> messages = messages_of(material);
    EXPECT_TRUE(messages.empty()) << messages[0];
  }
}

}  // namespace
}  // namespace crumple::deck::test::resynchronise_test
