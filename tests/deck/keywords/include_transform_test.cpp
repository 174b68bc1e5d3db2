// SPDX-License-Identifier: BSD-3-Clause
// *INCLUDE_TRANSFORM, *DEFINE_TRANSFORMATION, *NODE_TRANSFORM, *INCLUDE_PATH.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../small_deck.hpp"

namespace crumple::deck::test::include_transform_test {
namespace {

/// The offsets are all different, so that a reference of the wrong kind finds nothing.
constexpr const char* offsets =
    "   1000000   2000000   3000000   4000000   5000000   6000000   7000000\n   8000000\n";

/// A deck that includes `part.k` with these offsets and a transformation of these lines.
std::string including(const std::string& lines, const std::string& cards = offsets) {
  std::string text = "*KEYWORD\n";
  if (!lines.empty()) text += "*DEFINE_TRANSFORMATION\n         9\n" + lines;
  return text + "*INCLUDE_TRANSFORM\npart.k\n" + cards + (lines.empty() ? "" : "\n         9\n") + "*END\n";
}

ReadResult read(const std::string& deck, const std::string& part) {
  return read_deck_text(deck, {}, {{"part.k", part}});
}

model::Model model_of(const std::string& deck, const std::string& part) {
  ReadResult result = read(deck, part);
  EXPECT_TRUE(result.model) << listed(result.diagnostics);
  return result.model ? std::move(*result.model) : model::Model{};
}

bool has_error(const ReadResult& result, const std::string& text) {
  for (const Diagnostic& diagnostic : result.diagnostics)
    if (diagnostic.severity == Severity::Error && to_string(diagnostic).find(text) != std::string::npos)
      return true;
  return false;
}

void expect_position(const model::Model& model, std::size_t node, std::array<double, 3> expected) {
  ASSERT_LT(node, model.nodes.position.size());
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(model.nodes.position[node][i], expected[i], 1e-12) << node;
}

/// Cards that refer to every kind of item; all of them stand in the included file.
const char* references =
    "*DEFINE_CURVE\n5\n0,1\n1,1\n"
    "*DEFINE_BOX\n4,-9,9,-9,9,-9,9\n"
    "*DEFINE_COORDINATE_NODES\n6,1,2,4\n"
    "*DEFINE_VECTOR\n7,0,0,0,1,1,0,6\n"
    "*BOUNDARY_SPC_NODE_BIRTH_DEATH\n3,6,0,1,1\n0.1,0.2\n"
    "*BOUNDARY_PRESCRIBED_MOTION_NODE\n4,-4,0,5,1,7\n"
    "*LOAD_NODE_POINT\n6,4,5,1,0,1,2,4\n6,1,5,1,6\n"
    "*LOAD_BODY_RX\n5,0\n*LOAD_BODY_VECTOR\n5,1,0,0,0,0,6\n1,1,0\n*LOAD_BODY_PARTS\n1\n"
    "*LOAD_BODY_GENERALIZED\n1,2,5\n1\n*LOAD_BODY_GENERALIZED_SET_NODE\n2,0,5\n1\n"
    "*LOAD_BODY_GENERALIZED_SET_PART\n1,0,5\n1,0,0,0,0,0,6\n"
    "*LOAD_GRAVITY_PART\n1,3,5,9.81\n*LOAD_GRAVITY_PART_SET\n1,3,5,9.81\n"
    "*DAMPING_PART_MASS\n1,5\n*DAMPING_PART_MASS_SET\n1,5\n*DAMPING_PART_STIFFNESS\n1,0.1\n"
    "*DAMPING_RELATIVE\n0.1,5,2,1,0,5\n*TERMINATION_NODE\n1,1,9\n*TERMINATION_BODY\n2,1,9\n"
    "*TERMINATION_DELETED_SHELLS_SET\n1\n"
    "*ELEMENT_MASS_PART\n       1           0.001\n*ELEMENT_MASS_PART_SET\n       1           0.001\n"
    "*CONTROL_TIMESTEP\n0,0.9,0,0,0,5\n"
    "*DEFINE_SD_ORIENTATION\n8,0,1,0,0\n"
    "*SET_NODE_LIST\n1\n1,2\n"
    "*SET_NODE_LIST_GENERATE\n2\n1,4\n"
    "*SET_NODE_GENERAL\n3\nPART,1\nBOX,4\nNODE,5\n"
    "*SET_NODE_ADD\n4\n1,-3\n"
    "*SET_PART_LIST\n1\n1\n"
    "*SET_PART_GENERAL\n2\nPART,1\nSET,1\n"
    "*SET_SHELL_LIST\n1\n11\n"
    "*SET_SHELL_GENERAL\n2\nELEM,11,12\nPART,1\n"
    "*SET_SEGMENT\n1\n1,2,3,4\n"
    "*SET_SEGMENT_GENERAL\n2\nSEG,1,2,3,4\nPART,1\nSET,1\nSET_SHELL,1\n"
    "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n"
    "*BOUNDARY_SPC_SET\n1,0,0,0,1\n"
    "*BOUNDARY_PRESCRIBED_MOTION_NODE\n6,1,0,5\n"
    "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,0,5\n"
    "*INITIAL_VELOCITY\n4,1\n1,0,0\n0,0,0\n"
    "*INITIAL_VELOCITY_NODE\n5,1,0,0\n"
    "*INITIAL_VELOCITY_GENERATION\n1,2,0,1,0,0\n\n2,1,0,1,0,0\n\n2,3,0,1,0,0\n\n"
    "*LOAD_NODE_POINT\n6,1,5\n"
    "*LOAD_NODE_SET\n2,1,5\n"
    "*LOAD_SEGMENT\n5,1,0,1,2,3,4\n"
    "*LOAD_SEGMENT_SET\n2,5\n"
    "*LOAD_SHELL_ELEMENT\n12,5\n"
    "*LOAD_SHELL_SET\n2,5\n"
    "*LOAD_BODY_Z\n5,0\n"
    "*RIGIDWALL_PLANAR_ID\n3\n2,1,4\n0,0,-1,0,0,1\n"
    "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n2\n2,0,2,0,4\n\n\n"
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,1\n\n\n"
    "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n2,2,4,0\n\n\n"
    "*DATABASE_HISTORY_NODE\n1,2\n"
    "*DATABASE_HISTORY_NODE_SET\n2\n"
    "*DATABASE_HISTORY_SHELL\n11\n"
    "*DATABASE_HISTORY_SHELL_ID\n12,edge\n"
    "*DATABASE_CROSS_SECTION_SET\n1,0,0,2\n"
    "*DATABASE_CROSS_SECTION_PLANE_ID\n7\n1,1,0,0,2,0,0\n\n"
    "*ELEMENT_MASS\n      91       5           0.001\n"
    "*ELEMENT_MASS_NODE_SET\n      92       2           0.001\n"
    "*HOURGLASS\n7,4\n"
    "*PART\nrigid\n2,1,2\n*MAT_RIGID\n2,7.83E-6,207,0.3\n-1,6,111111\n\n"
    "*NODE\n31,5,0,0\n32,6,0,0\n33,6,1,0\n34,5,1,0\n35,5,0,1\n36,6,0,1\n"
    "*ELEMENT_SHELL\n      13       2      31      32      33      34\n"
    "*CONSTRAINED_EXTRA_NODES_NODE\n2,35\n"
    "*SET_NODE_LIST\n5\n36\n*CONSTRAINED_EXTRA_NODES_SET\n2,5\n"
    "*LOAD_RIGID_BODY\n2,3,5\n"
    "*PART\nspring\n3,3,3\n*SECTION_DISCRETE\n3\n\n*MAT_SPRING_NONLINEAR_ELASTIC\n3,7\n"
    "*DEFINE_CURVE\n7\n-1,-1\n1,1\n"
    "*ELEMENT_DISCRETE\n      71       3       3       6       8\n";

TEST(IncludeTransform, GivesEveryIdTheOffsetOfItsKind) {
  SmallDeck deck;
  deck.part = "*PART\nplate\n1,1,1,0,7\n";
  deck.more = references;
  const model::Model plain = model_of("*KEYWORD\n*INCLUDE\npart.k\n*END\n", deck.text());
  const model::Model moved = model_of(including(""), deck.text());
  ASSERT_EQ(moved.nodes.position.size(), plain.nodes.position.size());
  EXPECT_EQ(moved.nodes.id.at(0), 1000001);
  EXPECT_EQ(moved.shells.at(0).id, 2000011);
  EXPECT_EQ(moved.parts.at(0).id, 3000001);
  EXPECT_EQ(moved.materials.at(0).id, 4000001);
  EXPECT_EQ(moved.rigid_walls.at(0).id, 3000003);
  EXPECT_EQ(moved.contacts.at(0).id, 8000002);
  EXPECT_EQ(moved.shell_sections.at(0).id, 8000001);
  EXPECT_EQ(moved.contacts.size(), plain.contacts.size());
  EXPECT_EQ(moved.nodal_loads.size(), plain.nodal_loads.size());
  EXPECT_EQ(moved.shells.at(1).node, plain.shells.at(1).node);
}

TEST(IncludeTransform, OffsetsAndPlacesOfNestedFilesAddUp) {
  SmallDeck deck;
  const std::string outer =
      "*KEYWORD\n*DEFINE_TRANSFORMATION\n9\nTRANSL,100,0,0\n*INCLUDE_TRANSFORM\ninner.k\n1000,0,0,0,0,0,"
      "10\n0\n\n"
      "9\n" +
      deck.termination;
  const std::string inner =
      "*DEFINE_TRANSFORMATION\n9\nROTATE,0,0,1,0,0,0,90\n*INCLUDE_TRANSFORM\npart.k\n200,0,0,0,0,0,"
      "0\n0\n\n9\n";
  deck.termination.clear();
  const ReadResult result = read_deck_text(outer, {}, {{"inner.k", inner}, {"part.k", deck.text()}});
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_EQ(result.model->nodes.id.at(1), 1202);
  // Node 2 at x = 1: turned by the inner file, then shifted by the outer one.
  expect_position(*result.model, 1, {100, 1, 0});
}

TEST(IncludeTransform, TheFirstLineActsFirst) {
  const std::string part = SmallDeck().text();
  expect_position(model_of(including("SCALE,2,2,2\nROTATE,0,0,1,0,0,0,90\nTRANSL,10,0,0\n"), part), 1,
                  {10, 2, 0});
  expect_position(model_of(including("TRANSL,10,0,0\nROTATE,0,0,1,0,0,0,90\nSCALE,2,2,2\n"), part), 1,
                  {0, 22, 0});
}

TEST(IncludeTransform, RotatesAboutTwoPoints) {
  const std::string lines = "POINT,1,1,0,0\nPOINT,2,1,0,5\nROTATE,1,2,90\n";
  expect_position(model_of(including(lines), SmallDeck().text()), 4, {1, 1, 0});
}

TEST(IncludeTransform, PlacesThreePointsOnThreeOthers) {
  const std::string lines =
      "POINT,1,0,0,0\nPOINT,2,2,0,0\nPOINT,3,0,1,0\nPOINT,4,7,0,0\nPOINT,5,7,0,9\nPOINT,6,8,0,0\n"
      "POS6P,1,2,3,4,5,6\n";
  const model::Model model = model_of(including(lines), SmallDeck().text());
  expect_position(model, 0, {7, 0, 0});
  expect_position(model, 1, {7, 0, 1});
  expect_position(model, 2, {8, 0, 1});
}

TEST(IncludeTransform, MirroredShellsKeepTheirSideAndSolidsTheirVolume) {
  const model::Model shells = model_of(including("MIRROR,0,0,0,1,0,0\n"), SmallDeck().text());
  expect_position(shells, 1, {-1, 0, 0});
  EXPECT_EQ(shells.shells.at(0).node, (std::array<Index, 4>{1, 0, 3, 2}));
  const model::Model cube = model_of(including("MIRROR,0,0,0,0,0,1\n"), CubeDeck().text());
  EXPECT_EQ(cube.solids.size(), 1U);
}

TEST(IncludeTransform, MovesWallsAndTurnsVelocitiesWithAWarning) {
  SmallDeck deck;
  deck.more = "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1\n*INITIAL_VELOCITY\n\n3,0,0\n";
  const ReadResult result = read(including("ROTATE,0,1,0,0,0,0,90\n"), deck.text());
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  const model::RigidWall& wall = result.model->rigid_walls.at(0);
  EXPECT_NEAR(wall.point[0], -1, 1e-12);
  EXPECT_NEAR(wall.normal[0], 1, 1e-12);
  ASSERT_FALSE(result.model->initial_velocities.empty());
  EXPECT_NEAR(result.model->initial_velocities.at(0).velocity[2], -3, 1e-12);
  EXPECT_NE(listed(result.diagnostics).find("it turns with the transformation"), std::string::npos);
}

TEST(IncludeTransform, RefusesWhatCannotBePlaced) {
  SmallDeck deck;
  deck.more = "*DEFINE_BOX\n4,-9,9,-9,9,-9,9\n";
  EXPECT_TRUE(has_error(read(including("ROTATE,0,0,1,0,0,0,30\n"), deck.text()), "boxes have their sides"));
  EXPECT_TRUE(read(including("TRANSL,1,2,3\n"), deck.text()).model);
  deck.more = "*RIGIDWALL_GEOMETRIC_SPHERE\n\n0,0,-9,0,0,0\n1\n";
  EXPECT_TRUE(has_error(read(including("SCALE,2,2,2\n"), deck.text()), "does not scale this length"));
}

TEST(IncludeTransform, TheSetOfANodalRigidBodyHasTheNumberOfTheFile) {
  SmallDeck deck;
  deck.more = "*SET_NODE_LIST\n1\n5,6\n*CONSTRAINED_NODAL_RIGID_BODY\n1\n";
  deck.part = "*PART\nplate\n2,1,1\n";
  deck.shells =
      "*ELEMENT_SHELL\n      11       2       1       2       3       4\n      12       2       2       5    "
      "   6 "
      "      3\n";
  EXPECT_EQ(model_of(including(""), deck.text()).rigid_bodies.size(), 1U);
}

TEST(IncludeTransform, MovesTheAxisThatNodesGoRound) {
  SmallDeck deck;
  deck.more = "*DEFINE_CURVE\n1\n0,0\n1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,10,0,1\n0.5,-0.25\n";
  const model::Model model = model_of(including("TRANSL,10,20,30\n"), deck.text());
  ASSERT_EQ(model.prescribed_motions.size(), 1U);
  EXPECT_EQ(model.prescribed_motions[0].centre, (std::array<double, 3>{9.75, 20, 30.5}));
}

TEST(IncludeTransform, UnitsAreRefused) {
  const std::string cards = std::string(offsets) + "1,1,0.001\n";
  EXPECT_TRUE(read(including("", std::string(offsets) + "1,0,1.0\n"), SmallDeck().text()).model);
  EXPECT_TRUE(
      has_error(read(including("", cards), SmallDeck().text()), "FCTLEN: read \"0.001\", expected 1"));
}

TEST(IncludeTransform, ItsTransformationMustBeDefinedBefore) {
  const std::string deck =
      "*KEYWORD\n*INCLUDE_TRANSFORM\npart.k\n\n\n\n9\n*DEFINE_TRANSFORMATION\n9\nTRANSL,1\n*END\n";
  EXPECT_TRUE(
      has_error(read(deck, SmallDeck().text()), "TRANID: read \"9\", expected the id of a transformation"));
}

TEST(IncludeTransform, NumbersStayInTheirRange) {
  const std::string far = "*NODE_TRANSFORM\n9,1\n*SET_NODE_LIST_GENERATE\n1\n1,9000000000000000000\n";
  SmallDeck deck;
  deck.more = "*DEFINE_TRANSFORMATION\n9\nSCALE,1E308,1,1\nSCALE,1E308,1,1\n" + far;
  EXPECT_TRUE(has_error(read_deck_text(deck.text()), "out of the range of numbers"));
  EXPECT_TRUE(has_error(read(including("SCALE,1E308,1,1\nSCALE,1E308,1,1\n"), SmallDeck().text()),
                        "out of the range of numbers"));
  EXPECT_TRUE(has_error(read(including("", "-5\n0\n"), SmallDeck().text()), "IDNOFF: read \"-5\""));
}

TEST(NodeTransform, MovesTheNodesOfAListedSet) {
  SmallDeck deck;
  deck.more =
      "*DEFINE_TRANSFORMATION\n9\nTRANSL,0,0,3\n*SET_NODE_LIST\n1\n5\n*SET_NODE_LIST_GENERATE\n2\n6,6\n"
      "*SET_NODE_ADD\n3\n1,2\n*NODE_TRANSFORM\n9,3\n";
  const model::Model model = read_clean(deck.text());
  expect_position(model, 4, {2, 0, 3});
  expect_position(model, 5, {2, 1, 3});
  expect_position(model, 3, {0, 1, 0});
}

TEST(IncludePath, FoldersAreSearchedInOrder) {
  SmallDeck deck;
  const std::map<std::string, std::string> files = {{"lib/nodes.k", deck.nodes},
                                                    {"mesh/shells.k", deck.shells}};
  deck.nodes = "*INCLUDE_PATH\nlib\nme +\nsh\n*INCLUDE\nnodes.k\nshells.k\n";
  deck.shells.clear();
  EXPECT_EQ(read_clean(deck.text(), {}, files).shells.size(), 2U);
}

TEST(IncludePath, RelativeToTheFileOnDisk) {
  const ReadResult result = read_deck("tests/deck/good/include_path.k");
  ASSERT_TRUE(result.model) << listed(result.diagnostics);
  EXPECT_EQ(result.model->shells.size(), 2U);
}

// Whether TRANSL moves the points differs from code to code.
TEST(IncludeTransform, PointsAreTakenBeforeAllLinesThatMove) {
  const std::string points = "POINT,1,0,0,0\nPOINT,2,0,0,1\n";
  const ReadResult result = read(including(points + "TRANSL,100,0,0\nROTATE,1,2,90\n"), SmallDeck().text());
  EXPECT_TRUE(has_error(result, "differs from code to code")) << listed(result.diagnostics);
  expect_position(model_of(including(points + "ROTATE,1,2,90\nTRANSL,100,0,0\n"), SmallDeck().text()), 1,
                  {100, 1, 0});
}

TEST(IncludeTransform, PointsOnALineButForRoundingSpanNoPlane) {
  const std::string lines =
      "POINT,1,0,0,0\nPOINT,2,0.1,0.2,0.3\nPOINT,3,0.3,0.6,0.9\nPOINT,4,0,0,0\nPOINT,5,1,0,0\nPOINT,6,0,1,0\n"
      "POS6P,1,2,3,4,5,6\n";
  EXPECT_TRUE(has_error(read(including(lines), SmallDeck().text()), "they lie on one line"));
}

TEST(IncludeTransform, AnAngleOfZeroTurnsNothing) {
  expect_position(model_of(including("ROTATE,0,0,1,0,0,0,0\n"), SmallDeck().text()), 1, {1, 0, 0});
}

TEST(IncludeTransform, HalfATurnKeepsBoxes) {
  SmallDeck deck;
  deck.more = "*DEFINE_BOX\n4,0.5,9,-9,9,-9,9\n*SET_NODE_GENERAL\n3\nBOX,4\n";
  const model::Model model = model_of(including("ROTATE,0,0,1,0,0,0,180\n"), deck.text());
  const model::Model straight = model_of(including(""), deck.text());
  ASSERT_EQ(model.node_sets.size(), 1U);
  EXPECT_FALSE(model.node_sets[0].nodes.empty());
  EXPECT_EQ(model.node_sets[0].nodes, straight.node_sets.at(0).nodes);
}

// The codes of CON1 and CON2 name global axes, which do not turn; digits for a system of the file do.
TEST(IncludeTransform, RigidBodiesHeldAlongGlobalAxesAreNamedWhereTheFileTurns) {
  SmallDeck deck;
  deck.material = "*MAT_RIGID\n1,7.83E-6,207.0,0.3\n1.0,4,7\n\n";
  const std::string warning = "the global axes are taken";
  EXPECT_NE(listed(read(including("ROTATE,0,0,1,0,0,0,90\n"), deck.text()).diagnostics).find(warning),
            std::string::npos);
  EXPECT_EQ(listed(read(including("TRANSL,1,0,0\n"), deck.text()).diagnostics).find(warning),
            std::string::npos);
}

TEST(IncludeTransform, WhatIsHeldAlongAllAxesNeedsNoWarning) {
  SmallDeck deck;
  deck.material = "*MAT_RIGID\n1,7.83E-6,207.0,0.3\n1.0,7,7\n\n";
  deck.more = "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n2,0,1,1,1,1,1,1\n";
  const std::string turned = including("ROTATE,0,0,1,0,0,0,90\n");
  const std::string warning = "the global axes are taken";
  EXPECT_EQ(listed(read(turned, deck.text()).diagnostics).find(warning), std::string::npos);
  deck.more = "*BOUNDARY_SPC_NODE\n1,0,1,1,0\n";
  EXPECT_NE(listed(read(turned, deck.text()).diagnostics).find(warning), std::string::npos);
}

// The system turns with the file, and with it what is given along its axes: not twice.
TEST(IncludeTransform, VelocitiesOfARigidBodyAlongASystemTurnOnce) {
  SmallDeck deck;
  deck.material = "*MAT_RIGID\n1,7.83E-6,207.0,0.3\n\n\n";
  deck.more =
      "*DEFINE_COORDINATE_VECTOR\n2,0,1,0,-1,0,0\n*INITIAL_VELOCITY_RIGID_BODY\n1,1.0,2.0,3.0,0.7,0,1.5,2\n";
  const model::Model model = model_of(including("ROTATE,0,0,1,0,0,0,90\n"), deck.text());
  ASSERT_EQ(model.rigid_bodies.size(), 1U);
  ASSERT_TRUE(model.rigid_bodies[0].initial_motion);
  const model::RigidMotion& motion = *model.rigid_bodies[0].initial_motion;
  // Half a turn in all.
  const std::array<double, 3> velocity = {-1, -2, 3};
  const std::array<double, 3> spin = {-0.7, 0, 1.5};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(motion.velocity[i], velocity[i], 1e-12) << i;
    EXPECT_NEAR(motion.angular_velocity[i], spin[i], 1e-12) << i;
  }
}

TEST(IncludeTransform, AMirroredSystemIsNamedBecauseItStaysRightHanded) {
  SmallDeck deck;
  deck.more = "*DEFINE_COORDINATE_VECTOR\n2,0,1,0,-1,0,0\n";
  const std::string warning = "its axes stay right-handed";
  EXPECT_NE(listed(read(including("MIRROR,0,0,0,1,0,0\n"), deck.text()).diagnostics).find(warning),
            std::string::npos);
  EXPECT_EQ(listed(read(including("ROTATE,0,0,1,0,0,0,90\n"), deck.text()).diagnostics).find(warning),
            std::string::npos);
}

// NX = -999 means two nodes; so does a parameter of that value, which a transformation must not turn.
TEST(IncludeTransform, AnAxisByTwoNodesIsRefusedInAnyForm) {
  SmallDeck deck;
  for (const char* nx : {"-999", "-999.0", "&axis"}) {
    deck.more = "*PARAMETER\nI axis,-999\n*INITIAL_VELOCITY_GENERATION\n1,2,1.0,0,0,0\n0,0,0," +
                std::string(nx) + ",0,1\n";
    const ReadResult result = read(including("ROTATE,0,0,1,0,0,0,90\n"), deck.text());
    EXPECT_TRUE(has_error(result, "an axis through two nodes")) << nx << listed(result.diagnostics);
  }
}

TEST(IncludeTransform, ANameMustEnd) {
  const ReadResult result = read_deck_text("*KEYWORD\n*INCLUDE_TRANSFORM\npart +\n*END\n");
  EXPECT_TRUE(has_error(result, "there is no other line")) << listed(result.diagnostics);
}

// 8^12 members if each were followed again.
TEST(NodeTransform, ReadsNestedSetsOnce) {
  std::string sets = "*SET_NODE_LIST\n1\n1\n";
  for (int level = 2; level <= 13; ++level) {
    sets += "*SET_NODE_ADD\n" + std::to_string(level) + "\n";
    for (int i = 0; i < 8; ++i) sets += (i > 0 ? "," : "") + std::to_string(level - 1);
    sets += "\n";
  }
  const model::Model model =
      read_with("*DEFINE_TRANSFORMATION\n9\nTRANSL,0,0,0.1\n" + sets + "*NODE_TRANSFORM\n9,13\n");
  expect_position(model, 0, {0, 0, 0.1});
}

}  // namespace
}  // namespace crumple::deck::test::include_transform_test
