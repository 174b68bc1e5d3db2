// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <iosfwd>
#include <vector>

#include "output/checks.hpp"
#include "output/results/view.hpp"
#include "output/run_record.hpp"
#include "timeloop/simulation.hpp"

namespace crumple::app {

/// How the run will be done: end time, first step and what controls it, arithmetic, threads, contact search,
/// folder.
void print_run_settings(std::ostream& out, const timeloop::Simulation& simulation,
                        const std::filesystem::path& folder);

/// Timings by stage, contact search and energies at the end of a run.
void print_summary(std::ostream& out, const output::View& view, const output::PeakValues& peaks,
                   double loop_seconds);

/// The table of acceptance checks, with PASS or FAIL.
void print_checks(std::ostream& out, const std::vector<output::Check>& checks);

/// One line for each check that failed, for those who see no table.
void print_failed_checks(std::ostream& err, const std::vector<output::Check>& checks);

/// What of the deck did not take part, listed beside the results.
void print_final_omissions(std::ostream& out, const std::vector<output::LeftOut>& list);

/// The files to open.
void print_files(std::ostream& out, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& files);

}  // namespace crumple::app
