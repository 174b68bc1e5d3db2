// SPDX-License-Identifier: BSD-3-Clause
#include "output/earlier_results.hpp"

#include <array>
#include <string>
#include <string_view>
#include <system_error>

#include "files/input_file.hpp"
#include "output/files/own_file.hpp"
#include "output/lsdyna/binout.hpp"
#include "output/lsdyna/dynain.hpp"
#include "output/lsdyna/text_file.hpp"

namespace crumple::output {
namespace {

constexpr std::string_view names[] = {"run.json",         "report.html",          "initial_penetrations.csv",
                                      "glstat.csv",       "timestep.csv",         "matsum.csv",
                                      "rwforc.csv",       "rwmotion.csv",         "rcforc.csv",
                                      "ties.csv",         "rbdout.csv",           "swforc.csv",
                                      "nodout.csv",       "energy_residual.csv",  "sleout.csv",
                                      "deforc.csv",       "spcforc.csv",          "elout_shells.csv",
                                      "elout_solids.csv", "elout_beams.csv",      "secforc.csv",
                                      "ncforc.csv",       "jntforc.csv",          "jntstiff.csv",
                                      "abstat.csv",       "elout_beam_points.csv"};

/// LS-DYNA writes files of the same names: of these only our own are removed. All start with whose they are.
constexpr std::array<std::string_view, 15> shared_names{"glstat",  "matsum", "rwforc", "rcforc",  "nodout",
                                                        "rbdout",  "swforc", "sleout", "deforc",  "secforc",
                                                        "spcforc", "elout",  "ncforc", "jntforc", "abstat"};
constexpr std::string_view binout_name = "binout0000";

bool mentions(const std::filesystem::path& path, std::string_view mark) {
  return read_start(path, 2048).find(mark) != std::string::npos;
}

}  // namespace

void remove_ending(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* name : {"run.json", "report.html"}) std::filesystem::remove(folder / name, ignored);
}

void remove_earlier_results(const std::filesystem::path& folder) {
  std::error_code ignored;
  remove_unfinished_files(folder);
  for (const std::string_view name : names) std::filesystem::remove(folder / name, ignored);
  for (const std::string_view name : shared_names)
    if (mentions(folder / name, program_mark)) std::filesystem::remove(folder / name, ignored);
  if (mentions(folder / binout_name, binout_mark)) std::filesystem::remove(folder / binout_name, ignored);
  if (mentions(folder / dynain_name, dynain_mark)) std::filesystem::remove(folder / dynain_name, ignored);
}

}  // namespace crumple::output
