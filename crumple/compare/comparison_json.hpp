// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compare/comparison.hpp"
#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Everything that a comparison found but the curves themselves. Numbers that are not finite are null.
nlohmann::ordered_json comparison_json(const Comparison& comparison, const CurveSet& reference,
                                       const CurveSet& other, const ComparisonSettings& settings);

}  // namespace crumple::compare
