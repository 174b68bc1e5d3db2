// SPDX-License-Identifier: BSD-3-Clause
#include "report/scatter_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.hpp"
#include "report/result_folder.hpp"

namespace crumple::report::scatter_folder_test {
namespace {

namespace fs = std::filesystem;

const std::string table = std::string(bands_header) +
                          "0,glstat.kinetic,3,1,2,1,3\n"
                          "1,glstat.kinetic,3,4,5,4,6\n"
                          "2,glstat.kinetic,3,4,5,4,6\n"
                          "3,glstat.kinetic,3,7,8,7,9\n"
                          "0,rwforc.normal[2],3,0,0,0,0\n"
                          "0,glstat.internal,3,1,1,1,1\n";

class ScatterFolderTest : public testing::Test {
 public:
  ScatterFolderTest() { fs::create_directories(folder_ / "run_000"); }
  ~ScatterFolderTest() override { fs::remove_all(folder_); }

 protected:
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  void write_run() const {
    write("run_000/deck.pvd", "<Collection><DataSet timestep=\"0\" part=\"0\" file=\"a.vtu\"/></Collection>");
    write("run_000/glstat.csv", "time,kinetic\n");
  }

  fs::path folder_ = fs::temp_directory_path() / ("crumple_scatter_" + std::to_string(getpid()));
};

TEST(SplitBands, GroupsCurvesByTheirHistory) {
  const BandTable split = split_bands(table, 4096);
  EXPECT_EQ(split.runs, 3);
  ASSERT_EQ(split.histories.size(), 2U);
  EXPECT_EQ(split.histories[0].history, "glstat");
  EXPECT_EQ(split.histories[0].text,
            "time,curve,median,p5,p95\n"
            "0,glstat.kinetic,2,1,3\n1,glstat.kinetic,5,4,6\n2,glstat.kinetic,5,4,6\n3,glstat.kinetic,8,7,9\n"
            "0,glstat.internal,1,1,1\n");
  EXPECT_EQ(split.histories[0].every, 1);
  EXPECT_EQ(split.histories[1].history, "rwforc");
  EXPECT_EQ(split.histories[1].text, "time,curve,median,p5,p95\n0,rwforc.normal[2],0,0,0\n");
}

TEST(SplitBands, ThinsLongHistoriesButKeepsTheEndsOfCurves) {
  const BandTable split = split_bands(table, 70);
  EXPECT_EQ(split.histories[0].every, 2);
  EXPECT_EQ(split.histories[0].text,
            "time,curve,median,p5,p95\n"
            "0,glstat.kinetic,2,1,3\n2,glstat.kinetic,5,4,6\n3,glstat.kinetic,8,7,9\n"
            "0,glstat.internal,1,1,1\n");
  EXPECT_EQ(split.histories[1].every, 1);
}

TEST(SplitBands, SkipsIncompleteRowsAndOtherTables) {
  const BandTable cut =
      split_bands(std::string(bands_header) + "0,a.b,2,1,1,1,1\n1,a.b,2,1\n2,a.b,2,1,1,1", 99);
  ASSERT_EQ(cut.histories.size(), 1U);
  EXPECT_EQ(cut.histories[0].text, "time,curve,median,p5,p95\n0,a.b,1,1,1\n");
  EXPECT_TRUE(split_bands("time,kinetic\n0,1\n", 99).histories.empty());
  EXPECT_TRUE(split_bands("", 99).histories.empty());
}

TEST_F(ScatterFolderTest, IsReportedByItsUnperturbedRun) {
  write_run();
  write("bands.csv", table);
  ASSERT_TRUE(is_scatter_folder(folder_));
  const ResultFolder found = open_results(folder_);
  EXPECT_EQ(found.folder, folder_ / "run_000");
  EXPECT_EQ(found.scatter, folder_);
  EXPECT_EQ(found.name, "deck");
  EXPECT_EQ(found.tables.size(), 1U);
  EXPECT_TRUE(open_results(folder_ / "run_000").scatter.empty()) << "a run alone has no bands";
}

TEST_F(ScatterFolderTest, NeedsItsBands) {
  write_run();
  EXPECT_FALSE(is_scatter_folder(folder_));
  write("bands.csv", "mine\n");
  EXPECT_FALSE(is_scatter_folder(folder_));
  try {
    open_results(folder_);
    FAIL();
  } catch (const Error& fault) {
    EXPECT_NE(std::string(fault.what()).find("run_000 alone can be reported"), std::string::npos);
  }
}

TEST_F(ScatterFolderTest, KnowsThePerturbationFromTheFirstRunThatTellsIt) {
  EXPECT_FALSE(perturbation_of(folder_));
  write("run_000/run.json", R"({"perturbation": 0})");
  fs::create_directories(folder_ / "run_001");  // failed early
  write("run_002/run.json", "cut of");
  write("run_003/run.json", R"({"version": "older"})");
  EXPECT_FALSE(perturbation_of(folder_));
  write("run_004/run.json", R"({"perturbation": 1e-5})");
  EXPECT_EQ(perturbation_of(folder_), 1e-5);
}

}  // namespace
}  // namespace crumple::report::scatter_folder_test
