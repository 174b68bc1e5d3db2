// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/sprague_geers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace crumple::compare {

namespace {

double peak(std::span<const double> values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// Per sample interval, of both divided by their peaks so that no square is too large or small to represent.
double integral(std::span<const double> first, double first_peak, std::span<const double> second,
                double second_peak) {
  double sum = 0;
  for (std::size_t sample = 0; sample < first.size(); ++sample) {
    const double weight = sample == 0 || sample + 1 == first.size() ? 0.5 : 1.0;
    sum += weight * (first[sample] / first_peak) * (second[sample] / second_peak);
  }
  return sum;
}

}  // namespace

SpragueGeers sprague_geers(std::span<const double> reference, std::span<const double> curve) {
  SpragueGeers errors;
  const double reference_peak = peak(reference);
  const double curve_peak = peak(curve);
  if (reference_peak == 0 && curve_peak == 0) return errors;
  if (reference_peak == 0) {
    errors.magnitude = std::numeric_limits<double>::infinity();
  } else if (curve_peak == 0) {
    errors.magnitude = -1;
  } else {
    const double reference_square = integral(reference, reference_peak, reference, reference_peak);
    const double curve_square = integral(curve, curve_peak, curve, curve_peak);
    const double product = integral(reference, reference_peak, curve, curve_peak);
    errors.magnitude = curve_peak / reference_peak * std::sqrt(curve_square / reference_square) - 1;
    const double cosine = product / std::sqrt(reference_square * curve_square);
    errors.phase = std::acos(std::clamp(cosine, -1.0, 1.0)) / std::numbers::pi;
  }
  errors.combined = std::hypot(errors.magnitude, errors.phase);
  return errors;
}

}  // namespace crumple::compare
