// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "compare/comparison.hpp"
#include "compare/curves/curve.hpp"

namespace crumple::compare {

struct TableOptions {
  std::size_t rows = 40;  ///< most that are shown; zero shows all
  std::optional<double>
      tolerance;  ///< for the summary: largest difference over the peak of the reference [-]
  int cfc = 0;    ///< class of the filter [Hz]; 0 is none
};

/// A table of the curves, worst first, with what was compared above and a summary below.
std::string comparison_table(const Comparison& comparison, const CurveSet& reference, const CurveSet& other,
                             const TableOptions& options);

}  // namespace crumple::compare
