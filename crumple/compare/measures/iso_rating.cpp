// SPDX-License-Identifier: BSD-3-Clause
#include "compare/measures/iso_rating.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "compare/measures/time_warp.hpp"

namespace crumple::compare {

namespace {

using Samples = std::span<const double>;

// The constants have the names and values of the standard.
constexpr double a_0 = 0.05;
constexpr double b_0 = 0.5;
constexpr double most_shift = 0.2;
constexpr double epsilon_m = 0.5;
constexpr double epsilon_s = 2.0;
constexpr double warping_window = 0.1;

double peak(Samples values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double corridor_score(Samples reference, Samples curve) {
  const double norm = peak(reference);
  double sum = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const double distance = std::abs(reference[i] - curve[i]);
    const double share = (b_0 * norm - distance) / ((b_0 - a_0) * norm);
    if (distance <= a_0 * norm)
      sum += 1;
    else if (distance < b_0 * norm)
      sum += share * share;
  }
  return sum / static_cast<double>(reference.size());
}

/// Varies by so little that its phase and slope are those of rounding. The inner corridor is 50 times as
/// wide.
bool is_flat(Samples values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low <= 1e-3 * peak(values);
}

/// Pearson's coefficient; nothing if one of the two is constant.
std::optional<double> correlation(Samples first, Samples second) {
  const auto mean = [](Samples values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  };
  const double first_mean = mean(first);
  const double second_mean = mean(second);
  double first_square = 0;
  double second_square = 0;
  double product = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double a = first[i] - first_mean;
    const double b = second[i] - second_mean;
    first_square += a * a;
    second_square += b * b;
    product += a * b;
  }
  const double size = std::sqrt(first_square) * std::sqrt(second_square);
  // Rounding of the means leaves this much of a constant.
  const auto rounding = [](Samples values) {
    return static_cast<double>(values.size()) * std::pow(1e-15 * peak(values), 2);
  };
  if (!(first_square > rounding(first)) || !(second_square > rounding(second))) return std::nullopt;
  return product / size;
}

struct Aligned {
  Samples reference;
  Samples curve;
};

/// The overlap when the curve is moved so that it comes `shift` samples earlier.
Aligned aligned(Samples reference, Samples curve, long shift) {
  const auto cut = static_cast<std::size_t>(std::abs(shift));
  const std::size_t rest = reference.size() - cut;
  if (shift >= 0) return {reference.first(rest), curve.last(rest)};
  return {reference.last(rest), curve.first(rest)};
}

/// Samples that the curve comes later than the reference, by their best correlation. Where rounding alone
/// decides, as between straight lines, which correlate at any shift, the smallest one is meant.
long find_shift(Samples reference, Samples curve) {
  constexpr double rounding = 1e-10;
  const auto window = static_cast<long>(std::floor(static_cast<double>(curve.size()) * most_shift)) + 1;
  std::vector<std::pair<long, double>> found;
  double best = -1;
  const auto look_at = [&](long shift) {
    const Aligned overlap = aligned(reference, curve, shift);
    const std::optional<double> by_shift = correlation(overlap.curve, overlap.reference);
    if (!by_shift) return;
    found.emplace_back(shift, *by_shift);
    best = std::max(best, *by_shift);
  };
  look_at(0);
  for (long size = 1; size < window; ++size) {
    look_at(-size);
    look_at(size);
  }
  look_at(-window);
  for (const auto& [shift, by_shift] : found)
    if (by_shift >= best - rounding) return shift;
  return 0;
}

double phase_score(std::size_t samples, long shift) {
  const double most = most_shift * static_cast<double>(samples);
  return std::max(0.0, (most - static_cast<double>(std::abs(shift))) / most);
}

/// 1 - error / limit between 0 and 1; `error` is a quotient.
double linear_score(double numerator, double denominator, double limit) {
  if (numerator == 0) return 1;
  if (denominator == 0) return 0;
  return std::max(0.0, 1 - numerator / denominator / limit);
}

double magnitude_score(const Aligned& pair) {
  const auto band =
      static_cast<std::size_t>(std::ceil(warping_window * static_cast<double>(pair.reference.size())));
  double difference = 0;
  double size = 0;
  for (const auto& [of_curve, of_reference] : warping_path(pair.curve, pair.reference, band)) {
    difference += std::abs(pair.curve[of_curve] - pair.reference[of_reference]);
    size += std::abs(pair.reference[of_reference]);
  }
  return linear_score(difference, size, epsilon_m);
}

/// Central differences per sample, one-sided at the ends, averaged over nine samples, or as many as lie
/// evenly around a sample near the ends.
std::vector<double> smoothed_slopes(Samples values) {
  const std::size_t count = values.size();
  std::vector<double> slopes(count);
  slopes[0] = values[1] - values[0];
  slopes[count - 1] = values[count - 1] - values[count - 2];
  for (std::size_t i = 1; i + 1 < count; ++i) slopes[i] = 0.5 * (values[i + 1] - values[i - 1]);
  std::vector<double> smooth(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t half = std::min({std::size_t{4}, i, count - 1 - i});
    double sum = 0;
    for (std::size_t k = i - half; k <= i + half; ++k) sum += slopes[k];
    smooth[i] = sum / static_cast<double>(2 * half + 1);
  }
  return smooth;
}

double slope_score(const Aligned& pair) {
  const std::vector<double> of_reference = smoothed_slopes(pair.reference);
  const std::vector<double> of_curve = smoothed_slopes(pair.curve);
  double difference = 0;
  double size = 0;
  for (std::size_t i = 0; i < of_reference.size(); ++i) {
    difference += std::abs(of_curve[i] - of_reference[i]);
    size += std::abs(of_reference[i]);
  }
  return linear_score(difference, size, epsilon_s);
}

}  // namespace

const char* grade_of(double rating) {
  if (rating > 0.94) return "excellent";
  if (rating > 0.80) return "good";
  if (rating > 0.58) return "fair";
  return "poor";
}

IsoRating iso_rating(std::span<const double> reference, std::span<const double> curve) {
  IsoRating rating;
  const bool flat = is_flat(reference) && is_flat(curve);
  rating.shift = flat ? 0 : find_shift(reference, curve);
  const Aligned pair = aligned(reference, curve, rating.shift);
  rating.corridor = corridor_score(reference, curve);
  rating.phase = phase_score(reference.size(), rating.shift);
  rating.magnitude = magnitude_score(pair);
  rating.slope = flat ? 1 : slope_score(pair);
  rating.rating = 0.4 * rating.corridor + 0.2 * (rating.phase + rating.magnitude + rating.slope);
  return rating;
}

}  // namespace crumple::compare
