// SPDX-License-Identifier: BSD-3-Clause
// Runs of decks with a dynamic relaxation: what they write, where they go on, how they end in between.
#include <fmt/core.h>

#include <algorithm>

#include "app/program_fixture.hpp"

namespace crumple::app::dynamic_relaxation_test {
namespace {

constexpr double speed = 4.0;
constexpr double block_density = 2e-5;

/// A strip of 12 x 2 shells that is held at one end, pulled along x at the other, and hit by a cube.
std::string pulled_strip(const std::string& control, int phase = 2) {
  std::string deck = "*KEYWORD\n" + control + "*NODE\n";
  const auto node = [&deck](int id, double x, double y, double z, int tc, int rc) {
    deck += fmt::format("{:8d}{:16.6f}{:16.6f}{:16.6f}{:8d}{:8d}\n", id, x, y, z, tc, rc);
  };
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 13; ++i) node(1 + i + 13 * j, 5.0 * i, 5.0 * j, 0, i == 0 ? 7 : i == 12 ? 5 : 0, 0);
  for (int k = 0; k < 8; ++k) node(101 + k, 28 + 4 * (k % 2), 3 + 4 * (k / 2 % 2), k < 4 ? 1 : 5, 0, 0);
  deck += "*ELEMENT_SHELL\n";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 12; ++i) {
      const int n = 1 + i + 13 * j;
      deck += fmt::format("{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", 1 + i + 12 * j, 1, n, n + 1, n + 14, n + 13);
    }
  deck +=
      "*ELEMENT_SOLID\n     100       2     101     102     104     103     105     106     108     107\n";
  deck += fmt::format(
      "*PART\nstrip\n1,1,1\n*PART\ncube\n2,2,2\n*SECTION_SHELL\n1,2,0.833,3\n1.0,1.0,1.0,1.0\n"
      "*SECTION_SOLID\n2,1\n*MAT_ELASTIC\n1,7.85E-6,210.0,0.3\n*MAT_ELASTIC\n2,{},210.0,0.3\n"
      "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n\n\n"
      "*SET_NODE_LIST\n1\n101,102,103,104,105,106,107,108\n*INITIAL_VELOCITY\n1\n0.0,0.0,{}\n"
      "*LOAD_NODE_POINT\n13,1,1,0.25\n26,1,1,0.5\n39,1,1,0.25\n"
      "*DEFINE_CURVE\n1,{}\n0.0,1.0\n1000.0,1.0\n*DATABASE_GLSTAT\n0.01\n*DATABASE_BINARY_D3PLOT\n0.1\n*"
      "END\n",
      block_density, -speed, phase);
  return deck;
}

constexpr const char* half_a_millisecond = "*CONTROL_TERMINATION\n0.5\n";
/// The card of public decks, which have no keyword but this: on, all defaults.
constexpr const char* relaxation =
    "*CONTROL_DYNAMIC_RELAXATION\n"
    "       250      .001      .995         0        .9         0       .04         1\n";

class RelaxationTest : public ProgramTest {
 protected:
  Result run_deck(const std::string& deck, const std::string& folder,
                  std::vector<std::string> more = {}) const {
    write(folder + ".k", deck);
    std::vector<std::string> arguments{"run", path(folder + ".k"), "-o", path(folder)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_F(RelaxationTest, ATensionedStripThatIsHitKeepsTheEnergy) {
  const Result result = run_deck(pulled_strip(std::string(half_a_millisecond) + relaxation), "out");
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.out.find("dynamic relaxation: cycle "), std::string::npos);
  EXPECT_NE(result.out.find("Dynamic relaxation: converged after"), std::string::npos) << result.out;
  const auto json = record("out");
  const auto& relaxed = json["dynamic_relaxation"];
  EXPECT_TRUE(relaxed["converged"]);
  EXPECT_GT(relaxed["cycles"].get<long>(), 250);
  EXPECT_LT(relaxed["ratio"].get<double>(), 0.001);
  EXPECT_LT(relaxed["energy_error"].get<double>(), 0.01);
  // One force of 1 kN on 10 mm2: F^2 L / (2 E A), and the cube alone moves.
  const auto rows = table("out/glstat.csv");
  const auto column = [&](const char* name) {
    return std::stod(rows[1][std::find(rows[0].begin(), rows[0].end(), name) - rows[0].begin()]);
  };
  EXPECT_EQ(column("time"), 0);
  EXPECT_NEAR(column("internal"), 60 / (2 * 210.0 * 10), 0.05 * 60 / (2 * 210.0 * 10));
  EXPECT_NEAR(column("kinetic"), 0.5 * block_density * 64 * speed * speed, 0.001 * block_density * 64);
  EXPECT_LT(json["energy"]["error"].get<double>(), 0.01);
  EXPECT_NE(json["contact"][0]["worst_penetration"].get<double>(), 0) << "the cube has met the strip";
  const auto checks = table("out/relax.csv");
  ASSERT_GT(checks.size(), 2U);
  EXPECT_EQ(checks[0][0], "cycle");
  EXPECT_EQ(checks[1][0], "250");
  EXPECT_EQ(checks[1][3], "1");
}

TEST_F(RelaxationTest, ThreadsAndARestartGiveTheSameBits) {
  const std::string deck = pulled_strip(std::string(half_a_millisecond) + relaxation);
  ASSERT_EQ(run_deck(deck, "one", {"-t", "1", "-q"}).code, ExitCode::Normal);
  ASSERT_EQ(run_deck(deck, "three", {"-t", "3", "-q", "--restart-every", "100"}).code, ExitCode::Normal);
  EXPECT_EQ(record("one")["state_hash"], record("three")["state_hash"]);
  const Result again = run({"run", "--restart", path("three/restart/previous.restart"), "-t", "2"});
  ASSERT_EQ(again.code, ExitCode::Normal) << again.err;
  EXPECT_EQ(again.out.find("dynamic relaxation: cycle"), std::string::npos) << "the relaxation is over";
  EXPECT_EQ(record("one")["state_hash"], record("three")["state_hash"]);
  EXPECT_EQ(record("one")["dynamic_relaxation"]["cycles"], record("three")["dynamic_relaxation"]["cycles"]);
  EXPECT_EQ(read("one/glstat.csv"), read("three/glstat.csv"));
  EXPECT_TRUE(exists("three/relax.csv"));
}

TEST_F(RelaxationTest, WithoutARunItIsTheResult) {
  const Result result =
      run_deck(pulled_strip(std::string("*CONTROL_TERMINATION\n0.0\n") + relaxation), "out");
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_EQ(record("out")["cycles"], 0);
  EXPECT_GT(record("out")["energy"]["internal"].get<double>(), 0);
  EXPECT_EQ(table("out/glstat.csv").size(), 2U);
}

TEST_F(RelaxationTest, ItsEndTimeIsSaidAndTheRunGoesOn) {
  const Result result = run_deck(
      pulled_strip(
          "*CONTROL_TERMINATION\n0.05\n*CONTROL_DYNAMIC_RELAXATION\n250,0.001,0.995,0.1,0.9,0,0.04,1\n"),
      "out");
  ASSERT_EQ(result.code, ExitCode::Normal) << result.err;
  EXPECT_NE(result.err.find("has not converged at DRTERM = 0.1"), std::string::npos) << result.err;
  EXPECT_FALSE(record("out")["dynamic_relaxation"]["converged"]);
  EXPECT_GE(record("out")["end_time"].get<double>(), 0.0499);
}

TEST_F(RelaxationTest, ACurveAloneAsksForIt) {
  ASSERT_EQ(run_deck(pulled_strip("*CONTROL_TERMINATION\n0.01\n"), "out", {"-q"}).code, ExitCode::Normal);
  EXPECT_FALSE(record("out")["dynamic_relaxation"].is_null());
  ASSERT_EQ(run_deck(pulled_strip("*CONTROL_TERMINATION\n0.01\n", 0), "none", {"-q"}).code, ExitCode::Normal);
  EXPECT_TRUE(record("none")["dynamic_relaxation"].is_null());
  EXPECT_FALSE(exists("none/relax.csv"));
}

/// One that never converges is stopped from outside.
TEST_F(RelaxationTest, AStopEndsItWithoutARestartFile) {
  std::filesystem::create_directories(path("out"));
  write("out/d3kil", "sw1\n");
  const Result result =
      run_deck(pulled_strip(std::string(half_a_millisecond) +
                            "*CONTROL_DYNAMIC_RELAXATION\n250,1E-300,0.995,0.0,0.9,0,0.04,1\n"),
               "out");
  EXPECT_EQ(result.code, ExitCode::Stopped) << result.err;
  EXPECT_EQ(record("out")["termination"], "interrupted");
  EXPECT_FALSE(exists("out/restart"));
  EXPECT_EQ(record("out")["cycles"], 0);
}

}  // namespace
}  // namespace crumple::app::dynamic_relaxation_test
