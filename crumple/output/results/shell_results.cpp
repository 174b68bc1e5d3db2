// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/shell_results.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "output/results/point_results.hpp"

namespace crumple::output {

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

/// zz is zero in a shell.
double ShellResults::von_mises_of(const Stress& s) {
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * (s[2] * s[2] + s[3] * s[3] + s[4] * s[4]));
}

double ShellResults::pressure(Index place) const {
  double sum = 0;
  for (Index layer = 0; layer < layers(); ++layer) {
    const Stress mean = stress(place, layer);
    sum -= (mean[0] + mean[1]) / 3;
  }
  return sum / layers();
}

Index ShellResults::layers() const {
  return stress_ == nullptr ? 1 : stress_->count / stress_components / block_->plane_points;
}

std::array<Index, 2> ShellResults::layers_at(Surface surface) const {
  const Index last = layers() - 1;
  switch (surface) {
    case Surface::Inner:
      return {0, 0};
    case Surface::Middle:
      return {last / 2, (last + 1) / 2};
    case Surface::Outer:
      return {last, last};
  }
  return {};
}

ShellResults::Stress ShellResults::stress(Index place, Index layer) const {
  Stress mean{};
  const Index planes = block_->plane_points;
  for (Index plane = 0; plane < planes && stress_ != nullptr; ++plane)
    add_stress(place, plane * layers() + layer, 1.0 / planes, mean);
  return mean;
}

ShellResults::Stress ShellResults::stress(Index place, Surface surface) const {
  const auto [below, above] = layers_at(surface);
  Stress mean = stress(place, below);
  const Stress other = stress(place, above);
  for (std::size_t c = 0; c < mean.size(); ++c) mean[c] = 0.5 * (mean[c] + other[c]);
  return mean;
}

double ShellResults::plastic_strain(Index place, Index layer) const {
  double mean = 0;
  const Index planes = block_->plane_points;
  for (Index plane = 0; plane < planes; ++plane)
    mean += plastic_strain_of(*block_, place, plane * layers() + layer) / planes;
  return mean;
}

double ShellResults::plastic_strain(Index place, Surface surface) const {
  const auto [below, above] = layers_at(surface);
  return 0.5 * (plastic_strain(place, below) + plastic_strain(place, above));
}

double ShellResults::first_thickness(Index place) const {
  const auto corners = model::shell_thickness(*model_, model_->shells[block_->element[place]]);
  return std::accumulate(corners.begin(), corners.end(), 0.0) / static_cast<double>(corners.size());
}

double ShellResults::thickness(Index place) const {
  if (thickness_ == nullptr) return first_thickness(place);
  double sum = 0;
  for (Index i = 0; i < thickness_->count; ++i) sum += block_->state(place, thickness_->first + i);
  return sum / thickness_->count;
}

double ShellResults::thickness_change(Index place) const {
  return thickness(place) / first_thickness(place) - 1;
}

bool ShellResults::alive(Index place) const {
  return active_ == nullptr || block_->state(place, active_->first) != 0;
}

void ShellResults::add_stress(Index place, Index point, double share, Stress& sum) const {
  for (Index i = 0; i < stress_components; ++i)
    sum[i] += share * block_->state(place, stress_->first + point * stress_components + i);
}

}  // namespace crumple::output
