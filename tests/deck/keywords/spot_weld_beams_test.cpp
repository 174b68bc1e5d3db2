// SPDX-License-Identifier: BSD-3-Clause
// Spot weld beams from the cards to the model.
#include <numbers>

#include "deck/small_deck.hpp"

namespace crumple::deck::spot_weld_beams_test {
namespace {

using test::CubeDeck;
using test::expect_one;
using test::messages_with;
using test::read_clean;
using test::read_with;

const std::string element =
    "*ELEMENT_BEAM\n      11       2       1       6\n*PART\nweld\n         2         2         2\n";
const std::string material =
    "*MAT_SPOTWELD\n         2   7.85E-6     210.0       0.3      0.35       1.5    1.0E-4       7.0\n"
    "       0.2       6.0       4.0       3.0       8.0       7.0       5.0\n";

std::string weld(const std::string& section) {
  return element + material + "*SECTION_BEAM\n" + section;
}

TEST(SpotWeldBeams, HaveARoundSectionAndTheirOwnLaw) {
  const model::Model model = read_with(weld("2,9,0.9,,1\n5.0,5.0\n"));
  const model::BeamSection& section = model.beam_sections.at(0);
  const double area = std::numbers::pi * 25 / 4;
  EXPECT_EQ(section.formulation, model::BeamFormulation::SpotWeld);
  EXPECT_DOUBLE_EQ(section.area, area);
  EXPECT_DOUBLE_EQ(section.inertia_s, area * 25 / 16);
  EXPECT_EQ(section.inertia_t, section.inertia_s);
  EXPECT_EQ(section.torsion, 2 * section.inertia_s);
  EXPECT_DOUBLE_EQ(section.shear_area, 0.9 * area);
  const auto law = std::get<model::SpotWeldLaw>(model.materials.at(1).law);
  EXPECT_EQ(law.youngs_modulus, 210);
  EXPECT_EQ(law.poissons_ratio, 0.3);
  EXPECT_EQ(law.yield_stress, 0.35);
  EXPECT_EQ(law.hardening, 1.5);
  EXPECT_EQ(law.least_step, 1e-4);
  EXPECT_EQ(law.failure_time, 7);
  EXPECT_EQ(law.failure_strain, 0.2);
  EXPECT_EQ(law.tension_strength, 6);
  EXPECT_EQ(law.shear_strength_s, 4);
  EXPECT_EQ(law.shear_strength_t, 3);
  EXPECT_EQ(law.torsion_strength, 8);
  EXPECT_EQ(law.bending_strength_s, 7);
  EXPECT_EQ(law.bending_strength_t, 5);
}

TEST(SpotWeldBeams, MayBeTubesAndARectangleWithoutWidthIsACircle) {
  const model::BeamSection tube = read_with(weld("2,9,,,1\n5.0,,3.0\n")).beam_sections.at(0);
  EXPECT_DOUBLE_EQ(tube.area, std::numbers::pi * 16 / 4);
  EXPECT_DOUBLE_EQ(tube.inertia_s, std::numbers::pi / 64 * (625 - 81));
  EXPECT_EQ(tube.shear_area, tube.area);
  EXPECT_DOUBLE_EQ(read_with(weld("2,9\n5.0\n")).beam_sections.at(0).area, std::numbers::pi * 25 / 4);
}

TEST(SpotWeldBeams, BlanksAreNoFailureAndNoAddedMass) {
  const auto law = std::get<model::SpotWeldLaw>(
      read_with(element + "*MAT_100\n2,7.85E-6,210,0.3,0.35\n\n*SECTION_BEAM\n2,9,,,1\n5\n")
          .materials.at(1)
          .law);
  EXPECT_EQ(law.failure_time, 1e20);
  EXPECT_EQ(law.failure_strain, 0);
  EXPECT_EQ(law.tension_strength, 0);
  EXPECT_EQ(law.least_step, 0);
}

TEST(SpotWeldBeams, DamageAndFailureMayHaveItsThirdCard) {
  const std::string section = "*SECTION_BEAM\n2,9,,,1\n5\n";
  const std::string cards = "*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.85E-6,210,0.3,0.35\n0.2,6\n";
  EXPECT_EQ(std::get<model::SpotWeldLaw>(read_with(element + cards + "0,-1\n" + section).materials.at(1).law)
                .tension_strength,
            6);
  EXPECT_EQ(messages_with(element + cards + "0,1\n" + section).size(), 1U);
  EXPECT_EQ(messages_with(element + cards + "0.4,0\n" + section).size(), 1U);
}

void expect_one(const std::string& cards, const std::string& text) {
  const auto messages = messages_with(cards);
  ASSERT_EQ(messages.size(), 1U) << cards;
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}

TEST(SpotWeldBeams, OtherSectionsAreRefused) {
  expect_one(weld("2,9,,,2\n5\n"), "spot welds are round");
  expect_one(weld("2,9,,,0\n5,5,3,3\n"), "spot welds are round");
  expect_one(weld("2,9,,,1\n5,4\n"), "one diameter");
  expect_one(weld("2,9,,,1\n5,5,5,5\n"), "an inner diameter below TS1");
}

TEST(SpotWeldBeams, LawAndSectionBelongTogether) {
  expect_one(weld("2,2\n25,52,52\n"), "*MAT_ELASTIC or *MAT_RESULTANT_PLASTICITY");
  expect_one(
      "*ELEMENT_BEAM\n      11       2       1       6\n*PART\nweld\n         2         2         1\n"
      "*SECTION_BEAM\n2,9,,,1\n5\n",
      "spot weld beams (ELFORM 9) have this law");
}

TEST(SpotWeldBeams, AreTiedByTheirNodesAndTouchNothing) {
  const std::string section = "2,9,,,1\n5.0\n";
  for (const char* name : {"CONTACT_SPOTWELD", "CONTACT_SPOTWELD_WITH_TORSION_ID"}) {
    const std::string heading = std::string(name).ends_with("_ID") ? "4,welds\n" : "";
    const model::Model model = read_with(weld(section) + "*" + name + "\n" + heading + "2,1,3,3\n\n\n");
    const model::TiedContact& tied = model.tied_contacts.at(0);
    EXPECT_EQ(tied.method, model::TieMethod::Constraint);
    EXPECT_TRUE(tied.ties_rotations);
    EXPECT_EQ(tied.side[0].nodes, (std::vector<Index>{0, 5}));
    EXPECT_EQ(tied.side[1].parts, (std::vector<Index>{0}));
  }
  for (const char* name : {"AUTOMATIC_GENERAL", "AUTOMATIC_SINGLE_SURFACE"})
    EXPECT_EQ(read_with(weld(section) + "*CONTACT_" + name + "\n0\n\n\n").contacts.at(0).side[0].parts,
              (std::vector<Index>{0}));
}

TEST(SpotWeldSolids, AreMetalThatHardens) {
  CubeDeck deck;
  deck.material = "*MAT_SPOTWELD\n1,7.85E-6,210,0.3,0.35,1.5,,7\n0.2\n";
  const model::Model model = read_clean(deck.text());
  const model::Material& metal = model.materials.at(static_cast<std::size_t>(model.parts.at(0).material));
  const auto& law = std::get<model::PlasticKinematic>(metal.law);
  EXPECT_EQ(law.yield_stress, 0.35);
  EXPECT_EQ(law.isotropic_fraction, 1);
  EXPECT_EQ(law.failure_strain, 0.2);
  // Slope of the stress over the plastic strain.
  EXPECT_NEAR(law.tangent_modulus / (1 - law.tangent_modulus / 210), 1.5, 1e-12);
  ASSERT_TRUE(metal.erosion);
  EXPECT_EQ(metal.erosion->time, 7);
}

TEST(SpotWeldSolids, HaveNoResultants) {
  CubeDeck deck;
  deck.material = "*MAT_SPOTWELD\n1,7.85E-6,210,0.3,0.35,1.5\n0.2,6\n";
  expect_one(deck, "a *MAT_SPOTWELD without NRR");
  deck.material = "*MAT_SPOTWELD\n1,7.85E-6,210,0.3,0.35,1.5,1E-4\n0.2\n";
  expect_one(deck, "no mass is added");
}

}  // namespace
}  // namespace crumple::deck::spot_weld_beams_test
