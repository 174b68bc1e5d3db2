// SPDX-License-Identifier: BSD-3-Clause
// Beams inside solids.
#include "deck/small_deck.hpp"

namespace crumple::deck::test::embedded_beams_test {
namespace {

/// A cube with a bar of two trusses in it, and sets 7 of both parts.
std::string deck_with(const std::string& coupling) {
  CubeDeck deck;
  deck.nodes +=
      "       9             0.2             0.5             0.5\n"
      "      10             0.5             0.5             0.5\n"
      "      11             0.8             0.5             0.5\n";
  deck.more =
      "*ELEMENT_BEAM\n      31       2       9      10\n      32       2      10      11\n"
      "*SECTION_BEAM\n         2         3\n      0.01\n"
      "*PART\nbars\n         2         2         1\n"
      "*SET_PART_LIST\n         7\n         1\n*SET_PART_LIST\n         8\n         2\n" +
      coupling;
  return deck.text();
}

TEST(EmbeddedBeams, OfPartsAndSets) {
  const model::Model parts = read_clean(deck_with("*CONSTRAINED_BEAM_IN_SOLID\n2,1,1,1\n"));
  ASSERT_EQ(parts.embedded_beams.size(), 1U);
  const model::EmbeddedBeams& first = parts.embedded_beams[0];
  EXPECT_EQ(first.id, 1);
  EXPECT_EQ(first.beams, (std::vector<Index>{0, 1}));
  EXPECT_EQ(first.solids, (std::vector<Index>{0}));
  EXPECT_EQ(first.end_time, 1e20);
  EXPECT_FALSE(first.between_nodes);
  for (const char* const name : {"*CONSTRAINED_BEAM_IN_SOLID_ID\n", "*CONSTRAINED_BEAM_IN_SOLID_TITLE\n"}) {
    const model::Model sets =
        read_clean(deck_with(std::string(name) + "        12rebars\n8,7,0,0,,,3\n0.0,4.5\n"));
    ASSERT_EQ(sets.embedded_beams.size(), 1U);
    EXPECT_EQ(sets.embedded_beams[0].id, 12);
    EXPECT_EQ(sets.embedded_beams[0].beams.size(), 2U);
    EXPECT_EQ(sets.embedded_beams[0].end_time, 4.5);
    EXPECT_TRUE(sets.embedded_beams[0].between_nodes);
  }
}

TEST(EmbeddedBeams, LagrangeInSolid) {
  const model::Model model = read_clean(
      deck_with("*CONSTRAINED_LAGRANGE_IN_SOLID_TITLE\n         3rebars\n"
                "         2         1         1         1         0         2         1         0\n"
                "       0.0       0.0       0.1       0.0       0.5         0         0       0.0\n"
                "         0       0.0       0.0         0       0.1         0         0         0\n"));
  ASSERT_EQ(model.embedded_beams.size(), 1U);
  EXPECT_EQ(model.embedded_beams[0].id, 3);
  EXPECT_EQ(model.embedded_beams[0].end_time, 1e20);
  EXPECT_EQ(model.embedded_beams[0].beams.size(), 2U);
}

/// The one message of a deck with this coupling.
std::string message_of(const std::string& coupling, bool allow_unsupported = false) {
  ReadOptions options;
  options.allow_unsupported = allow_unsupported;
  const ReadResult result = read_deck_text(deck_with(coupling), options, {});
  std::string text;
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity != Severity::Note) text += to_string(diagnostic) + "\n";
  EXPECT_EQ(result.model.has_value(), allow_unsupported || text.find("error") == std::string::npos);
  return text;
}

void expect_message(const std::string& coupling, const std::string& text, bool allow_unsupported = false) {
  const std::string found = message_of(coupling, allow_unsupported);
  EXPECT_NE(found.find(text), std::string::npos) << found;
}

TEST(EmbeddedBeams, WhatIsNotThereIsRefused) {
  const std::string beams = "*CONSTRAINED_BEAM_IN_SOLID\n";
  expect_message(beams + "2,1,1,1,,,0,1\n", "beams do not slide in solids");
  expect_message(beams + "2,1,1,1,,,0,1\n", "beams do not slide in solids", true);
  expect_message(beams + "2,1,1,1\n0.0,0.0,,-5\n", "beams do not slip in solids");
  expect_message(beams + "2,1,1,1\n1.5\n", "from the beginning of the run on");
  expect_message(beams + "1,1,1,1\n", "part 1 has other elements, which are not put into solids");
  expect_message(beams + "2,2,1,1\n", "part 2 has other elements, which hold no beams");
  expect_message(beams + "2,9,1,1\n", "the deck has no part 9");
  expect_message(beams + "2,1,1,2\n", "0 is a part set, 1 a part");
  const std::string lagrange = "*CONSTRAINED_LAGRANGE_IN_SOLID\n";
  expect_message(lagrange + "2,1,1,1,0,4\n", "2 couples beams with Lagrangian solids");
  expect_message(lagrange + "2,1,2,1,0,2\n", "segments of a set are not coupled");
}

TEST(EmbeddedBeams, SpringsAreConstraintsWithAWarning) {
  expect_message("*CONSTRAINED_BEAM_IN_SOLID_PENALTY\n2,1,1,1\n", "move exactly with the solids");
  expect_message("*CONSTRAINED_BEAM_IN_SOLID_PENALTY_ID\n4\n2,1,1,1\n", "move exactly with the solids");
}

}  // namespace
}  // namespace crumple::deck::test::embedded_beams_test
