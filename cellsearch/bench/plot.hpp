// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "report.hpp"

namespace cellsearch::bench {

/// A picture (SVG text) of two charts over the number of nodes, all axes logarithmic: time per segment and
/// memory per node; the legend gives the fitted exponents. Methods that begin with "production" stand out,
/// `peers` are dashed.
std::string plot(const std::string& title, const std::vector<Curve>& curves,
                 const std::vector<std::string>& peers);

/// Writes plot() to a file. Throws std::runtime_error if that fails.
void write_plot(const std::string& file, const std::string& title, const std::vector<Curve>& curves,
                const std::vector<std::string>& peers);

}  // namespace cellsearch::bench
