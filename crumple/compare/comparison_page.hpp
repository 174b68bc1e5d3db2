// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compare/comparison.hpp"
#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Looks for the page to put a comparison into. Throws Error that says how to build it.
std::filesystem::path find_comparison_template();

/// Most curves that are drawn in the page, the worst ones; the table has all.
inline constexpr std::size_t most_drawn_curves = 300;

/// The elements of a comparison for the page: what comparison_json tells, and points of the curves, thinned
/// out to the common samples where there are many.
std::string comparison_payload(const Comparison& comparison, const CurveSet& reference, const CurveSet& other,
                               const ComparisonSettings& settings, std::optional<double> tolerance);

}  // namespace crumple::compare
