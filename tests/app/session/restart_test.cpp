// SPDX-License-Identifier: BSD-3-Clause
// Runs that are taken up from restart files: what lies in the folder at the end is what an uninterrupted run
// leaves there, byte by byte.
#include <algorithm>

#include "app/program_fixture.hpp"

namespace crumple::app::restart_test {
namespace {

const std::string control = "*CONTROL_TERMINATION\n       1.0\n*DATABASE_RWFORC\n     0.013\n";

class RestartTest : public ProgramTest {
 protected:
  RestartTest() { write("plate.k", falling_plate(control)); }

  Result run_whole(const std::string& folder) const {
    return run({"run", path("plate.k"), "-o", path(folder), "--restart-every", "100", "--d3plot", "-q"});
  }
  static long cycle_of(const Result& result) {
    const std::size_t at = result.out.find("cycle ", result.out.find("Taken up"));
    return at == std::string::npos ? -1 : std::stol(result.out.substr(at + 6));
  }
  void expect_same_files(const std::string& one, const std::string& other) const {
    int compared = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / one)) {
      const std::string name = entry.path().lexically_relative(folder_ / one).string();
      // These name the time of day, or hold how long it took.
      const bool timed = name == "run.json" || name == "d3plot" || name.starts_with("restart");
      if (!entry.is_regular_file() || timed) continue;
      EXPECT_EQ(read((std::filesystem::path(one) / name).string()),
                read((std::filesystem::path(other) / name).string()))
          << name;
      ++compared;
    }
    EXPECT_GT(compared, 100);
    EXPECT_EQ(record(one)["state_hash"], record(other)["state_hash"]);
  }
};

TEST_F(RestartTest, ARunTakenUpLeavesTheSameFiles) {
  ASSERT_EQ(run_whole("whole").code, ExitCode::Normal);
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const Result result = run({"run", "--restart", path("out/restart/previous.restart"), "-t", "2"});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_GT(cycle_of(result), 100);
  EXPECT_EQ(cycle_of(result) % 100, 0) << "a file of a hundredth cycle was taken";
  EXPECT_LT(cycle_of(result), record("whole")["cycles"].get<long>());
  expect_same_files("whole", "out");
}

TEST_F(RestartTest, AFolderStandsForItsNewestGoodFile) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const long last = record("out")["cycles"];
  EXPECT_EQ(cycle_of(run({"run", "--restart", path("out")})), last);
  std::filesystem::resize_file(path("out/restart/latest.restart"), 5000);
  const Result result = run({"run", "--restart", path("out")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.err.find("is cut off"), std::string::npos) << result.err;
  EXPECT_LT(cycle_of(result), last);
}

TEST_F(RestartTest, ALaterEndGoesOn) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const Result result = run({"run", "--restart", path("out"), "--end", "1.2"});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NEAR(record("out")["end_time"], 1.2, 0.01);
  const auto rows = table("out/glstat.csv");
  for (std::size_t i = 2; i < rows.size(); ++i)
    ASSERT_GT(std::stod(rows[i][0]), std::stod(rows[i - 1][0])) << "row " << i;
}

TEST_F(RestartTest, ADeckOfChangesMovesTheEndAndTheIntervals) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const std::size_t before = table("out/rwforc.csv").size();
  write("more.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.5\n*DATABASE_RWFORC\n0.1\n*END\n");
  const Result result = run({"run", path("more.k"), "--restart", path("out"), "--restart-every", "100"});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NEAR(record("out")["end_time"], 1.5, 0.01);
  // The row at the earlier end was not due: it goes, and five come.
  EXPECT_EQ(table("out/rwforc.csv").size(), before + 4);
  // The changes are those of the run from now on.
  write("again.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.7\n*END\n");
  const Result more = run({"run", path("again.k"), "--restart", path("out")});
  EXPECT_EQ(more.code, ExitCode::Normal) << more.err;
  EXPECT_NEAR(record("out")["end_time"], 1.7, 0.01);
  EXPECT_EQ(table("out/rwforc.csv").size(), before + 6);
}

TEST_F(RestartTest, TheModelCannotChange) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  write("more.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.5\n*MAT_ELASTIC\n1,7.83e-6,100.0,0.3\n*END\n");
  const Result result = run({"run", path("more.k"), "--restart", path("out")});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("more.k:4: error: *MAT_ELASTIC"), std::string::npos) << result.err;
  EXPECT_EQ(run({"run", "--restart", path("out"), "--precision", "mixed"}).code, ExitCode::Usage);
  write("more.k", "*KEYWORD\n$crumple method=brute-force\n*CONTROL_TERMINATION\n1.5\n*END\n");
  EXPECT_EQ(run({"run", path("more.k"), "--restart", path("out")}).code, ExitCode::Input);
  // A deck that lies where the first one lay is one of changes all the same.
  write("plate.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.5\n*END\n");
  const Result same = run({"run", path("plate.k"), "--restart", path("out")});
  EXPECT_EQ(same.code, ExitCode::Normal) << same.err;
}

TEST_F(RestartTest, TheDeckIsInTheFile) {
  write("mesh.k", falling_plate(""));
  write("split.k", "*KEYWORD\n" + control + "*INCLUDE\nmesh.k\n*END\n");
  ASSERT_EQ(run({"run", path("split.k"), "-o", path("out"), "--restart-every", "100"}).code,
            ExitCode::Normal);
  const auto hash = record("out")["state_hash"];
  std::filesystem::remove(path("mesh.k"));
  std::filesystem::remove(path("split.k"));
  std::filesystem::remove(path("out/restart/latest.restart"));
  const Result result = run({"run", "--restart", path("out")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_EQ(record("out")["state_hash"], hash);
}

TEST_F(RestartTest, AnotherFolderBeginsWithTheStateOfTheFile) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const std::string before = read("out/glstat.csv");
  const Result result = run({"run", "--restart", path("out/restart/previous.restart"), "-o", path("branch")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_EQ(record("branch")["state_hash"], record("out")["state_hash"]);
  EXPECT_GT(std::stod(table("branch/glstat.csv")[1][0]), 0.1);
  EXPECT_EQ(read("out/glstat.csv"), before);
}

TEST_F(RestartTest, TwoSidedContactsAreKnownBeforeTheFirstStep) {
  // Segments and sides are those of the model, not of the steps so far.
  std::string text = falling_plate(control);
  text.replace(text.find("*END"), 4,
               "*SET_PART_LIST\n1\n1\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID\n5\n1,1,2,2\n0.1\n\n*END");
  write("plate.k", text);
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  ASSERT_EQ(run({"run", "--restart", path("out/restart/previous.restart"), "-o", path("branch")}).code,
            ExitCode::Normal);
  const auto whole = table("out/rcforc.csv");
  const auto branch = table("branch/rcforc.csv");
  EXPECT_EQ(branch.back(), whole.back());
  EXPECT_EQ(branch[1][2], "first");
}

TEST_F(RestartTest, ATableThatLostItsEndIsSetAside) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const std::string before = read("out/glstat.csv");
  std::filesystem::resize_file(path("out/glstat.csv"), 300);
  const Result result = run({"run", "--restart", path("out/restart/previous.restart")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.err.find("glstat.csv holds less"), std::string::npos) << result.err;
  EXPECT_EQ(read("out/before_restart_glstat.csv"), before.substr(0, 300));
  EXPECT_GT(table("out/glstat.csv").size(), 2U);
}

TEST_F(RestartTest, WhoGoesBackLeavesTheLaterFilesAside) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  const long last = record("out")["cycles"];
  ASSERT_EQ(run({"run", "--restart", path("out/restart/previous.restart"), "--end", "0.95"}).code,
            ExitCode::Normal);
  EXPECT_TRUE(exists("out/restart/latest.restart.abandoned"));
  const Result result = run({"run", "--restart", path("out")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_LT(cycle_of(result), last);
  EXPECT_EQ(result.err.find("holds less"), std::string::npos) << result.err;
  // No frame is left of the run that was longer.
  const std::string collection = read("out/plate.pvd");
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "out/vtu"))
    EXPECT_NE(collection.find(entry.path().filename().string()), std::string::npos) << entry.path();
}

TEST_F(RestartTest, AFileElsewhereNeedsAFolderForItsResults) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  std::filesystem::copy_file(path("out/restart/latest.restart"), path("mine.restart"));
  const Result result = run({"run", "--restart", path("mine.restart")});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("-o"), std::string::npos) << result.err;
  EXPECT_EQ(run({"run", "--restart", path("mine.restart"), "-o", path("new")}).code, ExitCode::Normal);
}

TEST_F(RestartTest, OutputAskedForLaterBeginsThen) {
  std::string text = falling_plate(control);
  text.replace(text.find("*END"), 4, "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n*END");
  write("plate.k", text);
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  write("more.k", "*KEYWORD\n*CONTROL_TERMINATION\n1.2\n*DATABASE_SPCFORC\n0.01\n*END\n");
  const Result result = run({"run", path("more.k"), "--restart", path("out")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_GT(table("out/spcforc.csv").size(), 10U);
}

TEST_F(RestartTest, OnlyDumpsAreEnough) {
  write("plate.k", falling_plate(control + "*DATABASE_BINARY_D3DUMP\n       150\n"));
  ASSERT_EQ(run({"run", path("plate.k"), "-o", path("out")}).code, ExitCode::Normal);
  std::filesystem::remove(path("out/restart/latest.restart"));
  EXPECT_GE(cycle_of(run({"run", "--restart", path("out")})), 300);
}

TEST_F(RestartTest, NamesInAnyEncoding) {
  write("m\xe4sh.k", falling_plate(""));
  write("split.k", "*KEYWORD\n" + control + "*INCLUDE\nm\xe4sh.k\n*END\n");
  ASSERT_EQ(run({"run", path("split.k"), "-o", path("out"), "--restart-every", "100"}).code,
            ExitCode::Normal);
  const Result result = run({"run", "--restart", path("out")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
}

TEST_F(RestartTest, ANewRunRemovesOnlyItsOwn) {
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  write("out/restart/lammps.restart", "another program's");
  ASSERT_EQ(run({"run", path("plate.k"), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  EXPECT_TRUE(exists("out/restart/lammps.restart"));
  EXPECT_FALSE(exists("out/restart/latest.restart"));
}

TEST_F(RestartTest, TheDeckAsksForFiles) {
  write("plate.k", falling_plate(control + "*DATABASE_BINARY_D3DUMP\n       150\n*DATABASE_BINARY_RUNRSF\n"
                                           "        70         2\n"));
  ASSERT_EQ(run({"run", path("plate.k"), "-o", path("out")}).code, ExitCode::Normal);
  for (const char* name : {"dump01", "dump02", "latest", "previous", "previous2"})
    EXPECT_TRUE(exists("out/restart/" + std::string(name) + ".restart")) << name;
  const Result result = run({"r=" + path("out/restart/dump01.restart")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_EQ(cycle_of(result), 150);
}

TEST_F(RestartTest, WhatIsNoRestartFileIsTold) {
  EXPECT_EQ(run({"run", "--restart", path("nothing")}).code, ExitCode::Input);
  write("noise", std::string(1000, 'x'));
  const Result noise = run({"run", "--restart", path("noise")});
  EXPECT_EQ(noise.code, ExitCode::Input);
  EXPECT_NE(noise.err.find("is no restart file"), std::string::npos) << noise.err;
  ASSERT_EQ(run_whole("out").code, ExitCode::Normal);
  std::string bytes = read("out/restart/latest.restart");
  for (const std::size_t at :
       {std::size_t{9}, std::size_t{17}, std::size_t{60}, bytes.size() / 2, bytes.size() - 3}) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    write("damaged", damaged);
    const Result result = run({"run", "--restart", path("damaged")});
    EXPECT_EQ(result.code, ExitCode::Input) << at;
    EXPECT_FALSE(exists("damaged.out"));
  }
}

}  // namespace
}  // namespace crumple::app::restart_test
