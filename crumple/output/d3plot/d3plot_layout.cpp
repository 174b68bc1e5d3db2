// SPDX-License-Identifier: BSD-3-Clause
#include "output/d3plot/d3plot_layout.hpp"

#include <algorithm>
#include <string_view>

namespace crumple::output {

namespace {

/// The items behind the stress are the material's, up to the first one of the element itself.
bool is_of_element(std::string_view name) {
  return name == "thickness" || name == "reference_volume";
}

/// No variable of the material's own: shown beside the stress, what rounding has cut off, or a direction.
bool is_left_out(std::string_view name) {
  return name == "plastic_strain" || name.ends_with("_rest") || name == "material_axis";
}

}  // namespace

D3plotLayout::D3plotLayout(const model::StateExtent& extent)
    : solid_history(extent.solid_history),
      shell_history(extent.shell_history),
      layers(std::max(surfaces, extent.shell_points)),
      stresses(extent.stresses),
      plastic_strain(extent.plastic_strain),
      resultants(extent.resultants),
      energy(extent.energy) {}

PointHistory::PointHistory(const domain::ElementBlock& block) : block_(&block) {
  auto item = std::find_if(block.items.begin(), block.items.end(),
                           [](const domain::StateItem& one) { return one.name == "stress"; });
  if (item == block.items.end()) return;
  for (++item; item != block.items.end() && !is_of_element(item->name); ++item) {
    if (is_left_out(item->name) || item->count % block.points != 0) continue;
    const Index stride = item->count / block.points;
    for (Index i = 0; i < stride; ++i) components_.push_back({item->first + i, stride});
  }
}

double PointHistory::value(Index place, Index point, int variable) const {
  if (variable >= count()) return 0;
  const Component& its = components_[static_cast<std::size_t>(variable)];
  return block_->state(place, its.first + point * its.stride);
}

}  // namespace crumple::output
