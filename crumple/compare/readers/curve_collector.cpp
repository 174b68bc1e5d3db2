// SPDX-License-Identifier: BSD-3-Clause
#include "compare/readers/curve_collector.hpp"

#include <utility>

namespace crumple::compare {

void CurveCollector::add(std::string_view quantity, std::string_view item, double time, double value) {
  if (quantity.empty()) return;
  std::string key(quantity);
  key.append("\n").append(item);
  const auto [place, is_new] = places_.try_emplace(std::move(key), curves_.size());
  if (is_new) {
    Curve curve{group_, std::string(quantity), std::string(item)};
    curves_.push_back(std::move(curve));
  }
  append_point(curves_[place->second], time, value);
}

std::vector<Curve> CurveCollector::take() {
  places_.clear();
  return std::exchange(curves_, {});
}

}  // namespace crumple::compare
