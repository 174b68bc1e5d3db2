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
    const Index points = item->layers == 0 ? block.points : block.points / item->all_layers * item->layers;
    if (is_left_out(item->name) || item->count % points != 0) continue;
    add(*item);
  }
}

void PointHistory::add(const domain::StateItem& item) {
  const Index points = item.layers == 0 ? block_->points : block_->points / item.all_layers * item.layers;
  const Index stride = item.count / points;
  // The laws of layers count their variables each from the first on.
  if (item.layers != 0 && item.first_layer != last_layer_) {
    last_layer_ = item.first_layer;
    next_ = 0;
  }
  for (Index i = 0; i < stride; ++i, ++next_) {
    if (next_ == components_.size())
      components_.emplace_back(static_cast<std::size_t>(block_->points), no_index);
    for (Index point = 0; point < block_->points; ++point)
      if (const Index at = item.point_of(point); at != no_index)
        components_[next_][static_cast<std::size_t>(point)] = item.first + i + at * stride;
  }
}

double PointHistory::value(Index place, Index point, int variable) const {
  if (variable >= count()) return 0;
  const Index component = components_[static_cast<std::size_t>(variable)][static_cast<std::size_t>(point)];
  return component == no_index ? 0 : block_->state(place, component);
}

}  // namespace crumple::output
