// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// The curve of that name; an empty one, and a failed test, if there is none.
inline Curve curve_named(const std::vector<Curve>& curves, const std::string& name) {
  for (const Curve& curve : curves)
    if (name_of(curve) == name) return curve;
  ADD_FAILURE() << "there is no curve " << name;
  return {"", "", ""};
}

inline std::vector<std::string> names_of(const std::vector<Curve>& curves) {
  std::vector<std::string> names;
  names.reserve(curves.size());
  for (const Curve& curve : curves) names.push_back(name_of(curve));
  return names;
}

}  // namespace crumple::compare
