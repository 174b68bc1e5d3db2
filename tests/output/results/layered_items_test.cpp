// SPDX-License-Identifier: BSD-3-Clause
// What output finds of layers, each of which has items of its own law.
#include <gtest/gtest.h>

#include "domain/shell_block.hpp"
#include "output/d3plot/d3plot_layout.hpp"
#include "output/results/point_results.hpp"
#include "output/results/shell_results.hpp"

namespace crumple::output::layered_items_test {
namespace {

/// An item of some layers whose numbers tell where they stand.
void add(domain::ShellBlock& block, const std::string& name, Index first_layer, Index layers, Index stride) {
  domain::add_item(block, name, "-", block.plane_points * layers * stride);
  block.items.back().first_layer = first_layer;
  block.items.back().layers = layers;
  block.items.back().all_layers = block.thickness_points;
}

/// Two planes of three layers: the lowest yields and has a back stress, the others have a damage of two
/// numbers and a strain, the highest yields, too.
domain::ShellBlock block_of_layers() {
  domain::ShellBlock block;
  block.elements = 1;
  block.plane_points = 2;
  block.thickness_points = 3;
  block.points = 6;
  domain::add_item(block, "stress", "stress", 30);
  add(block, "plastic_strain", 0, 1, 1);
  add(block, "plastic_strain_rest", 0, 1, 1);
  add(block, "back_stress", 0, 1, 1);
  add(block, "material_axis", 1, 1, 1);
  add(block, "damage", 1, 2, 2);
  add(block, "strain", 1, 2, 1);
  add(block, "plastic_strain", 2, 1, 1);
  domain::add_item(block, "thickness", "length", 1);
  block.allocate(Precision::Double);
  for (Index component = 0; component < block.components; ++component)
    block.set_state(0, component, component);
  return block;
}

TEST(LayeredItems, PlasticStrainIsThatOfTheLayersLaw) {
  const domain::ShellBlock block = block_of_layers();
  const Index low = block.items[1].first;
  const Index high = block.items[7].first;
  const double expected[] = {double(low), 0, double(high), double(low + 1), 0, double(high + 1)};
  for (Index point = 0; point < 6; ++point) EXPECT_EQ(plastic_strain_of(block, 0, point), expected[point]);
  const model::Model model;
  EXPECT_EQ(ShellResults(model, block).plastic_strain(0), high + 1);
}

TEST(LayeredItems, FurtherVariablesAreCountedByLaw) {
  const domain::ShellBlock block = block_of_layers();
  const PointHistory history(block);
  const Index back = block.items[3].first;
  const Index damage = block.items[5].first;
  const Index strain = block.items[6].first;
  EXPECT_EQ(history.count(), 3);
  // The lowest layer, in both planes.
  EXPECT_EQ(history.value(0, 0, 0), back);
  EXPECT_EQ(history.value(0, 3, 0), back + 1);
  EXPECT_EQ(history.value(0, 0, 1), 0);
  // The others: point 1 and 2 of the first plane, 4 and 5 of the second.
  EXPECT_EQ(history.value(0, 1, 0), damage);
  EXPECT_EQ(history.value(0, 2, 1), damage + 3);
  EXPECT_EQ(history.value(0, 4, 0), damage + 4);
  EXPECT_EQ(history.value(0, 5, 2), strain + 3);
  EXPECT_EQ(history.value(0, 5, 3), 0);
}

}  // namespace
}  // namespace crumple::output::layered_items_test
