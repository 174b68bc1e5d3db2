// SPDX-License-Identifier: BSD-3-Clause
#include "compare/open_results.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"
#include "binout_sample.hpp"
#include "curve_lookup.hpp"

namespace crumple::compare::open_results_test {
namespace {

using Names = std::vector<std::string>;
using Numbers = std::vector<double>;

class OpenResults : public ::testing::Test {
 public:
  ~OpenResults() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 protected:
  OpenResults()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                (std::string("crumple_open_") +
                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
                 std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  static std::string binout(double kinetic) {
    BinoutSample sample;
    sample.folder("/glstat/d000001");
    sample.write("time", BinoutSample::R8, {0.5});
    sample.write("kinetic_energy", BinoutSample::R8, {kinetic});
    sample.folder("/matsum/metadata");
    sample.write("ids", BinoutSample::I4, {4});
    sample.folder("/matsum/d000001");
    sample.write("time", BinoutSample::R8, {0.5});
    sample.write("internal_energy", BinoutSample::R8, {9});
    sample.table();
    return sample.bytes();
  }

  static constexpr const char* text =
      " time...........................   1.00000E+00\n"
      " kinetic energy.................   4.00000E+04\n";

  std::filesystem::path folder_;
};

/// binout has a branch for each side of a contact, the table has all of them.
TEST_F(OpenResults, ForcesOfContactNodesCountOnce) {
  write("ncforc.csv", "time,contact,side,node,fx\n0,1,1,7,2\n1,1,1,7,3\n");
  BinoutSample sample;
  sample.folder("/ncforc/slave_1/metadata");
  sample.write("ids", BinoutSample::I4, {7});
  sample.folder("/ncforc/slave_1/d000001");
  sample.write("time", BinoutSample::R8, {0.5});
  sample.write("x_force", BinoutSample::R8, {9});
  sample.table();
  write("binout0000", sample.bytes());
  const CurveSet both = open_results(folder_);
  for (const Curve& curve : both.curves) EXPECT_EQ(curve.group, "ncforc");
  std::filesystem::remove(folder_ / "ncforc.csv");
  EXPECT_EQ(open_results(folder_).curves.at(0).group, "ncforc_slave_1") << "alone they are read";
}

TEST_F(OpenResults, TablesCountBeforeBinoutBeforeText) {
  write("glstat.csv", "time,kinetic\n0,1\n1,2\n");
  write("binout0000", binout(77));
  write("glstat", text);
  write("rwforc", "  time wall# normal-force x-force y-force z-force\n 0.0 3 1.0 2.0 3.0 4.0\n");
  const CurveSet set = open_results(folder_);
  EXPECT_EQ(curve_named(set.curves, "glstat.kinetic").values, (Numbers{1, 2}));
  EXPECT_EQ(curve_named(set.curves, "matsum.internal[4]").values, (Numbers{9}));
  EXPECT_EQ(curve_named(set.curves, "rwforc.fx[3]").values, (Numbers{2}));
  EXPECT_EQ(set.files, (Names{"glstat.csv", "binout0000", "rwforc"}));
  EXPECT_TRUE(set.notes.empty());
}

TEST_F(OpenResults, OneFileOfAnyName) {
  EXPECT_EQ(open_results(write("energies.csv", "time,kinetic\n0,1\n1,2\n")).curves[0].group, "energies");
  EXPECT_EQ(curve_named(open_results(write("results.bin", binout(5))).curves, "glstat.kinetic").values,
            (Numbers{5}));
  EXPECT_EQ(curve_named(open_results(write("glstat", text)).curves, "glstat.kinetic").values,
            (Numbers{40000}));
  EXPECT_EQ(curve_named(open_results(write("run7.glstat", text)).curves, "glstat.kinetic").values,
            (Numbers{40000}));
}

TEST_F(OpenResults, TablesThatAreNoHistoriesAreLeftOut) {
  write("glstat.csv", "time,kinetic\n0,1\n1,2\n");
  write("timestep.csv", "time,dt,kind,element,part\n0,1,shell,3,1\n");
  write("initial_penetrations.csv", "interface,node,depth\n1,2,3\n");
  EXPECT_EQ(open_results(folder_).files, (Names{"glstat.csv"}));
}

TEST_F(OpenResults, WhatCannotBeReadIsANote) {
  write("glstat.csv", "time,kinetic\n0,1\n1,2\n");
  write("parts.csv", "id,mass\n1,2\n");
  write("binout0000", "no binout");
  write("rcforc", "nothing here\n");
  const CurveSet set = open_results(folder_);
  EXPECT_EQ(set.files, (Names{"glstat.csv"}));
  ASSERT_EQ(set.notes.size(), 3U);
  EXPECT_NE(set.notes[0].find("parts.csv"), std::string::npos);
  EXPECT_NE(set.notes[1].find("binout0000"), std::string::npos);
  EXPECT_NE(set.notes[2].find("rcforc"), std::string::npos);
}

TEST_F(OpenResults, ValuesThatAreNotFiniteAreNoted) {
  write("glstat.csv", "time,kinetic,internal\n0,1,nan\n1,nan,nan\n2,3,nan\n");
  const CurveSet set = open_results(folder_);
  ASSERT_EQ(set.notes.size(), 1U);
  EXPECT_NE(set.notes[0].find("glstat.csv: 4 values"), std::string::npos) << set.notes[0];
}

TEST_F(OpenResults, NothingToReadIsAnError) {
  EXPECT_THROW(open_results(folder_), Error);
  EXPECT_THROW(open_results(folder_ / "nowhere"), Error);
  EXPECT_THROW(open_results(write("notes.txt", "some text\n")), Error);
  EXPECT_THROW(open_results(write("empty.csv", "time,kinetic\n")), Error);
}

TEST_F(OpenResults, TheUnitOfTimeIsThatOfTheRecord) {
  EXPECT_EQ(guessed_seconds(folder_), 0);
  write("run.json", "{\"units\": \"kg, mm, ms\"}");
  EXPECT_EQ(guessed_seconds(folder_), 1e-3);
  EXPECT_EQ(guessed_seconds(folder_ / "glstat.csv"), 1e-3);
  write("run.json", "{\"units\": \"t, mm, s\"}");
  EXPECT_EQ(guessed_seconds(folder_), 1);
  write("run.json", "{\"units\": \"\"}");
  EXPECT_EQ(guessed_seconds(folder_), 0);
  write("run.json", "[1, 2");
  EXPECT_EQ(guessed_seconds(folder_), 0);
}

}  // namespace
}  // namespace crumple::compare::open_results_test
