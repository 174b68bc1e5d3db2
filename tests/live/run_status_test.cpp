// SPDX-License-Identifier: BSD-3-Clause
#include "live/run_status.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "live/folder_status.hpp"

namespace crumple::live::run_status_test {
namespace {

nlohmann::json json_of(const RunStatus& status) {
  return nlohmann::json::parse(status_json(status));
}

TEST(RunStatus, IsJson) {
  RunStatus status;
  status.state = RunState::Running;
  status.cycle = 12;
  status.time = 0.25;
  status.end_time = 2;
  status.frames = 3;
  status.seconds_to_go = 0;
  status.nanoseconds_per_element_cycle = 61.5;
  EXPECT_EQ(json_of(status), nlohmann::json::parse(R"({"state": "running", "termination": null, "cycle": 12,
    "time": 0.25, "end_time": 2.0, "frames": 3, "seconds_to_go": 0.0, "ns_per_element_cycle": 61.5})"));
}

TEST(RunStatus, LeavesOutWhatIsNotKnown) {
  const nlohmann::json json = json_of({});
  EXPECT_EQ(json["state"], "starting");
  for (const char* name : {"termination", "end_time", "seconds_to_go", "ns_per_element_cycle"})
    EXPECT_TRUE(json[name].is_null()) << name;
  RunStatus endless;
  endless.seconds_to_go = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(json_of(endless)["seconds_to_go"].is_null());
}

TEST(StatusBoard, KeepsWhatWasLastAtTheEnd) {
  StatusBoard board;
  EXPECT_EQ(board.read().state, RunState::Starting);
  RunStatus status;
  status.state = RunState::Running;
  status.cycle = 7;
  board.post(status);
  board.end("interrupted");
  EXPECT_EQ(board.read().state, RunState::Ended);
  EXPECT_EQ(board.read().termination, "interrupted");
  EXPECT_EQ(board.read().cycle, 7);
}

class FolderStatus : public ::testing::Test {
 public:
  ~FolderStatus() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 protected:
  FolderStatus() { std::filesystem::create_directories(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("crumple_live_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(FolderStatus, StartsRunsAndEnds) {
  EXPECT_EQ(folder_status(folder_ / "missing").state, RunState::Starting);
  EXPECT_EQ(folder_status(folder_).state, RunState::Starting);
  write("a.pvd",
        R"(<DataSet timestep="0" part="0" file="0.vtu"/><DataSet timestep="1.5" part="0" file="1.vtu"/>)");
  const RunStatus running = folder_status(folder_);
  EXPECT_EQ(running.state, RunState::Running);
  EXPECT_EQ(running.frames, 2);
  EXPECT_EQ(running.time, 1.5);
  EXPECT_EQ(running.termination, "");
  write("run.json",
        R"({"termination": "normal", "end_time": 1.5, "cycles": 40, "ns_per_element_cycle": null})");
  const RunStatus ended = folder_status(folder_);
  EXPECT_EQ(ended.state, RunState::Ended);
  EXPECT_EQ(ended.termination, "normal");
  EXPECT_EQ(ended.cycle, 40);
  EXPECT_EQ(ended.end_time, 1.5);
}

}  // namespace
}  // namespace crumple::live::run_status_test
