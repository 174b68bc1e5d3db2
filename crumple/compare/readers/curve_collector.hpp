// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Sorts points into curves of one group, which come in the order of their first points.
class CurveCollector {
 public:
  explicit CurveCollector(std::string group) : group_(std::move(group)) {}

  /// Does nothing for a quantity without a name.
  void add(std::string_view quantity, std::string_view item, double time, double value);

  /// The curves, with nothing left here. One whose values are no numbers has no point.
  std::vector<Curve> take();

 private:
  std::string group_;
  std::vector<Curve> curves_;
  std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace crumple::compare
