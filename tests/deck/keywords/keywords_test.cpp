// SPDX-License-Identifier: BSD-3-Clause
// What each keyword puts into the model; those of the run are in control/control_test.cpp.
#include <algorithm>

#include "deck/keywords/keywords.hpp"
#include "deck/small_deck.hpp"

namespace crumple::deck::test::keywords_test {
namespace {

using Vector = std::array<double, 3>;

TEST(Section, TrapezoidalRuleAndPlaceOfTheNodes) {
  SmallDeck deck;
  deck.section =
      "*SECTION_SHELL\n         1         2       1.0        15         0         1\n"
      "       0.1       0.1       0.1       0.1       1.0\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.shell_sections[0].thickness_points, 15);
  EXPECT_EQ(model.shell_sections[0].thickness_rule, model::ThicknessRule::Trapezoid);
  EXPECT_EQ(model.shell_sections[0].node_place, 1.0);
}

/// Names that older decks have are those of the same readers.
TEST(Keyword, OldSpellings) {
  const auto is_same = [](const char* old, const char* now) {
    const auto first = find_keyword(old);
    const auto second = find_keyword(now);
    return first && second && first->keyword->read == second->keyword->read &&
           first->heading == second->heading;
  };
  EXPECT_TRUE(is_same("DEFINE_COORDINATE_NODE_TITLE", "DEFINE_COORDINATE_NODES_TITLE"));
  EXPECT_TRUE(is_same("BOUNDARY_PRESCRIBED_MOTION_NODES_ID", "BOUNDARY_PRESCRIBED_MOTION_NODE_ID"));
  EXPECT_TRUE(is_same("CONTROL_DAMPING", "CONTROL_DYNAMIC_RELAXATION"));
}

TEST(Part, HourglassAndTitles) {
  SmallDeck deck;
  deck.part = "*PART\nfirst\n1,1,1,0,7\nsecond\n2,1,1\n";
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,4\n12,2,2,5,6,3\n";
  deck.more =
      "*HOURGLASS_TITLE\nstiff\n         7         5      0.05         0         0         0      0.02\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.parts.size(), 2U);
  EXPECT_EQ(model.parts[1].title, "second");
  EXPECT_EQ(model.parts[0].hourglass, 0);
  EXPECT_EQ(model.parts[1].hourglass, no_index);
  EXPECT_EQ(model.hourglass_controls[0].form, model::HourglassForm::Stiffness);
  EXPECT_EQ(model.hourglass_controls[0].coefficient, 0.05);
  EXPECT_EQ(model.hourglass_controls[0].bending, 0.02);
  EXPECT_EQ(model.hourglass_controls[0].warping, 0.02);
}

TEST(Section, ThicknessOfEveryNode) {
  SmallDeck deck;
  deck.section =
      "*SECTION_SHELL_TITLE\nthin\n         1         1\n       0.1       0.2       0.3       0.4\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.shell_sections[0].title, "thin");
  EXPECT_EQ(model.shell_sections[0].formulation, model::ShellFormulation::HughesLiu);
  EXPECT_EQ(model.shell_sections[0].thickness, (std::array<double, 4>{0.1, 0.2, 0.3, 0.4}));
}

TEST(Element, TrianglesByRepeatedOrMissingFourthNode) {
  SmallDeck deck;
  deck.shells = "*ELEMENT_SHELL\n11,1,1,2,3,3\n12,1,2,5,6,0\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.shells[0].node, (std::array<Index, 4>{0, 1, 2, 2}));
  EXPECT_EQ(model.shells[1].node, (std::array<Index, 4>{1, 4, 5, 5}));
}

TEST(Element, ThicknessOfItsOwn) {
  SmallDeck deck;
  deck.section = "*SECTION_SHELL\n         1         2\n       0.5\n";
  deck.shells =
      "*ELEMENT_SHELL_THICKNESS\n"
      "      11       1       1       2       3       4\n"
      "             0.1             0.2             0.0             0.4\n"
      "12,1,2,5,6,3\n"
      "\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.shells[0].thickness, (std::array<double, 4>{0.1, 0.2, 0.5, 0.4}));
  EXPECT_EQ(shell_thickness(model, model.shells[1]), (std::array<double, 4>{0.5, 0.5, 0.5, 0.5}));
}

TEST(Element, MassOfANodeAndOfEveryNodeOfASet) {
  const model::Model model = read_with(
      "*ELEMENT_MASS\n       1       4           100.0       1\n"
      "*ELEMENT_MASS_NODE_SET\n       2       8             5.0\n"
      "*SET_NODE_LIST\n         8\n         1         6         1\n");
  ASSERT_EQ(model.lumped_masses.size(), 3U);
  EXPECT_EQ(model.lumped_masses[0].node, 3);
  EXPECT_EQ(model.lumped_masses[0].mass, 100.0);
  EXPECT_EQ(model.lumped_masses[1].node, 0);
  EXPECT_EQ(model.lumped_masses[2].node, 5);
  EXPECT_EQ(model.lumped_masses[2].mass, 5.0);
}

model::Material material_of(const std::string& text) {
  SmallDeck deck;
  deck.material = text;
  return read_clean(deck.text()).materials.at(0);
}

TEST(Material, NamesNumbersAndTitles) {
  for (const char* name : {"*MAT_ELASTIC\n", "*MAT_001\n", "*MAT_1\n", "*MAT_ELASTIC_TITLE\nsteel\n",
                           "*mat_01_title\nsteel\n"}) {
    const model::Material material = material_of(std::string(name) + "1,7.83E-6,207,0.3\n");
    EXPECT_EQ(std::get<model::Elastic>(material.law).poissons_ratio, 0.3) << name;
    EXPECT_EQ(material.title, std::string(name).find("steel") == std::string::npos ? "" : "steel");
  }
}

TEST(Material, SeveralUnderOneKeyword) {
  SmallDeck deck;
  deck.material = "*MAT_PLASTIC_KINEMATIC\n1,7.83E-6,207,0.3,0.2\n\n2,7.83E-6,70,0.3,0.1\n\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(std::get<model::PlasticKinematic>(model.materials[1].law).yield_stress, 0.1);
}

TEST(Material, PlasticKinematic) {
  const model::Material material = material_of(
      "*MAT_PLASTIC_KINEMATIC\n"
      "         1   7.83E-6     207.0       0.3       0.2       2.0       0.5\n"
      "      40.0       5.0      0.75       0.0\n");
  const auto& law = std::get<model::PlasticKinematic>(material.law);
  EXPECT_EQ(law.youngs_modulus, 207.0);
  EXPECT_EQ(law.yield_stress, 0.2);
  EXPECT_EQ(law.tangent_modulus, 2.0);
  EXPECT_EQ(law.isotropic_fraction, 0.5);
  EXPECT_EQ(law.cowper_symonds_rate, 40.0);
  EXPECT_EQ(law.cowper_symonds_exponent, 5.0);
  EXPECT_EQ(law.failure_strain, 0.75);
}

TEST(Material, PiecewiseFromTangentModulus) {
  const model::Material material = material_of("*MAT_024\n1,7.83E-6,200,0.3,0.25,2.0,1.0E21\n40,5\n\n\n");
  const auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  ASSERT_EQ(law.plastic_strain.size(), 2U);
  EXPECT_EQ(law.plastic_strain[0], 0.0);
  EXPECT_EQ(law.yield_stress[0], 0.25);
  // Plastic modulus E Et / (E - Et).
  const double slope = (law.yield_stress[1] - law.yield_stress[0]) / law.plastic_strain[1];
  EXPECT_NEAR(slope, 200.0 * 2.0 / 198.0, 1e-12);
  EXPECT_EQ(law.failure_strain, 0.0);
  EXPECT_EQ(law.cowper_symonds_rate, 40.0);
}

TEST(Material, PiecewiseFromPoints) {
  const model::Material material =
      material_of("*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,7.83E-6,200,0.3\n\n0.0,0.1,0.2\n0.3,0.4,0.45\n");
  const auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  // Continued with its last slope, 0.5 per unit strain.
  EXPECT_EQ(law.plastic_strain, (std::vector<double>{0.0, 0.1, 0.2, 10.0}));
  ASSERT_EQ(law.yield_stress.size(), 4U);
  EXPECT_NEAR(law.yield_stress[3], 0.45 + 0.5 * 9.8, 1e-12);
}

TEST(Material, PiecewiseFromCurveWithScale) {
  const model::Material material = material_of(
      "*MAT_024\n1,7.83E-6,200,0.3\n0,0,5\n\n\n"
      "*DEFINE_CURVE_TITLE\nhardening\n         5         0       0.5       2.0       0.2       0.1\n"
      "                -0.2                 0.0\n"
      "0.2,0.2\n");
  const auto& law = std::get<model::PiecewiseLinearPlasticity>(material.law);
  // Abscissa 0.5 (a + 0.2), ordinate 2 (o + 0.1).
  ASSERT_GE(law.plastic_strain.size(), 2U);
  EXPECT_EQ(law.plastic_strain[0], 0.0);
  EXPECT_NEAR(law.yield_stress[0], 0.2, 1e-15);
  EXPECT_NEAR(law.plastic_strain[1], 0.2, 1e-15);
  EXPECT_NEAR(law.yield_stress[1], 0.6, 1e-15);
}

TEST(Sets, ListsAndRanges) {
  const model::Model model = read_with(
      "*SET_NODE_LIST_TITLE\nsome\n         3       0.0       0.0       0.0       0.0MECH\n         4        "
      " 2\n         6\n"
      "*SET_NODE\n4\n1,2,3\n"
      "*SET_NODE_LIST_GENERATE\n5\n2,4,6,9\n"
      "*SET_PART_LIST\n         6\n         1\n");
  ASSERT_EQ(model.node_sets.size(), 3U);
  EXPECT_EQ(model.node_sets[0].title, "some");
  EXPECT_EQ(model.node_sets[0].nodes, (std::vector<Index>{3, 1, 5}));
  EXPECT_EQ(model.node_sets[1].nodes, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(model.node_sets[2].nodes, (std::vector<Index>{1, 2, 3, 5}));
  ASSERT_EQ(model.part_sets.size(), 1U);
  EXPECT_EQ(model.part_sets[0].parts, (std::vector<Index>{0}));
}

TEST(Fixed, CodesOfNodesAndSpcTogether) {
  SmallDeck deck;
  deck.nodes = "*NODE\n1,0,0,0,4,6\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,2,0,0\n6,2,1,0\n";
  deck.more =
      "*BOUNDARY_SPC_NODE\n         1         0         0         0         1         0         0         0\n"
      "*BOUNDARY_SPC_SET_ID\n        12symmetry\n         3         0         1         0         0         "
      "0         1         1\n"
      "*SET_NODE_LIST\n         3\n         2\n";
  const model::Model model = read_clean(deck.text());
  ASSERT_EQ(model.fixed_nodes.size(), 2U);
  EXPECT_EQ(model.fixed_nodes[0].node, 0);
  EXPECT_EQ(model.fixed_nodes[0].translation, (std::array<bool, 3>{true, true, true}));
  EXPECT_EQ(model.fixed_nodes[0].rotation, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(model.fixed_nodes[1].translation, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(model.fixed_nodes[1].rotation, (std::array<bool, 3>{false, true, true}));
}

TEST(Velocity, AllButTheExemptOnes) {
  const model::Model model = read_with(
      "*INITIAL_VELOCITY\n         0         2\n       1.0       2.0       3.0\n       0.0       0.0       "
      "9.0\n"
      "*SET_NODE_LIST\n         2\n         6\n");
  ASSERT_EQ(model.initial_velocities.size(), 6U);
  EXPECT_EQ(model.initial_velocities[0].velocity, (Vector{1, 2, 3}));
  EXPECT_EQ(model.initial_velocities[5].velocity, (Vector{0, 0, 9}));
}

TEST(Velocity, OfNodesCountsLast) {
  const model::Model model = read_with(
      "*INITIAL_VELOCITY_NODE\n2,7,0,0,0,0,1.5\n"
      "*INITIAL_VELOCITY\n         2\n       1.0\n"
      "*SET_NODE_LIST\n         2\n         2         3\n");
  ASSERT_EQ(model.initial_velocities.size(), 2U);
  EXPECT_EQ(model.initial_velocities[0].velocity, (Vector{7, 0, 0}));
  EXPECT_EQ(model.initial_velocities[0].angular_velocity, (Vector{0, 0, 1.5}));
  EXPECT_EQ(model.initial_velocities[1].velocity, (Vector{1, 0, 0}));
}

TEST(Velocity, GenerationTurnsAboutAnAxis) {
  const model::Model model = read_with(
      "*INITIAL_VELOCITY_GENERATION\n         1         2       2.0       0.0       0.0       5.0\n"
      "       1.0       0.0       0.0       0.0       0.0       4.0\n");
  ASSERT_EQ(model.initial_velocities.size(), 6U);
  // Node 6 is at (1, 1, 0) from the axis through (1, 0, 0) along z: v = 2 e_z x r + 5 e_z.
  EXPECT_EQ(model.initial_velocities[5].velocity, (Vector{-2, 2, 5}));
  EXPECT_EQ(model.initial_velocities[5].angular_velocity, (Vector{0, 0, 2}));
}

TEST(Wall, PlaneAndNodes) {
  const model::Model model = read_with(
      "*RIGIDWALL_PLANAR_ID\n        21front\n         0         4\n"
      "       3.0       0.0       0.0       1.0       0.0       0.0       0.3\n"
      "*SET_NODE_LIST\n         4\n         1\n");
  ASSERT_EQ(model.rigid_walls.size(), 1U);
  const model::RigidWall& wall = model.rigid_walls[0];
  EXPECT_EQ(wall.id, 21);
  EXPECT_EQ(wall.title, "front");
  EXPECT_EQ(wall.nodes, (std::vector<Index>{1, 2, 3, 4, 5}));
  EXPECT_EQ(wall.point, (Vector{3, 0, 0}));
  EXPECT_EQ(wall.normal, (Vector{-1, 0, 0}));
  EXPECT_EQ(wall.friction, 0.3);
}

TEST(Wall, BlankFirstCardIsAllNodesAndNumbersFollowTheOrder) {
  const model::Model model = read_with(
      "*RIGIDWALL_PLANAR\n\n       3.0       0.0       0.0       2.0       0.0       0.0\n"
      "         0\n       0.0       0.0      -1.0       0.0       0.0       1.0\n");
  ASSERT_EQ(model.rigid_walls.size(), 2U);
  EXPECT_EQ(model.rigid_walls[0].nodes.size(), 6U);
  EXPECT_EQ(model.rigid_walls[1].id, 2);
}

TEST(Wall, GeometricShapes) {
  const model::Model model = read_with(
      "*RIGIDWALL_GEOMETRIC_FLAT_ID\n         5barrier\n0,0,0,1.0,2.0\n3,0,0,2,0,0,0.2\n3,4,0,6,7\n"
      "*RIGIDWALL_GEOMETRIC_PRISM\n0\n3,0,0,2,0,0\n5,4,0,6,7,8\n"
      "*RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY\n0\n3,0,0,3,0,9\n0.5,2.5\n77,1,2,3\n"
      "*DEFINE_CURVE\n8\n0,0\n1,1\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE_MOTION_DISPLAY\n0\n3,0,0\n0.5\n8,1,0,0,-1\n\n"
      "*RIGIDWALL_PLANAR_FINITE\n0\n3,0,0,2,0,0\n3,4,0,6,7\n");
  using model::WallShape;
  ASSERT_EQ(model.rigid_walls.size(), 5U);
  const auto& walls = model.rigid_walls;
  EXPECT_EQ(walls[0].id, 5);
  EXPECT_EQ(walls[0].shape, WallShape::Flat);
  EXPECT_EQ(walls[0].birth_time, 1);
  EXPECT_EQ(walls[0].death_time, 2);
  EXPECT_EQ(walls[0].friction, 0.2);
  EXPECT_EQ(walls[0].edge, (Vector{0, 1, 0}));
  EXPECT_EQ(walls[0].lengths, (Vector{6, 7, 0}));
  EXPECT_EQ(walls[1].shape, WallShape::Prism);
  EXPECT_EQ(walls[1].edge, (Vector{0, 1, 0})) << "made square to the normal";
  EXPECT_EQ(walls[1].lengths, (Vector{6, 7, 8}));
  EXPECT_EQ(walls[2].shape, WallShape::Cylinder);
  EXPECT_EQ(walls[2].normal, (Vector{0, 0, 1}));
  EXPECT_EQ(walls[2].radius, 0.5);
  EXPECT_EQ(walls[2].lengths[0], 2.5);
  EXPECT_EQ(walls[2].motion.curve, no_index);
  EXPECT_EQ(walls[3].shape, WallShape::Sphere);
  EXPECT_EQ(walls[3].motion.curve, 0);
  EXPECT_TRUE(walls[3].motion.is_displacement);
  EXPECT_EQ(walls[3].motion.direction, (Vector{0, 0, -1}));
  EXPECT_EQ(walls[4].shape, WallShape::Flat);
  EXPECT_EQ(walls[4].lengths, (Vector{6, 7, 0}));
}

TEST(Wall, NodesThatShowAMovingOneAreWarnedOf) {
  const auto found = messages_with("*RIGIDWALL_PLANAR_MOVING_FORCES\n0\n3,0,0,2,0,0\n50,-1\n0,0,1,2,3,4\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("do not move with it"), std::string::npos) << found[0];
  EXPECT_TRUE(messages_with("*RIGIDWALL_PLANAR_FORCES\n0\n3,0,0,2,0,0\n0,0,1,2,3,4\n").empty());
}

TEST(Wall, MovingOnesHaveAMassAndAVelocity) {
  const model::Model model = read_with(
      "*RIGIDWALL_PLANAR_MOVING\n0\n3,0,0,2,0,0,0.2\n0.5,8\n0\n4,0,0,3,0,0\n0.75\n"
      "*RIGIDWALL_PLANAR_FINITE_MOVING_ID\n         7hammer\n0\n3,0,0,2,0,0\n3,4,0,6,7\n100,-2.5\n"
      "*RIGIDWALL_PLANAR_MOVING_FINITE\n0\n3,0,0,2,0,0\n3,4,0,6,7\n100,-2.5\n"
      "*RIGIDWALL_PLANAR\n0\n3,0,0,2,0,0\n"
      "*RIGIDWALL_PLANAR_MOVING_FORCES_FINITE_ID\n8,shown\n0\n3,0,0,2,0,0\n3,4,0,6,7\n50,-1\n0,3\n");
  ASSERT_EQ(model.rigid_walls.size(), 6U);
  EXPECT_EQ(model.rigid_walls[5].id, 8);
  EXPECT_EQ(model.rigid_walls[5].lengths, (Vector{6, 7, 0}));
  EXPECT_EQ(model.rigid_walls[5].mass, 50);
  EXPECT_EQ(model.rigid_walls[0].shape, model::WallShape::Plane);
  EXPECT_EQ(model.rigid_walls[0].mass, 0.5);
  EXPECT_EQ(model.rigid_walls[0].initial_velocity, 8);
  EXPECT_EQ(model.rigid_walls[1].mass, 0.75);
  EXPECT_EQ(model.rigid_walls[1].initial_velocity, 0);
  EXPECT_EQ(model.rigid_walls[2].id, 7);
  for (const std::size_t finite : {2U, 3U}) {
    EXPECT_EQ(model.rigid_walls[finite].shape, model::WallShape::Flat);
    EXPECT_EQ(model.rigid_walls[finite].lengths, (Vector{6, 7, 0}));
    EXPECT_EQ(model.rigid_walls[finite].mass, 100);
    EXPECT_EQ(model.rigid_walls[finite].initial_velocity, -2.5);
  }
  EXPECT_EQ(model.rigid_walls[4].mass, 0) << "it stays where it is";
}

TEST(Part, ContactThickness) {
  SmallDeck deck;
  deck.part = "*PART_CONTACT\nplate\n1,1,1\n0.3,0.2,4,0,1.5,0.8\n";
  const model::Model model = read_clean(deck.text());
  EXPECT_EQ(model.parts[0].contact_thickness, 1.5);
  EXPECT_EQ(model.parts[0].contact_thickness_scale, 0.8);
  deck.part = "*PART_CONTACT\nplate\n1,1,1\n0.3,0.2,4,0,0,0,2\n";
  const std::string messages = listed(read_deck_text(deck.text()).diagnostics);
  EXPECT_NE(messages.find("field SSF"), std::string::npos) << messages;
}

TEST(Wall, ABoxChoosesAmongItsNodes) {
  const model::Model model =
      read_with("*DEFINE_BOX\n3,-1,0.5,-9,9,-9,9\n*RIGIDWALL_PLANAR\n0,0,3\n3,0,0,2,0,0\n");
  ASSERT_EQ(model.rigid_walls.size(), 1U);
  EXPECT_EQ(model.rigid_walls[0].nodes.size(), 2U);
}

TEST(Wall, AnEdgeAlongTheNormalIsAnError) {
  const auto messages = messages_with("*RIGIDWALL_GEOMETRIC_FLAT\n0\n3,0,0,2,0,0\n1,0,0,6,7\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("the head of the edge vector l"), std::string::npos) << messages[0];
}

TEST(Wall, WarnsOfNodesBehind) {
  const auto messages = messages_with(
      "*RIGIDWALL_PLANAR\n         0\n       1.5       0.0       0.0       1.0       0.0       0.0\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_NE(messages[0].find("2 of the wall's 6 nodes are behind it"), std::string::npos) << messages[0];
}

TEST(Unsupported, HarmlessKeywordsAreListed) {
  SmallDeck deck;
  deck.more = "*DATABASE_SPHOUT\n0.1\n*CONTROL_OUTPUT\n1,1\n*DATABASE_SPHOUT\n0.2\n";
  const ReadResult result = read_deck_text(deck.text());
  EXPECT_TRUE(result.model);
  ASSERT_EQ(result.ignored_keywords.size(), 2U);
  EXPECT_EQ(result.ignored_keywords[0].keyword, "*DATABASE_SPHOUT");
  EXPECT_EQ(result.ignored_keywords[0].line, 22);
  EXPECT_EQ(result.ignored_keywords[0].count, 2);
  EXPECT_EQ(result.ignored_keywords[0].why, Omission::Harmless);
}

TEST(Unsupported, CardsBehindTheLastKnownOne) {
  EXPECT_TRUE(messages_with("*CONTROL_TIMESTEP\n0.0,0.9\n\n0,0.0,0,0.0E+00\n").empty());
  const auto messages = messages_with("*CONTROL_HOURGLASS\n1,0.1\n2.5,1\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0],
            "deck.k:24: error: *CONTROL_HOURGLASS: read \"2.5,1\" behind the last card that is known; remove "
            "the line");
}

}  // namespace
}  // namespace crumple::deck::test::keywords_test
