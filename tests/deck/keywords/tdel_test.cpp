// SPDX-License-Identifier: BSD-3-Clause
// TDEL of *MAT_024 and *MAT_123, DTMIN of *MAT_ADD_EROSION.
#include <gtest/gtest.h>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::tdel_test {
namespace {

double least_step(const std::string& material) {
  CubeDeck deck;
  deck.material = material;
  return read_clean(deck.text()).materials.at(0).least_step;
}
const std::string metal = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8E-9,2.1E5,0.3,250,1000,,";

TEST(DeletionByStep, OfTheLaw) {
  EXPECT_EQ(least_step(metal + "2.5E-7\n\n\n\n"), 2.5e-7);
  EXPECT_EQ(least_step(metal + "1.0E20\n\n\n\n"), 0);
  EXPECT_EQ(least_step(metal + "\n\n\n\n"), 0);
  EXPECT_EQ(least_step("*MAT_123\n1,7.8E-9,2.1E5,0.3,250,1000,,2.5E-7\n\n\n\n"), 2.5e-7);
}

TEST(DeletionByStep, OfTheCriteria) {
  EXPECT_EQ(least_step(metal + "\n\n\n\n*MAT_ADD_EROSION\n1\n\n0\n0\n,,,1.5E-7\n"), 1.5e-7);
  EXPECT_EQ(least_step(metal + "2.5E-7\n\n\n\n*MAT_ADD_EROSION\n1\n\n0\n0\n,,,1.5E-7\n"), 2.5e-7)
      << "the larger";
}

TEST(DeletionByStep, IsNotForBeamsNorRigidBodies) {
  SmallDeck deck;
  deck.part += "rod\n3,3,3\n";
  deck.section += "*SECTION_BEAM\n3,3\n0.5\n";
  deck.material +=
      "*MAT_PLASTIC_KINEMATIC\n3,7.8E-6,210,0.3,0.3,1\n\n*MAT_ADD_EROSION\n3\n\n0\n0\n,,,1.5E-7\n";
  deck.more = "*ELEMENT_BEAM\n31,3,5,6,1\n";
  expect_one(deck, "shells and solids alone are deleted by their time step");
  SmallDeck made_rigid;
  made_rigid.material = "*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.8E-6,210,0.3,0.25,1,,2.5E-7\n\n\n\n";
  made_rigid.more = "*DEFORMABLE_TO_RIGID\n1\n";
  const ReadResult result = read_deck_text(made_rigid.text());
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  const model::Model& model = *result.model;
  EXPECT_EQ(model.materials.at(static_cast<std::size_t>(model.parts.at(0).material)).least_step, 0);
}

}  // namespace
}  // namespace crumple::deck::test::tdel_test
