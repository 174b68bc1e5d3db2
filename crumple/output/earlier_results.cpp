// SPDX-License-Identifier: BSD-3-Clause
#include "output/earlier_results.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "files/input_file.hpp"
#include "output/files/own_file.hpp"
#include "output/lsdyna/binout.hpp"
#include "output/lsdyna/dynain.hpp"
#include "output/lsdyna/text_file.hpp"
#include "output/paraview/paraview_series.hpp"

namespace crumple::output {
namespace {

constexpr std::string_view names[] = {"run.json",
                                      "report.html",
                                      "initial_penetrations.csv",
                                      "glstat.csv",
                                      "timestep.csv",
                                      "matsum.csv",
                                      "rwforc.csv",
                                      "rwmotion.csv",
                                      "rcforc.csv",
                                      "ties.csv",
                                      "rbdout.csv",
                                      "swforc.csv",
                                      "nodout.csv",
                                      "energy_residual.csv",
                                      "sleout.csv",
                                      "deforc.csv",
                                      "spcforc.csv",
                                      "elout_shells.csv",
                                      "elout_solids.csv",
                                      "elout_beams.csv",
                                      "secforc.csv",
                                      "ncforc.csv",
                                      "jntforc.csv",
                                      "jntstiff.csv",
                                      "abstat.csv",
                                      "elout_beam_points.csv",
                                      "relax.csv"};

/// LS-DYNA writes files of the same names: of these only our own are removed. All start with whose they are.
constexpr std::array<std::string_view, 15> shared_names{"glstat",  "matsum", "rwforc", "rcforc",  "nodout",
                                                        "rbdout",  "swforc", "sleout", "deforc",  "secforc",
                                                        "spcforc", "elout",  "ncforc", "jntforc", "abstat"};
constexpr std::string_view binout_name = "binout0000";

/// Whether a run may write a file of that name, here or elsewhere.
bool is_name_of_results(const std::string& name) {
  const auto is = [&](std::string_view other) { return name == other; };
  return std::ranges::any_of(names, is) || std::ranges::any_of(shared_names, is) || is(binout_name) ||
         is(dynain_name) || name.starts_with("d3plot") || name.ends_with(".pvd");
}

bool mentions(const std::filesystem::path& path, std::string_view mark) {
  return read_start(path, 2048).find(mark) != std::string::npos;
}

/// Collections that name a frame as we name them, with their frames.
void remove_all_frames(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> collections;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".pvd" && entry.is_regular_file(ignored) &&
        mentions(entry.path(), "file=\"vtu/" + entry.path().stem().string() + "_000000.vtu\""))
      collections.push_back(entry.path());
  for (const std::filesystem::path& collection : collections) {
    remove_frames(folder, collection.stem().string());
    std::filesystem::remove(collection, ignored);
  }
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
  remove_all_frames(folder);
}

void require_no_output(const std::filesystem::path& folder, std::span<const std::filesystem::path> files) {
  std::error_code ignored;
  for (const std::filesystem::path& file : files) {
    const std::filesystem::path place = file.has_parent_path() ? file.parent_path() : ".";
    if (!std::filesystem::equivalent(place, folder, ignored) || !is_name_of_results(file.filename().string()))
      continue;
    throw Error("The results would overwrite the input file " + file.string() +
                ": choose another folder with -o, or another name for it.");
  }
}

}  // namespace crumple::output
