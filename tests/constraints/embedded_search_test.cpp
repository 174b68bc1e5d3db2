// SPDX-License-Identifier: BSD-3-Clause
#include "constraints/embedded_search.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"
#include "constraints/tie_links.hpp"
#include "domain/build.hpp"
#include "support/reinforced.hpp"

namespace crumple::constraints::embedded_search_test {
namespace {

using test::Point;
using test::ReinforcedBlock;

std::vector<domain::Embedding> found_in(const model::Model& model) {
  domain::Domain domain = domain::build(model, test::execution());
  find_embedded_beams(model, domain);
  return domain.embeddings;
}

TEST(EmbeddedSearch, FindsEveryNodeOfAGridOfBars) {
  ReinforcedBlock block({7, 6, 5}, {70, 60, 50}, 1);
  for (int i = 0; i < 9; ++i) {
    block.add_bar(23, {0, 60.0 * i / 8, 3.0 * i}, {70, 60.0 * i / 8, 50});
    block.add_bar(17, {70.0 * i / 8, 0, 25}, {70.0 * i / 8, 60, 25});
  }
  domain::Domain domain = domain::build(block.model, test::execution());
  find_embedded_beams(block.model, domain);
  const domain::Embedding& found = domain.embeddings[0];
  EXPECT_EQ(found.nodes.size() + static_cast<std::size_t>(found.shared), 9U * 24 + 9 * 18);
  EXPECT_TRUE(found.outside.empty());
  for (const domain::EmbeddedNode& node : found.nodes) {
    math::Vec3 mean;
    double sum = 0;
    for (Index k = 0; k < node.corners; ++k) {
      mean += node.weight[k] * domain.nodes.position[node.corner[k]];
      sum += node.weight[k];
      EXPECT_GT(node.weight[k], 0);
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_LT(norm(mean - domain.nodes.position[node.node]), 1e-12);
  }
}

TEST(EmbeddedSearch, OnAFaceBothSolidsHoldTheNode) {
  ReinforcedBlock block({2, 2, 1}, {20, 20, 10}, 1);
  block.add_bar(2, {5, 5, 5}, {15, 5, 5});
  block.add_bar(1, {10, 10, 5}, {3, 10, 5});
  const domain::Embedding found = found_in(block.model)[0];
  ASSERT_EQ(found.nodes.size(), 5U);
  EXPECT_EQ(found.nodes[0].hosts.size(), 1U);
  EXPECT_EQ(found.nodes[0].corners, 8);
  EXPECT_EQ(found.nodes[1].hosts.size(), 2U);
  EXPECT_EQ(found.nodes[1].corners, 4);
  EXPECT_EQ(found.nodes[3].hosts.size(), 4U);
  EXPECT_EQ(found.nodes[3].corners, 2);
}

TEST(EmbeddedSearch, CountsWhatIsNotCoupled) {
  ReinforcedBlock block({2, 1, 1}, {20, 10, 10}, 1);
  const Index bar = block.add_bar(4, {-10, 5, 5}, {30, 5, 5});  // at -10, 0, 10, 20, 30
  block.add_bar(1, {5, 5, 10.04}, {5, 5, 10.06});               // 0.008 and 0.012 beyond a face
  block.model.beams.push_back({.id = 99, .part = 1, .node = {0, bar + 2}, .orientation = {}});
  block.model.embedded_beams[0].beams.push_back(static_cast<Index>(block.model.beams.size()) - 1);
  block.model.embedded_beams.push_back(block.model.embedded_beams[0]);
  block.model.embedded_beams[1].id = 6;
  const std::vector<domain::Embedding> found = found_in(block.model);
  EXPECT_EQ(found[0].nodes.size(), 4U);
  EXPECT_EQ(found[0].shared, 1);
  EXPECT_EQ(found[0].elsewhere, 0);
  const auto id = [&](Index node) { return block.model.nodes.id[static_cast<std::size_t>(node)]; };
  EXPECT_EQ(found[0].outside, (std::vector<UserId>{id(bar), id(bar + 4), id(bar + 6)}));
  EXPECT_TRUE(found[1].nodes.empty());
  EXPECT_EQ(found[1].elsewhere, 4);
}

TEST(EmbeddedSearch, NamesBeamsThatPassThroughSolidsBetweenTheirNodes) {
  ReinforcedBlock block({4, 1, 1}, {40, 10, 10}, 1);
  block.add_bar(1, {5, 5, 5}, {15, 5, 5});
  block.add_bar(1, {5, 4, 5}, {35, 4, 5});
  EXPECT_TRUE(found_in(block.model)[0].long_beams.empty()) << "no points between the nodes are asked for";
  block.model.embedded_beams[0].between_nodes = true;
  EXPECT_EQ(found_in(block.model)[0].long_beams, (std::vector<UserId>{2}));
}

TEST(EmbeddedSearch, ACouplingOfNothingIsAnError) {
  ReinforcedBlock block({1, 1, 1}, {10, 10, 10}, 1);
  block.add_bar(2, {5, 5, 15}, {5, 5, 25});
  EXPECT_THROW(found_in(block.model), Error);
}

/// What is said of a model whose nodes cannot follow their solids.
std::string fault_of(const model::Model& model) {
  domain::Domain domain = domain::build(model, test::execution());
  find_embedded_beams(model, domain);
  try {
    find_tie_links(model, domain);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(EmbeddedSearch, NodesThatSomethingElseHoldsAreNamed) {
  const auto block_with_bar = [] {
    ReinforcedBlock block({1, 1, 1}, {10, 10, 10}, 1);
    block.add_bar(2, {2, 5, 5}, {8, 5, 5});
    return block.model;
  };
  EXPECT_EQ(fault_of(block_with_bar()), "");
  model::Model held = block_with_bar();
  held.fixed_nodes.push_back({.node = 9, .translation = {true, false, false}, .rotation = {}});
  EXPECT_NE(fault_of(held).find("node 10 lies in a solid and is held by *BOUNDARY_SPC"), std::string::npos)
      << fault_of(held);
  model::Model joined = block_with_bar();
  joined.rivets.push_back({.id = 4, .node = {0, 8}});
  EXPECT_NE(fault_of(joined).find("node 9 lies in a solid and belongs to rivet 4"), std::string::npos)
      << fault_of(joined);
  model::Model rigid = block_with_bar();
  rigid.spot_welds.push_back({.id = 3, .nodes = {0, 1}});
  EXPECT_NE(fault_of(rigid).find("lies in a solid with node 1 of spot weld 3"), std::string::npos)
      << fault_of(rigid);
}

}  // namespace
}  // namespace crumple::constraints::embedded_search_test
