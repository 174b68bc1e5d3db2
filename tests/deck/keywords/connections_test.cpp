// SPDX-License-Identifier: BSD-3-Clause
// Spot welds, rivets and constrained sets of nodes.
#include "deck/small_deck.hpp"

namespace crumple::deck::test::connections_test {
namespace {

TEST(Connections, SpotWeldsOfPairsAndSets) {
  const model::Model model = read_with(
      "*CONSTRAINED_SPOTWELD_ID\n        31\n         1         4       2.0       3.0       1.5       2.5"
      "       9.0       0.2\n"
      "*CONSTRAINED_GENERALIZED_WELD_SPOT\n         8\n\n         9\n       7.0       0.1\n"
      "*SET_NODE_LIST\n         8\n         6         5         6\n*SET_NODE_LIST\n         9\n         2    "
      "     3\n");
  ASSERT_EQ(model.spot_welds.size(), 3U);
  const model::SpotWeld& pair = model.spot_welds[0];
  EXPECT_EQ(pair.id, 31);
  EXPECT_EQ(pair.nodes, (std::vector<Index>{0, 3}));
  EXPECT_EQ(pair.normal_strength, 2);
  EXPECT_EQ(pair.shear_strength, 3);
  EXPECT_EQ(pair.normal_exponent, 1.5);
  EXPECT_EQ(pair.shear_exponent, 2.5);
  EXPECT_EQ(pair.failure_time, 9);
  EXPECT_EQ(pair.failure_strain, 0.2);
  const model::SpotWeld& set = model.spot_welds[1];
  EXPECT_EQ(set.nodes, (std::vector<Index>{4, 5}));
  EXPECT_EQ(set.normal_strength, 0);
  EXPECT_EQ(set.failure_strain, 0) << "never";
  EXPECT_EQ(set.failure_time, 1e20);
  EXPECT_EQ(model.spot_welds[2].failure_time, 7);
  EXPECT_EQ(model.spot_welds[2].failure_strain, 0.1);
}

TEST(Connections, AFibreOfSolidsAtAShellIsAWeldOfAllItsNodes) {
  const std::string fibre =
      "*CONSTRAINED_SHELL_TO_SOLID\n2,8\n*SET_NODE_LIST\n         8\n         6         5\n";
  SmallDeck deck;
  deck.more = fibre;
  const ReadResult result = read_deck_text(deck.text());
  ASSERT_TRUE(result.model);
  ASSERT_EQ(result.model->spot_welds.size(), 1U);
  const model::SpotWeld& weld = result.model->spot_welds[0];
  EXPECT_EQ(weld.nodes, (std::vector<Index>{1, 4, 5}));
  EXPECT_EQ(weld.failure_time, 1e20);
  EXPECT_EQ(weld.failure_strain, 0);
  EXPECT_NE(listed(result.diagnostics).find("LS-DYNA lets it stretch"), std::string::npos);
  deck.more = "*CONSTRAINED_SHELL_TO_SOLID\n77,8\n" + fibre.substr(fibre.find("*SET"));
  EXPECT_FALSE(read_deck_text(deck.text()).model);
}

TEST(Connections, RivetsAndNodeSets) {
  const model::Model model = read_with(
      "*CONSTRAINED_RIVET\n         1         6       4.0\n"
      "*CONSTRAINED_NODE_SET\n         8         5\n*SET_NODE_LIST\n         8\n         2         3\n");
  ASSERT_EQ(model.rivets.size(), 1U);
  EXPECT_EQ(model.rivets[0].node, (std::array<Index, 2>{0, 5}));
  EXPECT_EQ(model.rivets[0].failure_time, 4);
  ASSERT_EQ(model.constrained_node_sets.size(), 1U);
  EXPECT_EQ(model.constrained_node_sets[0].nodes, (std::vector<Index>{1, 2}));
  EXPECT_EQ(model.constrained_node_sets[0].direction, (std::array<bool, 3>{false, true, true}));
}

TEST(Connections, NodeSetsMayHaveANumber) {
  const model::Model model = read_with(
      "*CONSTRAINED_NODE_SET_ID\n        31\n         8         5\n*SET_NODE_LIST\n         8\n         2"
      "         3\n");
  ASSERT_EQ(model.constrained_node_sets.size(), 1U);
  EXPECT_EQ(model.constrained_node_sets[0].nodes, (std::vector<Index>{1, 2}));
}

TEST(Connections, LinearEquations) {
  const model::Model model = read_with(
      "*CONSTRAINED_LINEAR_GLOBAL\n12\n2,1,1.0\n3,4,-2.5\n"
      "*CONSTRAINED_ADAPTIVITY\n6,1,2\n");
  ASSERT_EQ(model.linear_equations.size(), 7U);
  const model::LinearEquation& given = model.linear_equations[0];
  EXPECT_EQ(given.id, 12);
  ASSERT_EQ(given.terms.size(), 2U);
  EXPECT_EQ(given.terms[0].node, 1);
  EXPECT_EQ(given.terms[0].component, 0);
  EXPECT_EQ(given.terms[0].factor, 1);
  EXPECT_EQ(given.terms[1].node, 2);
  EXPECT_EQ(given.terms[1].component, 3);
  EXPECT_EQ(given.terms[1].factor, -2.5);
  const model::LinearEquation& middle = model.linear_equations[6];
  ASSERT_EQ(middle.terms.size(), 3U);
  EXPECT_EQ(middle.terms[0].node, 5);
  EXPECT_EQ(middle.terms[0].component, 5);
  EXPECT_EQ(middle.terms[0].factor, 1);
  EXPECT_EQ(middle.terms[2].node, 1);
  EXPECT_EQ(middle.terms[2].factor, -0.5);
}

TEST(Connections, PlanesHoldTheirNodes) {
  const model::Model model = read_with("*CONSTRAINED_GLOBAL\n1,6,1,0.0\n0,3,2,0.0,1.0\n2,0,2,0,0.9,0,0.11\n");
  ASSERT_EQ(model.fixed_nodes.size(), 4U);
  // Nodes 1 and 4 lie on x = 0; 3, 4 and 6 on y = 1, which is within 0.11 of 0.9 as well.
  EXPECT_EQ(model.fixed_nodes[0].node, 0);
  EXPECT_EQ(model.fixed_nodes[0].translation, (std::array<bool, 3>{true, false, false}));
  EXPECT_EQ(model.fixed_nodes[0].rotation, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(model.fixed_nodes[1].node, 2);
  EXPECT_EQ(model.fixed_nodes[1].translation, (std::array<bool, 3>{false, true, false}));
  EXPECT_EQ(model.fixed_nodes[1].rotation, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(model.fixed_nodes[2].node, 3);
  EXPECT_EQ(model.fixed_nodes[2].translation, (std::array<bool, 3>{true, true, false}));
}

TEST(Connections, Interpolations) {
  const model::Model nodes =
      read_with("*CONSTRAINED_INTERPOLATION\n7,6,1234\n1,123\n2,123,2.0\n3,123456,1.5,1.5,0,0.5\n");
  ASSERT_EQ(nodes.interpolations.size(), 1U);
  const model::Interpolation& first = nodes.interpolations[0];
  EXPECT_EQ(first.id, 7);
  EXPECT_EQ(first.dependent, 5);
  EXPECT_EQ(first.follows, (std::array<bool, 6>{true, true, true, true, false, false}));
  ASSERT_EQ(first.independent.size(), 3U);
  EXPECT_EQ(first.independent[1].node, 1);
  EXPECT_EQ(first.independent[1].weight, 2);
  EXPECT_EQ(first.independent[1].rotation_weight, 0);
  EXPECT_EQ(first.independent[2].weight, 1.5);
  EXPECT_EQ(first.independent[2].rotation_weight, 0.5);
  const model::Model set = read_with("*SET_NODE_LIST\n8\n4,1,2\n*CONSTRAINED_INTERPOLATION\n7,6,,,1\n8\n");
  ASSERT_EQ(set.interpolations.size(), 1U);
  EXPECT_EQ(set.interpolations[0].follows, (std::array<bool, 6>{true, true, true, true, true, true}));
  ASSERT_EQ(set.interpolations[0].independent.size(), 3U);
  EXPECT_EQ(set.interpolations[0].independent[2].node, 3);
  EXPECT_EQ(set.interpolations[0].independent[2].rotation_weight, 1);
}

void expect_one(const std::string& cards, const std::string& text) {
  const auto messages = messages_with(cards);
  ASSERT_EQ(messages.size(), 1U) << cards;
  EXPECT_NE(messages[0].find(text), std::string::npos) << messages[0];
}

TEST(Connections, WhatDoesNotGoTogetherIsNamed) {
  expect_one("*CONSTRAINED_RIVET\n         1         6\n*CONSTRAINED_SPOTWELD\n         6         2\n",
             "node 6 belongs to spot weld 1 and rivet 1 (deck.k");
  expect_one("*CONSTRAINED_RIVET\n         1         6\n*CONSTRAINED_ADAPTIVITY\n2,6,3\n",
             "node 6 belongs to rivet 1");
  expect_one("*CONSTRAINED_ADAPTIVITY\n2,6,6\n", "three different nodes");
  expect_one("*CONSTRAINED_LINEAR_GLOBAL\n1\n2,1,1.0\n2,1,1.0\n", "has this one already");
  expect_one("*CONSTRAINED_LINEAR_GLOBAL\n1\n2,1,1.0\n3,1\n", "a number other than zero");
  expect_one("*CONSTRAINED_LINEAR_GLOBAL\n1\n", "the equation has no terms");
  expect_one("*CONSTRAINED_LINEAR_GLOBAL\n1\n2,1,1.0\n99,1,1.0\n", "the deck has no node 99");
  expect_one("*CONSTRAINED_INTERPOLATION\n7,6,11\n1\n2\n3\n", "the digits 1 to 6, each at most once");
  expect_one("*CONSTRAINED_INTERPOLATION\n7,6\n1\n6\n3\n", "the dependent node is one of");
  expect_one("*CONSTRAINED_INTERPOLATION\n7,6\n1\n1\n3\n", "among the independent ones twice");
  expect_one("*CONSTRAINED_INTERPOLATION\n7,6\n1\n", "two independent nodes at least");
  expect_one("*CONSTRAINED_INTERPOLATION\n7,6\n1,123,1.0,2.0\n2\n3\n", "the same along all axes");
  expect_one("*CONSTRAINED_RIVET\n         1         5\n*CONSTRAINED_INTERPOLATION\n7,6\n1\n2\n3\n",
             "node 1 belongs to rivet 1");
  expect_one("*CONSTRAINED_SPOTWELD\n         6         6\n", "another node than N1");
  expect_one("*CONSTRAINED_SPOTWELD\n         6        99\n", "the deck has no node 99");
  expect_one(
      "*CONSTRAINED_NODE_SET\n         8         1\n*SET_NODE_LIST\n         8\n         2         2\n",
      "a set of at least two nodes");
  expect_one(
      "*CONSTRAINED_GENERALIZED_WELD_SPOT\n         8\n                           3.0\n"
      "*SET_NODE_LIST\n         8\n         2         3         4\n",
      "failure by forces needs two nodes at different places");
}

TEST(Connections, NodesAreNotMovedBySomethingElseToo) {
  const std::string weld = "*CONSTRAINED_SPOTWELD\n         6         2\n";
  const std::string rivet = "*CONSTRAINED_RIVET\n         6         2\n";
  const std::string set =
      "*CONSTRAINED_NODE_SET\n         8         1\n*SET_NODE_LIST\n         8\n         6         2\n";
  const std::string held = "*BOUNDARY_SPC_NODE\n         6         0         1\n";
  const std::string curve =
      "*DEFINE_CURVE\n         1\n                 0.0                 1.0\n"
      "                 3.0                 1.0\n";
  const std::string along_x =
      curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n         6         1         0         1\n";
  const std::string along_y =
      curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n         6         2         0         1\n";
  const std::string about_x =
      curve + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n         6         5         0         1\n";
  expect_one(weld + held,
             "node 6 belongs to spot weld 1, and degrees of freedom of its nodes cannot be held");
  EXPECT_EQ(read_with(rivet + held).fixed_nodes.size(), 1U);
  expect_one(weld + about_x, "node 6 belongs to spot weld 1, which moves it as well");
  expect_one(rivet + along_y, "node 6 belongs to rivet 1, which moves it as well");
  EXPECT_EQ(read_with(rivet + about_x).prescribed_motions.size(), 1U);
  expect_one(set + along_x, "node 6 belongs to a constrained node set, which moves it as well");
  EXPECT_EQ(read_with(set + along_y).prescribed_motions.size(), 1U);
}

}  // namespace
}  // namespace crumple::deck::test::connections_test
