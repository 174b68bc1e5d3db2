// SPDX-License-Identifier: BSD-3-Clause
// *MAT_ADD_EROSION.
#include <gtest/gtest.h>

#include <utility>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::erosion_test {
namespace {

const std::string steel = "*MAT_ELASTIC\n1,7.8E-9,2.1E5,0.3\n";

model::ErosionCriteria criteria(const std::string& cards) {
  CubeDeck deck;
  deck.material = steel + cards;
  const model::Model model = read_clean(deck.text());
  return model.materials[0].erosion.value_or(model::ErosionCriteria{});
}
std::vector<std::string> messages(const std::string& cards) {
  CubeDeck deck;
  deck.material = steel + cards;
  return messages_in(deck);
}
void only_message(const std::string& cards, const std::string& part) {
  const auto found = messages(cards);
  ASSERT_EQ(found.size(), 1U) << cards << (found.empty() ? "" : found.back());
  EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
}

/// A plate and a rod of a material of its own.
SmallDeck rod(const std::string& form, const std::string& criteria) {
  SmallDeck deck;
  deck.part += "rod\n3,3,3\n";
  deck.section += "*SECTION_BEAM\n3," + form + (form == "1" ? ",,,1\n0.5,0.5\n" : "\n0.5\n");
  deck.material += "*MAT_PLASTIC_KINEMATIC\n3,7.8E-6,210,0.3,0.3,1\n\n*MAT_ADD_EROSION\n" + criteria + "\n\n";
  deck.more = "*ELEMENT_BEAM\n31,3,5,6,1\n";
  return deck;
}

TEST(MatAddErosion, OfTrussesByPlasticStrainAlone) {
  const model::Model model = read_clean(rod("3", "3,,,,-0.1").text());
  EXPECT_EQ(model.materials.at(1).erosion->effective_plastic_strain, 0.1);
  for (const auto& [form, criteria] :
       {std::pair{"3", "3,,,,0.1"}, {"3", "3,,,-0.2,-0.1"}, {"1", "3,,,,-0.1"}}) {
    const std::string found = listed(read_deck_text(rod(form, criteria).text()).diagnostics);
    EXPECT_NE(found.find("of beams only trusses (ELFORM 3) and spot welds (9) fail by it"), std::string::npos)
        << form << " " << criteria << found;
  }
}

TEST(MatAddErosion, EveryField) {
  const auto read = criteria(
      "*MAT_ADD_EROSION_TITLE\nlimits\n1,,900,-0.3,0.5,0.6,-50,2\n-400,800,700,0.2,0.25,100,3.5,0.01\n0\n");
  EXPECT_EQ(read.largest_pressure, 900);
  EXPECT_EQ(read.smallest_principal_strain, -0.3);
  EXPECT_EQ(read.effective_strain, 0.5);
  EXPECT_FALSE(read.effective_plastic_strain);
  EXPECT_EQ(read.volumetric_strain, 0.6);
  EXPECT_EQ(read.points, -50);
  EXPECT_EQ(read.conditions, 2);
  EXPECT_EQ(read.smallest_pressure, -400);
  EXPECT_EQ(read.largest_principal_stress, 800);
  EXPECT_EQ(read.largest_equivalent_stress, 700);
  EXPECT_EQ(read.largest_principal_strain, 0.2);
  EXPECT_EQ(read.shear_strain, 0.25);
  EXPECT_EQ(read.threshold_stress, 100);
  EXPECT_EQ(read.impulse, 3.5);
  EXPECT_EQ(read.time, 0.01);
}

TEST(MatAddErosion, WhatIsZeroOrExcludedDoesNotCount) {
  const auto read =
      criteria("*MAT_ADD_EROSION\n1,1234,1234,1234,-0.4,1234\n1234,1234,1234,0.2,1234,1234,1234,1234\n");
  EXPECT_EQ(read.effective_plastic_strain, 0.4);
  EXPECT_EQ(read.largest_principal_strain, 0.2);
  for (const auto& none :
       {read.largest_pressure, read.smallest_principal_strain, read.effective_strain, read.volumetric_strain,
        read.smallest_pressure, read.largest_principal_stress, read.largest_equivalent_stress,
        read.shear_strain, read.threshold_stress, read.impulse, read.time})
    EXPECT_FALSE(none);
  EXPECT_EQ(read.points, 1);
  EXPECT_EQ(read.conditions, 1);
}

TEST(MatAddErosion, SaysWhatDoesNotFit) {
  only_message("*MAT_ADD_EROSION\n2,,,,0.4\n", "the deck has no material 2");
  only_message("*MAT_ADD_EROSION\n1\n", "there is no criterion");
  only_message("*MAT_ADD_EROSION\n1,,,0.3,0.4\n", "field MNEPS: read \"0.3\", expected a number below zero");
  only_message("*MAT_ADD_EROSION\n1,,,,0.4\n40\n", "field MNPRES");
  only_message("*MAT_ADD_EROSION\n1,,,,0.4\n0,0,-7\n", "field SIGVM");
  only_message("*MAT_ADD_EROSION\n1,,,,0.3,,150\n", "field NUMFIP");
  only_message("*MAT_ADD_EROSION\n1,,,,0.3\n\n2\n", "field IDAM");
  only_message("*MAT_ADD_EROSION\n1,,,,0.3\n\n0\n0,0,0.2\n", "field EPSTHIN");
  only_message("*MAT_ADD_EROSION\n1,,,,0.3\n*MAT_ADD_EROSION\n1,,,,0.4\n", "earlier *MAT_ADD_EROSION");
}

TEST(MatAddErosion, LeavesRigidBodiesAlone) {
  CubeDeck deck;
  deck.material = "*MAT_RIGID\n1,7.8E-9,2.1E5,0.3\n\n\n*MAT_ADD_EROSION\n1,,,,0.4\n";
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  EXPECT_FALSE(result.model->materials[0].erosion);
}

}  // namespace
}  // namespace crumple::deck::test::erosion_test
