// SPDX-License-Identifier: BSD-3-Clause
#include "output/earlier_results.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

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

TEST(EarlierResults, AFolderThatIsNotThereIsNoError) {
  EXPECT_NO_THROW(remove_earlier_results("no/such/folder"));
}

}  // namespace
}  // namespace crumple::output::earlier_results_test
