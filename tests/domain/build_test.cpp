// SPDX-License-Identifier: BSD-3-Clause
#include "domain/build.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "base/error.hpp"
#include "domain/numbering.hpp"
#include "support/meshes.hpp"

namespace crumple::domain::build_test {
namespace {

model::Model sheet() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1.0, 3));
  test::add_grid(model, 0, 50, 30, [](double u, double v) {
    return test::Point{50 * u, 30 * v, 0.1 * u * v};
  });
  return model;
}

TEST(Numbering, IsAPermutationOfNodesAndShells) {
  const model::Model model = sheet();
  const Numbering numbering = number_for_locality(model);
  std::vector<Index> nodes = numbering.model_node;
  std::sort(nodes.begin(), nodes.end());
  std::vector<Index> all(model.nodes.id.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(nodes, all);
  for (Index i = 0; i < model.nodes.count(); ++i)
    EXPECT_EQ(numbering.domain_node[numbering.model_node[i]], i);
  std::vector<Index> shells = numbering.shells_by_part[0];
  std::sort(shells.begin(), shells.end());
  all.resize(model.shells.size());
  EXPECT_EQ(shells, all);
}

TEST(Numbering, BringsNeighboursTogetherHoweverTheDeckOrdersThem) {
  model::Model model = sheet();
  std::mt19937 random(7);
  std::shuffle(model.shells.begin(), model.shells.end(), random);
  const Domain domain = build(model, {});
  double spread = 0;
  const ShellBlock& block = domain.shells[0];
  for (Index place = 0; place < block.elements; ++place) {
    const auto nodes = block.nodes_of(place);
    const auto [low, high] = std::minmax_element(nodes.begin(), nodes.end());
    spread += static_cast<double>(*high - *low) / block.elements;
  }
  // Row-by-row numbering of this sheet has a spread of 52; a shuffled one about 950.
  EXPECT_LT(spread, 100);
}

TEST(Build, PlacesConditionsAtTheRenumberedNodes) {
  model::Model model = sheet();
  model.lumped_masses.push_back({.id = 1, .node = 17, .mass = 2.5});
  model.initial_velocities.push_back({.node = 17, .velocity = {1, 2, 3}, .angular_velocity = {4, 5, 6}});
  model.fixed_nodes.push_back(
      {.node = 17, .translation = {false, true, false}, .rotation = {true, false, false}});
  const Domain domain = build(model, {});
  const Index node = domain.nodes.domain_node[17];
  EXPECT_EQ(domain.nodes.mass[node], 2.5);
  EXPECT_EQ(domain.nodes.velocity[node].x, 1);
  EXPECT_EQ(domain.nodes.velocity[node].y, 0) << "a held degree of freedom starts at rest";
  EXPECT_EQ(domain.nodes.angular_velocity[node].x, 0);
  EXPECT_EQ(domain.nodes.angular_velocity[node].z, 6);
  EXPECT_EQ(domain.nodes.position[node].x, model.nodes.position[17][0]);
}

TEST(Build, ElementsKeepTheirNodesInTheOrderOfTheDeck) {
  const model::Model model = sheet();
  const Domain domain = build(model, {});
  const ShellBlock& block = domain.shells[0];
  for (Index place = 0; place < block.elements; ++place)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_EQ(domain.nodes.model_node[block.nodes_of(place)[k]],
                model.shells[block.element[place]].node[k]);
}

TEST(Build, ListsEveryFaultOfAModelAtOnce) {
  model::Model model = sheet();
  model.nodes.position[3][1] = std::numeric_limits<double>::quiet_NaN();
  model.materials[0].density = 0;
  try {
    build(model, {});
    FAIL() << "a model with faults was built";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("Node 4 "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("density"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace crumple::domain::build_test
