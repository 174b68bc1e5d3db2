// SPDX-License-Identifier: BSD-3-Clause
#include "output/results/solid_results.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::output {

namespace {

double von_mises_of(const std::array<double, 6>& s) {
  const double a = s[0] - s[1];
  const double b = s[1] - s[2];
  const double c = s[2] - s[0];
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

}  // namespace

SolidResults::SolidResults(const domain::SolidBlock& block)
    : block_(&block),
      stress_(block.find("stress")),
      plastic_strain_(block.find("plastic_strain")),
      active_(block.find("active")) {}

SolidResults::Stress SolidResults::stress(Index place, Index point) const {
  Stress found{};
  if (stress_ == nullptr) return found;
  for (std::size_t c = 0; c < found.size(); ++c)
    found[c] = block_->state(place, stress_->first + 6 * point + static_cast<Index>(c));
  return found;
}

SolidResults::Stress SolidResults::mean_stress(Index place) const {
  Stress mean{};
  for (Index point = 0; point < block_->points; ++point) {
    const Stress one = stress(place, point);
    for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += one[c] / block_->points;
  }
  return mean;
}

double SolidResults::plastic_strain(Index place) const {
  if (plastic_strain_ == nullptr) return 0;
  double largest = 0;
  for (Index i = 0; i < plastic_strain_->count; ++i)
    largest = std::max(largest, block_->state(place, plastic_strain_->first + i));
  return largest;
}

double SolidResults::mean_plastic_strain(Index place) const {
  if (plastic_strain_ == nullptr) return 0;
  double sum = 0;
  for (Index i = 0; i < plastic_strain_->count; ++i) sum += block_->state(place, plastic_strain_->first + i);
  return sum / plastic_strain_->count;
}

double SolidResults::von_mises(Index place) const {
  double largest = 0;
  for (Index point = 0; point < block_->points; ++point)
    largest = std::max(largest, von_mises_of(stress(place, point)));
  return largest;
}

double SolidResults::mean_von_mises(Index place) const {
  return von_mises_of(mean_stress(place));
}

double SolidResults::pressure(Index place) const {
  const Stress mean = mean_stress(place);
  return -(mean[0] + mean[1] + mean[2]) / 3;
}

bool SolidResults::alive(Index place) const {
  return active_ == nullptr || block_->state(place, active_->first) != 0;
}

}  // namespace crumple::output
