// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "compare/curves/curve.hpp"

namespace crumple::compare {

/// Reads the histories of a folder or of one file: our CSV tables, LS-DYNA's binout and text files, time
/// histories of OpenRadioss as CSV. In a folder every known file is read; where several hold the same group
/// of curves
/// (`glstat.csv`, binout, `glstat`) the first of them, in this order, counts and a note says so. Curves that
/// are sums of others are added (`add_derived_curves`). In a folder of `crumple scatter` the bands are read
/// alone: its curves are their medians. What cannot be read becomes a note.
///
/// Throws Error if there is no such file or folder, or if nothing in it could be read.
CurveSet open_results(const std::filesystem::path& source);

/// Seconds of a unit of time, as run.json of our own results guesses it; zero if it is not known.
double guessed_seconds(const std::filesystem::path& source);

}  // namespace crumple::compare
