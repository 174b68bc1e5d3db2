// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crumple::report {

/// Table of bands in a folder of `crumple scatter`, and its first line.
inline constexpr const char* bands_file = "bands.csv";
inline constexpr std::string_view bands_header = "time,curve,runs,first,median,p5,p95\n";

/// Folder of a run of `crumple scatter` within that of all runs; number 0 is the unperturbed run.
std::string scatter_run_name(int number);

/// Whether a folder holds a table of bands and the unperturbed run.
bool is_scatter_folder(const std::filesystem::path& folder);

/// Largest move of a node over the diagonal of the model, as the records of the perturbed runs say [-]; none
/// if no record does.
std::optional<double> perturbation_of(const std::filesystem::path& folder);

/// The bands of the curves of one history.
struct HistoryBands {
  std::string history;  ///< what the names of its curves begin with: "glstat" of "glstat.kinetic"
  std::string text;     ///< CSV: time,curve,median,p5,p95
  int every = 1;        ///< one point of so many was kept
};

struct BandTable {
  int runs = 0;  ///< that ended normally
  std::vector<HistoryBands> histories;
};

/// Splits a table of bands by history. Incomplete rows are skipped; no histories if it is another table.
/// @param most of each text, beyond which points are thinned out evenly; the ends of curves are kept [bytes]
BandTable split_bands(std::string_view table, std::size_t most);

}  // namespace crumple::report
