// SPDX-License-Identifier: BSD-3-Clause
#include "compare/scatter_bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <unordered_map>

#include "report/scatter_folder.hpp"

namespace crumple::compare {

namespace {

/// The curves of one name, the first run's first; empty if a run does not have it.
std::vector<const Curve*> same_curves(
    const std::string& name, const std::vector<std::unordered_map<std::string, const Curve*>>& runs) {
  std::vector<const Curve*> same;
  for (const auto& run : runs) {
    const auto found = run.find(name);
    if (found == run.end() || found->second->times.empty()) return {};
    same.push_back(found->second);
  }
  return same;
}

Band band_of(const std::string& name, const std::vector<const Curve*>& same) {
  Band band{name, same.size(), {}, {}, {}, {}, {}};
  double start = same.front()->times.front();
  double end = same.front()->times.back();
  for (const Curve* curve : same) {
    start = std::max(start, curve->times.front());
    end = std::min(end, curve->times.back());
  }
  std::vector<double> values(same.size());
  for (std::size_t point = 0; point < same.front()->times.size(); ++point) {
    const double time = same.front()->times[point];
    if (time < start || time > end) continue;
    std::ranges::transform(same, values.begin(), [&](const Curve* curve) { return value_at(*curve, time); });
    std::ranges::sort(values);
    band.times.push_back(time);
    band.first.push_back(same.front()->values[point]);
    band.median.push_back(quantile(values, 0.5));
    band.p5.push_back(quantile(values, 0.05));
    band.p95.push_back(quantile(values, 0.95));
  }
  return band;
}

bool read_number(std::string_view text, double& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

/// The cells of a row; false if it does not have as many as a table of bands.
bool split_row(std::string_view row, std::array<std::string_view, 7>& cells) {
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::size_t comma = row.find(',');
    if ((comma == std::string_view::npos) != (cell + 1 == cells.size())) return false;
    cells[cell] = row.substr(0, comma);
    if (comma != std::string_view::npos) row.remove_prefix(comma + 1);
  }
  return true;
}

}  // namespace

double quantile(const std::vector<double>& ascending, double share) {
  const double place = share * static_cast<double>(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= ascending.size()) return ascending.back();
  return std::lerp(ascending[below], ascending[below + 1], place - static_cast<double>(below));
}

std::vector<Band> bands_of(const std::vector<CurveSet>& runs) {
  std::vector<std::unordered_map<std::string, const Curve*>> named(runs.size());
  for (std::size_t run = 0; run < runs.size(); ++run)
    for (const Curve& curve : runs[run].curves) named[run].emplace(name_of(curve), &curve);
  std::vector<Band> bands;
  if (runs.empty()) return bands;
  for (const Curve& curve : runs.front().curves) {
    const std::string name = name_of(curve);
    const std::vector<const Curve*> same = same_curves(name, named);
    if (same.empty()) continue;
    Band band = band_of(name, same);
    if (!band.times.empty()) bands.push_back(std::move(band));
  }
  return bands;
}

double largest_median(const Band& band) {
  double peak = 0;
  for (const double value : band.median) peak = std::max(peak, std::abs(value));
  return peak;
}

double relative_width(const Band& band) {
  double width = 0;
  for (std::size_t point = 0; point < band.times.size(); ++point)
    width = std::max(width, band.p95[point] - band.p5[point]);
  const double peak = largest_median(band);
  return peak > 0 ? width / peak : 0;
}

std::string bands_csv(const std::vector<Band>& bands) {
  std::string text(report::bands_header);
  for (const Band& band : bands)
    for (std::size_t point = 0; point < band.times.size(); ++point)
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", band.times[point], band.name,
                     band.runs, band.first[point], band.median[point], band.p5[point], band.p95[point]);
  return text;
}

std::vector<Band> read_bands(std::string_view text) {
  std::vector<Band> bands;
  if (!text.starts_with(report::bands_header)) return bands;
  std::map<std::string, std::size_t, std::less<>> places;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) break;
    std::array<std::string_view, 7> cells;
    const bool whole = split_row(text.substr(0, end), cells);
    text.remove_prefix(end + 1);
    std::array<double, 6> numbers{};
    const std::array<std::size_t, 6> columns{0, 2, 3, 4, 5, 6};
    bool good = whole;
    for (std::size_t i = 0; good && i < columns.size(); ++i)
      good = read_number(cells[columns[i]], numbers[i]);
    if (!good || numbers[1] < 1) continue;
    const auto [place, is_new] = places.try_emplace(std::string(cells[1]), bands.size());
    if (is_new)
      bands.push_back({std::string(cells[1]), static_cast<std::size_t>(numbers[1]), {}, {}, {}, {}, {}});
    Band& band = bands[place->second];
    band.times.push_back(numbers[0]);
    band.first.push_back(numbers[2]);
    band.median.push_back(numbers[3]);
    band.p5.push_back(numbers[4]);
    band.p95.push_back(numbers[5]);
  }
  return bands;
}

std::vector<Curve> medians_of(const std::vector<Band>& bands) {
  std::vector<Curve> medians;
  for (const Band& band : bands) {
    Curve median = curve_named(band.name);
    median.times = band.times;
    median.values = band.median;
    medians.push_back(std::move(median));
  }
  return medians;
}

std::optional<double> share_inside(const Band& band, const Curve& curve) {
  std::size_t inside = 0;
  std::size_t all = 0;
  if (curve.times.empty()) return std::nullopt;
  for (std::size_t point = 0; point < band.times.size(); ++point) {
    const double time = band.times[point];
    if (time < curve.times.front() || time > curve.times.back()) continue;
    const double value = value_at(curve, time);
    ++all;
    if (value >= band.p5[point] && value <= band.p95[point]) ++inside;
  }
  if (all == 0) return std::nullopt;
  return static_cast<double>(inside) / static_cast<double>(all);
}

}  // namespace crumple::compare
