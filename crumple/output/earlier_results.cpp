// SPDX-License-Identifier: BSD-3-Clause
#include "output/earlier_results.hpp"

#include <array>
#include <string_view>
#include <system_error>

namespace crumple::output {
namespace {

constexpr std::array<std::string_view, 14> names{
    "run.json",   "report.html",        "initial_penetrations.csv",
    "glstat.csv", "timestep.csv",       "matsum.csv",
    "rwforc.csv", "rwmotion.csv",       "rcforc.csv",
    "ties.csv",   "rbdout.csv",         "swforc.csv",
    "nodout.csv", "energy_residual.csv"};

}  // namespace

void remove_ending(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* name : {"run.json", "report.html"}) std::filesystem::remove(folder / name, ignored);
}

void remove_earlier_results(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const std::string_view name : names) std::filesystem::remove(folder / name, ignored);
}

}  // namespace crumple::output
