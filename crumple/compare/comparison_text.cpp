// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace crumple::compare {

namespace {

/// Names in a list of curves without scores.
constexpr std::size_t most_listed = 8;

std::string percent(double share) {
  if (!std::isfinite(share)) return "ref. zero";
  if (share >= 100) return fmt::format("x {:.3g}", share);
  return share == 0 ? "0 %" : fmt::format("{:.3g} %", 100 * share);
}

std::string score(double value) {
  if (!std::isfinite(value)) return "-";
  return std::abs(value) < 100 ? fmt::format("{:.3f}", value) : fmt::format("{:.1e}", value);
}

void add_sides(std::string& text, const CurveSet& reference, const CurveSet& other) {
  const auto files = [](const CurveSet& set) {
    std::string list;
    for (const std::string& file : set.files) list += (list.empty() ? "" : " ") + file;
    return list;
  };
  fmt::format_to(std::back_inserter(text), "reference: {}   {} curves ({})\n    other: {}   {} curves ({})\n",
                 reference.source, reference.curves.size(), files(reference), other.source,
                 other.curves.size(), files(other));
}

void add_range(std::string& text, const Comparison& comparison, int cfc) {
  double start = comparison.curves.front().start;
  double end = comparison.curves.front().end;
  auto [fewest, most] = std::pair(comparison.curves.front().samples, comparison.curves.front().samples);
  for (const ComparedCurve& curve : comparison.curves) {
    start = std::min(start, curve.start);
    end = std::max(end, curve.end);
    fewest = std::min(fewest, curve.samples);
    most = std::max(most, curve.samples);
  }
  const std::string samples =
      fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
  const std::string filter = cfc == 0 ? "" : fmt::format(", through SAE CFC {}", cfc);
  fmt::format_to(std::back_inserter(text),
                 "rated over the common times {:.6g} to {:.6g}, {} samples by linear interpolation{}\n\n",
                 start, end, samples, filter);
}

/// Of a reference that is the median of several runs.
std::string in_band(const ComparedCurve& curve) {
  return curve.inside_band ? fmt::format(", {} of the time in the band", percent(*curve.inside_band)) : "";
}

void add_rows(std::string& text, const Comparison& comparison, std::size_t rows) {
  std::size_t width = 20;
  for (std::size_t row = 0; row < rows; ++row)
    width = std::max(width, name_of(comparison.curves[row].reference).size());
  fmt::format_to(
      std::back_inserter(text),
      "{:<{}} {:>23} {:>11} | {:^22} | ISO/TS 18571: corridor,\n{:<{}} {:>11} {:>11} {:>11} | {:>6} {:>7} "
      "{:>7} | phase, magn., slope    total\n",
      "", width, "worst difference", "", "Sprague-Geers", "curve", width, "", "of peak", "at time", "M", "P",
      "C");
  for (std::size_t row = 0; row < rows; ++row) {
    const ComparedCurve& curve = comparison.curves[row];
    const IsoRating& rating = curve.rating;
    fmt::format_to(
        std::back_inserter(text),
        "{:<{}} {:>11.4g} {:>11} {:>11.5g} | {:>6} {:>7} {:>7} | {:.2f} {:.2f} {:.2f} {:.2f}  {:.3f} {}{}\n",
        name_of(curve.reference), width, curve.difference, percent(curve.relative), curve.time,
        score(curve.errors.magnitude), score(curve.errors.phase), score(curve.errors.combined),
        rating.corridor, rating.phase, rating.magnitude, rating.slope, rating.rating, grade_of(rating.rating),
        in_band(curve));
  }
  if (rows < comparison.curves.size())
    fmt::format_to(std::back_inserter(text), "... and {} more that differ less (--rows 0 shows all)\n",
                   comparison.curves.size() - rows);
}

void add_list(std::string& text, const std::string& heading, const std::vector<std::string>& names) {
  if (names.empty()) return;
  text += heading + ":";
  for (std::size_t i = 0; i < std::min(names.size(), most_listed); ++i)
    text += (i == 0 ? " " : ", ") + names[i];
  if (names.size() > most_listed) fmt::format_to(std::back_inserter(text), ", ... ({} in all)", names.size());
  text += "\n";
}

void add_summary(std::string& text, const Comparison& comparison, std::optional<double> tolerance) {
  std::map<std::string, std::size_t> grades;
  for (const ComparedCurve& curve : comparison.curves) ++grades[grade_of(curve.rating.rating)];
  std::string list;
  for (const char* grade : {"excellent", "good", "fair", "poor"})
    if (grades.contains(grade))
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", grades[grade], grade);
  const ComparedCurve& worst = comparison.curves.front();
  fmt::format_to(std::back_inserter(text), "\n{} curves: {}; worst difference {} of the peak, {}\n",
                 comparison.curves.size(), list, percent(worst.relative), name_of(worst.reference));
  if (!tolerance) return;
  const auto beyond = std::count_if(comparison.curves.begin(), comparison.curves.end(),
                                    [&](const ComparedCurve& curve) { return curve.relative > *tolerance; });
  if (beyond == 0)
    fmt::format_to(std::back_inserter(text), "all within {} of the peak\n", percent(*tolerance));
  else
    fmt::format_to(std::back_inserter(text), "{} of them beyond {} of the peak\n", beyond,
                   percent(*tolerance));
}

}  // namespace

std::string comparison_table(const Comparison& comparison, const CurveSet& reference, const CurveSet& other,
                             const TableOptions& options) {
  std::string text;
  add_sides(text, reference, other);
  if (!comparison.curves.empty()) {
    const std::size_t all = comparison.curves.size();
    add_range(text, comparison, options.cfc);
    add_rows(text, comparison, options.rows == 0 ? all : std::min(options.rows, all));
    add_summary(text, comparison, options.tolerance);
  }
  std::vector<std::string> small;
  for (const ComparedCurve& curve : comparison.negligible) small.push_back(name_of(curve.reference));
  add_list(text, "not rated, as they are zero or small beside others of their kind on both sides", small);
  add_list(text, "only in the reference", comparison.only_reference);
  add_list(text, "only in the other", comparison.only_other);
  for (const CurveSet* side : {&reference, &other})
    for (const std::string& note : side->notes) text += "note: " + note + "\n";
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace crumple::compare
