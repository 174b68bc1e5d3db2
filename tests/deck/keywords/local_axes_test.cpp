// SPDX-License-Identifier: BSD-3-Clause
// Supports, motions, loads and velocities along the axes of coordinate systems and vectors; loads, damping
// and mass by part.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::local_axes_test {
namespace {

/// Local x is along (1, 1, 0), local y along (-1, 1, 0).
const std::string system = "*DEFINE_COORDINATE_SYSTEM\n9,0,0,0,1,1,0\n-1,1,0\n";
const std::string curve = "*DEFINE_CURVE\n1\n0,1\n3,1\n";
const double half = std::sqrt(0.5);

void expect_vector(const std::array<double, 3>& found, const std::array<double, 3>& expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-15) << i;
}

bool has(const std::vector<std::string>& messages, const std::string& text) {
  for (const std::string& message : messages)
    if (message.find(text) != std::string::npos) return true;
  return false;
}

TEST(LocalSupports, HaveTheAxesOfTheirSystemAndTheirTimes) {
  const model::Model model = read_with(system +
                                       "*BOUNDARY_SPC_NODE\n2,9,1,0,0,0,0,1\n3,0,1\n"
                                       "*SET_NODE_LIST\n4\n5,6\n"
                                       "*BOUNDARY_SPC_SET_BIRTH_DEATH\n4,0,0,1\n0.5,2\n");
  ASSERT_EQ(model.fixed_nodes.size(), 1U);
  ASSERT_EQ(model.local_supports.size(), 3U);
  const model::LocalSupport& first = model.local_supports[0];
  EXPECT_EQ(first.node, 1);
  expect_vector(first.axes[0], {half, half, 0});
  expect_vector(first.axes[1], {-half, half, 0});
  EXPECT_EQ(first.translation, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(first.rotation, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(first.death, 1e28);
  const model::LocalSupport& timed = model.local_supports[2];
  EXPECT_EQ(timed.node, 5);
  EXPECT_EQ(timed.birth, 0.5);
  EXPECT_EQ(timed.death, 2);
}

TEST(LocalSupports, AlongGlobalAxesAreOrdinaryOnes) {
  const model::Model model =
      read_with("*DEFINE_COORDINATE_SYSTEM\n9,1,1,1,2,1,1\n1,2,1\n*BOUNDARY_SPC_NODE\n2,9,1\n");
  EXPECT_TRUE(model.local_supports.empty());
  EXPECT_EQ(model.fixed_nodes.size(), 1U);
}

TEST(LocalSupports, OfTheWholeRunAreOrdinaryOnes) {
  const model::Model model = read_with("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n2,0,1\n0,1e20\n3,0,1\n\n");
  EXPECT_TRUE(model.local_supports.empty());
  EXPECT_EQ(model.fixed_nodes.size(), 2U);
  const model::Model born = read_with("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n2,0,1\n1e-9,1e20\n3,0,1\n0,1e19\n");
  EXPECT_EQ(born.local_supports.size(), 2U);
}

TEST(LocalMotions, AreAlongAndAboutVectors) {
  const model::Model model = read_with(system + curve +
                                       "*DEFINE_VECTOR\n7,1,1,1,4,1,5\n8,0,0,0,2,0,0,9\n"
                                       "*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,4,0,1,2,7\n3,-8,0,1,1,8\n");
  ASSERT_EQ(model.prescribed_motions.size(), 2U);
  const model::PrescribedMotion& along = model.prescribed_motions[0];
  expect_vector(along.direction, {0.6, 0, 0.8});
  EXPECT_FALSE(along.rotation || along.holds_plane);
  const model::PrescribedMotion& about = model.prescribed_motions[1];
  expect_vector(about.direction, {half, half, 0});
  EXPECT_TRUE(about.rotation && about.holds_plane);
}

TEST(LocalMotions, GoRoundAxesThroughTwoOffsets) {
  const model::Model model = read_with(
      "*DEFINE_CURVE\n1\n0,0\n3,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,10,0,1,2\n0.5,-0.25\n"
      "3,-11,2,1\n3,4\n4,3,0,1\n");
  ASSERT_EQ(model.prescribed_motions.size(), 3U);
  const model::PrescribedMotion& about_y = model.prescribed_motions[0];
  EXPECT_EQ(about_y.axis, 1);
  EXPECT_TRUE(about_y.goes_round && about_y.keeps_radius);
  EXPECT_FALSE(about_y.rotation || about_y.holds_plane);
  expect_vector(about_y.centre, {-0.25, 0, 0.5});
  const model::PrescribedMotion& about_z = model.prescribed_motions[1];
  EXPECT_EQ(about_z.axis, 2);
  EXPECT_FALSE(about_z.keeps_radius || about_z.holds_plane);
  expect_vector(about_z.centre, {3, 4, 0});
  EXPECT_FALSE(model.prescribed_motions[2].goes_round);
}

TEST(LocalMotions, NeedAVector) {
  const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,4,0,1,1,";
  EXPECT_TRUE(has(messages_with(curve + motion + "\n"), "field VID"));
  EXPECT_TRUE(has(messages_with(curve + motion + "7\n"), "has no vector 7"));
  EXPECT_TRUE(has(messages_with("*DEFINE_VECTOR\n7,1,1,1,1,1,1\n"), "the same point"));
}

TEST(LocalLoads, AreAlongTheAxesOfTheirSystem) {
  const model::Model model = read_with(system + curve + "*LOAD_NODE_POINT\n2,1,1,3,9\n3,6,1,2,9\n");
  ASSERT_EQ(model.nodal_loads.size(), 2U);
  expect_vector(model.nodal_loads[0].force, {3 * half, 3 * half, 0});
  expect_vector(model.nodal_loads[1].moment, {-2 * half, 2 * half, 0});
  EXPECT_FALSE(model.nodal_loads[0].plane.given());
}

TEST(FollowerLoads, HaveAPlane) {
  const model::Model model = read_with(curve + "*LOAD_NODE_POINT\n2,4,1,3,0,1,2,4\n3,8,1,2,0,1,2,4\n");
  ASSERT_EQ(model.nodal_loads.size(), 2U);
  EXPECT_EQ(model.nodal_loads[0].plane.node, (std::array<Index, 3>{0, 1, 3}));
  expect_vector(model.nodal_loads[0].force, {3, 0, 0});
  expect_vector(model.nodal_loads[1].moment, {2, 0, 0});
  EXPECT_TRUE(has(messages_with(curve + "*LOAD_NODE_POINT\n2,4,1,3,0,1,2,0\n"), "field M3"));
}

TEST(LocalVelocities, TurnWithTheirSystemAndStayInTheirBox) {
  const model::Model model = read_with(system +
                                       "*DEFINE_BOX\n3,-1,0.5,-1,9,-1,1\n"
                                       "*INITIAL_VELOCITY\n0,0,3,0,9\n2,0,0,0,0,1\n");
  ASSERT_EQ(model.initial_velocities.size(), 2U);
  EXPECT_EQ(model.initial_velocities[0].node, 0);
  EXPECT_EQ(model.initial_velocities[1].node, 3);
  expect_vector(model.initial_velocities[0].velocity, {2 * half, 2 * half, 0});
  expect_vector(model.initial_velocities[0].angular_velocity, {0, 0, 1});
}

TEST(LocalVelocities, OfGenerationTurnAboutALocalAxis) {
  const model::Model model =
      read_with(system + "*INITIAL_VELOCITY_GENERATION\n1,2,5,0,0,1,0,9\n0,0,0,1,0,0\n");
  ASSERT_EQ(model.initial_velocities.size(), 6U);
  expect_vector(model.initial_velocities[0].velocity, {0, 0, 1});
  expect_vector(model.initial_velocities[0].angular_velocity, {5 * half, 5 * half, 0});
}

TEST(InertiaFields, AreOfPartsByRotationAndAlongVectors) {
  const std::string set = "*SET_PART_LIST\n2\n1\n";
  const model::Model parts = read_with(set + curve + "*LOAD_BODY_PARTS\n2\n*LOAD_BODY_Z\n1,9.81\n");
  EXPECT_TRUE(parts.body_loads.empty());
  ASSERT_EQ(parts.inertia_fields.size(), 1U);
  EXPECT_EQ(parts.inertia_fields[0].parts, std::vector<Index>{0});
  EXPECT_FALSE(parts.inertia_fields[0].of_all);
  expect_vector(parts.inertia_fields[0].acceleration, {0, 0, 9.81});

  const model::Model rest =
      read_with(system + curve +
                "*LOAD_BODY_RY\n1,3,0,1,2,3\n*LOAD_BODY_VECTOR\n1,5,0,0,0,0,9\n2,0,0\n"
                "*LOAD_BODY_GENERALIZED\n2,3,1,0,4,5,6\n1,2,3,0,0,7\n*LOAD_GRAVITY_PART\n1,3,1,9.81\n");
  ASSERT_EQ(rest.inertia_fields.size(), 4U);
  expect_vector(rest.inertia_fields[0].spin, {0, 3, 0});
  expect_vector(rest.inertia_fields[0].centre, {1, 2, 3});
  EXPECT_TRUE(rest.inertia_fields[0].of_all);
  expect_vector(rest.inertia_fields[1].acceleration, {5 * half, 5 * half, 0});
  EXPECT_EQ(rest.inertia_fields[2].nodes, (std::vector<Index>{1, 2}));
  expect_vector(rest.inertia_fields[2].spin, {0, 0, 7});
  EXPECT_EQ(rest.inertia_fields[3].parts, std::vector<Index>{0});
}

TEST(GravityOfParts, StaysWithoutACurve) {
  const model::Model model = read_with("*LOAD_GRAVITY_PART\n1,3,0,9.81\n");
  ASSERT_EQ(model.inertia_fields.size(), 1U);
  const model::Curve& steady = model.curves.at(static_cast<std::size_t>(model.inertia_fields[0].curve));
  EXPECT_EQ(steady.at(0), 1);
  EXPECT_EQ(steady.at(1e6), 1);
}

TEST(PartDamping, TakesACurveAFactorAndDirections) {
  const model::Model model = read_with(curve + "*DAMPING_PART_MASS\n1,1,0.5\n1,1,2,1\n1,0,0,0.5\n1,0\n");
  ASSERT_EQ(model.part_dampings.size(), 2U);
  EXPECT_EQ(model.part_dampings[0].scale, 0.5);
  EXPECT_EQ(model.part_dampings[0].translation, (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(model.part_dampings[1].translation, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(model.part_dampings[1].rotation, (std::array<double, 3>{0.5, 0, 0}));
  EXPECT_FALSE(model.mass_damping);
}

TEST(StiffnessDamping, OfPartsByASignedCoefficient) {
  const model::Model share = read_with("*DAMPING_PART_STIFFNESS\n1,0.1\n");
  ASSERT_TRUE(share.parts[0].damping);
  EXPECT_EQ(share.parts[0].damping->share, 0.1);
  EXPECT_EQ(share.parts[0].damping->beta, 0);
  const model::Model beta = read_with("*SET_PART_LIST\n4\n1\n*DAMPING_PART_STIFFNESS_SET\n4,-2e-6\n");
  ASSERT_TRUE(beta.parts[0].damping);
  EXPECT_EQ(beta.parts[0].damping->share, 0);
  EXPECT_EQ(beta.parts[0].damping->beta, 2e-6);
  EXPECT_FALSE(read_with("*DAMPING_PART_STIFFNESS\n1,0\n").parts[0].damping);
}

TEST(PartMasses, AreAddedOrFinal) {
  const model::Model model =
      read_with("*ELEMENT_MASS_PART\n       1           0.001\n       1                           0.002\n");
  ASSERT_EQ(model.part_masses.size(), 2U);
  EXPECT_EQ(model.part_masses[0].added, 0.001);
  EXPECT_EQ(model.part_masses[1].final_mass, 0.002);
  EXPECT_TRUE(has(messages_with("*ELEMENT_MASS_PART\n1,0.001,0.002\n"), "field FINMASS"));
}

TEST(StepCurve, IsThatOfLctm) {
  const model::Model model = read_with(curve + "*CONTROL_TIMESTEP\n0,0.9,0,0,0,1\n");
  EXPECT_EQ(model.control.step_curve, 0);
}

TEST(LocalHistories, HaveAxesThatStayOrMove) {
  const model::Model model =
      read_with(system +
                "*DEFINE_COORDINATE_NODES\n8,1,2,4\n*SET_NODE_LIST\n4\n5,6\n"
                "*DATABASE_HISTORY_NODE\n1,3\n*DATABASE_HISTORY_NODE_LOCAL\n3,9\n2,8,1\n4\n"
                "*DATABASE_HISTORY_NODE_SET_LOCAL\n4,9\n");
  EXPECT_EQ(model.output.history_nodes, (std::vector<Index>{0, 2, 1, 3, 4, 5}));
  const std::vector<model::NodeAxes>& axes = model.output.history_axes;
  ASSERT_EQ(axes.size(), 4U);
  EXPECT_EQ(axes[0].node, 1);
  EXPECT_EQ(axes[0].moving, (std::array<Index, 3>{0, 1, 3}));
  EXPECT_EQ(axes[1].node, 2);
  EXPECT_EQ(axes[1].moving[0], no_index);
  expect_vector(axes[1].axes[0], {half, half, 0});
  EXPECT_EQ(axes[2].node, 4);
  EXPECT_EQ(axes[3].node, 5);
}

TEST(LocalHistories, HaveBadCards) {
  const auto only = [](const std::string& cards) {
    const std::vector<std::string> found = messages_with(system + cards);
    EXPECT_EQ(found.size(), 1U) << cards;
    return found.empty() ? "" : found[0];
  };
  const auto expect = [&](const std::string& cards, const std::string& text) {
    EXPECT_NE(only("*DATABASE_HISTORY_NODE_LOCAL\n" + cards).find(text), std::string::npos)
        << only("*DATABASE_HISTORY_NODE_LOCAL\n" + cards);
  };
  expect("3,9,1\n", "field REF: read \"1\", expected 0, or a system of *DEFINE_COORDINATE_NODES");
  expect("3,9,2\n", "field REF: read \"2\"");
  expect("3,7\n", "field CID: read \"7\"");
  expect("33,9\n", "field ID: read \"33\"");
  expect("3,9,0,1\n", "warning");
}

TEST(LocalAxes, TurnWithTheFile) {
  SmallDeck deck;
  deck.more = system + curve + "*BOUNDARY_SPC_NODE\n2,9,1\n*LOAD_NODE_POINT\n3,1,1,3,9\n" +
              "*INITIAL_VELOCITY\n0,0,0,0,9\n2,0,0\n*INITIAL_VELOCITY_NODE\n1,1,0,0,0,0,0,9\n";
  const std::string text =
      "*KEYWORD\n*DEFINE_TRANSFORMATION\n9\nROTATE,0,0,1,0,0,0,45\n*INCLUDE_TRANSFORM\npart.k\n0\n\n\n9\n*"
      "END\n";
  const model::Model model = read_clean(text, {}, {{"part.k", deck.text()}});
  ASSERT_EQ(model.local_supports.size() + model.fixed_nodes.size(), 1U);
  ASSERT_EQ(model.nodal_loads.size(), 1U);
  ASSERT_EQ(model.initial_velocities.size(), 6U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(model.nodal_loads[0].force[i], i == 1 ? 3 : 0, 1e-12);
    EXPECT_NEAR(model.initial_velocities[0].velocity[i], i == 1 ? 1 : 0, 1e-12);
    EXPECT_NEAR(model.initial_velocities[1].velocity[i], i == 1 ? 2 : 0, 1e-12);
  }
}

}  // namespace
}  // namespace crumple::deck::test::local_axes_test
