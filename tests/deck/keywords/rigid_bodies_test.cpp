// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies, prescribed motions and body loads in decks.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::rigid_bodies_test {
namespace {

using Axes = std::array<bool, 3>;

/// The small deck with a second part of rigid material: the second shell.
SmallDeck rigid_deck() {
  SmallDeck deck;
  deck.shells =
      "*ELEMENT_SHELL\n"
      "      11       1       1       2       3       4\n"
      "      12       2       2       5       6       3\n";
  deck.part =
      "*PART\nplate\n         1         1         1\n"
      "*PART\nstiff\n         2         1         2\n";
  deck.material +=
      "*MAT_RIGID\n         2   7.83E-6     207.0       0.3\n"
      "       1.0         4         7\n\n"
      "*DEFINE_CURVE\n         1\n                 0.0                 0.0\n"
      "                 3.0                 2.0\n";
  return deck;
}

/// The one message that the rigid deck has with something added.
std::string message_with(const std::string& more) {
  SmallDeck deck = rigid_deck();
  deck.more = more;
  const std::vector<std::string> found = messages_in(deck);
  EXPECT_EQ(found.size(), 1U) << more;
  return found.empty() ? "" : found.front();
}

bool has(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

TEST(RigidBodies, PartOfRigidMaterialIsABodyWithItsConstraints) {
  const model::Model model = read_clean(rigid_deck().text());
  ASSERT_EQ(model.rigid_bodies.size(), 1U);
  const model::RigidBody& body = model.rigid_bodies[0];
  EXPECT_EQ(body.id, 2);
  EXPECT_EQ(body.parts, std::vector<Index>{1});
  EXPECT_EQ(body.nodes, (std::vector<Index>{1, 2, 4, 5}));
  EXPECT_EQ(body.fixed_translation, (Axes{true, true, false}));
  EXPECT_EQ(body.fixed_rotation, (Axes{true, true, true}));
  EXPECT_TRUE(model::is_rigid(model, model.parts[1]));
  EXPECT_FALSE(model::is_rigid(model, model.parts[0]));
}

TEST(RigidBodies, InitialVelocityOfABody) {
  SmallDeck deck = rigid_deck();
  deck.more =
      "*INITIAL_VELOCITY_RIGID_BODY\n2,1,2,3,0.1,0.2,0.3,8\n"
      "*DEFINE_COORDINATE_VECTOR\n8,0,1,0,-1,0,0\n";
  const auto motion = read_clean(deck.text()).rigid_bodies.at(0).initial_motion;
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->velocity, (std::array<double, 3>{-2, 1, 3}));
  EXPECT_EQ(motion->angular_velocity, (std::array<double, 3>{-0.2, 0.1, 0.3}));
  EXPECT_TRUE(has(message_with("*INITIAL_VELOCITY_RIGID_BODY\n1,1\n"), "rigid body 1"));
}

TEST(RigidBodies, RigidPartWithoutElementsIsNoBody) {
  SmallDeck deck = rigid_deck();
  deck.part += "*PART\nempty\n         3         1         2\n";
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
  EXPECT_EQ(result.model->rigid_bodies.size(), 1U);
  EXPECT_TRUE(model::faults(*result.model).empty());
}

TEST(RigidBodies, WithoutCmoNothingIsHeld) {
  SmallDeck deck = rigid_deck();
  deck.material.replace(deck.material.find("       1.0         4"), 20, "       0.0         4");
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.rigid_bodies[0].fixed_translation, (Axes{false, false, false}));
}

SmallDeck locally_held(const std::string& digits, const std::string& system) {
  SmallDeck deck = rigid_deck();
  const std::size_t at = deck.material.find("       1.0         4");
  deck.material.replace(at, deck.material.find('\n', at) - at, "      -1.0         9" + digits);
  deck.more = system;
  return deck;
}

TEST(RigidBodies, AxesOfASystemAreHeld) {
  const std::string points =
      "*DEFINE_COORDINATE_SYSTEM\n         9       1.0       1.0       1.0       1.0       5.0       1.0\n"
      "      -2.0       7.0       1.0\n";
  const std::string vectors =
      "*DEFINE_COORDINATE_VECTOR\n         9       0.0       2.0       0.0      -1.0       1.0\n";
  for (const std::string& system : {points, vectors}) {
    const model::Model model = read_clean(locally_held("    100011", system).text());
    const model::RigidBody& body = model.rigid_bodies.at(0);
    EXPECT_EQ(body.fixed_translation, (Axes{true, false, false})) << system;
    EXPECT_EQ(body.fixed_rotation, (Axes{false, true, true})) << system;
    const std::array<std::array<double, 3>, 3> turned = {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
    EXPECT_EQ(body.held_axes, turned) << system;
  }
}

TEST(RigidBodies, AxesOfThreeNodesAreHeld) {
  // Nodes 1, 4 and 2 of the plate: x is global y or x, as the plate lies.
  const model::Model model = read_clean(
      locally_held("         1", "*DEFINE_COORDINATE_NODES\n         9         1         4         2\n")
          .text());
  const model::RigidBody& body = model.rigid_bodies.at(0);
  EXPECT_EQ(body.fixed_rotation, (Axes{false, false, true}));
  const auto& position = model.nodes.position;
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(
        body.held_axes[0][i] * std::hypot(position[3][0] - position[0][0], position[3][1] - position[0][1]),
        position[3][i] - position[0][i], 1e-14);
  EXPECT_EQ(std::fabs(body.held_axes[2][2]), 1);
}

TEST(RigidBodies, FaultsOfLocalConstraintsAreTold) {
  const std::string line =
      "*DEFINE_COORDINATE_VECTOR\n         9       0.0       2.0       0.0       0.0       1.0\n";
  const std::string plane =
      "*DEFINE_COORDINATE_VECTOR\n         9       0.0       2.0       0.0       1.0       1.0\n";
  EXPECT_TRUE(has(messages_in(locally_held("    100000", "")).at(0), "coordinate system 9"));
  EXPECT_TRUE(has(messages_in(locally_held("    100000", line)).at(0), "on one line"));
  EXPECT_TRUE(has(messages_in(locally_held("    100200", plane)).at(0), "six digits"));
  EXPECT_TRUE(has(messages_in(locally_held("   1000000", plane)).at(0), "six digits"));
  SmallDeck deck = rigid_deck();
  deck.material.replace(deck.material.find("       1.0         4"), 20, "       1.0         8");
  EXPECT_TRUE(has(messages_in(deck).at(0), "0 to 7"));
}

TEST(RigidBodies, MotionOfALocallyHeldBodyIsRefused) {
  const std::string plane =
      "*DEFINE_COORDINATE_VECTOR\n         9       0.0       2.0       0.0       1.0       1.0\n";
  const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n         2         1         0         1\n";
  EXPECT_TRUE(
      has(messages_in(locally_held("    100000", plane + motion)).at(0), "CMO of rigid body 2 is -1"));
}

TEST(RigidBodies, ExtraNodesAndSetsJoinTheBody) {
  SmallDeck deck = rigid_deck();
  deck.more =
      "*CONSTRAINED_EXTRA_NODES_NODE\n         2         1\n"
      "*SET_NODE_LIST\n         7\n         4         3\n"
      "*CONSTRAINED_EXTRA_NODES_SET\n         2         7         1\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.rigid_bodies[0].nodes, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(model.rigid_bodies[0].added_nodes, (std::vector<Index>{2, 3}));
}

TEST(RigidBodies, NodesOfASetAreABody) {
  const model::Model model = read_with(
      "*SET_NODE_LIST\n         7\n         1         4\n"
      "*CONSTRAINED_NODAL_RIGID_BODY\n        70                   7\n");
  ASSERT_EQ(model.rigid_bodies.size(), 1U);
  EXPECT_EQ(model.rigid_bodies[0].id, 70);
  EXPECT_EQ(model.rigid_bodies[0].nodes, (std::vector<Index>{0, 3}));
  EXPECT_TRUE(model.rigid_bodies[0].parts.empty());
}

TEST(RigidBodies, NodalBodyWithConstraintsAndInertia) {
  const model::Model model = read_with(
      "*SET_NODE_LIST\n         7\n         1         4\n"
      "*CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA\n         7\n"
      "       1.0         6         1\n"
      "       1.0       2.0       3.0       4.0\n"
      "       5.0       0.0       0.0       6.0       0.0       7.0\n\n");
  const model::RigidBody& body = model.rigid_bodies.at(0);
  EXPECT_EQ(body.fixed_translation, (Axes{true, false, true}));
  EXPECT_EQ(body.fixed_rotation, (Axes{true, false, false}));
  EXPECT_EQ(body.inertia->mass, 4);
  EXPECT_EQ(body.nodes, (std::vector<Index>{0, 3})) << "the set has the body's number";
}

TEST(RigidBodies, MergedPartsAreOne) {
  SmallDeck deck = rigid_deck();
  deck.part =
      "*PART\nplate\n         1         1         2\n"
      "*PART\nstiff\n         2         1         2\n";
  EXPECT_TRUE(has(messages_in(deck).at(0), "node 2 belongs to the rigid bodies 1 and 2"))
      << messages_in(deck)[0];
  deck.more = "*CONSTRAINED_RIGID_BODIES\n         2         1\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.rigid_bodies.size(), 1U);
  EXPECT_EQ(model.rigid_bodies[0].id, 2);
  EXPECT_EQ(model.rigid_bodies[0].parts, (std::vector<Index>{1, 0}));
  EXPECT_EQ(model.rigid_bodies[0].nodes.size(), 6U);
}

TEST(RigidBodies, GivenInertiaInLocalAxes) {
  SmallDeck deck = rigid_deck();
  deck.part =
      "*PART\nplate\n         1         1         1\n"
      "*PART_INERTIA\nstiff\n         2         1         2\n"
      "       1.0       2.0       3.0       4.0         1         5\n"
      "       5.0       0.0       0.0       6.0       0.0       7.0\n"
      "       0.1       0.2       0.3       0.4       0.5       0.6\n"
      "       0.0       1.0       0.0       0.0       0.0       1.0\n";
  const model::Model model = read_clean(deck.text());
  const auto& inertia = model.rigid_bodies.at(0).inertia;
  ASSERT_TRUE(inertia.has_value());
  EXPECT_EQ(inertia->mass, 4);
  EXPECT_EQ(inertia->centre, (std::array<double, 3>{2, 0, 0})) << "of node 5";
  // Local x is y, local y is z, local z is x.
  EXPECT_EQ(inertia->tensor, (std::array<double, 6>{7, 0, 0, 5, 0, 6}));
  EXPECT_EQ(inertia->velocity, (std::array<double, 3>{0.1, 0.2, 0.3}));
  EXPECT_EQ(inertia->angular_velocity, (std::array<double, 3>{0.4, 0.5, 0.6}));
  EXPECT_FALSE(inertia->velocity_from_nodes);
}

TEST(RigidBodies, GenerationMayReplaceGivenVelocities) {
  SmallDeck deck = rigid_deck();
  deck.part =
      "*PART\nplate\n         1         1         1\n"
      "*PART_INERTIA\nstiff\n         2         1         2\n"
      "       1.0       2.0       3.0       4.0\n"
      "       5.0       0.0       0.0       6.0       0.0       7.0\n"
      "       0.1       0.2       0.3       0.4       0.5       0.6\n";
  deck.more =
      "*INITIAL_VELOCITY_GENERATION\n         2         2       0.0       1.0\n"
      "       0.0       0.0       0.0       0.0       0.0       0.0         0         1\n";
  EXPECT_TRUE(read_clean(deck.text()).rigid_bodies.at(0).inertia->velocity_from_nodes);
}

TEST(RigidBodies, WholeBodiesGetTheVelocitiesOfTheirParts) {
  SmallDeck deck = rigid_deck();
  const std::string tie = "*CONSTRAINED_EXTRA_NODES_NODE\n         2         1\n";
  const std::string velocity = "*INITIAL_VELOCITY_GENERATION\n         2         2       0.0       1.0";
  deck.more = tie + velocity + "\n\n";
  EXPECT_EQ(read_clean(deck.text()).initial_velocities.size(), 4U);
  deck.more = tie + velocity + "                             1\n\n";
  EXPECT_EQ(read_clean(deck.text()).initial_velocities.size(), 5U);
}

TEST(RigidBodies, NodesThatAreHeldHoldTheirBody) {
  SmallDeck deck = rigid_deck();
  deck.material.replace(deck.material.find("       1.0         4"), 20, "       0.0         0");
  // Node 5 by the keyword, node 6 by the codes of *NODE: z, and the rotations about x and y.
  deck.more = "*BOUNDARY_SPC_NODE\n         5         0         1\n";
  const std::string last = "       6             2.0             1.0             0.0";
  deck.nodes.replace(deck.nodes.find(last), last.size(), last + "       3       4");
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model.has_value()) << listed(result.diagnostics);
  const model::RigidBody& body = result.model->rigid_bodies.at(0);
  EXPECT_EQ(body.fixed_translation, (Axes{true, false, true}));
  EXPECT_EQ(body.fixed_rotation, (Axes{true, true, false}));
  EXPECT_TRUE(result.model->fixed_nodes.empty());
  EXPECT_TRUE(has(
      listed(result.diagnostics),
      "warning: *BOUNDARY_SPC_NODE card 1: node 5 belongs to the rigid body 2: its degrees of freedom are "
      "held at the body's centre of mass, as in LS-DYNA after R11.1"));
}

TEST(RigidBodies, EachBodyThatIsHeldIsNamedOnce) {
  SmallDeck deck = rigid_deck();
  deck.material.replace(deck.material.find("       1.0         4"), 20, "       0.0         0");
  deck.part.replace(deck.part.find("         1         1         1"), 30, "         1         1         3");
  deck.material += "*MAT_RIGID\n         3   7.83E-6     207.0       0.3\n\n\n";
  deck.shells =
      "*ELEMENT_SHELL\n"
      "      11       1       1       2       3       4\n"
      "      12       2       5       6       7       8\n";
  deck.nodes +=
      "       7             3.0             1.0             0.0\n"
      "       8             3.0             0.0             0.0\n";
  deck.more =
      "*SET_NODE_LIST\n         1\n         1         2         5         6\n"
      "*BOUNDARY_SPC_SET\n         1         0         1\n";
  std::vector<std::string> held;
  for (const std::string& message : messages_in(deck))
    if (has(message, "degrees of freedom are held at")) held.push_back(message);
  ASSERT_EQ(held.size(), 2U);
  EXPECT_TRUE(has(held[0], "node 1 belongs to the rigid body 1")) << held[0];
  EXPECT_TRUE(has(held[1], "node 5 belongs to the rigid body 2")) << held[1];
}

TEST(RigidBodies, NodesOfBodiesInLocalAxesAreNotHeldInGlobalOnes) {
  SmallDeck deck = rigid_deck();
  deck.material.replace(deck.material.find("       1.0         4         7"), 30,
                        "      -1.0         9    100000");
  deck.more =
      "*DEFINE_COORDINATE_SYSTEM\n9,0,0,0,1,1,0\n-1,1,0\n*BOUNDARY_SPC_NODE\n         5         0         "
      "1\n";
  const std::vector<std::string> found = messages_in(deck);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(has(found[0], "error: *BOUNDARY_SPC_NODE") && has(found[0], "local axes")) << found[0];
}

TEST(RigidBodies, NodesOfBodiesAreNotMovedByThemselves) {
  const std::string moved =
      message_with("*BOUNDARY_PRESCRIBED_MOTION_NODE\n         5         1         0         1\n");
  EXPECT_TRUE(has(moved, "node 5 belongs to the rigid body 2") && has(moved, "_RIGID")) << moved;
}

TEST(RigidBodies, DeformablePartsCannotBeMergedOrTiedTo) {
  EXPECT_TRUE(has(message_with("*CONSTRAINED_RIGID_BODIES\n         2         1\n"), "*MAT_RIGID"));
  EXPECT_TRUE(has(message_with("*CONSTRAINED_EXTRA_NODES_NODE\n         1         4\n"), "*MAT_RIGID"));
}

TEST(PrescribedMotions, OfNodesSetsAndBodies) {
  SmallDeck deck = rigid_deck();
  deck.material.replace(deck.material.find("       1.0         4         7"), 30,
                        "       1.0         4         0");
  deck.more =
      "*SET_NODE_LIST\n         7\n         1         4\n"
      "*BOUNDARY_PRESCRIBED_MOTION_SET\n         7         3         2         1      -2.0\n"
      "*BOUNDARY_PRESCRIBED_MOTION_NODE_ID\n         9a motion\n"
      "         1         6         1         1\n"
      "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n"
      "         2         7         0         1       1.5         0       3.0       0.5\n";
  const model::Model model = read_clean(deck.text());
  using Kind = model::PrescribedMotion::Kind;
  ASSERT_EQ(model.prescribed_motions.size(), 4U);
  const auto& motions = model.prescribed_motions;
  EXPECT_EQ(motions[0].node, 0);
  EXPECT_EQ(motions[1].node, 3);
  EXPECT_EQ(motions[1].axis, 2);
  EXPECT_EQ(motions[1].scale, -2);
  EXPECT_EQ(motions[1].kind, Kind::Displacement);
  EXPECT_FALSE(motions[1].rotation);
  EXPECT_TRUE(motions[2].rotation);
  EXPECT_EQ(motions[2].axis, 1);
  EXPECT_EQ(motions[2].kind, Kind::Acceleration);
  EXPECT_EQ(motions[2].death, 1e28);
  EXPECT_EQ(motions[3].body, 0);
  EXPECT_EQ(motions[3].node, no_index);
  EXPECT_EQ(motions[3].axis, 2);
  EXPECT_EQ(motions[3].birth, 0.5);
  EXPECT_EQ(motions[3].death, 3);
}

TEST(PrescribedMotions, OfBodiesAlongVectorsNeedOneAndHoldNothingAcross) {
  const std::string without =
      message_with("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n         2         4         0         1\n");
  EXPECT_TRUE(has(without, "field VID") && has(without, "*DEFINE_VECTOR")) << without;
  const std::string across = message_with("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,-4,0,1,,7\n");
  EXPECT_TRUE(has(across, "field DOF") && has(across, "nodes alone")) << across;
  const std::string offset = message_with("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,9,0,1\n");
  EXPECT_TRUE(has(offset, "field DOF") && has(offset, "nodes may also go round an axis")) << offset;
}

TEST(MassDamping, IsConstantOrACurveAndOfAllDirectionsUnlessOneIsGiven) {
  SmallDeck deck = rigid_deck();
  deck.more = "*DAMPING_GLOBAL\n         0      12.5\n";
  const model::Model constant = read_clean(deck.text());
  ASSERT_TRUE(constant.mass_damping.has_value());
  EXPECT_EQ(constant.mass_damping->constant, 12.5);
  EXPECT_EQ(constant.mass_damping->curve, no_index);
  EXPECT_EQ(constant.mass_damping->rotation, (std::array<double, 3>{1, 1, 1}));
  deck.more = "*DAMPING_GLOBAL\n         1       0.0       0.0       1.0       0.5\n";
  const model::Model some = read_clean(deck.text());
  ASSERT_TRUE(some.mass_damping.has_value());
  EXPECT_EQ(some.mass_damping->curve, 0);
  EXPECT_EQ(some.mass_damping->translation, (std::array<double, 3>{0, 1, 0.5}));
  EXPECT_EQ(some.mass_damping->rotation, (std::array<double, 3>{}));
  deck.more = "*DAMPING_GLOBAL\n\n";
  EXPECT_FALSE(read_clean(deck.text()).mass_damping.has_value());
}

TEST(DeformableToRigid, PartsAreBodiesForTheWholeRun) {
  SmallDeck deck = rigid_deck();
  deck.more = "*DEFORMABLE_TO_RIGID\n1\n";
  // Both parts have nodes 2 and 3.
  const std::vector<std::string> shared = messages_in(deck);
  ASSERT_EQ(shared.size(), 2U);
  EXPECT_TRUE(has(shared[0], "belongs to the rigid bodies")) << shared[0];
  deck.more = "*DEFORMABLE_TO_RIGID\n1,2,PART\n";
  const model::Model merged = read_clean(deck.text());
  ASSERT_EQ(merged.rigid_bodies.size(), 1U);
  EXPECT_EQ(merged.rigid_bodies[0].id, 2);
  EXPECT_EQ(merged.rigid_bodies[0].parts, (std::vector<Index>{1, 0}));
  EXPECT_EQ(merged.rigid_bodies[0].nodes.size(), 6U);
  ASSERT_EQ(merged.materials.size(), 3U);
  EXPECT_EQ(merged.parts[0].material, 2);
  EXPECT_TRUE(merged.materials[2].rigid);
  EXPECT_EQ(merged.materials[2].density, merged.materials[0].density);
  deck.more = "*SET_PART_LIST\n4\n1,2\n*DEFORMABLE_TO_RIGID\n4,2,PSET\n";
  EXPECT_EQ(read_clean(deck.text()).rigid_bodies.size(), 1U);
  EXPECT_TRUE(has(message_with("*DEFORMABLE_TO_RIGID\n1,2,SET\n"), "expected PART or PSET"));
  EXPECT_TRUE(has(message_with("*DEFORMABLE_TO_RIGID\n9\n"), "the deck has no part 9"));
}

TEST(RelativeDamping, OfPartsAgainstABody) {
  SmallDeck deck = rigid_deck();
  deck.more = "*SET_PART_LIST\n4\n1\n*DAMPING_RELATIVE\n0.05,20,2,4\n0.05,20,2,4,0,1\n0,20,2,4\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.relative_dampings.size(), 2U);
  const model::RelativeDamping& first = model.relative_dampings[0];
  EXPECT_EQ(first.body, 0);
  EXPECT_EQ(first.frequency, 20);
  EXPECT_EQ(first.share, 0.05);
  EXPECT_EQ(first.curve, no_index);
  EXPECT_EQ(first.parts, std::vector<Index>{0});
  EXPECT_EQ(model.relative_dampings[1].curve, 0);
}

TEST(BodyLoads, OnEverythingAndOnBodies) {
  SmallDeck deck = rigid_deck();
  deck.more =
      "*LOAD_BODY_Z\n         1      9.81\n"
      "*LOAD_RIGID_BODY\n         2         2         1       3.0\n         2         7         1       "
      "4.0\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.body_loads.size(), 1U);
  EXPECT_EQ(model.body_loads[0].axis, 2);
  EXPECT_EQ(model.body_loads[0].scale, 9.81);
  ASSERT_EQ(model.rigid_body_loads.size(), 2U);
  EXPECT_EQ(model.rigid_body_loads[0].force[1], 3);
  EXPECT_EQ(model.rigid_body_loads[1].moment[2], 4);
}

}  // namespace
}  // namespace crumple::deck::test::rigid_bodies_test
