// SPDX-License-Identifier: BSD-3-Clause
// Joints between rigid bodies in decks.
#include "deck/small_deck.hpp"

namespace crumple::deck::test::joints_test {
namespace {

using model::JointKind;

/// Two rigid shells, with nodes of both where they meet and apart from there, and a loose node 99.
SmallDeck two_bodies() {
  SmallDeck deck;
  deck.nodes +=
      "      12             1.0             0.0             0.0\n"
      "      13             1.0             1.0             0.0\n"
      "      14             1.0             0.0             1.0\n"
      "      24             1.0             0.0             1.0\n"
      "      25             1.0             2.0             0.0\n"
      "      26             1.5             0.0             0.0\n"
      "      99             5.0             0.0             0.0\n";
  deck.shells =
      "*ELEMENT_SHELL\n"
      "      11       1       1       2       3       4\n"
      "      12       2      12       5       6      13\n";
  deck.part =
      "*PART\nleft\n         1         1         1\n"
      "*PART\nright\n         2         1         1\n";
  deck.material = "*MAT_RIGID\n         1   7.83E-6     207.0       0.3\n\n\n";
  deck.more =
      "*CONSTRAINED_EXTRA_NODES_NODE\n         1        14\n         2        24\n         2        25\n"
      "         2        26\n";
  return deck;
}

/// A line of numbers in columns of ten.
std::string columns(std::initializer_list<int> values) {
  std::string line;
  for (const int value : values) {
    const std::string number = std::to_string(value);
    line += std::string(10 - number.size(), ' ') + number;
  }
  return line + "\n";
}

SmallDeck with(const std::string& cards) {
  SmallDeck deck = two_bodies();
  deck.more += cards;
  return deck;
}

TEST(Joints, AreReadWithTheirNodesAndNumbers) {
  const model::Model model = read_clean(
      with("*CONSTRAINED_JOINT_SPHERICAL\n" + columns({2, 12}) + "*CONSTRAINED_JOINT_REVOLUTE_ID\n" +
           columns({31}) + columns({2, 12, 3, 13, 0, 0, 5, 2}) + "*CONSTRAINED_JOINT_CYLINDRICAL\n" +
           columns({2, 12, 3, 25}) + "*CONSTRAINED_JOINT_TRANSLATIONAL\n" + columns({2, 12, 3, 25, 1, 26}) +
           "*CONSTRAINED_JOINT_UNIVERSAL\n" + columns({2, 12, 3, 24}) + "*CONSTRAINED_JOINT_LOCKING\n" +
           columns({2, 12, 3, 13, 14, 24}))
          .text());
  ASSERT_EQ(model.joints.size(), 6U);
  EXPECT_EQ(model.joints[0].kind, JointKind::Spherical);
  EXPECT_EQ(model.joints[0].id, 1);
  EXPECT_EQ(model.joints[0].node, (std::array<Index, 6>{1, 6, no_index, no_index, no_index, no_index}));
  EXPECT_EQ(model.joints[0].stiffness_scale, 1);
  EXPECT_EQ(model.joints[0].damping, 1);
  EXPECT_EQ(model.joints[1].kind, JointKind::Revolute);
  EXPECT_EQ(model.joints[1].id, 31);
  EXPECT_EQ(model.joints[1].node, (std::array<Index, 6>{1, 6, 2, 7, no_index, no_index}));
  EXPECT_EQ(model.joints[1].stiffness_scale, 5);
  EXPECT_EQ(model.joints[1].damping, 2);
  EXPECT_EQ(model.joints[2].kind, JointKind::Cylindrical);
  EXPECT_EQ(model.joints[3].kind, JointKind::Translational);
  EXPECT_EQ(model.joints[4].kind, JointKind::Universal);
  EXPECT_EQ(model.joints[5].kind, JointKind::Locking);
  EXPECT_EQ(model.joints[5].node, (std::array<Index, 6>{1, 6, 2, 7, 8, 9}));
}

TEST(Joints, ALittleDampingIsNone) {
  EXPECT_EQ(read_clean(with("*CONSTRAINED_JOINT_SPHERICAL\n2,12,,,,,,0.01\n").text()).joints[0].damping, 0);
}

void expect_one(const std::string& cards, const std::string& text) {
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : read_deck_text(with(cards).text()).diagnostics)
    if (diagnostic.severity != Severity::Note) messages.push_back(to_string(diagnostic));
  ASSERT_EQ(messages.size(), 1U) << cards;
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}

TEST(Joints, NeedNodesOfTwoRigidBodies) {
  const std::string revolute = "*CONSTRAINED_JOINT_REVOLUTE\n";
  expect_one(
      revolute + columns({2, 99, 3, 13}),
      "error: *CONSTRAINED_JOINT_REVOLUTE card 1 field N2: read \"99\", expected a node of a rigid body");
  expect_one(revolute + columns({2, 77, 3, 13}), "the deck has no node 77");
  expect_one(revolute + columns({2, 3, 1, 4}), "field N2: read \"3\", expected a node of another rigid body");
  expect_one(revolute + columns({2, 12, 13, 3}),
             "field N3: read \"13\", expected a node of the same rigid body as N1");
  expect_one("*CONSTRAINED_JOINT_SPHERICAL_ID\n" + columns({7}) + columns({2, 12}) +
                 "*CONSTRAINED_JOINT_SPHERICAL_ID\n" + columns({7}) + columns({3, 13}),
             "joint 7 is already defined");
}

TEST(Joints, NeedTheirAxes) {
  expect_one("*CONSTRAINED_JOINT_REVOLUTE\n" + columns({2, 12, 2, 12}),
             "field N3: read \"2\", expected a node apart from N1");
  expect_one("*CONSTRAINED_JOINT_UNIVERSAL\n" + columns({2, 12, 3, 13}),
             "field N4: read \"13\", expected a node across the line from N1 to N3");
  expect_one("*CONSTRAINED_JOINT_TRANSLATIONAL\n" + columns({2, 12, 3, 25, 3, 13}),
             "field N5: read \"3\", expected a node off the line from N1 to N3");
}

TEST(Joints, NodesThatAreApartAreReported) {
  expect_one(
      "*CONSTRAINED_JOINT_SPHERICAL\n" + columns({2, 26}),
      "warning: *CONSTRAINED_JOINT_SPHERICAL card 1 field N2: read \"26\", expected a node at the place "
      "of N1; it is 0.5 away");
  expect_one("*CONSTRAINED_JOINT_CYLINDRICAL\n" + columns({2, 12, 3, 24}),
             "expected a node on the line from N1 to N3; it is 1 away");
  expect_one("*CONSTRAINED_JOINT_TRANSLATIONAL\n" + columns({2, 12, 3, 25, 1, 24}),
             "expected a node in the plane of N1, N3 and N5; it is 1 away");
}

TEST(Joints, ThatAreNotSupportedAreRefusedByName) {
  for (const char* name : {"REVOLUTE_FAILURE", "GEARS", "SCREW", "RACK_AND_PINION", "REVOLUTE_LOCAL"})
    expect_one(std::string("*CONSTRAINED_JOINT_") + name + "\n" + columns({2, 12, 3, 13}), name);
}

TEST(Joints, ForcesAreWrittenOnRequest) {
  const model::Model model = read_clean(with("*DATABASE_JNTFORC\n0.01,2\n").text());
  const model::HistoryRequest& request = model.output.of(model::HistoryFile::Jntforc);
  EXPECT_TRUE(request.asked);
  EXPECT_EQ(request.interval, 0.01);
  EXPECT_FALSE(request.ascii);
  EXPECT_TRUE(request.binary);
}

}  // namespace
}  // namespace crumple::deck::test::joints_test
