// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

namespace crumple::compare {

/// The objective rating of ISO/TS 18571 for signals without ambiguity; each score lies between 0 and 1
/// (perfect).
struct IsoRating {
  double corridor = 1;   ///< Z: distance to the reference, of its peak: 1 within 5 %, 0 beyond 50 %
  double phase = 1;      ///< E_P: shift of best correlation, 0 from 20 % of the span on
  double magnitude = 1;  ///< E_M: difference after the shift and dynamic time warping
  double slope = 1;      ///< E_S: difference of smoothed slopes after the shift
  double rating = 1;     ///< R = 0.4 Z + 0.2 (E_P + E_M + E_S)
  long shift = 0;        ///< samples that the curve comes later than the reference (negative: earlier)
};

/// Fewest samples of a rating: slopes are averaged over nine.
inline constexpr std::size_t fewest_rated_samples = 12;

/// "excellent" above 0.94, "good" above 0.80, "fair" above 0.58, else "poor".
const char* grade_of(double rating);

/// Rates evenly spaced samples, as many of each and fewest_rated_samples at least. The standard asks for 10
/// kHz.
///
/// Where the standard has no answer: without correlation (one of the curves is constant) there is no shift
/// and E_P is 1; where the reference is zero or has no slope, E_M and E_S are 1 if the curve is the same,
/// else 0.
IsoRating iso_rating(std::span<const double> reference, std::span<const double> curve);

}  // namespace crumple::compare
