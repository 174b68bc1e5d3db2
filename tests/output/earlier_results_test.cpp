// SPDX-License-Identifier: BSD-3-Clause
#include "output/earlier_results.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace crumple::output::earlier_results_test {
namespace {

TEST(EarlierResults, OnlyWhatIsOurOwnIsRemoved) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("crumple_earlier_" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto touch = [&](const char* name) { std::ofstream(folder / name) << "x\n"; };
  for (const char* name : {"run.json", "rwforc.csv", "rwmotion.csv", "glstat.csv", "secforc.csv",
                           "elout_shells.csv", "report.html"})
    touch(name);
  for (const char* name : {"measured.csv", "d3plot", "deck.k", "rcforc"}) touch(name);
  std::ofstream(folder / "glstat") << " a title\n                         crumple (version 0.1.0)\n";
  std::ofstream(folder / "binout0000") << "...version0.1.0     ...revisioncrumple   ";
  remove_earlier_results(folder);
  for (const char* name : {"run.json", "rwforc.csv", "rwmotion.csv", "glstat.csv", "report.html",
                           "secforc.csv", "elout_shells.csv", "glstat", "binout0000"})
    EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const char* name : {"measured.csv", "d3plot", "deck.k", "rcforc"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  touch("binout0000");
  remove_earlier_results(folder);
  EXPECT_TRUE(fs::exists(folder / "binout0000")) << "LS-DYNA's own";
  fs::remove_all(folder);
}

TEST(EarlierResults, FramesOfOtherRunsGoWithTheirCollection) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("crumple_frames_" + std::to_string(getpid()));
  fs::create_directories(folder / "vtu");
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
  write("a.pvd", "<DataSet timestep=\"0\" part=\"0\" file=\"vtu/a_000000.vtu\"/>");
  write("theirs.pvd", "<DataSet timestep=\"0\" part=\"0\" file=\"steps/theirs_0.vtu\"/>");
  for (const char* name : {"vtu/a_000000.vtu", "vtu/a_walls_000000.vtu", "vtu/ab_000000.vtu", "vtu/a.txt"})
    write(name, "x");
  remove_earlier_results(folder);
  for (const char* name : {"a.pvd", "vtu/a_000000.vtu", "vtu/a_walls_000000.vtu"})
    EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const char* name : {"theirs.pvd", "vtu/ab_000000.vtu", "vtu/a.txt"})
    EXPECT_TRUE(fs::exists(folder / name)) << name;
  fs::remove_all(folder);
}

TEST(EarlierResults, InputFilesAreNoResults) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("crumple_inputs_" + std::to_string(getpid()));
  fs::create_directories(folder / "other");
  const auto refuses = [&](const fs::path& file) {
    const std::vector<fs::path> files{folder / "deck.k", file};
    try {
      require_no_output(folder, files);
    } catch (const Error& fault) {
      return std::string(fault.what()).find(file.string()) != std::string::npos;
    }
    return false;
  };
  for (const char* name : {"nodout", "elout", "glstat.csv", "binout0000", "dynain", "d3plot01", "a.pvd"})
    EXPECT_TRUE(refuses(folder / name)) << name;
  EXPECT_FALSE(refuses(folder / "mesh.k"));
  EXPECT_FALSE(refuses(folder / "other" / "nodout"));
  fs::remove_all(folder);
}

TEST(EarlierResults, AFolderThatIsNotThereIsNoError) {
  EXPECT_NO_THROW(remove_earlier_results("no/such/folder"));
}

}  // namespace
}  // namespace crumple::output::earlier_results_test
