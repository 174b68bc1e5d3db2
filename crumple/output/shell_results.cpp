// SPDX-License-Identifier: BSD-3-Clause
#include "output/shell_results.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace crumple::output {

namespace {

/// Stress components per thickness point: xx, yy, xy, yz, zx.
constexpr Index stress_components = 5;

}  // namespace

ShellResults::ShellResults(const model::Model& model, const domain::ShellBlock& block)
    : model_(&model),
      block_(&block),
      stress_(block.find("stress")),
      plastic_strain_(block.find("plastic_strain")),
      thickness_(block.find("thickness")),
      active_(block.find("active")) {}

double ShellResults::plastic_strain(Index place) const {
  if (plastic_strain_ == nullptr) return 0;
  double largest = 0;
  for (Index i = 0; i < plastic_strain_->count; ++i)
    largest = std::max(largest, block_->state(place, plastic_strain_->first + i));
  return largest;
}

double ShellResults::von_mises(Index place) const {
  if (stress_ == nullptr) return 0;
  double largest = 0;
  for (Index point = 0; point < stress_->count / stress_components; ++point)
    largest = std::max(largest, von_mises_between(place, point, point));
  return largest;
}

double ShellResults::mid_von_mises(Index place) const {
  if (stress_ == nullptr) return 0;
  const Index points = stress_->count / stress_components;
  return von_mises_between(place, (points - 1) / 2, points / 2);
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

/// Of the mean of the stresses at two points; zz is zero in a shell.
double ShellResults::von_mises_between(Index place, Index first_point, Index second_point) const {
  std::array<double, stress_components> s{};
  for (Index i = 0; i < stress_components; ++i)
    s[i] = 0.5 * (block_->state(place, stress_->first + first_point * stress_components + i) +
                  block_->state(place, stress_->first + second_point * stress_components + i));
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4]));
}

}  // namespace crumple::output
