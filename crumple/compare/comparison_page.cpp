// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/comparison_json.hpp"
#include "report/page.hpp"

namespace crumple::compare {

namespace {

using Json = nlohmann::ordered_json;

/// Points of a curve that are drawn.
constexpr std::size_t most_points = 1000;

/// As many digits as a picture shows.
double rounded(double value) {
  return std::stod(fmt::format("{:.7g}", value));
}

/// All points if they are few, else of each stretch of the curve the lowest and the highest one, so that no
/// peak is lost.
Json points(const Curve& curve) {
  Json times = Json::array();
  Json values = Json::array();
  const auto add = [&](std::size_t place) {
    times.push_back(rounded(curve.times[place]));
    values.push_back(rounded(curve.values[place]));
  };
  const std::size_t count = curve.times.size();
  if (count <= most_points) {
    for (std::size_t place = 0; place < count; ++place) add(place);
    return {times, values};
  }
  const std::size_t stretches = most_points / 2;
  for (std::size_t stretch = 0; stretch < stretches; ++stretch) {
    const auto at = [&](std::size_t number) {
      return curve.values.begin() + static_cast<std::ptrdiff_t>(number * count / stretches);
    };
    const auto [low, high] = std::minmax_element(at(stretch), at(stretch + 1));
    const auto first = static_cast<std::size_t>(std::min(low, high) - curve.values.begin());
    const auto last = static_cast<std::size_t>(std::max(low, high) - curve.values.begin());
    add(first);
    if (last != first) add(last);
  }
  return {times, values};
}

}  // namespace

std::filesystem::path find_comparison_template() {
  return report::find_page({"compare_template.html", "CRUMPLE_COMPARE_TEMPLATE", "comparison"});
}

std::string comparison_payload(const Comparison& comparison, const CurveSet& reference, const CurveSet& other,
                               const ComparisonSettings& settings, std::optional<double> tolerance) {
  Json json = comparison_json(comparison, reference, other, settings);
  if (tolerance) json["tolerance"] = *tolerance;
  json["drawn"] = Json::array();
  for (std::size_t place = 0; place < std::min(comparison.curves.size(), most_drawn_curves); ++place) {
    const ComparedCurve& curve = comparison.curves[place];
    json["drawn"].push_back({{"reference", points(curve.reference)}, {"other", points(curve.other)}});
  }
  std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  // JSON ends no element of HTML as long as it holds no "<".
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"crumple-comparison\">" + text + "</script>\n";
}

}  // namespace crumple::compare
