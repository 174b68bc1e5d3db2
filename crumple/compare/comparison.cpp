// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/error.hpp"
#include "compare/curves/quantity_names.hpp"
#include "compare/measures/channel_filter.hpp"
#include "compare/measures/resample.hpp"
#include "compare/scatter_bands.hpp"

namespace crumple::compare {

namespace {

bool is_wanted(const Curve& curve, const std::vector<std::string>& quantities) {
  if (quantities.empty()) return true;
  return std::any_of(quantities.begin(), quantities.end(), [&](const std::string& name) {
    return name == curve.quantity || name == curve.group || name == curve.group + "." + curve.quantity ||
           name == name_of(curve);
  });
}

using ByName = std::map<std::string, const Curve*>;

ByName by_name(const CurveSet& set) {
  ByName names;
  for (const Curve& curve : set.curves) names.try_emplace(name_of(curve), &curve);
  return names;
}

using BandsByName = std::map<std::string, const Band*>;

BandsByName by_name(const std::vector<Band>& bands) {
  BandsByName names;
  for (const Band& band : bands) names.try_emplace(band.name, &band);
  return names;
}

/// An interface of a surface with itself is `single` with us; LS-DYNA's binout shows it as a first side
/// alone.
const Curve* find_partner(const ByName& curves, const Curve& curve) {
  if (const auto found = curves.find(name_of(curve)); found != curves.end()) return found->second;
  if (curve.group != "rcforc") return nullptr;
  const std::size_t blank = curve.item.find(' ');
  if (blank == std::string::npos) return nullptr;
  const std::string side = curve.item.substr(blank + 1);
  if (side != "single" && side != "first") return nullptr;
  Curve like{curve.group, curve.quantity,
             curve.item.substr(0, blank) + (side == "single" ? " first" : " single")};
  const auto found = curves.find(name_of(like));
  return found == curves.end() ? nullptr : found->second;
}

using Pair = std::pair<const Curve*, const Curve*>;

/// Places tell what displacements tell, but their distance to the origin hides every difference.
bool says_nothing_new(const Curve& curve, const ByName& of_reference, const ByName& of_other) {
  if (curve.group != "nodout" || curve.quantity.size() != 1) return false;
  const std::string name = name_of({curve.group, "u" + curve.quantity, curve.item});
  return of_reference.contains(name) && of_other.contains(name);
}

class Pairing {
 public:
  Pairing(const CurveSet& reference, const CurveSet& other, const ComparisonSettings& settings)
      : settings_(settings), of_reference_(by_name(reference)), of_other_(by_name(other)) {
    for (const auto& [first, second] : settings.pairs)
      pairs_.emplace_back(&named(of_reference_, first, reference), &named(of_other_, second, other));
    for (const Curve& curve : reference.curves)
      if (const Curve* partner = find_partner(of_other_, curve)) add(curve, *partner);
  }

  const std::vector<Pair>& pairs() const { return pairs_; }

  /// Names of curves that were asked for and have no partner; sums of ours that nobody asks for are none of
  /// them.
  std::vector<std::string> lonely(const CurveSet& set, bool is_reference) const {
    std::set<const Curve*> paired;
    for (const auto& [first, second] : pairs_) paired.insert(is_reference ? first : second);
    const ByName& others = is_reference ? of_other_ : of_reference_;
    std::vector<std::string> names;
    for (const Curve& curve : set.curves)
      if (!curve.derived && !paired.contains(&curve) && find_partner(others, curve) == nullptr &&
          is_wanted(curve, settings_.quantities))
        names.push_back(name_of(curve));
    return names;
  }

 private:
  static const Curve& named(const ByName& curves, const std::string& name, const CurveSet& set) {
    const auto found = curves.find(name);
    if (found == curves.end()) throw Error(fmt::format("{} has no curve {}.", set.source, name));
    return *found->second;
  }

  void add(const Curve& curve, const Curve& partner) {
    if (curve.derived && partner.derived) return;
    if (!is_wanted(curve, settings_.quantities) || says_nothing_new(curve, of_reference_, of_other_)) return;
    for (const auto& [first, second] : pairs_)
      if (first == &curve || second == &partner) return;
    pairs_.emplace_back(&curve, &partner);
  }

  const ComparisonSettings& settings_;
  ByName of_reference_;
  ByName of_other_;
  std::vector<Pair> pairs_;
};

double peak_between(const Curve& curve, double start, double end) {
  double most = std::max(std::abs(value_at(curve, start)), std::abs(value_at(curve, end)));
  const auto first = std::lower_bound(curve.times.begin(), curve.times.end(), start);
  for (auto place = static_cast<std::size_t>(first - curve.times.begin());
       place < curve.times.size() && curve.times[place] <= end; ++place)
    most = std::max(most, std::abs(curve.values[place]));
  return most;
}

/// What can be said without scores. Nothing if the curves have no common time.
std::optional<ComparedCurve> measured(const Pair& pair, const ComparisonSettings& settings,
                                      std::size_t& unfiltered) {
  ComparedCurve result;
  result.reference = *pair.first;
  result.other = *pair.second;
  if (settings.cfc != 0) {
    const bool first = filter_curve(result.reference, settings.cfc, settings.seconds_per_unit);
    const bool second = filter_curve(result.other, settings.cfc, settings.seconds_per_unit);
    if (!first || !second) {
      // Only one of them filtered would be no comparison.
      result.reference = *pair.first;
      result.other = *pair.second;
      ++unfiltered;
    }
  }
  const auto times = common_times(result.reference, result.other, settings.interval);
  if (!times) return std::nullopt;
  result.start = times->start;
  result.end = times->end;
  result.samples = times->samples;
  const LargestDifference largest =
      largest_difference(result.reference, result.other, times->start, times->end);
  result.peak = largest.peak;
  result.difference = largest.difference;
  result.time = largest.time;
  if (largest.difference != 0)
    result.relative = largest.peak > 0 ? std::abs(largest.difference) / largest.peak
                                       : std::numeric_limits<double>::infinity();
  return result;
}

void rate(ComparedCurve& curve, const ComparisonSettings& settings) {
  const auto times = common_times(curve.reference, curve.other, settings.interval);
  const std::vector<double> reference = resample(curve.reference, *times);
  const std::vector<double> other = resample(curve.other, *times);
  curve.errors = sprague_geers(reference, other);
  if (reference.size() >= fewest_rated_samples) curve.rating = iso_rating(reference, other);
}

void add_notes(Comparison& comparison, std::size_t unfiltered, const ComparisonSettings& settings,
               const std::vector<std::string>& apart) {
  if (unfiltered > 0)
    comparison.notes.push_back(fmt::format(
        "{} curves have too few points for CFC {} and were compared as they are.", unfiltered, settings.cfc));
  if (!apart.empty())
    comparison.notes.push_back(
        fmt::format("{} curves have no common time, the first is {}.", apart.size(), apart[0]));
  for (const ComparedCurve& curve : comparison.curves) {
    const double longest = std::max(curve.reference.times.back(), curve.other.times.back());
    const double span = curve.end - curve.start;
    if (longest - curve.end <= 0.01 * span) continue;
    const bool reference = curve.reference.times.back() > curve.other.times.back();
    comparison.notes.push_back(
        fmt::format("Times differ: {} goes on to {:.6g} in the {}, only times to {:.6g} are compared.",
                    name_of(curve.reference), longest, reference ? "reference" : "other results", curve.end));
    return;
  }
}

}  // namespace

bool Comparison::within(double tolerance) const {
  return std::all_of(curves.begin(), curves.end(),
                     [&](const ComparedCurve& curve) { return curve.relative <= tolerance; });
}

LargestDifference largest_difference(const Curve& reference, const Curve& other, double start, double end) {
  LargestDifference largest{start, value_at(other, start) - value_at(reference, start),
                            peak_between(reference, start, end)};
  const auto look_at = [&](double time) {
    const double difference = value_at(other, time) - value_at(reference, time);
    if (std::abs(difference) > std::abs(largest.difference)) {
      largest.difference = difference;
      largest.time = time;
    }
  };
  for (const Curve* curve : {&reference, &other})
    for (const double time : curve->times)
      if (time >= start && time <= end) look_at(time);
  look_at(end);
  return largest;
}

Comparison compare(const CurveSet& reference, const CurveSet& other, const ComparisonSettings& settings,
                   const CompareProgress& progress) {
  const Pairing pairing(reference, other, settings);
  Comparison comparison;
  std::size_t unfiltered = 0;
  std::vector<std::string> apart;
  std::vector<ComparedCurve> all;
  std::map<std::string, double> largest_of_kind;
  const BandsByName bands = by_name(reference.bands);
  for (const Pair& pair : pairing.pairs()) {
    std::optional<ComparedCurve> result = measured(pair, settings, unfiltered);
    if (!result) {
      apart.push_back(name_of(*pair.first));
      continue;
    }
    if (const auto band = bands.find(name_of(*pair.first)); band != bands.end())
      result->inside_band = share_inside(*band->second, *pair.second);
    double& largest = largest_of_kind[kind_of(result->reference)];
    largest = std::max({largest, result->peak, peak_between(result->other, result->start, result->end)});
    all.push_back(std::move(*result));
  }
  for (std::size_t place = 0; place < all.size(); ++place) {
    ComparedCurve& curve = all[place];
    if (progress) progress(place + 1, all.size());
    const double size = std::max(curve.peak, peak_between(curve.other, curve.start, curve.end));
    curve.negligible = size == 0 || size < settings.floor * largest_of_kind[kind_of(curve.reference)];
    if (!curve.negligible) rate(curve, settings);
    (curve.negligible ? comparison.negligible : comparison.curves).push_back(std::move(curve));
  }
  for (std::vector<ComparedCurve>* list : {&comparison.curves, &comparison.negligible})
    std::stable_sort(list->begin(), list->end(),
                     [](const ComparedCurve& a, const ComparedCurve& b) { return a.relative > b.relative; });
  comparison.only_reference = pairing.lonely(reference, true);
  comparison.only_other = pairing.lonely(other, false);
  add_notes(comparison, unfiltered, settings, apart);
  return comparison;
}

}  // namespace crumple::compare
