// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::blasts_test {
namespace {

using Burst = model::AirBlast::Burst;

/// In kg, mm, ms, a metre above the plate, with the shells as segments.
std::string charge(const std::string& unit_and_burst, const std::string& more = "\n") {
  return "*LOAD_BLAST_ENHANCED\n7,2.0,0.0,0.0,1000.0,0.5," + unit_and_burst + "\n" + more;
}

const std::string segments = "*SET_SEGMENT\n3\n1,2,3,4\n2,5,6,3\n*LOAD_BLAST_SEGMENT_SET\n7,3\n";

TEST(Blasts, DefaultsAreAFreeSphereWithSuctionInKilogramsAndMetres) {
  SmallDeck deck;
  deck.material = "*MAT_ELASTIC\n1,7830.0,2.07E11,0.3\n";
  deck.more = "*LOAD_BLAST_ENHANCED\n7,2.0,0.0,0.0,3.0\n\n*LOAD_BLAST_SEGMENT\n7,1,2,3,4\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.air_blasts.size(), 1U);
  const model::AirBlast& blast = model.air_blasts[0];
  EXPECT_EQ(blast.id, 7);
  EXPECT_EQ(blast.burst, Burst::Air);
  EXPECT_TRUE(blast.negative_phase);
  EXPECT_EQ(blast.detonation, 0);
  EXPECT_EQ(blast.death, 1e20);
  EXPECT_EQ(blast.node, no_index);
  EXPECT_NEAR(blast.units.pounds, 2.2046226, 1e-7);
  EXPECT_NEAR(blast.units.feet, 3.2808399, 1e-7);
  EXPECT_EQ(blast.units.milliseconds, 1000);
  EXPECT_NEAR(blast.units.psi, 1.4503774e-4, 1e-11);
  ASSERT_EQ(model.blast_segments.size(), 1U);
  EXPECT_EQ(model.blast_segments[0].scale, 1);
  EXPECT_EQ(model.blast_segments[0].node, (std::array<Index, 4>{0, 1, 2, 3}));
  EXPECT_EQ(model.blast_segments[0].shell, 0);
}

TEST(Blasts, FieldsOfBothCards) {
  const model::Model model =
      read_with(charge("6,1", "0,0,0,0,0,30.0,1\n") + "*LOAD_BLAST_SEGMENT\n7,1,2,3,0,0,0,0.7\n" + segments);
  ASSERT_EQ(model.air_blasts.size(), 1U);
  const model::AirBlast& blast = model.air_blasts[0];
  EXPECT_EQ(blast.burst, Burst::Surface);
  EXPECT_EQ(blast.mass, 2);
  EXPECT_EQ(blast.centre, (std::array<double, 3>{0, 0, 1000}));
  EXPECT_EQ(blast.detonation, 0.5);
  EXPECT_EQ(blast.death, 30);
  EXPECT_FALSE(blast.negative_phase);
  ASSERT_EQ(model.blast_segments.size(), 3U);
  EXPECT_EQ(model.blast_segments[0].node, (std::array<Index, 4>{0, 1, 2, 2}));
  EXPECT_EQ(model.blast_segments[0].scale, 0.7);
  EXPECT_EQ(model.blast_segments[0].shell, no_index);
  EXPECT_EQ(model.blast_segments[2].node, (std::array<Index, 4>{1, 4, 5, 2}));
  EXPECT_EQ(model.blast_segments[2].shell, 1);
}

/// A unit of stress is one of mass over length and time squared, in all but the first, as LS-DYNA has it.
TEST(Blasts, UnitsAreConsistent) {
  constexpr double pound_force = 32.17404855643045;  // lb ft/s^2
  for (const int unit : {2, 3, 4, 6, 7, 8}) {
    SmallDeck deck;
    deck.material = "*MAT_ELASTIC\n1,1.0,1.0,0.3\n";  // of no units in use
    deck.more = "*LOAD_BLAST_ENHANCED\n7,1.0,0.0,0.0,1.0,0.0," + std::to_string(unit) + "\n\n";
    const ReadResult result = read_deck_text(deck.text());
    ASSERT_TRUE(result.model) << listed(result.diagnostics);
    const model::BlastUnits& units = result.model->air_blasts.at(0).units;
    const double seconds = units.milliseconds / 1000;
    const double stress = units.pounds / (units.feet * seconds * seconds) / pound_force / 144;  // psi
    EXPECT_NEAR(units.psi / stress, 1, 1e-12) << unit;
  }
}

/// A kilogram at a metre is the same in all units.
TEST(Blasts, UnitsGiveTheSameScaledDistance) {
  struct Case {
    const char* card;
    double mass;      // of a kilogram
    double distance;  // of a metre
    double time;      // of a second
  };
  constexpr double pound = 0.45359237;
  const Case cases[] = {
      {"1", 1 / pound, 1 / 0.3048, 1}, {"2", 1, 1, 1},       {"3", 1 / 175.12683524637, 1 / 0.0254, 1},
      {"4", 1000, 100, 1e6},           {"6", 1, 1000, 1000}, {"7", 1e-3, 1000, 1},
      {"8", 1000, 1000, 1000},         {"5", 1, 1, 1e6},
  };
  for (const Case& each : cases) {
    SmallDeck deck;
    deck.material = "*MAT_ELASTIC\n1,1.0,1.0,0.3\n";
    deck.more = std::string("*LOAD_BLAST_ENHANCED\n7,1.0,0.0,0.0,1.0,0.0,") + each.card +
                "\n2.204622621848776,3.280839895013123,0.001,1.0\n";
    const ReadResult result = read_deck_text(deck.text());
    ASSERT_TRUE(result.model) << listed(result.diagnostics);
    model::AirBlast blast = result.model->air_blasts.at(0);
    blast.mass = each.mass;
    EXPECT_NEAR(model::scaled_distance(blast, each.distance), 2.520810993592768, 1e-12) << each.card;
    EXPECT_NEAR(each.time * blast.units.milliseconds, 1000, 1e-9) << each.card;
  }
}

TEST(Blasts, AChargeAtANodeIsWhereThatIs) {
  const model::Model model = read_with("*NODE\n40,0.0,0.0,500.0\n" + charge("6", "0,0,0,0,40\n") + segments);
  EXPECT_EQ(model.air_blasts.at(0).node, 6);
  EXPECT_EQ(model.air_blasts.at(0).centre[2], 500);
}

TEST(Blasts, WarnOfOtherUnitsThanThoseOfTheMaterials) {
  const std::vector<std::string> messages =
      messages_with("*LOAD_BLAST_ENHANCED\n7,2.0,0.0,0.0,3.0\n\n*LOAD_BLAST_SEGMENT\n7,1,2,3,4\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("field UNIT: read \"2\", expected the units of the deck; UNIT = 2 is kg, m, s; "
                             "densities and moduli look like kg, mm, ms"),
            std::string::npos)
      << messages[0];
}

TEST(Blasts, WarnOfSegmentsThatAllLookAway) {
  const std::vector<std::string> messages = messages_with(charge("6") + "*LOAD_BLAST_SEGMENT\n7,4,3,2,1\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(
      messages[0].find("card 1 field N1: read \"4\", expected segments whose normals point to the side of "
                       "the charge"),
      std::string::npos)
      << messages[0];
}

TEST(Blasts, WarnOfAChargeWithoutSegments) {
  const std::vector<std::string> messages = messages_with(charge("6"));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("field BID: read \"7\", expected a blast that loads segments"),
            std::string::npos)
      << messages[0];
}

TEST(Blasts, SegmentsOfAMirroredFileKeepTheirSide) {
  const std::string main =
      "*KEYWORD\n*DEFINE_TRANSFORMATION\n5\nMIRROR,0,0,0,1,0,0\n*INCLUDE_TRANSFORM\npart.k\n0,0,0,0,0,0,"
      "0\n0\n"
      "\n5\n*END\n";
  SmallDeck deck;
  deck.more = charge("6") + "*LOAD_BLAST_SEGMENT\n7,1,2,3,4\n";
  const ReadResult result = read_deck_text(main, {}, {{"part.k", deck.text()}});
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_EQ(result.model->blast_segments.at(0).node, (std::array<Index, 4>{1, 0, 3, 2}));
  EXPECT_EQ(result.model->blast_segments.at(0).shell, 0);
}

}  // namespace
}  // namespace crumple::deck::test::blasts_test
