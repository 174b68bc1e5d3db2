// SPDX-License-Identifier: BSD-3-Clause
// *MAT_COHESIVE_MIXED_MODE, *MAT_COHESIVE_ELASTIC, ELFORM 19 of *SECTION_SOLID.
#include <gtest/gtest.h>

#include <string>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::cohesive_materials_test {
namespace {

CubeDeck cohesive(const std::string& material) {
  CubeDeck deck;
  deck.section = "*SECTION_SOLID\n         1        19\n";
  deck.material = material;
  return deck;
}
const std::string mixed = "*MAT_COHESIVE_MIXED_MODE\n1,1.2E-9,1,3,5000,2000,0.3,1.1\n-1.5,30,0,0,0.05,1.2\n";

TEST(CohesiveMaterial, MixedMode) {
  for (const std::string keyword : {"*MAT_COHESIVE_MIXED_MODE", "*MAT_138"}) {
    const model::Model model =
        read_clean(cohesive(replaced(mixed, "*MAT_COHESIVE_MIXED_MODE", keyword)).text());
    EXPECT_EQ(model.solid_sections[0].formulation, model::SolidFormulation::CohesiveHexahedron);
    EXPECT_EQ(model.materials[0].density, 1.2e-9);
    const auto& law = std::get<model::Cohesive>(model.materials[0].law);
    EXPECT_EQ(law.youngs_modulus, 5000);
    EXPECT_EQ(law.shear_stiffness, 2000);
    EXPECT_EQ(law.failure, model::Cohesive::Failure::BenzeggaghKenane);
    EXPECT_EQ(law.normal_energy, 0.3);
    EXPECT_EQ(law.shear_energy, 1.1);
    EXPECT_EQ(law.exponent, 1.5);
    EXPECT_EQ(law.stiffness_exponent, 1.2);
    EXPECT_EQ(law.normal_strength, 30);
    EXPECT_DOUBLE_EQ(law.shear_strength, 2 * 1.1 / 0.05);
    EXPECT_TRUE(law.mass_by_area);
    EXPECT_EQ(law.failed_points, 3);
    EXPECT_FALSE(law.at_corners);
  }
}

TEST(CohesiveMaterial, Defaults) {
  const model::Model model =
      read_clean(cohesive("*MAT_138\n1,1.2E-9,0,0,5000,2000,0.3,1.1\n0,30,40\n").text());
  const auto& law = std::get<model::Cohesive>(model.materials[0].law);
  EXPECT_EQ(law.failure, model::Cohesive::Failure::PowerLaw);
  EXPECT_EQ(law.exponent, 1);
  EXPECT_EQ(law.stiffness_exponent, 1);
  EXPECT_EQ(law.shear_strength, 40);
  EXPECT_FALSE(law.mass_by_area);
  EXPECT_EQ(law.failed_points, 0);
  EXPECT_TRUE(law.at_corners);
}

TEST(CohesiveMaterial, Elastic) {
  for (const std::string keyword : {"*MAT_COHESIVE_ELASTIC", "*MAT_184"}) {
    const model::Model model = read_clean(cohesive(keyword + "\n1,1.2E-9,0,-2,2000,5000,30,40\n").text());
    const auto& law = std::get<model::Cohesive>(model.materials[0].law);
    EXPECT_EQ(law.failure, model::Cohesive::Failure::Brittle);
    EXPECT_EQ(law.youngs_modulus, 5000);
    EXPECT_EQ(law.shear_stiffness, 2000);
    EXPECT_EQ(law.normal_strength, 30);
    EXPECT_EQ(law.shear_strength, 40);
    EXPECT_EQ(law.failed_points, 2);
    EXPECT_TRUE(law.at_corners);
  }
}

TEST(CohesiveMaterial, WrongFields) {
  expect_one(cohesive(replaced(mixed, "-1.5,30", "-1.5,-30")), "it is a curve over the size of elements");
  expect_one(cohesive(replaced(mixed, "-1.5,30", "-1.5,0")), "a strength above zero, or UND");
  expect_one(cohesive(replaced(mixed, ",1,3,", ",1,5,")), "INTFAIL");
  expect_one(cohesive(replaced(mixed, ",1,3,", ",2,3,")), "ROFLG");
  expect_one(cohesive(replaced(mixed, ",5000,", ",0,")), "EN");
}

TEST(CohesiveMaterial, GoesWithItsSectionAlone) {
  CubeDeck deck = cohesive(mixed);
  deck.section = "*SECTION_SOLID\n         1         1\n";
  expect_one(deck, "goes with a section of ELFORM 19");
  expect_one(cohesive("*MAT_ELASTIC\n1,1.2E-9,5000,0.3\n"), "is cohesive, ELFORM 19");
  deck.section = "*SECTION_SOLID\n         1        20\n";
  deck.material = mixed;
  expect_one(deck, "take 19");
}

TEST(CohesiveSolid, MayHaveNoVolume) {
  CubeDeck deck = cohesive(mixed);
  for (int k = 0; k < 4; ++k) deck.nodes = replaced(deck.nodes, "             1.0\n", "             0.0\n");
  EXPECT_EQ(read_clean(deck.text()).solids.size(), 1U);
}

TEST(CohesiveSolid, WrongShapes) {
  CubeDeck deck = cohesive(mixed);
  deck.shells =
      "*ELEMENT_SOLID\n      21       1       5       6       7       8       1       2       3       4\n";
  expect_one(deck, "has the negative thickness -1; N1 to N4 run counter-clockwise");
  deck.shells =
      "*ELEMENT_SOLID\n      21       1       1       2       3       4       5       5       5       5\n";
  expect_one(deck, "has a face with fewer than three nodes");
  // A wedge is a hexahedron with triangles.
  deck.shells =
      "*ELEMENT_SOLID\n      21       1       1       2       3       3       5       6       7       7\n";
  EXPECT_TRUE(messages_in(deck).empty()) << messages_in(deck).front();
  deck = cohesive(mixed);
  for (int k = 0; k < 4; ++k) deck.nodes = replaced(deck.nodes, "             1.0\n", "             0.0\n");
  for (const char* y : {"             1.0             0.0\n"})
    for (int k = 0; k < 4; ++k) deck.nodes = replaced(deck.nodes, y, "             0.0             0.0\n");
  expect_one(deck, "has no area");
}

}  // namespace
}  // namespace crumple::deck::test::cohesive_materials_test
