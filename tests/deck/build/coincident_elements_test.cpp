// SPDX-License-Identifier: BSD-3-Clause
// Elements that have the same nodes under two ids.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test {
namespace {

constexpr const char* second_part = "*PART\nskin\n         2         1         1\n";

TEST(CoincidentElements, ShellsOfOnePartAreNamedWithTheirPlace) {
  SmallDeck deck;
  deck.shells += "      13       1       6       3       2       5\n";
  expect_one(deck,
             "shell 13 of part 1 has the nodes of shell 12 at deck.k:13: mass and stiffness of both count; "
             "remove one of them");
}

TEST(CoincidentElements, LayersOfTwoPartsAreNotCalledAFault) {
  SmallDeck deck;
  deck.shells += "      13       2       1       2       3       4\n";
  deck.more = second_part;
  expect_one(
      deck,
      "shell 13 of part 2 has the nodes of shell 11 of part 1 at deck.k:12: mass and stiffness of both "
      "count, as of two layers");
}

TEST(CoincidentElements, TrianglesAreFoundWhicheverNodeTheyRepeat) {
  SmallDeck deck;
  deck.shells +=
      "      13       1       2       5       6       6\n      14       1       5       6       2       2\n";
  expect_one(deck, "shell 14 of part 1 has the nodes of shell 13");
}

TEST(CoincidentElements, ManyAreCounted) {
  SmallDeck deck;
  for (int id = 13; id < 43; ++id)
    deck.shells += "      " + std::to_string(id) + "       1       1       2       3       4\n";
  const std::vector<std::string> found = messages_in(deck);
  ASSERT_EQ(found.size(), 2U) << testing::PrintToString(found);
  EXPECT_NE(found[0].find("shell 13 of part 1 has the nodes of shell 11"), std::string::npos) << found[0];
  EXPECT_NE(found[1].find("and 29 more of this kind"), std::string::npos) << found[1];
}

TEST(CoincidentElements, SolidsAndBeamsAreLookedAtAsWell) {
  CubeDeck deck;
  deck.shells += "      22       1       2       3       4       1       6       7       8       5\n";
  expect_one(deck, "solid 22 of part 1 has the nodes of solid 21");
  SmallDeck beams;
  beams.more =
      "*PART\nbar\n         3         3         1\n*SECTION_BEAM\n         3         3\n      0.01\n"
      "*ELEMENT_BEAM\n      31       3       1       2\n      32       3       2       1\n";
  expect_one(beams, "beam 32 of part 3 has the nodes of beam 31");
}

TEST(CoincidentElements, SpringsSideBySideAndShellsOnSolidsAreMeant) {
  CubeDeck deck;
  deck.more =
      "*PART\nskin\n         2         2         1\n*SECTION_SHELL\n         2         2\n       0.1\n"
      "*ELEMENT_SHELL\n      11       2       1       2       3       4\n"
      "*PART\nspring\n         3         3         3\n*PART\nother spring\n         4         3         3\n"
      "*SECTION_DISCRETE\n         3         0\n         0\n*MAT_SPRING_ELASTIC\n         3       1.0\n"
      "*ELEMENT_DISCRETE\n      31       3       1       2\n      32       3       1       2\n      33       "
      "4       1       2\n";
  EXPECT_TRUE(messages_in(deck).empty()) << testing::PrintToString(messages_in(deck));
}

}  // namespace
}  // namespace crumple::deck::test
