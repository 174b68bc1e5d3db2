// SPDX-License-Identifier: BSD-3-Clause
// Beams that are integrated over their cross section, from the cards to the model.
#include <numbers>

#include "deck/small_deck.hpp"

namespace crumple::deck::integrated_beams_test {
namespace {

using test::messages_with;
using test::read_with;

std::string with_section(const std::string& section) {
  return "*ELEMENT_BEAM\n      11       2       1       5       4\n*PART\nframe\n         2         2        "
         " 1\n"
         "*SECTION_BEAM\n" +
         section;
}

model::BeamSection section_of(const std::string& section) {
  return read_with(with_section(section)).beam_sections.at(0);
}

TEST(IntegratedBeamDecks, RectangleHasFourPointsByDefault) {
  for (const std::string form : {"", "0", "1", "4"}) {
    const model::BeamSection section = section_of("2," + form + ",0.8\n0.4,,0.2\n");
    EXPECT_EQ(section.formulation, model::BeamFormulation::Integrated);
    EXPECT_EQ(section.shear_factor, 0.8);
    ASSERT_EQ(section.points.size(), 4U);
    EXPECT_NEAR(section.area, 0.08, 1e-15);
    EXPECT_NEAR(section.inertia_s, 0.4 * 0.008 / 12, 1e-15);
    EXPECT_NEAR(section.inertia_t, 0.2 * 0.064 / 12, 1e-15);
  }
}

TEST(IntegratedBeamDecks, RulesHaveTheirPoints) {
  const std::size_t points[] = {1, 4, 9, 9, 16};
  for (int rule = 1; rule <= 5; ++rule)
    EXPECT_EQ(section_of("2,1,," + std::to_string(rule) + ".0\n0.4,,0.2\n").points.size(), points[rule - 1]);
  EXPECT_NEAR(section_of("2,1,,4\n0.4,,0.2\n").points.front().s, -0.2, 1e-15);
}

TEST(IntegratedBeamDecks, TubesHaveTheirDiameters) {
  const double area = std::numbers::pi / 4 * (25 - 9);
  EXPECT_NEAR(section_of("2,1,,,1\n5.0,,3.0\n").area, area, 1e-12);
  EXPECT_NEAR(section_of("2,5\n5.0,5.0,3.0,3.0\n").area, area, 1e-12);
  EXPECT_NEAR(section_of("2,1,,,1\n5.0\n").area, std::numbers::pi / 4 * 25, 1e-12);
  const model::BeamSection section = section_of("2,1,,5,1\n5.0,,3.0\n");
  EXPECT_EQ(section.points.size(), 32U);
  EXPECT_NEAR(section.inertia_s, std::numbers::pi / 64 * (625 - 81), 1e-12);
}

TEST(IntegratedBeamDecks, TaperedBeamsHaveTheMeanOfBothEnds) {
  EXPECT_NEAR(section_of("2,1\n0.4,0.6,0.2,0.4\n").area, 0.5 * 0.3, 1e-15);
}

TEST(IntegratedBeamDecks, NodesMayLieOnASide) {
  const model::BeamSection section = section_of("2,1\n0.4,,0.2,,1,-1\n");
  double s = 0;
  double t = 0;
  for (const model::SectionPoint& point : section.points) {
    s += point.area * point.s / section.area;
    t += point.area * point.t / section.area;
  }
  EXPECT_NEAR(s, -0.2, 1e-15);
  EXPECT_NEAR(t, 0.1, 1e-15);
}

TEST(IntegratedBeamDecks, RulesOfTheDeckGivePoints) {
  const model::BeamSection section =
      section_of("2,1,,-7\n0.4,,0.2\n*INTEGRATION_BEAM\n7,2,0.5\n-0.5,0.25,0.25\n1.0,-1.0,0.75\n");
  ASSERT_EQ(section.points.size(), 2U);
  EXPECT_NEAR(section.points[0].s, -0.1, 1e-15);
  EXPECT_NEAR(section.points[0].t, 0.025, 1e-15);
  EXPECT_NEAR(section.points[0].area, 0.25 * 0.5 * 0.08, 1e-15);
  EXPECT_NEAR(section.points[1].s, 0.2, 1e-15);
  EXPECT_NEAR(section.area, 0.04, 1e-15);
}

TEST(IntegratedBeamDecks, StandardShapesHaveTheirAreas) {
  const auto area = [](const std::string& shape, const std::string& size) {
    return section_of("2,1,,-7,2\n0.0\n*INTEGRATION_BEAM\n7,,," + shape + "\n" + size + "\n").area;
  };
  EXPECT_NEAR(area("1", "0.3,0.02,0.4,0.01"), 2 * 0.3 * 0.02 + 0.36 * 0.01, 1e-15);
  EXPECT_NEAR(area("2", "0.3,0.02,0.4,0.01"), 2 * 0.3 * 0.02 + 0.36 * 0.01, 1e-15);
  EXPECT_NEAR(area("3", "0.3,0.02,0.4,0.01"), 0.3 * 0.02 + 0.38 * 0.01, 1e-15);
  EXPECT_NEAR(area("4", "0.3,0.02,0.4,0.01"), 0.3 * 0.02 + 0.38 * 0.01, 1e-15);
  EXPECT_NEAR(area("5", "0.3,0.02,0.4,0.01"), 2 * 0.3 * 0.02 + 2 * 0.36 * 0.01, 1e-15);
  EXPECT_NEAR(area("8", "0.3"), std::numbers::pi * 0.09, 1e-15);
  EXPECT_NEAR(area("9", "0.2,0.3"), std::numbers::pi * 0.05, 1e-15);
  EXPECT_NEAR(area("11", "0.3,0.2"), 0.06, 1e-15);
  const auto points = [](const std::string& refinement) {
    return section_of("2,1,,-7,2\n0.0\n*INTEGRATION_BEAM\n7,,,1," + refinement + "\n0.3,0.02,0.4,0.01\n")
        .points.size();
  };
  EXPECT_EQ(points("0"), 24U);
  EXPECT_EQ(points("2"), 48U);
}

TEST(IntegratedBeamDecks, NodesOfShapesMoveToTheirSides) {
  const auto mean = [](const std::string& size) {
    const auto section = section_of("2,1,,-7\n0.0\n*INTEGRATION_BEAM\n7,,,4\n" + size + "\n");
    double t = 0;
    for (const model::SectionPoint& point : section.points) t += point.area * point.t / section.area;
    return t;
  };
  // The centre of a T: flange 0.3 x 0.02 at the top, web 0.01 x 0.38.
  const double centre = (0.006 * 0.39 + 0.0038 * 0.19) / 0.0098;
  EXPECT_NEAR(mean("0.3,0.02,0.4,0.01"), 0, 1e-15);
  EXPECT_NEAR(mean("0.3,0.02,0.4,0.01,0,1"), centre - 0.4, 1e-15);
  EXPECT_NEAR(mean("0.3,0.02,0.4,0.01,0,-1"), centre, 1e-15);
}

TEST(IntegratedBeamDecks, WarnOfWeightsThatAreNotTheWhole) {
  const auto messages =
      messages_with(with_section("2,1,,-7\n0.4,,0.2\n*INTEGRATION_BEAM\n7,1,0.5\n0.0,0.0,0.9\n"));
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("sum to 0.9"), std::string::npos) << messages[0];
}

TEST(IntegratedBeamDecks, TakeElasticPlasticAndRigidMaterials) {
  const auto with = [](const std::string& material) {
    return read_with(
        "*ELEMENT_BEAM\n      11       2       1       5       4\n*PART\nframe\n         2         2         "
        "2\n"
        "*SECTION_BEAM\n2,1\n0.4,,0.2\n" +
        material);
  };
  EXPECT_TRUE(std::holds_alternative<model::PlasticKinematic>(
      with("*MAT_PLASTIC_KINEMATIC\n2,7.8e-6,207,0.3,0.2,1.0,0.5\n40,5,0.3\n").materials[1].law));
  EXPECT_TRUE(std::holds_alternative<model::PiecewiseLinearPlasticity>(
      with("*MAT_PIECEWISE_LINEAR_PLASTICITY\n2,7.8e-6,207,0.3,0.2,1.0\n\n\n\n").materials[1].law));
  EXPECT_TRUE(std::holds_alternative<model::PowerLawPlasticity>(
      with("*MAT_POWER_LAW_PLASTICITY\n2,7.8e-6,207,0.3,0.5,0.2\n\n").materials[1].law));
  EXPECT_TRUE(std::holds_alternative<model::JohnsonCook>(
      with("*MAT_SIMPLIFIED_JOHNSON_COOK\n2,7.8e-6,207,0.3\n0.2,0.3,0.5,0.01\n").materials[1].law));
  EXPECT_TRUE(std::holds_alternative<model::NullMaterial>(with("*MAT_NULL\n2,7.8e-6\n").materials[1].law));
  EXPECT_TRUE(with("*MAT_RIGID\n2,7.8e-6,207,0.3\n\n\n").materials[1].rigid.has_value());
}

}  // namespace
}  // namespace crumple::deck::integrated_beams_test
