// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/curves/curve.hpp"
#include "compare/measures/iso_rating.hpp"
#include "compare/measures/sprague_geers.hpp"

namespace crumple::compare {

struct ComparisonSettings {
  /// Quantities, groups, `group.quantity` or whole names of curves to look at; empty is all.
  std::vector<std::string> quantities;
  /// Names of a curve of the reference and of the other side that belong together under different names.
  std::vector<std::pair<std::string, std::string>> pairs;
  int cfc = 0;                     ///< channel frequency class of the filter [Hz]; 0 is none
  double seconds_per_unit = 1;     ///< what one unit of time of the curves is, for the filter [s]
  std::optional<double> interval;  ///< between common samples [time]
  /// Curves that stay below this share of the largest of their kind on both sides are not rated [-].
  double floor = 0.01;
};

/// One curve on both sides and how far apart they are. Both have passed the filter, if there is one.
struct ComparedCurve {
  Curve reference;
  Curve other;
  double start = 0;         ///< of the common time [time]
  double end = 0;           ///< [time]
  std::size_t samples = 0;  ///< common samples that were rated
  double peak = 0;          ///< largest size of the reference in the common time
  double difference = 0;    ///< largest one: other - reference
  double time = 0;          ///< when it occurs [time]
  /// Size of the difference over the peak [-]; infinite if the reference is zero and the other is not.
  double relative = 0;
  bool negligible = false;  ///< zero, or below the floor: without scores
  SpragueGeers errors;
  IsoRating rating;
  /// Share of the reference's times at which the other lies in the band of the reference's runs [-].
  std::optional<double> inside_band;
};

struct Comparison {
  std::vector<ComparedCurve> curves;        ///< worst relative difference first
  std::vector<ComparedCurve> negligible;    ///< zero, or below the floor
  std::vector<std::string> only_reference;  ///< names of curves that the other side does not have
  std::vector<std::string> only_other;
  std::vector<std::string> notes;       ///< sentences
  bool within(double tolerance) const;  ///< no rated curve differs by more, relative to its peak
};

/// Told how many of how many curves are done.
using CompareProgress = std::function<void(std::size_t, std::size_t)>;

/// Compares the curves that both sides have, over their common times. Throws Error for a pair whose curves
/// are not there and for an interval that does not fit.
Comparison compare(const CurveSet& reference, const CurveSet& other, const ComparisonSettings& settings,
                   const CompareProgress& progress = {});

/// The largest difference of two curves between two times, of the lines between their points; it lies at a
/// point of one of them.
struct LargestDifference {
  double time = 0;        ///< [time]
  double difference = 0;  ///< other - reference
  double peak = 0;        ///< largest size of the reference
};
LargestDifference largest_difference(const Curve& reference, const Curve& other, double start, double end);

}  // namespace crumple::compare
