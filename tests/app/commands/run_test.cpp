// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <csignal>
#include <sstream>
#include <thread>

#include "app/program_fixture.hpp"

namespace crumple::app::run_test {
namespace {

class RunTest : public ProgramTest {};

constexpr const char* normal_termination = " N o r m a l    t e r m i n a t i o n";

TEST_F(RunTest, APlateFallsOnAWall) {
  const std::string deck = write("plate.k", falling_plate());
  const Result result = run({"run", deck, "-o", path("out")});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.find(normal_termination), std::string::npos);
  EXPECT_NE(result.out.find(" *** termination time reached ***"), std::string::npos);
  for (const char* word : {"plate falls on a wall", "4 (0 of them triangles)", "contact search (global)",
                           "energy ratio", "PASS", "out/plate.pvd"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word;
  for (const char* name : {"out/plate.pvd", "out/vtu/plate_000000.vtu", "out/vtu/plate_000100.vtu",
                           "out/glstat.csv", "out/matsum.csv", "out/rwforc.csv", "out/run.json"})
    EXPECT_TRUE(exists(name)) << name;

  const auto json = record("out");
  EXPECT_EQ(json["termination"], "normal");
  EXPECT_GE(json["end_time"], 1.0);
  EXPECT_EQ(json["elements"]["shells"], 4);
  EXPECT_LT(json["energy"]["error"], 1e-3);
}

TEST_F(RunTest, ATiedContactTellsWhatItTies) {
  std::string text = falling_plate();
  const std::string end = "*END\n";
  text.replace(text.find(end), end.size(),
               "*NODE\n21,2.,2.,1.1\n22,8.,2.,1.1\n23,8.,8.,1.1\n24,2.,8.,9.\n"
               "*ELEMENT_SHELL\n9,2,21,22,23,24\n*PART\ncap\n2,1,1\n"
               "*CONTACT_TIED_SURFACE_TO_SURFACE_ID\n7,cap\n2,1,3,3\n\n\n*END\n");
  const std::string deck = write("plate.k", text);
  const std::string words = "tied contact 7        by constraint, 3 nodes to 4 segments, moved by up to";
  const Result check = run({"check", deck});
  EXPECT_NE(check.out.find(words), std::string::npos) << check.out;
  EXPECT_NE(check.err.find("1 node is not tied, too far away: 24 by"), std::string::npos) << check.err;
  const Result result = run({"run", deck, "-o", path("out")});
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.find("Tied contact 7: 3 nodes tied"), std::string::npos);
  EXPECT_TRUE(exists("out/ties.csv"));
  EXPECT_EQ(record("out")["ties"][0]["tied"], 3);
}

TEST_F(RunTest, HistoriesAgreeWithThePhysicsAndEndWithTheRun) {
  ASSERT_EQ(run({"run", write("plate.k", falling_plate()), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  const double end = record("out")["end_time"];
  const auto energy = table("out/glstat.csv");
  EXPECT_EQ(std::stod(energy.back()[0]), end);
  // The plate is 20 x 20 x 1, a little warped: its mass is a little more than that of the square.
  const auto parts = table("out/matsum.csv");
  const double mass = std::stod(parts[1][8]);
  EXPECT_NEAR(mass, 7.83e-6 * 400, 1e-3 * mass);
  EXPECT_NEAR(std::stod(energy[1][2]), 0.5 * mass, 1e-12 * mass) << "kinetic energy at the start";
  // The wall's impulse is the change of momentum.
  double impulse = 0;
  const auto wall = table("out/rwforc.csv");
  EXPECT_EQ(wall[1][1], "12");
  for (std::size_t i = 2; i < wall.size(); ++i)
    impulse += std::stod(wall[i][5]) * (std::stod(wall[i][0]) - std::stod(wall[i - 1][0]));
  const double change = mass * (std::stod(parts.back()[7]) - std::stod(parts[1][7]));
  EXPECT_NEAR(-impulse, change, 1e-12 * mass);
  EXPECT_GT(change, 0.5 * mass) << "it did bounce or stop";
}

TEST_F(RunTest, TheResultIsTheSameForAnyNumberOfThreads) {
  const std::string deck = write("plate.k", falling_plate());
  std::string hash;
  for (const char* threads : {"1", "2", "3"}) {
    ASSERT_EQ(run({"run", deck, "-o", path(threads), "-t", threads, "-q"}).code, ExitCode::Normal);
    const auto json = record(threads);
    EXPECT_EQ(json["threads"], std::stoi(threads));
    if (hash.empty()) hash = json["state_hash"];
    EXPECT_EQ(json["state_hash"], hash);
    EXPECT_EQ(read(std::string(threads) + "/glstat.csv"), read("1/glstat.csv"));
  }
}

TEST_F(RunTest, LsDynaSpellingRunsToo) {
  const std::string deck = write("plate.k", falling_plate());
  const Result result = run({"i=" + deck, "ncpu=2", "memory=200m", "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.err.find("memory=200m"), std::string::npos);
  EXPECT_EQ(record("out")["threads"], 2);
}

TEST_F(RunTest, QuietSaysLittleAndStillHowItEnded) {
  const Result result = run({"run", write("plate.k", falling_plate()), "-o", path("out"), "--quiet"});
  EXPECT_NE(result.out.find(normal_termination), std::string::npos);
  EXPECT_LT(result.out.size(), 120U) << result.out;
}

TEST_F(RunTest, EndTimeOfTheCommandLineComesFirst) {
  ASSERT_EQ(run({"run", write("plate.k", falling_plate()), "-o", path("out"), "-q", "--end", "0.25"}).code,
            ExitCode::Normal);
  // No step is cut short: the last one ends at or behind the end time, by less than itself.
  const auto json = record("out");
  const double behind = json["end_time"].get<double>() - 0.25;
  EXPECT_GE(behind, 0);
  EXPECT_LT(behind, 1.01 * json["end_time"].get<double>() / json["cycles"].get<double>());
}

TEST_F(RunTest, ABadDeckGivesItsPlaceAndWritesNothing) {
  std::string text = falling_plate();
  text.replace(text.find("     207.0"), 10, "     2o7.0");
  const Result result = run({"run", write("plate.k", text), "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("plate.k:28: error: *MAT_ELASTIC"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find(" E r r o r    t e r m i n a t i o n"), std::string::npos);
  EXPECT_NE(result.err.find("\n1 error in the deck: nothing was run"), std::string::npos) << result.err;
  EXPECT_FALSE(exists("out"));
}

TEST_F(RunTest, AMissingDeckIsAnInputError) {
  const Result result = run({"run", path("absent.k"), "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("absent.k"), std::string::npos);
  EXPECT_FALSE(exists("out"));
}

TEST_F(RunTest, AFolderThatCannotBeMadeIsAnOutputError) {
  write("file", "in the way");
  const Result result = run({"run", write("plate.k", falling_plate()), "-o", path("file"), "-q"});
  EXPECT_EQ(result.code, ExitCode::Output);
  EXPECT_NE(result.err.find("Cannot make the folder"), std::string::npos) << result.err;
  EXPECT_EQ(read("file"), "in the way");
}

TEST_F(RunTest, ARunThatGoesWrongEndsWithAnErrorAndKeepsWhatWasGood) {
  // A corner that leaves at 1e30 mm/ms: the elements at it cannot follow.
  std::string text = falling_plate();
  text.replace(text.find("*END"), 4,
               "*INITIAL_VELOCITY_NODE\n         9     -1e30     -1e30       0.0\n*END");
  const Result result = run({"run", write("plate.k", text), "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Numerical) << result.out;
  EXPECT_NE(result.out.find(" E r r o r    t e r m i n a t i o n"), std::string::npos);
  EXPECT_EQ(result.out.find(normal_termination), std::string::npos);
  const auto json = record("out");
  EXPECT_EQ(json["termination"], "error");
  EXPECT_NE(result.err.find(json["reason"].get<std::string>()), std::string::npos) << json["reason"];
  EXPECT_TRUE(exists("out/vtu/plate_000000.vtu"));
  EXPECT_EQ(table("out/glstat.csv")[1][0], "0");
}

TEST_F(RunTest, WhereItWentWrongIsTheLastFrame) {
  // Halfway a curve pulls a node away faster than the elements can follow.
  std::string text = falling_plate();
  text.replace(text.find("*END"), 4,
               "*DEFINE_CURVE\n5\n0.0,0.0\n0.5,0.0\n0.500001,1e30\n2.0,1e30\n"
               "*LOAD_NODE_POINT\n9,1,5\n*END");
  const Result result = run({"run", write("plate.k", text), "-o", path("out")});
  EXPECT_EQ(result.code, ExitCode::Numerical) << result.out;
  const auto json = record("out");
  const std::string reason = json["reason"];
  EXPECT_NE(reason.find(" of shell "), std::string::npos) << reason;
  EXPECT_NE(reason.find("is the last frame"), std::string::npos) << reason;
  const double last = json["end_time"];
  EXPECT_NEAR(last, 0.5, 0.01);
  EXPECT_EQ(std::stod(table("out/glstat.csv").back()[0]), last);
  EXPECT_TRUE(exists("out/restart/last_good.restart"));
  // It fails again where it failed.
  EXPECT_EQ(run({"run", "--restart", path("out/restart/last_good.restart")}).code, ExitCode::Numerical);
}

TEST_F(RunTest, AnEnergyRatioOutOfBoundsEndsTheRun) {
  const std::string control =
      "*CONTROL_TERMINATION\n"
      "       1.0         0       0.0     1e-9\n"
      "*CONTROL_TIMESTEP\n       0.0       0.9\n";
  const Result result = run({"run", write("plate.k", falling_plate(control)), "-o", path("out"), "-q"});
  EXPECT_EQ(result.code, ExitCode::Numerical) << result.err;
  EXPECT_NE(record("out")["reason"].get<std::string>().find("ENDENG"), std::string::npos);
  EXPECT_TRUE(exists("out/restart/last_good.restart"))
      << "the state is good, and may go on with another limit";
}

TEST_F(RunTest, AnEarlierRunInTheSameFolderLeavesNoTrace) {
  const std::string deck = write("plate.k", falling_plate());
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "-q"}).code, ExitCode::Normal);
  ASSERT_TRUE(exists("out/vtu/plate_000100.vtu"));
  const std::string few = "*CONTROL_TERMINATION\n       1.0\n*DATABASE_BINARY_D3PLOT\n       0.5\n";
  write("plate.k", falling_plate(few));
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "-q"}).code, ExitCode::Normal);
  EXPECT_FALSE(exists("out/vtu/plate_000100.vtu"));
  EXPECT_TRUE(exists("out/vtu/plate_000002.vtu"));
}

TEST_F(RunTest, FramesOfAnotherDeckGoWhenARunStartsInTheirFolder) {
  ASSERT_EQ(run({"run", write("plate.k", falling_plate()), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  ASSERT_EQ(run({"run", write("other.k", falling_plate()), "-o", path("out"), "-q"}).code, ExitCode::Normal);
  EXPECT_FALSE(exists("out/plate.pvd"));
  EXPECT_FALSE(exists("out/vtu/plate_000000.vtu"));
  EXPECT_TRUE(exists("out/vtu/other_000100.vtu"));
}

TEST_F(RunTest, ADeckWithTheNameOfAResultIsNotOverwritten) {
  const std::string text = falling_plate();
  const Result result = run({"run", write("glstat.csv", text), "-o", path("."), "-q"});
  EXPECT_EQ(result.code, ExitCode::Input) << result.err;
  EXPECT_NE(result.err.find("would overwrite the input file"), std::string::npos) << result.err;
  EXPECT_EQ(read("glstat.csv"), text);
}

TEST_F(RunTest, ARestartBehindItsEndSaysThatItMakesNoStep) {
  const std::string deck = write("plate.k", falling_plate());
  ASSERT_EQ(run({"run", deck, "-o", path("out"), "-q", "--restart-every", "1000000"}).code, ExitCode::Normal);
  const Result result = run({"run", "--restart", path("out/restart"), "--end", "0.5", "-o", path("more")});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.err.find("at its end and makes no step"), std::string::npos) << result.err;
}

TEST_F(RunTest, WhatCannotBePrintedIsAnError) {
  std::ofstream full("/dev/full");
  ASSERT_TRUE(full);
  std::ostringstream err;
  EXPECT_EQ(run_program({"keywords"}, {full, err, false}), ExitCode::Output);
  EXPECT_NE(err.str().find("standard output"), std::string::npos) << err.str();
}

TEST_F(RunTest, PerturbationChangesTheResultAndItsSeedRepeatsIt) {
  const std::string deck = write("plate.k", falling_plate());
  const auto hash = [&](const char* name, const char* size, const char* seed) {
    EXPECT_EQ(run({"run", deck, "-o", path(name), "-q", "--perturb", size, "--seed", seed}).code,
              ExitCode::Normal);
    return record(name)["state_hash"].get<std::string>();
  };
  EXPECT_EQ(hash("a", "1e-9", "1"), hash("b", "1e-9", "1"));
  EXPECT_NE(hash("c", "1e-9", "2"), hash("a", "1e-9", "1"));
  EXPECT_NE(hash("d", "0", "1"), hash("a", "1e-9", "1"));
}

/// It is no fault of the deck.
TEST_F(RunTest, AnInstructionSetThatDoesNotExistIsAMistakeOfTheCall) {
  const std::string deck = write("plate.k", falling_plate());
  setenv("CRUMPLE_ISA", "z80", 1);
  const Result result = run({"run", deck, "-o", path("out")});
  unsetenv("CRUMPLE_ISA");
  EXPECT_EQ(result.code, ExitCode::Usage);
  EXPECT_EQ(result.err.find("crumple: error: CRUMPLE_ISA in the environment: The instruction set \"z80\""),
            0U)
      << result.err;
  EXPECT_FALSE(exists("out"));
}

/// Runs that would last for hours, ended from outside once they write.
class StopTest : public ProgramTest {
 protected:
  /// Starts the run and calls `stop` as soon as the run has its files.
  template <class Stop>
  Result run_until(const Stop& stop) {
    const std::string deck = write("plate.k", falling_plate());
    std::thread user([&] {
      while (!exists("out/plate.pvd")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      stop();
    });
    Result result = run({"run", deck, "-o", path("out"), "--end", "1e6"});
    user.join();
    return result;
  }
  /// The last state is in the frames and histories, and run.json knows of it.
  void expect_complete(const std::string& reason) {
    const auto json = record("out");
    EXPECT_EQ(json["termination"], "interrupted");
    EXPECT_NE(json["reason"].get<std::string>().find(reason), std::string::npos) << json["reason"];
    const double end = json["end_time"];
    EXPECT_EQ(std::stod(table("out/glstat.csv").back()[0]), end);
    const std::string collection = read("out/plate.pvd");
    const std::size_t last = collection.rfind("timestep=\"") + 10;
    EXPECT_EQ(std::stod(collection.substr(last)), end);
  }
};

TEST_F(StopTest, CtrlC) {
  const Result result = run_until([] { kill(getpid(), SIGINT); });
  EXPECT_EQ(result.code, ExitCode::Interrupt);
  expect_complete("SIGINT");
}

TEST_F(StopTest, Sigterm) {
  const Result result = run_until([] { kill(getpid(), SIGTERM); });
  EXPECT_EQ(result.code, ExitCode::Terminate);
  expect_complete("SIGTERM");
}

/// The terminal was closed, or the connection to it broke.
TEST_F(StopTest, Sighup) {
  const Result result = run_until([] { kill(getpid(), SIGHUP); });
  EXPECT_EQ(result.code, ExitCode::Hangup);
  expect_complete("SIGHUP");
}

TEST_F(StopTest, SighupIsIgnoredWhereItWasBefore) {
  const auto before = std::signal(SIGHUP, SIG_IGN);
  const Result result = run_until([] {
    kill(getpid(), SIGHUP);
    kill(getpid(), SIGTERM);
  });
  std::signal(SIGHUP, before);
  EXPECT_EQ(result.code, ExitCode::Terminate);
}

TEST_F(StopTest, SwitchOne) {
  const Result result = run_until([this] { write("out/d3kil", "sw1"); });
  EXPECT_EQ(result.code, ExitCode::Stopped);
  expect_complete("sw1");
  EXPECT_FALSE(exists("out/d3kil"));
}

TEST_F(StopTest, WhatWasStoppedCanBeTakenUp) {
  run_until([] { kill(getpid(), SIGTERM); });
  const auto stopped = record("out");
  EXPECT_TRUE(exists("out/restart/latest.restart"));
  const double end = 1.1 * stopped["end_time"].get<double>();
  const Result result = run({"run", "--restart", path("out"), "--end", fmt::format("{}", end)});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_GE(record("out")["end_time"], end * (1 - 1e-9));
  EXPECT_GT(record("out")["cycles"], stopped["cycles"]);
}

TEST_F(StopTest, SwitchThreeAndSigusr1WriteRestartFilesAndTheRunGoesOn) {
  run_until([this] {
    write("out/d3kil", "sw3");
    while (!exists("out/restart/latest.restart")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(exists("out/restart/previous.restart"));
    kill(getpid(), SIGUSR1);
    while (!exists("out/restart/previous.restart")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_FALSE(exists("out/run.json"));
    kill(getpid(), SIGINT);
  });
  EXPECT_EQ(record("out")["termination"], "interrupted");
}

TEST_F(StopTest, SwitchFourWritesAFrameAndTheRunGoesOn) {
  const auto frames = [this] {
    return std::distance(std::filesystem::directory_iterator(folder_ / "out/vtu"),
                         std::filesystem::directory_iterator());
  };
  long before = 0;
  long after = 0;
  run_until([&] {
    before = frames();
    write("out/d3kil", "sw4");
    while (exists("out/d3kil")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    after = frames();
    kill(getpid(), SIGINT);
  });
  EXPECT_EQ(before, 1) << "frames are 1e4 apart: only the first is due";
  EXPECT_EQ(after, 2);
}

class CheckTest : public ProgramTest {};

TEST_F(CheckTest, TellsWhatAGoodDeckHoldsAndWritesNothing) {
  const Result result = run({"check", write("plate.k", falling_plate())});
  EXPECT_EQ(result.code, ExitCode::Normal) << result.err;
  for (const char* word : {"kg, mm, ms", "nodes                 9", "Belytschko-Tsay", "first step",
                           "controlled by shell", "The deck can be run"})
    EXPECT_NE(result.out.find(word), std::string::npos) << word << " in\n" << result.out;
  EXPECT_EQ(
      std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator()), 1);
}

/// The line of the report that begins with these words, blanks drawn together.
std::string line_with(const std::string& report, const std::string& words) {
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string joined;
    for (std::string cell; cells >> cell;) joined += (joined.empty() ? "" : " ") + cell;
    if (joined.starts_with(words)) return joined;
  }
  return "no such line in\n" + report;
}

TEST_F(CheckTest, ShowsByPartWhatItsResultsDependOn) {
  std::string text = falling_plate("*CONTROL_TERMINATION\n1.0,\n*CONTROL_HOURGLASS\n4,0.03\n");
  EXPECT_EQ(line_with(run({"check", write("plate.k", text)}).out, "1 0"), "1 0 stiffness QM 0.03 none");
  text.replace(text.find("         1         2  0.833333         3\n"), 41, "1,1,1.0,9,0,1\n");
  text.replace(text.find("       1.0       1.0       1.0       1.0\n"), 41, "1.0,1.0,1.0,1.0,-1\n");
  text.replace(text.find("         1         1         1\n*SECTION"), 31, "1,1,1,0,5\n");
  text.replace(text.find("*MAT_ELASTIC\n         1   7.83e-6     207.0       0.3\n"), 54,
               "*MAT_098\n1,7.83e-6,207,0.3,1\n0.8,0.5,0.26,0.01\n*HOURGLASS\n5,1,0.1,0,0,0,0.05,0.02\n");
  const Result result = run({"check", write("plate.k", text)});
  EXPECT_EQ(line_with(result.out, "1 4"),
            "1 4 Hughes-Liu simplified Johnson-Cook 9 trapezoid 1 0.003132 plate");
  EXPECT_EQ(line_with(result.out, "1 -1"), "1 -1 viscous QM 0.1 QB 0.05 QW 0.02 C ln(rate), VP 1");
}

TEST_F(CheckTest, ABadDeckFails) {
  std::string text = falling_plate();
  text.replace(text.find("*MAT_ELASTIC"), 12, "*MAT_ELASTIK");
  const Result result = run({"check", write("plate.k", text)});
  EXPECT_EQ(result.code, ExitCode::Input);
  EXPECT_NE(result.err.find("*MAT_ELASTIK"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("cannot be run"), std::string::npos);
}

TEST_F(CheckTest, AMistakeOnTheCommandLineIsTwo) {
  EXPECT_EQ(run({"chek", "deck.k"}).code, ExitCode::Usage);
  EXPECT_EQ(run({"--help"}).code, ExitCode::Normal);
}

}  // namespace
}  // namespace crumple::app::run_test
