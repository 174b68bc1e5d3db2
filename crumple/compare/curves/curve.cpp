// SPDX-License-Identifier: BSD-3-Clause
#include "compare/curves/curve.hpp"

#include <algorithm>
#include <cmath>

namespace crumple::compare {

std::string name_of(const Curve& curve) {
  std::string name = curve.group + "." + curve.quantity;
  if (!curve.item.empty()) name += "[" + curve.item + "]";
  return name;
}

Curve curve_named(const std::string& name) {
  const std::size_t dot = name.find('.');
  const std::size_t bracket = name.ends_with(']') ? name.find('[', dot) : std::string::npos;
  Curve curve{name.substr(0, dot), name.substr(dot + 1, bracket - dot - 1), ""};
  if (bracket != std::string::npos) curve.item = name.substr(bracket + 1, name.size() - bracket - 2);
  return curve;
}

void append_point(Curve& curve, double time, double value) {
  if (!std::isfinite(time) || !std::isfinite(value)) {
    ++curve.not_finite;
    return;
  }
  while (!curve.times.empty() && curve.times.back() >= time) {
    curve.times.pop_back();
    curve.values.pop_back();
  }
  curve.times.push_back(time);
  curve.values.push_back(value);
}

double value_at(const Curve& curve, double time) {
  const auto after = std::upper_bound(curve.times.begin(), curve.times.end(), time);
  if (after == curve.times.begin()) return curve.values.front();
  if (after == curve.times.end()) return curve.values.back();
  const auto place = static_cast<std::size_t>(after - curve.times.begin());
  const double start = curve.times[place - 1];
  const double share = (time - start) / (curve.times[place] - start);
  return curve.values[place - 1] + share * (curve.values[place] - curve.values[place - 1]);
}

}  // namespace crumple::compare
