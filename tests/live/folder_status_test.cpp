// SPDX-License-Identifier: BSD-3-Clause
#include "live/folder_status.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "report/scatter_folder.hpp"

namespace crumple::live::folder_status_test {
namespace {

namespace fs = std::filesystem;

class FolderStatusTest : public testing::Test {
 public:
  FolderStatusTest() { fs::create_directories(folder_ / "run_000"); }
  ~FolderStatusTest() override { fs::remove_all(folder_); }

 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  fs::path folder_ = fs::temp_directory_path() / ("crumple_status_" + std::to_string(getpid()));
};

TEST_F(FolderStatusTest, OfAScatterIsThatOfItsUnperturbedRun) {
  write("run_000/a.pvd",
        "<Collection><DataSet timestep=\"0\" part=\"0\" file=\"0.vtu\"/>"
        "<DataSet timestep=\"2\" part=\"0\" file=\"1.vtu\"/></Collection>");
  write("run_000/run.json",
        R"({"end_time": 2, "cycles": 9, "ns_per_element_cycle": 50, "termination": "normal"})");
  EXPECT_EQ(folder_status(folder_).frames, 0) << "without bands it is no result";
  write("bands.csv", std::string(report::bands_header));
  const RunStatus status = folder_status(folder_);
  EXPECT_EQ(status.state, RunState::Ended);
  EXPECT_EQ(status.frames, 2);
  EXPECT_EQ(status.cycle, 9);
  EXPECT_EQ(status.termination, "normal");
}

}  // namespace
}  // namespace crumple::live::folder_status_test
