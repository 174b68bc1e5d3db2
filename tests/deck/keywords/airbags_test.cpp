// SPDX-License-Identifier: BSD-3-Clause
// *AIRBAG: fields, curves, and surfaces that must be closed and have one outside.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::airbags_test {
namespace {

/// A closed cube of side 1 of six shells, two of which are given to part 2; normals outwards.
struct BoxDeck : CubeDeck {
  BoxDeck() {
    section = "*SECTION_SHELL\n         1         2\n       0.1\n";
    part = "*PART\nbox\n         1         1         1\n*PART\nlid\n         2         1         1\n";
    shells =
        "*ELEMENT_SHELL\n"
        "       1       1       1       4       3       2\n"
        "       2       1       1       2       6       5\n"
        "       3       1       2       3       7       6\n"
        "       4       1       3       4       8       7\n"
        "       5       2       4       1       5       8\n"
        "       6       2       5       6       7       8\n";
    more = "*SET_PART_LIST\n         3\n         1         2\n";
  }
};

constexpr const char* curves =
    "*DEFINE_CURVE\n         5\n                 0.0                 0.0\n                 1.0               "
    "  2.0\n"
    "*DEFINE_CURVE\n         6\n                 0.0                 0.0\n                 1.0               "
    "  4.0\n";

model::Model model_of(const std::string& airbag) {
  BoxDeck deck;
  deck.more += curves + airbag;
  return read_clean(deck.text());
}

TEST(Airbags, ReadsALawOfPressureAndVolume) {
  const model::Model model = model_of(
      "*AIRBAG_SIMPLE_PRESSURE_VOLUME_ID\n        17tyre\n         3         1                 2.0       "
      "3.0\n"
      "       0.4       0.5\n"
      "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n         3         1\n                           6\n");
  ASSERT_EQ(model.control_volumes.size(), 2U);
  const model::ControlVolume& first = model.control_volumes[0];
  EXPECT_EQ(first.id, 17);
  EXPECT_EQ(first.title, "tyre");
  EXPECT_EQ(first.segments.size(), 6U);
  EXPECT_EQ(first.volume_scale, 2);
  EXPECT_EQ(first.pressure_scale, 3);
  EXPECT_EQ(std::get<model::PressureOfVolume>(first.filling).coefficient, 0.2);
  EXPECT_EQ(model.control_volumes[1].id, 2);
  EXPECT_EQ(std::get<model::PressureOfVolume>(model.control_volumes[1].filling).curve, 1);
  EXPECT_EQ(model::enclosed_volume(model.nodes.position, first.segments), 1);
}

TEST(Airbags, ReadsGasesAndLiquids) {
  const model::Model model = model_of(
      "*AIRBAG_ADIABATIC_GAS_MODEL\n         3         1\n       2.0                 1.4       0.2       0.1"
      "       3.0\n"
      "*AIRBAG_LINEAR_FLUID\n         3         1\n       2.0       3.0         5         6         5"
      "         6         5\n       0.9         6\n"
      "*AIRBAG_SIMPLE_AIRBAG_MODEL\n         3         1\n       1.0       1.4     300.0         5       0.7"
      "       0.3       0.1       2.0\n"
      "*AIRBAG_SIMPLE_AIRBAG_MODEL\n         3         1\n       1.0       1.4     300.0         5       0.0"
      "       0.0       0.1       2.0\n         6\n");
  ASSERT_EQ(model.control_volumes.size(), 4U);
  const auto& gas = std::get<model::AdiabaticGas>(model.control_volumes[0].filling);
  EXPECT_EQ(gas.scale, 2);
  EXPECT_EQ(gas.exponent, 1.4);
  EXPECT_EQ(gas.pressure, 0.2);
  EXPECT_EQ(gas.ambient, 0.1);
  EXPECT_EQ(gas.density, 3);
  const auto& fluid = std::get<model::LinearFluid>(model.control_volumes[1].filling);
  EXPECT_EQ(fluid.bulk_modulus, 2);
  EXPECT_EQ(fluid.density, 3);
  EXPECT_EQ(fluid.inflow, 0);
  EXPECT_EQ(fluid.outflow, 1);
  EXPECT_EQ(fluid.outflow_pressure, 0);
  EXPECT_EQ(fluid.added_pressure, 1);
  EXPECT_EQ(fluid.bulk_modulus_time, 0);
  EXPECT_EQ(fluid.limit, 0.9);
  EXPECT_EQ(fluid.limit_time, 1);
  const auto& inflated = std::get<model::InflatedGas>(model.control_volumes[2].filling);
  EXPECT_EQ(inflated.heat_at_volume, 1);
  EXPECT_EQ(inflated.heat_at_pressure, 1.4);
  EXPECT_EQ(inflated.temperature, 300);
  EXPECT_EQ(inflated.inflow, 0);
  EXPECT_EQ(inflated.vent, 0.7 * 0.3);
  EXPECT_EQ(inflated.ambient, 0.1);
  EXPECT_EQ(inflated.density, 2);
  EXPECT_EQ(inflated.outflow, no_index);
  EXPECT_EQ(std::get<model::InflatedGas>(model.control_volumes[3].filling).outflow, 1);
}

TEST(Airbags, ReadsTheGasOfWangAndNefske) {
  const model::Model model = model_of(
      "*AIRBAG_WANG_NEFSKE\n         3         1\n       1.0       1.4     300.0         5         6\n"
      "       0.5                 0.2                 0.3                 2.0\n"
      "       0.1       2.0       1.0                           0.4\n");
  const auto& gas = std::get<model::InflatedGas>(model.control_volumes.at(0).filling);
  EXPECT_EQ(gas.heat_at_volume, 1);
  EXPECT_EQ(gas.heat_at_pressure, 1.4);
  EXPECT_EQ(gas.temperature, 300);
  EXPECT_EQ(gas.temperature_time, 0);
  EXPECT_EQ(gas.inflow, 1);
  EXPECT_EQ(gas.vent, 0.5 * 0.2 + 0.3 * 2);
  EXPECT_EQ(gas.ambient, 0.1);
  EXPECT_EQ(gas.density, 2);
  EXPECT_EQ(gas.opening_pressure, 0.4);
  EXPECT_EQ(gas.outflow, no_index);
}

/// The lid of the box is of fabric.
BoxDeck fabric_lid(const std::string& leakage, const std::string& option) {
  BoxDeck deck;
  deck.section = "*SECTION_SHELL\n         1         5\n       0.1\n";
  deck.part = "*PART\nbox\n         1         1         1\n*PART\nlid\n         2         1         2\n";
  deck.more += curves;
  deck.more += "*MAT_FABRIC\n2,9e-7,.5,,,.3\n0\n0," + leakage + "\n\n\n";
  deck.more +=
      "*AIRBAG_WANG_NEFSKE\n         3         1\n       1.0       1.4     300.0         5         6\n"
      "       0.5                 0.2                 0.3                 2.0\n"
      "       0.1       2.0       1.0                           0.4" +
      option + "\n";
  return deck;
}

TEST(Airbags, LetGasOutThroughFabric) {
  const model::Model model = read_clean(fabric_lid("0.7,-6", "         1").text());
  const model::ControlVolume& volume = model.control_volumes.at(0);
  EXPECT_EQ(std::get<model::InflatedGas>(volume.filling).vent, 0.5 * 0.2);
  ASSERT_EQ(volume.porous.size(), 1U);
  EXPECT_EQ(volume.porous[0].segments.size(), 2U);
  EXPECT_EQ(volume.porous[0].coefficient, 0.7);
  EXPECT_EQ(volume.porous[0].coefficient_time, no_index);
  EXPECT_EQ(volume.porous[0].area_pressure, 1);
  EXPECT_FALSE(volume.porous[0].by_velocity);
  // FVOPT of the fabric goes before OPT of the airbag.
  const model::Model fast = read_clean(fabric_lid("-5,-6,,,,7", "").text());
  const model::ControlVolume& by_velocity = fast.control_volumes.at(0);
  EXPECT_EQ(std::get<model::InflatedGas>(by_velocity.filling).vent, 0.5 * 0.2 + 0.3 * 2);
  ASSERT_EQ(by_velocity.porous.size(), 1U);
  EXPECT_EQ(by_velocity.porous[0].coefficient_time, 0);
  EXPECT_TRUE(by_velocity.porous[0].by_velocity);
}

TEST(Airbags, WarnOfFabricThatStaysTight) {
  const ReadResult result = read_deck_text(fabric_lid("0.7,0.1", "").text(), {}, {});
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_NE(listed(result.diagnostics).find("no gas leaves through it"), std::string::npos);
  EXPECT_TRUE(result.model->control_volumes.at(0).porous.empty());
}

// One shell goes round the other way, as does a triangle that stands for half of another one.
TEST(Airbags, TurnsTheSegmentsThatDisagreeWithMostOthers) {
  BoxDeck deck;
  deck.shells =
      "*ELEMENT_SHELL\n"
      "       1       1       1       4       3       2\n"
      "       2       1       1       2       6       5\n"
      "       3       1       6       7       3       2\n"
      "       4       1       3       4       8       7\n"
      "       5       2       4       1       5       8\n"
      "       6       2       5       6       7       7\n"
      "       7       2       8       7       5       5\n";
  deck.more += "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n         3         1\n       1.0\n";
  const ReadResult result = read_deck_text(deck.text(), {}, {});
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_NE(listed(result.diagnostics).find("2 of 7 are turned"), std::string::npos)
      << listed(result.diagnostics);
  const model::ControlVolume& volume = result.model->control_volumes.at(0);
  EXPECT_EQ(model::enclosed_volume(result.model->nodes.position, volume.segments), 1);
}

TEST(Airbags, TakesASetOfSegments) {
  BoxDeck deck;
  deck.more +=
      "*SET_SEGMENT\n         4\n"
      "         1         4         3         2\n         1         2         6         5\n"
      "         2         3         7         6\n         3         4         8         7\n"
      "         4         1         5         8\n         5         6         7         8\n"
      "*AIRBAG_SIMPLE_PRESSURE_VOLUME\n         4\n       1.0\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.control_volumes.at(0).segments.size(), 6U);
}

}  // namespace
}  // namespace crumple::deck::test::airbags_test
