// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/shell_results.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::output {

namespace {

/// zz is zero in a shell.
double von_mises_of(const ShellResults::Stress& s) {
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4]));
}

}  // namespace

ShellResults::ShellResults(const model::Model& model, const domain::ShellBlock& block)
    : model_(&model),
      block_(&block),
      stress_(block.find("stress")),
      thickness_(block.find("thickness")),
      active_(block.find("active")) {
  for (const domain::StateItem& item : block.items)
    if (item.name == "plastic_strain") plastic_strains_.push_back(&item);
}

double ShellResults::plastic_strain(Index place) const {
  double largest = 0;
  for (const domain::StateItem* item : plastic_strains_)
    for (Index i = 0; i < item->count; ++i)
      largest = std::max(largest, block_->state(place, item->first + i));
  return largest;
}

double ShellResults::von_mises(Index place) const {
  if (stress_ == nullptr) return 0;
  double largest = 0;
  for (Index point = 0; point < stress_->count / stress_components; ++point) {
    Stress stress{};
    add_stress(place, point, 1, stress);
    largest = std::max(largest, von_mises_of(stress));
  }
  return largest;
}

double ShellResults::mid_von_mises(Index place) const {
  if (stress_ == nullptr) return 0;
  const Index planes = block_->plane_points;
  const Index points = stress_->count / stress_components / planes;
  Stress mean{};
  for (Index plane = 0; plane < planes; ++plane) {
    add_stress(place, plane * points + (points - 1) / 2, 0.5 / planes, mean);
    add_stress(place, plane * points + points / 2, 0.5 / planes, mean);
  }
  return von_mises_of(mean);
}

double ShellResults::thickness(Index place) const {
  double sum = 0;
  if (thickness_ == nullptr) {
    const auto corners = model::shell_thickness(*model_, model_->shells[block_->element[place]]);
    for (const double corner : corners) sum += corner;
    return sum / static_cast<double>(corners.size());
  }
  for (Index i = 0; i < thickness_->count; ++i) sum += block_->state(place, thickness_->first + i);
  return sum / thickness_->count;
}

bool ShellResults::alive(Index place) const {
  return active_ == nullptr || block_->state(place, active_->first) != 0;
}

void ShellResults::add_stress(Index place, Index point, double share, Stress& sum) const {
  for (Index i = 0; i < stress_components; ++i)
    sum[i] += share * block_->state(place, stress_->first + point * stress_components + i);
}

}  // namespace crumple::output
