// SPDX-License-Identifier: BSD-3-Clause
// Cards of other people's decks that change nothing here: they are accepted, and refused where they would.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "deck/small_deck.hpp"

namespace crumple::deck::test::without_effect_test {
namespace {

bool has(const std::vector<std::string>& messages, const std::string& words) {
  return std::any_of(messages.begin(), messages.end(),
                     [&](const std::string& message) { return message.find(words) != std::string::npos; });
}

std::vector<std::string> messages_of_deck(const SmallDeck& deck) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(deck.text()).diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(to_string(diagnostic));
  return messages;
}

TEST(WithoutEffect, AreAccepted) {
  for (const char* cards : {"*CONTROL_SOLUTION\n",
                            "*CONTROL_SOLUTION\n         0\n",
                            "*CONTROL_UNITS\nmm,ms,kg\n",
                            "*CONTROL_STRUCTURED\n",
                            "*CONTROL_STRUCTURED_TERM\n",
                            "*INTERFACE_SPRINGBACK_NASTRAN\n         1\n",
                            "*INTERFACE_COMPONENT_FILE\nf\n",
                            "*SENSOR_DEFINE_NODE\n         1         1         2\n",
                            "*CONTROL_SOLID\n         1\n",
                            "*CONTROL_SOLID\n         1\n         0\n",
                            "*PART\nmirror\n         7\n",
                            "*CONTROL_SHELL\n20,0,-2,0,11\n1,0,1\n0,0,2\n",
                            "*HOURGLASS\n         5         8\n",
                            "*ELEMENT_PLOTEL\n       1       1       2\n",
                            "*RIGIDWALL_PLANAR_DISPLAY\n0\n0,0,-1,0,0,1\n7\n",
                            "*PART_PRINT\nmirror\n         7\n         1\n",
                            "*PARAMETER\nC case    frontal\n",
                            "*PARAMETER\nR a          0.010\nR a           0.01\n",
                            "*PARAMETER_MUTABLE\nR a          0.010\nR a            2.0\n",
                            "*MAT_ADD_FATIGUE\n1\n",
                            "*CONTROL_DAMPING\n0,0.0,0.0,0.0,0.0,0,0.0,0\n",
                            "*CONTROL_ADAPSTEP\n1.0,0.01\n",
                            "*CONTROL_ADAPTIVE\n0.1,5.0,2,3\n",
                            "*INITIAL_VELOCITY_GENERATION_START_TIME\n0.0\n",
                            "*CONTROL_TIMESTEP\n0,0.9,0,0,0,0,1\n",
                            "*DEFINE_COORDINATE_NODE\n1,1,2,3\n",
                            "*CONTROL_TIMESTEP\n0.0\n0,0,0,0,0,0,0,0\n"})
    EXPECT_FALSE(has(messages_with(cards), ": error: ")) << cards << messages_with(cards)[0];
}

TEST(WithoutEffect, AreAcceptedWithAWarning) {
  for (const char* cards :
       {"*INCLUDE\n", "*BOUNDARY_SPC_SET\n0,0,0,0,0,0,0,0\n", "*CONTROL_TIMESTEP\n0,0.9,0,0,0,0,10\n",
        "*CONTROL_BULK_VISCOSITY\n       1.5      0.06        -2\n"}) {
    const std::vector<std::string> messages = messages_with(cards);
    ASSERT_EQ(messages.size(), 1U) << cards;
    EXPECT_NE(messages[0].find(": warning: "), std::string::npos) << messages[0];
  }
}

/// NFAIL1 and NFAIL4 stand on the second card in older decks.
TEST(WithoutEffect, WhatDeletesDistortedShellsIsWarnedOfOnEitherCard) {
  for (const char* cards : {"*CONTROL_SHELL\n\n1,0,0,1,0,1,1\n", "*CONTROL_SHELL\n\n\n\n1,1\n"})
    EXPECT_TRUE(has(messages_with(cards), "NFAIL1 is not zero")) << cards;
}

TEST(WithoutEffect, RemarksAreNotWorthAWord) {
  EXPECT_TRUE(messages_with("*COMMENT *PART\nremark\n").empty());
}

TEST(WithoutEffect, AccelerometersAreTracedNodes) {
  const model::Model model = read_with("*ELEMENT_SEATBELT_ACCELEROMETER\n1,4,1,2,0,0\n");
  EXPECT_EQ(model.output.history_nodes.size(), 1U);
  EXPECT_TRUE(has(messages_with("*ELEMENT_SEATBELT_ACCELEROMETER\n1,4,1,2,0,0,0.5\n"), "field MASS"));
}

TEST(WithoutEffect, AreRefusedWhereTheyHaveAnEffect) {
  EXPECT_TRUE(has(messages_with("*CONTROL_SOLUTION\n         2\n"), "field SOLN: read \"2\""));
  EXPECT_TRUE(
      has(messages_with(
              "*CONTROL_SOLID\n\n\n*CONTROL_SOLID\n         0         0         0         0         3\n"),
          "field PSFAIL"));
  SmallDeck offset;
  offset.section = "*SECTION_SHELL\n1,2\n0.1,,,,1\n";
  offset.more = "*CONTROL_SHELL\n\n\n0,0,2\n";
  EXPECT_TRUE(has(messages_of_deck(offset), "field CNTCO: read \"2\""));
  SmallDeck fibres;
  fibres.section = "*SECTION_SHELL\n1,1\n0.1\n";
  fibres.more = "*CONTROL_SHELL\n20,0,-2\n";
  EXPECT_TRUE(has(messages_of_deck(fibres), "field IRNXX: read \"-2\""));
  SmallDeck layers;
  layers.section = "*SECTION_SHELL\n1,2,,2,,,1\n0.1\n0,90\n";
  layers.more = "*CONTROL_SHELL\n\n1,0,1\n";
  EXPECT_TRUE(has(messages_of_deck(layers), "field LAMSHT: read \"1\""));
  SmallDeck open;
  open.section = "*SECTION_SHELL\n1\n0.1\n";
  open.more = "*CONTROL_SHELL\n20,0,-1,0,11\n";
  EXPECT_TRUE(has(messages_of_deck(open), "field THEORY: read \"11\""));
  SmallDeck part;
  part.more = "*PART\nmirror\n         7\n*ELEMENT_SHELL\n      13       7       1       2       3       4\n";
  EXPECT_TRUE(has(messages_of_deck(part), "field SECID: read \"0\", expected the id of a section"));
}

/// Default cards as LS-PrePost and Workbench put them before a model.
constexpr const char* default_headers[] = {
    ("*CONTROL_ACCURACY\n         0         0         0         0\n"
     "*CONTROL_BULK_VISCOSITY\n       1.5      0.06         1         0         0\n"
     "*CONTROL_CONTACT\n       0.1       0.0         1         0         1         1         1         0\n"
     "         0         0        10         0       4.0         0         0       0.0\n"
     "       0.0       0.0       0.0       0.0       0.0       1.0       1.0\n"
     "         0         1         0         0         0         0       0.0\n"
     "*CONTROL_CPU\n       0.0         0\n"
     "*CONTROL_DYNAMIC_RELAXATION\n       250     0.001     0.995   1.0E20       0.0         0      0.04     "
     " "
     "   0\n"
     "*CONTROL_ENERGY\n         2         2         2         2\n"
     "*CONTROL_HOURGLASS\n         1       0.1\n"
     "*CONTROL_IMPLICIT_GENERAL\n         0       0.0         2         1         2         0         0      "
     " "
     "  0\n"
     "*CONTROL_IMPLICIT_SOLVER\n         5\n"
     "*CONTROL_OUTPUT\n         0         3         0         0       0.0\n"
     "*CONTROL_RIGID\n         0         0         0         0         0\n"
     "*CONTROL_SHELL\n      20.0         0        -1         0         2         2         1         0       "
     " "
     " 1\n"
     "       1.0         0         0         1         0\n         0         0         0         0         "
     "2\n"
     "*CONTROL_SOLID\n         0         0         0         0\n"
     "*CONTROL_SOLUTION\n         0         0         0       100\n"
     "*CONTROL_SUBCYCLE\n         1         1\n"
     "*CONTROL_TIMESTEP\n       0.0       0.9         0       0.0       0.0         0         0         0\n"
     "       0.0         0         0\n"),
    ("*DATABASE_FORMAT\n         0         0\n"
     "*DATABASE_ABSTAT\n       0.1\n*DATABASE_BNDOUT\n       0.1\n*DATABASE_JNTFORC\n       0.1\n"
     "*DATABASE_NODFOR\n       0.1\n*DATABASE_SBTOUT\n       0.1\n*DATABASE_SSSTAT\n       0.1\n"
     "*DATABASE_GLSTAT\n       0.1         0         0         1\n*DATABASE_MATSUM\n       0.1\n"
     "*DATABASE_SPCFORC\n       0.1\n*DATABASE_RCFORC\n       0.1\n"
     "*DATABASE_BINARY_D3PLOT\n       0.1         0         0         0         0\n         0\n"
     "*DATABASE_BINARY_D3THDT\n       0.1\n*DATABASE_BINARY_INTFOR\n       0.1\n"
     "*DATABASE_EXTENT_BINARY\n         0         0         3         1         1         1         1        "
     " "
     "1\n"
     "         0         0         0         1         1         1         2         1\n"),
    // Cards that are not there are blank.
    ("*CONTROL_ACCURACY\n*CONTROL_BULK_VISCOSITY\n*CONTROL_CONTACT\n*CONTROL_ENERGY\n*CONTROL_HOURGLASS\n"
     "*CONTROL_SHELL\n*CONTROL_TIMESTEP\n*CONTROL_DYNAMIC_RELAXATION\n*CONTROL_IMPLICIT_GENERAL\n")};

TEST(WithoutEffect, DefaultHeadersPass) {
  for (const char* cards : default_headers) {
    const std::vector<std::string> messages = messages_with(cards);
    EXPECT_FALSE(has(messages, ": error: ")) << messages.front();
  }
}

TEST(WithoutEffect, WhatWouldChangeTheRunIsRefused) {
  EXPECT_TRUE(
      has(messages_with("*CONTROL_DYNAMIC_RELAXATION\n250,0.001,0.995,1E20,0,0,0.04,5\n"), "field IDRFLG"));
  EXPECT_TRUE(has(messages_with("*CONTROL_IMPLICIT_GENERAL\n         1\n"), "field IMFLAG"));
}

TEST(WithoutEffect, EveryOutputThatIsLackingIsOneLine) {
  const std::vector<std::string> messages = messages_with("*DATABASE_NODFOR\n0.1\n*DATABASE_NODFOR\n0.2\n");
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_NE(messages[0].find("warning: *DATABASE_NODFOR: is left out: an output that is not written"),
            std::string::npos);
  const std::vector<std::string> mistyped = messages_with("*DATABASE_RWFORCE\n0.1\n");
  ASSERT_EQ(mistyped.size(), 1U);
  EXPECT_NE(mistyped[0].find(
                "error: *DATABASE_RWFORCE: LS-DYNA has no such keyword; did you mean *DATABASE_RWFORC?"),
            std::string::npos)
      << mistyped[0];
}

TEST(WithoutEffect, ThicknessWithoutItsElasticPart) {
  const auto change = [](const char* option) {
    SmallDeck deck;
    deck.more = std::string("*CONTROL_SHELL\n20,0,-1,") + option + "\n";
    const ReadResult result = read_deck_text(deck.text());
    return result.model && result.model->control.thickness_change;
  };
  EXPECT_FALSE(change("0"));
  EXPECT_TRUE(change("1"));
  EXPECT_FALSE(change("2"));
  EXPECT_TRUE(change("3"));
  EXPECT_TRUE(change("4"));
  const auto messages = messages_with("*CONTROL_SHELL\n20,0,-1,4\n");
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(has(messages, "warning: *CONTROL_SHELL card 1 field ISTUPD: read \"4\"")) << messages[0];
}

TEST(WithoutEffect, DeletionOfDistortedShellsWhereThereAreNone) {
  const std::string card = "*CONTROL_SHELL\n20\n\n\n";
  EXPECT_TRUE(messages_with(card + "0,1\n").empty());  // there is no fully integrated shell
  EXPECT_TRUE(has(messages_with(card + "1,0\n"), "warning: *CONTROL_SHELL card 4: NFAIL1 is not zero"));
  SmallDeck full;
  full.section = "*SECTION_SHELL\n         1        16\n       0.1\n";
  full.more = card + "1,0\n";
  EXPECT_TRUE(messages_of_deck(full).empty());
  full.more = card + "0,1\n";
  EXPECT_TRUE(has(messages_of_deck(full), "warning: *CONTROL_SHELL card 4: NFAIL4 is not zero"));
  CubeDeck cube;
  cube.more = card + "1,1\n";
  EXPECT_TRUE(messages_of_deck(cube).empty());
}

TEST(WithoutEffect, NullShellsWithoutStiffnessMatterToContactAlone) {
  SmallDeck deck;
  deck.material = "*MAT_NULL\n1,1.0E-6\n";
  EXPECT_TRUE(messages_of_deck(deck).empty());
  deck.more = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n";
  EXPECT_TRUE(has(messages_of_deck(deck), "warning: *MAT_NULL card 1 field YM"));
}

TEST(WithoutEffect, OptionsInAnyOrder) {
  const model::Model model = read_with(
      "*SET_NODE_TITLE_LIST\nsome\n         4\n         1         2\n"
      "*BOUNDARY_SPC_ID_SET\n         1held\n         4         0         1\n"
      "*SET_SHELL_GENERAL_TITLE\nall\n         5\nALL\n"
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE_TITLE_ID\n         3self\n0\n\n\n"
      "*RIGIDWALL_PLANAR_ID_MOVING_FINITE\n         6\n0\n0,0,-1,0,0,1\n1,0,0,4,4\n1.0,1.0\n");
  EXPECT_EQ(model.fixed_nodes.size(), 2U);
  ASSERT_EQ(model.contacts.size(), 1U);
  EXPECT_EQ(model.contacts[0].id, 3);
  ASSERT_EQ(model.rigid_walls.size(), 1U);
  EXPECT_EQ(model.rigid_walls[0].mass, 1);
}

TEST(WithoutEffect, OptionsOfWallsInAnyOrderAndADisplayCardThatIsMissing) {
  const model::Model model = read_with(
      "*RIGIDWALL_GEOMETRIC_CYLINDER_ID_DISPLAY\n         4pole\n0\n3,0,0,3,0,9\n0.5,2.5\n"
      "*RIGIDWALL_GEOMETRIC_SPHERE_DISPLAY_ID\n         5ball\n0\n3,0,0\n0.5\n");
  ASSERT_EQ(model.rigid_walls.size(), 2U);
  EXPECT_EQ(model.rigid_walls[0].id, 4);
  EXPECT_EQ(model.rigid_walls[1].id, 5);
  EXPECT_EQ(model.rigid_walls[1].shape, model::WallShape::Sphere);
}

TEST(WithoutEffect, SortingIsRefusedForSolidsThatRepeatNodesOnly) {
  CubeDeck deck;
  deck.more = "*CONTROL_SOLID\n         1\n";
  EXPECT_TRUE(messages_of_deck(deck).empty());
  deck.shells =
      "*ELEMENT_SOLID\n      21       1       1       2       3       4       5       5       8       8\n";
  EXPECT_TRUE(has(messages_of_deck(deck), "solid 21 repeats nodes, and ESORT (deck.k:"));
  deck.more.clear();
  EXPECT_FALSE(has(messages_of_deck(deck), "ESORT"));
}

TEST(WithoutEffect, PressureCutOffOfNullShells) {
  SmallDeck deck;
  deck.material = "*MAT_NULL\n1,1.0E-6,0.1,0,0,0,200.0,0.3\n";
  EXPECT_TRUE(messages_of_deck(deck).empty());
}

TEST(WithoutEffect, IsRefusedWhereItWouldHaveOne) {
  const auto only = [](const SmallDeck& deck, const char* words) {
    const std::vector<std::string> messages = messages_of_deck(deck);
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_NE(messages[0].find(words), std::string::npos) << messages[0];
  };
  SmallDeck deck;
  deck.more = "*BOUNDARY_SPC_SET\n0,0,1\n";
  only(deck, "error: *BOUNDARY_SPC_SET card 1 field NSID: read \"0\", expected the id of a set of nodes");
  deck.more = "*INITIAL_VELOCITY_GENERATION_START_TIME\n0.5\n";
  only(deck, "field STIME");
  deck.more = "";
  deck.part = "*PART\nplate\n1,1,1,0,0,0,1\n";
  only(deck, "field ADPOPT");
}

}  // namespace
}  // namespace crumple::deck::test::without_effect_test
