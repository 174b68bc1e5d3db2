// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Curves of a table with a line of names, the time in the first column:
/// - our own histories, whose columns `wall`, `node`, `part`, ... say which item a row belongs to;
/// - time histories of OpenRadioss (its th_to_csv), whose energies get our names;
/// - any other table of numbers with a first column called `time`.
/// Rows that are cut off or no numbers are left out. Throws Error if the first line is not that of such a
/// table.
/// @param group what the curves belong to unless the table shows it: the file's name without its ending
std::vector<Curve> read_csv(std::string_view text, std::string_view group);

}  // namespace crumple::compare
