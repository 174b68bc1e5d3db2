// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Quantile of numbers in ascending order by straight lines between them (definition 7 of R. J. Hyndman,
/// Y. Fan, The American Statistician 50 (1996) 361-365). There must be one number at least.
double quantile(const std::vector<double>& ascending, double share);

/// The band of every curve of the first run that all others have, too, also of curves that are computed of
/// others: the median of a sum is not the sum of medians.
std::vector<Band> bands_of(const std::vector<CurveSet>& runs);

/// Largest size of the median.
double largest_median(const Band& band);

/// Largest width of a band over the largest size of its median [-]; zero if the median is.
double relative_width(const Band& band);

/// One table with the columns of report::bands_header.
std::string bands_csv(const std::vector<Band>& bands);

/// Bands of such a table; incomplete rows and rows without numbers are skipped. Empty if it is another table.
std::vector<Band> read_bands(std::string_view text);

/// The medians as curves, in the order of the bands.
std::vector<Curve> medians_of(const std::vector<Band>& bands);

/// Share of the band's times that the curve has, at which it lies between p5 and p95 [-]; none if it
/// has none of them.
std::optional<double> share_inside(const Band& band, const Curve& curve);

}  // namespace crumple::compare
