// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/error.hpp"
#include "domain/build.hpp"
#include "support/meshes.hpp"

namespace crumple::domain::triangle_blocks_test {
namespace {

/// Two parts of quadrilaterals and triangles; the repeated node at any place of the connectivity.
model::Model mixed_model() {
  model::Model model = test::one_part(test::elastic_steel(), test::shell_section(1, 2));
  model.parts.push_back({.id = 7, .title = "second", .section = 0, .material = 0});
  test::add_grid(model, 0, 6, 6, [](double u, double v) { return test::Point{u, v, 0}; });
  for (std::size_t i = 0; i < model.shells.size(); ++i) {
    model::ShellElement& shell = model.shells[i];
    if (i >= 18) shell.part = 1;
    if (i % 3 != 0) continue;
    shell.node[3] = shell.node[2];
    std::rotate(shell.node.begin(), shell.node.begin() + static_cast<std::ptrdiff_t>(i / 3 % 4),
                shell.node.end());
  }
  return model;
}

TEST(Triangles, HaveABlockOfTheirOwnInEachPart) {
  const model::Model model = mixed_model();
  const Domain domain = build(model, {});
  ASSERT_EQ(domain.shells.size(), 4U);
  std::vector<Index> seen;
  for (const ShellBlock& block : domain.shells) {
    const bool triangles = block.formulation == model::ShellFormulation::Triangle;
    EXPECT_EQ(block.elements, triangles ? 6 : 12);
    for (Index place = 0; place < block.elements; ++place) {
      const model::ShellElement& shell = model.shells[block.element[place]];
      EXPECT_EQ(shell.part, block.part);
      const std::array<Index, 4> node = block.nodes_of(place);
      EXPECT_EQ(node[2] == node[3], triangles);
      std::set<Index> of_model;
      std::set<Index> of_block;
      for (std::size_t k = 0; k < 4; ++k) {
        of_model.insert(domain.nodes.domain_node[shell.node[k]]);
        of_block.insert(node[k]);
      }
      EXPECT_EQ(of_model, of_block);
      seen.push_back(block.element[place]);
    }
  }
  std::sort(seen.begin(), seen.end());
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i], static_cast<Index>(i));
  EXPECT_EQ(seen.size(), model.shells.size());
}

/// In mixed precision the double arrays are empty under the names of the float ones; other names are unique.
TEST(Triangles, HaveNamesOfTheirOwnInTheStateList) {
  Domain domain = build(mixed_model(), {});
  for (ShellBlock& block : domain.shells) {
    add_item(block, "stress", "stress", 1);
    block.double_state.assign(static_cast<std::size_t>(block.groups()) * lanes, 0.0);
  }
  StateList list;
  domain.declare(list);
  std::set<std::string> names;
  for (const StateArray& array : list.arrays())
    if (!array.bytes.empty()) {
      EXPECT_TRUE(names.insert(array.name).second) << array.name;
    }
  EXPECT_TRUE(names.contains("shell_state_1"));
  EXPECT_TRUE(names.contains("triangle_state_1"));
}

TEST(Triangles, AreAllThatTheirFormulationTakes) {
  model::Model model = mixed_model();
  model.shell_sections[0].formulation = model::ShellFormulation::Triangle;
  EXPECT_THROW(build(model, {}), Error);
}

}  // namespace
}  // namespace crumple::domain::triangle_blocks_test
